"""An X series servo, register by register."""

import pytest

FAIL, INSTRUCTION, RANGE, LENGTH, LIMIT, ACCESS = 1, 2, 4, 5, 6, 7


@pytest.fixture
def servo(probes):
    return probes("XL430-W250", [1])[0]


@pytest.fixture
def axes(probes):
    return probes("2XL430-W250", [1, 2])


def mode(servo, number):
    servo.put("torque_enable", 0)
    assert servo.put("operating_mode", number) == 0
    assert servo.put("torque_enable", 1) == 0


class TestMotion:
    def test_position_mode_goes_to_the_goal(self, servo):
        servo.put("torque_enable", 1)
        assert servo.put("goal_position", 3000) == 0
        servo.wait(2)
        assert servo.get("present_position") == pytest.approx(3000, abs=8)
        assert servo.get("moving") == 0
        assert servo.get("moving_status") & 1

    def test_the_profile_sets_velocity_and_acceleration(self, servo):
        servo.put("torque_enable", 1)
        servo.put("profile_velocity", 50)  # 11.45 rpm are 782 ticks a second
        servo.put("profile_acceleration", 10)  # 2146 rev/min2: full speed after 0.32 s
        servo.put("goal_position", 4000)
        servo.wait(0.16)
        assert servo.get("velocity_trajectory") == pytest.approx(25, abs=1)
        servo.wait(0.84)
        assert servo.get("velocity_trajectory") == 50
        assert servo.get("present_velocity") == pytest.approx(50, abs=2)
        assert servo.get("moving_status") >> 4 == 3
        assert servo.get("moving_status") & 2
        # The ramps cost half their time in distance.
        assert servo.get("position_trajectory") == pytest.approx(2048 + 782 * (1 - 0.16), rel=0.01)
        servo.wait(3)
        assert servo.get("position_trajectory") == 4000
        assert servo.get("velocity_trajectory") == 0

    def test_a_time_based_profile_takes_its_time(self, servo):
        servo.put("drive_mode", 4)
        servo.put("torque_enable", 1)
        servo.put("profile_velocity", 2000)
        servo.put("profile_acceleration", 500)
        servo.put("goal_position", 3048)
        servo.wait(1.0)
        assert servo.get("position_trajectory") == pytest.approx(2548, abs=15)
        servo.wait(1.1)
        assert servo.get("position_trajectory") == 3048

    def test_velocity_mode_turns_at_a_speed_for_ever(self, servo):
        mode(servo, 1)
        servo.put("goal_velocity", -100)
        servo.wait(2)
        assert servo.get("present_velocity") == pytest.approx(-100, abs=2)
        servo.wait(60)
        assert servo.get("present_position") < -4096

    def test_pwm_mode_drives_as_told(self, servo):
        mode(servo, 16)
        servo.put("goal_pwm", 442)
        servo.wait(1)
        assert servo.get("present_pwm") == 442
        assert 100 < servo.get("present_velocity") < 140

    def test_extended_mode_counts_turns_and_a_reboot_forgets_them(self, servo):
        mode(servo, 4)
        assert servo.put("goal_position", 20000) == 0
        servo.wait(8)
        assert servo.get("present_position") == pytest.approx(20000, abs=8)
        servo.power_cycle()
        assert 0 <= servo.get("present_position") < 4096

    def test_goal_pwm_limits_every_mode(self, servo):
        servo.put("torque_enable", 1)
        servo.put("goal_pwm", 100)
        servo.put("goal_position", 4000)
        servo.wait(0.3)
        assert servo.get("present_pwm") == 100

    def test_reverse_mode_mirrors_the_position(self, servo):
        servo.put("drive_mode", 1)
        servo.put("torque_enable", 1)
        angle = servo.plant.angle
        servo.put("goal_position", 3000)
        servo.wait(2)
        assert servo.plant.angle < angle
        assert servo.get("present_position") == pytest.approx(3000, abs=8)

    def test_a_homing_offset_moves_the_zero(self, servo):
        before = servo.get("present_position")
        servo.put("homing_offset", 100)
        assert servo.get("present_position") == before + 100

    def test_torque_on_holds_where_it_is(self, servo):
        servo.put("torque_enable", 1)
        servo.wait(1)
        assert servo.get("present_position") == 2048
        assert servo.memory["goal_position"] == 2048

    def test_changing_the_mode_resets_gains_and_profile(self, servo):
        servo.put("position_p_gain", 100)
        servo.put("profile_velocity", 100)
        servo.put("operating_mode", 1)
        assert servo.memory["position_p_gain"] == 640
        assert servo.memory["profile_velocity"] == 0


class TestRules:
    @pytest.mark.parametrize(
        ("name", "value", "error"),
        [
            ("goal_position", 4096, LIMIT),
            ("goal_position", -1, LIMIT),
            ("goal_velocity", 300, LIMIT),
            ("operating_mode", 2, RANGE),
            ("drive_mode", 2, RANGE),
            ("id", 253, RANGE),
            ("baud_rate", 8, RANGE),
            ("led", 2, RANGE),
            ("present_position", 0, ACCESS),
        ],
    )
    def test_wrong_values_bring_their_error(self, servo, name, value, error):
        assert servo.put(name, value) == error

    def test_part_of_a_register_is_too_short(self, servo):
        assert servo.write(116, b"\0\0") == LENGTH

    def test_several_whole_registers_are_fine(self, servo):
        assert servo.write(108, bytes([1, 0, 0, 0, 2, 0, 0, 0])) == 0
        assert (servo.memory["profile_acceleration"], servo.memory["profile_velocity"]) == (1, 2)

    def test_one_bad_register_keeps_the_others_from_being_written(self, servo):
        assert servo.write(112, bytes([9, 0, 0, 0, 0, 0, 1, 0])) == LIMIT
        assert servo.memory["profile_velocity"] == 0

    def test_the_eeprom_is_shut_while_torque_is_on(self, servo):
        servo.put("torque_enable", 1)
        assert servo.put("id", 5) == ACCESS
        servo.put("torque_enable", 0)
        assert servo.put("id", 5) == 0

    def test_undocumented_addresses_can_be_read_but_not_written(self, servo):
        assert servo.read(14, 2) == (0, b"\0\0")
        assert servo.write(14, b"\1") == ACCESS
        assert servo.read(600, 100) == (ACCESS, b"")


class TestIndirect:
    def test_scattered_registers_are_read_in_one_block(self, servo):
        for n, address in enumerate((132, 133, 134, 135, 146), 1):
            assert servo.put(f"indirect_address_{n}", address) == 0
        error, data = servo.read(224, 5)
        assert error == 0
        assert data == bytes([0, 8, 0, 0, 25])

    def test_and_written(self, servo):
        for n in range(4):
            servo.put(f"indirect_address_{n + 1}", 116 + n)
        assert servo.write(224, (2500).to_bytes(4, "little")) == 0
        assert servo.memory["goal_position"] == 2500

    def test_the_target_decides_what_may_be_written(self, servo):
        servo.put("indirect_address_1", 146)
        assert servo.write(224, b"\5") == ACCESS
        servo.put("indirect_address_1", 116)
        assert servo.write(224, b"\5") == LENGTH

    def test_as_delivered_it_is_plain_memory(self, servo):
        assert servo.write(225, b"\x2a") == 0
        assert servo.read(225, 1) == (0, b"\x2a")


class TestAlarms:
    def stall(self, servo):
        servo.put("torque_enable", 1)
        servo.plant.held = True
        servo.put("goal_position", 4000)
        servo.wait(5)

    def test_only_a_reboot_brings_torque_back(self, servo):
        self.stall(servo)
        assert servo.memory["hardware_error_status"] == 0x20
        assert servo.memory["torque_enable"] == 0
        assert servo.error_byte(0) == 0x80
        servo.plant.held = False
        assert servo.put("torque_enable", 1) == FAIL
        servo.power_cycle()
        assert servo.put("torque_enable", 1) == 0
        assert servo.error_byte(0) == 0

    def test_bad_voltage_alerts_but_does_not_shut_down_by_default(self, servo):
        servo.put("torque_enable", 1)
        servo.supply.volts = 5.5
        servo.wait(0.1)
        assert servo.memory["hardware_error_status"] == 1
        assert servo.memory["torque_enable"] == 1

    def test_the_watchdog_stops_the_motor_and_refuses_goals(self, servo):
        mode(servo, 1)
        servo.put("bus_watchdog", 10)
        servo.put("goal_velocity", 100)
        servo.heard()
        servo.wait(0.19)
        assert servo.get("present_velocity") > 50
        servo.wait(1)
        assert servo.memory["bus_watchdog"] == 255
        assert servo.get("present_velocity") == 0
        assert servo.put("goal_velocity", 50) == RANGE
        servo.put("bus_watchdog", 0)
        assert servo.put("goal_velocity", 50) == 0


class TestTwoAxes:
    def test_their_ids_must_differ(self, axes):
        assert axes[1].put("id", 1) == LIMIT
        assert axes[1].put("id", 9) == 0

    def test_baud_rate_and_protocol_are_shared(self, axes):
        axes[0].put("baud_rate", 4)
        assert axes[1].baud == 2_000_000
        axes[1].put("protocol_type", 1)
        assert axes[0].protocol == 1

    def test_one_axis_with_torque_shuts_the_eeprom_of_both(self, axes):
        axes[0].put("torque_enable", 1)
        assert axes[1].put("homing_offset", 5) == ACCESS

    def test_they_move_apart(self, axes):
        for axis, goal in zip(axes, (1000, 3000), strict=True):
            axis.put("torque_enable", 1)
            axis.put("goal_position", goal)
            axis.wait(2)
        assert [axis.get("present_position") for axis in axes] == [
            pytest.approx(1000, abs=8),
            pytest.approx(3000, abs=8),
        ]
