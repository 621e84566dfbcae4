"""An AX or RX servo, register by register."""

import pytest

RANGE, ANGLE_LIMIT, INSTRUCTION, OVERLOAD, HOT, VOLTAGE = 8, 2, 64, 32, 4, 1


@pytest.fixture(params=["AX-12A", "RX-24F"])
def servo(request, probes):
    return probes(request.param, [1])[0]


def test_it_goes_where_it_is_told(servo):
    assert servo.put("goal_position", 700) == 0
    servo.wait(2)
    assert servo.get("present_position") == pytest.approx(700, abs=3)
    assert servo.get("moving") == 0


def test_moving_speed_is_a_speed(servo):
    servo.put("moving_speed", 100)  # 11.1 rpm are 227 ticks a second
    servo.put("goal_position", 1000)
    servo.wait(0.5)
    first = servo.get("present_position")
    servo.wait(1.0)
    assert servo.get("present_position") - first == pytest.approx(227, rel=0.03)
    assert servo.get("present_speed") == pytest.approx(100, abs=3)
    assert servo.get("moving") == 1


def test_wheel_mode_turns_for_ever_both_ways(servo):
    servo.put("cw_angle_limit", 0)
    servo.put("ccw_angle_limit", 0)
    servo.put("torque_enable", 1)
    servo.put("moving_speed", 512)
    servo.wait(5)
    ahead = servo.plant.angle
    assert ahead > 10
    servo.put("moving_speed", 0x400 | 512)
    servo.wait(10)
    assert servo.plant.angle < ahead
    assert servo.get("present_speed") < 0
    servo.put("moving_speed", 0)
    servo.wait(2)
    assert servo.get("present_speed") == 0


def test_torque_off_leaves_it_free(servo):
    servo.put("torque_enable", 0)
    servo.plant.external = 0.5
    servo.wait(1)
    assert servo.get("present_position") > 600


def test_a_soft_slope_yields_more_than_a_stiff_one(servo):
    def yields(slope):
        servo.put("cw_compliance_slope", slope)
        servo.put("ccw_compliance_slope", slope)
        servo.put("goal_position", 512)
        servo.plant.external = 0.5 * servo.table.stall_nm
        servo.wait(3)
        return abs(servo.get("present_position") - 512)

    stiff, soft = yields(2), yields(128)
    assert soft > 10 * stiff


def test_the_margin_is_a_dead_band(servo):
    servo.put("cw_compliance_margin", 50)
    servo.put("ccw_compliance_margin", 50)
    servo.put("goal_position", 540)
    servo.wait(2)
    assert servo.get("present_position") == 512


def test_punch_is_the_least_drive(servo):
    servo.put("cw_compliance_slope", 128)
    servo.put("ccw_compliance_slope", 128)
    servo.plant.held = True
    servo.put("goal_position", 520)
    servo.wait(0.1)
    gentle = servo.plant.torque
    servo.put("punch", 500)
    servo.wait(0.1)
    assert servo.plant.torque > 2 * gentle


class TestRules:
    def test_reading_beyond_the_table_is_out_of_range(self, servo):
        assert servo.read(48, 2)[0] == 0
        assert servo.read(49, 2) == (RANGE, b"")
        assert servo.read(0, 50)[0] == 0

    def test_read_only_registers_do_not_change(self, servo):
        assert servo.put("present_position", 5) == RANGE
        assert servo.put("model_number", 5) == RANGE

    def test_a_value_out_of_range_is_refused_and_nothing_is_written(self, servo):
        assert servo.put("goal_position", 1024) == RANGE
        assert servo.write(24, bytes([1, 1, 1, 1, 255])) == RANGE
        assert servo.get("led") == 0

    def test_a_goal_outside_the_angle_limits_is_refused(self, servo):
        servo.put("cw_angle_limit", 200)
        servo.put("ccw_angle_limit", 800)
        assert servo.put("goal_position", 100) == ANGLE_LIMIT
        assert servo.put("goal_position", 200) == 0

    def test_each_byte_of_a_register_can_be_written(self, servo):
        assert servo.write(30, b"\x10") == 0
        assert servo.write(31, b"\x01") == 0
        assert servo.memory["goal_position"] == 0x110

    def test_a_write_may_span_registers_and_skip_what_cannot_be_written(self, servo):
        assert servo.write(30, bytes([0, 2, 50, 0, 255, 3, 9, 9])) == 0
        assert (servo.memory["goal_position"], servo.memory["moving_speed"]) == (512, 50)

    def test_locked_it_takes_only_goals_until_the_next_power_on(self, servo):
        servo.put("lock", 1)
        assert servo.put("punch", 64) == RANGE
        assert servo.put("lock", 0) == RANGE
        assert servo.put("goal_position", 600) == 0
        servo.power_cycle()
        assert servo.put("punch", 64) == 0

    def test_the_ram_is_lost_and_the_eeprom_kept(self, servo):
        servo.put("led", 1)
        servo.put("max_torque", 800)
        servo.power_cycle()
        assert servo.memory["led"] == 0
        assert servo.memory["torque_limit"] == servo.memory["max_torque"] == 800


class TestAlarms:
    def stall(self, servo):
        servo.plant.held = True
        servo.put("goal_position", 1000)
        servo.wait(5)

    def test_a_stalled_servo_shuts_down_and_recovers_by_a_torque_limit(self, servo):
        self.stall(servo)
        assert servo.error_byte(0) == OVERLOAD
        assert servo.memory["torque_limit"] == 0
        assert servo.drive == 0.0
        servo.plant.held = False
        servo.put("torque_limit", 1023)
        assert servo.error_byte(0) == 0
        servo.wait(2)
        assert servo.get("present_position") == pytest.approx(1000, abs=3)

    def test_half_the_torque_is_half_the_load_and_no_alarm(self, servo):
        servo.put("torque_limit", 512)
        self.stall(servo)
        assert servo.get("present_load") == pytest.approx(500, abs=5)
        assert servo.error_byte(0) == 0

    def test_it_grows_warm_under_load_and_reports_overheating(self, servo):
        servo.put("torque_limit", 400)
        self.stall(servo)
        cool = servo.get("present_temperature")
        servo.wait(1000)
        assert servo.get("present_temperature") > cool + 10
        servo.put("temperature_limit", cool)
        assert servo.error_byte(0) & HOT
        servo.wait(0.01)
        assert servo.memory["torque_limit"] == 0
        servo.wait(5000)
        assert servo.get("present_temperature") == 25

    def test_bad_voltage_is_reported_as_long_as_it_lasts(self, servo):
        servo.supply.volts = 5.0
        assert servo.error_byte(0) == VOLTAGE
        servo.supply.volts = 12.0
        assert servo.error_byte(0) == 0

    def test_the_cable_costs_volts_under_load(self, servo):
        servo.put("torque_limit", 700)
        self.stall(servo)
        assert servo.get("present_voltage") < 120


def test_it_gets_by_with_any_pattern_of_waiting(probes):
    """Asked often or seldom, a servo is in the same place."""
    often, seldom = (probes("AX-12A", [1])[0] for _ in range(2))
    for servo in (often, seldom):
        servo.put("goal_position", 900)
    for _ in range(300):
        often.wait(0.01)
    seldom.wait(3)
    assert often.plant.angle == pytest.approx(seldom.plant.angle, abs=0.01)
