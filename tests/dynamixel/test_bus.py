"""The master, against a chain in memory and in simulated time."""

import pytest

from kinlab.dynamixel import BusError, DamagedAnswerError, NoAnswerError, PortError, RefusedError, open_port
from kinlab.dynamixel.bus import Passage, packets
from kinlab.dynamixel.chain import Burst
from kinlab.dynamixel.monitor import CsvLog, Monitor
from kinlab.errors import FileError, UsageError

MIXED = (("AX-12A", [1]), ("XL430-W250", [2]), ("2XL430-W250", [3, 4]), ("RX-24F", [5]), ("XL430-W250", [6]))


@pytest.fixture
def bus(bus_of):
    return bus_of(*MIXED)


def test_scan_finds_all_of_both_protocols(bus):
    assert [(f.id, f.model, f.protocol) for f in bus.scan()] == [
        (1, "AX-12A", 1),
        (2, "XL430-W250-T", 2),
        (3, "2XL430-W250-T", 2),
        (4, "2XL430-W250-T", 2),
        (5, "RX-24F", 1),
        (6, "XL430-W250-T", 2),
    ]


@pytest.mark.parametrize("servo", [1, 2, 3, 5])
def test_it_writes_and_reads_in_ticks_and_degrees(bus, servo):
    bus.write(servo, "torque_enable", 1)
    bus.write(servo, "goal_position", "100deg")
    bus.port.clock.wait(3)
    assert bus.read(servo, "present_position", "deg") == pytest.approx(100, abs=1.5)
    assert bus.read(servo, "goal_position") == bus.register(servo, "goal_position").ticks(100)
    bus.write(servo, "goal_position", 1.0, "rad")
    assert bus.read(servo, "goal_position", "rad") == pytest.approx(1.0, abs=0.01)


def test_registered_writes(bus):
    bus.reg_write(1, "goal_position", 100)
    bus.reg_write(2, "led", 1)
    assert bus.read(1, "goal_position") == 512
    bus.action()
    assert (bus.read(1, "goal_position"), bus.read(2, "led")) == (100, 1)


@pytest.mark.parametrize("fast", [False, True])
def test_many_at_once(bus, fast):
    bus.sync_write("profile_velocity", {2: 20, 6: 60})
    assert bus.sync_read("profile_velocity", [2, 6], fast=fast) == {2: 20, 6: 60}
    bus.bulk_write({2: ("led", 1), 6: ("profile_velocity", 66)})
    assert bus.bulk_read({2: "led", 6: "profile_velocity"}, fast=fast) == {2: 1, 6: 66}
    assert bus.sync_read("present_position", [2, 6], "deg", fast)[2] == pytest.approx(180)


def test_sync_write_in_protocol_1(bus):
    bus.sync_write("goal_position", {1: "90deg", 5: "120deg"})
    assert (bus.read(1, "goal_position"), bus.read(5, "goal_position")) == (307, 410)


def test_reboot_reset_clear_and_backup(bus):
    bus.write(2, "velocity_limit", 99)
    bus.backup(2)
    bus.write(2, "velocity_limit", 11)
    bus.backup(2, restore=True)
    bus.port.clock.wait(1)
    assert bus.read(2, "velocity_limit") == 99
    bus.clear(2)
    bus.reboot(2)
    bus.port.clock.wait(1)
    bus.factory_reset(2, keep="id and baud rate")
    bus.port.clock.wait(1)
    assert bus.read(2, "velocity_limit") == 265
    with pytest.raises(UsageError, match="keeps"):
        bus.factory_reset(2, keep="calm")


def test_a_servo_that_answers_only_reads_takes_orders_all_the_same(bus):
    bus.write(1, "status_return_level", 1)
    bus.write(1, "goal_position", 222)
    bus.write(1, "led", 1)
    assert (bus.read(1, "goal_position"), bus.read(1, "led")) == (222, 1)


class TestErrors:
    def test_a_refusal_names_servo_register_and_cause(self, bus):
        with pytest.raises(
            RefusedError, match="servo 2, goal_position: the servo reports: data limit"
        ) as refused:
            bus.write(2, "goal_position", 9000)
        assert (refused.value.servo, refused.value.subject, refused.value.error) == (2, "goal_position", 6)

    def test_silence_names_the_usual_reasons(self, bus):
        with pytest.raises(
            NoAnswerError, match=r"servo 77, PING: no answer .wrong id, baud rate or protocol"
        ):
            bus.ping(77)

    def test_a_damaged_answer_is_shown(self, bus):
        bus.scan()
        hopeless = type(bus)(bus.port, retries=0)
        bus.port.chain.faults.flip = 0.0
        hopeless.ping(2)
        bus.port.chain.faults.flip = 1.0
        with pytest.raises(NoAnswerError):
            hopeless.read(2, "present_position")
        bus.port.chain.obey = lambda packet, now, baud: [Burst(now, now, b"\xff\xff\xfd\x00\x02")]
        bus.port.chain.faults.flip = 0.0
        with pytest.raises(DamagedAnswerError, match="a damaged answer: FF FF FD 00 02"):
            hopeless.read(2, "present_position")

    def test_retries_get_through_some_noise(self, bus_of):
        bus = bus_of(("XL430", [1]))
        bus.scan()
        bus.port.chain.faults.drop = 0.02
        patient = type(bus)(bus.port, retries=50)
        assert [patient.read(1, "present_position") for _ in range(100)] == [2048] * 100

    def test_alarms_do_not_keep_one_from_reading(self, bus):
        bus.port.chain.servo(1).forced.add("overload")
        bus.port.chain.servo(2).forced.add("overheating")
        bus.port.clock.wait(0.1)
        assert bus.read(1, "torque_limit") == 0
        assert bus.read(2, "hardware_error_status") == 4
        assert bus.alarms == {1: ["overload"], 2: ["alert: see hardware_error_status"]}

    def test_what_cannot_be_asked_is_refused_beforehand(self, bus):
        with pytest.raises(UsageError, match="can only be read"):
            bus.write(2, "present_load", 1)
        with pytest.raises(UsageError, match="did you mean goal_position"):
            bus.read(2, "goal_positoin")
        with pytest.raises(UsageError, match="no SYNC_READ"):
            bus.sync_read("present_position", [1, 5])
        with pytest.raises(UsageError, match="one address"):
            bus.sync_read("present_position", [1, 2])

    def test_a_missing_servo_in_a_group_is_named(self, bus):
        bus.scan()
        bus.port.chain.servo(6).dead = True
        with pytest.raises(BusError) as failed:
            bus.sync_read("present_position", [2, 6])
        assert failed.value.servo == 6

    @pytest.mark.parametrize(
        ("name", "word"), [("/dev/there-is-none", "no such device"), ("127.0.0.1:1", "nothing listens")]
    )
    def test_a_port_that_is_not_there(self, name, word):
        with pytest.raises(PortError, match=word):
            open_port(name)

    def test_an_emulated_port_that_cannot_be(self):
        with pytest.raises(UsageError):
            open_port("emu:no-such-robot")


class TestLateAnswers:
    """Answers that come after their request was repeated, and would do for those to the next one."""

    @pytest.fixture
    def late(self, bus_of):
        """A bus whose answers come when the bus has just begun to ask again."""
        bus = bus_of(("AX-12A", [1]), ("XL430", [2]))
        bus.port.chain.faults.delay = 0.002
        bus.port.chain.servo(1).forced.add("overload")
        return type(bus)(bus.port, protocol=1)

    def test_of_a_ping_are_not_taken_for_those_to_a_read(self, late):
        assert late.ping(1).model == "AX-12A"
        assert late.alarms == {1: ["overload"]}

    def test_of_one_register_are_not_taken_for_those_of_another(self, late):
        late.ping(1)
        asked = ("goal_position", "ccw_angle_limit", "punch", "present_voltage", "id", "baud_rate")
        for _ in range(3):
            assert [late.read(1, name) for name in asked] == [512, 1023, 32, 120, 1, 1]

    def test_of_another_servo_are_passed_over(self, bus_of):
        bus = bus_of(("AX-12A", [1]), ("AX-12A", [2]))
        bus.port.chain.faults.delay = 0.002
        once, again = (type(bus)(bus.port, protocol=1, retries=retries) for retries in (0, 2))
        with pytest.raises(NoAnswerError):
            once.ping(1)
        bus.port.chain.servo(2).forced.add("overload")
        assert again.ping(2).id == 2
        assert again.alarms == {2: ["overload"]}

    def test_of_many_servos_either(self, late):
        bus = type(late)(late.port, protocol=2)
        for _ in range(3):
            assert bus.sync_read("position_p_gain", [2]) == {2: 640}
            assert bus.sync_read("position_d_gain", [2], fast=True) == {2: 4000}

    def test_a_scan_asks_again_what_a_servo_is_once_it_has_answered(self, bus_of):
        bus = bus_of(("AX-12A", [1]))
        answer, told = bus.port.chain.obey, []

        def forgetful(packet, now, baud):
            told.append(packet.name)
            return [] if told == ["PING", "READ"] else answer(packet, now, baud)

        bus.port.chain.obey = forgetful
        assert [found.id for found in type(bus)(bus.port, protocol=1).scan([1])] == [1]


def test_an_adapter_that_hears_itself(bus_of):
    bus = bus_of(("AX-12A", [1]), ("XL430", [2]))
    bus.port.chain.faults.echo = True
    hearing = type(bus)(bus.port, echo=True)
    assert [found.id for found in hearing.scan(range(4))] == [1, 2]
    assert hearing.read(1, "present_position") == 512


def test_slow_lines_get_more_time(bus_of):
    bus = bus_of(("XL430", [1]), baud=9600)
    assert bus.read(1, "present_position") == 2048


class TestMonitor:
    def test_rounds_hold_values_with_units_and_faults(self, bus):
        monitor = Monitor(bus, [1, 2], None, 100)
        bus.port.chain.servo(2).dead = True
        (seen,) = monitor.rounds(1)
        assert seen.values[1]["present_position_deg"] == pytest.approx(150)
        assert seen.values[1]["present_voltage_V"] == pytest.approx(12)
        assert set(seen.values[2].values()) == {None}
        assert "no answer" in seen.faults[2]

    def test_rounds_come_at_the_rate(self, bus):
        times = [seen.time for seen in Monitor(bus, [1], ["present_position"], 50).rounds(4)]
        assert times == [pytest.approx(n / 50) for n in range(4)]

    def test_csv_has_a_row_for_each_servo_and_round(self, bus, tmp_path):
        monitor = Monitor(bus, [1, 2], ["present_position", "led"], 100)
        path = tmp_path / "log.csv"
        with CsvLog(path, monitor) as log:
            for seen in monitor.rounds(3):
                log.add(seen)
        rows = path.read_text().splitlines()
        assert rows[0] == "time_s,id,present_position_deg,led,fault"
        assert rows[1] == "0.000000,1,150.0,0.0,"
        assert len(rows) == 7

    def test_what_cannot_be_watched_or_written(self, bus, tmp_path):
        with pytest.raises(UsageError, match="no servo to watch"):
            Monitor(bus, [], None, 10)
        with pytest.raises(UsageError, match="rate"):
            Monitor(bus, [1], None, 0)
        with pytest.raises(FileError, match="cannot be written"):
            CsvLog(tmp_path / "none" / "log.csv", Monitor(bus, [1], None, 10))


def test_registers_side_by_side_are_written_in_one_packet(bus_of):
    bus = bus_of(("RX-24F", [5]))
    goal, speed, load = (bus.register(5, name) for name in ("goal_position", "moving_speed", "present_load"))
    bus.write_block(5, {speed: 100, goal: 600})
    assert (bus.read(5, "goal_position"), bus.read(5, "moving_speed")) == (600, 100)
    with pytest.raises(UsageError, match="goal_position to present_load are not side by side"):
        bus.write_block(5, {goal: 600, load: 0})


def test_a_tap_hears_all_that_passes_with_its_time(bus):
    bus.write(1, "torque_enable", 1)
    heard = []
    bus.tap = heard.append
    began = bus.port.clock.now()
    bus.read(1, "present_position")
    bus.sync_write("goal_position", {1: 512})
    bus.tap = None
    bus.read(1, "present_position")
    assert [(p.sent, len(p.data)) for p in heard] == [(True, 8), (False, 8), (True, 11)]
    assert heard[0].data.startswith(bytes.fromhex("FFFF0104"))
    # At 1 Mbps a byte takes 10 us; the answer waits for the servo's return delay.
    assert heard[0].at == pytest.approx(began + 80e-6)
    assert heard[1].at > heard[0].at + 80e-6
    assert heard[2].at == pytest.approx(heard[1].at + 110e-6)


def test_answers_heard_in_pieces_become_whole_packets(bus):
    bus.scan()
    heard = []
    bus.tap = heard.append
    bus.read(1, "present_position")
    bus.sync_write("goal_position", {1: 512})
    bus.read(2, "present_position")
    pieces = []
    for passage in heard:
        at, sent, data = passage
        cuts = [data] if sent else [data[:1], data[1:4], data[4:]]
        pieces += [Passage(at + i * 1e-3, sent, part) for i, part in enumerate(cuts)]
    whole = list(packets(pieces))
    assert [(p.sent, p.data) for p in whole] == [(p.sent, p.data) for p in heard]
    assert whole[1].at == pytest.approx(heard[1].at + 2e-3)
    # Answers that come in one piece are told apart, and what is none comes as it is.
    request, answer = heard[0], heard[1]
    both = list(packets([request, answer._replace(data=answer.data * 2), answer._replace(data=b"\xff\x00")]))
    assert [p.data for p in both] == [request.data, answer.data, answer.data, b"\xff\x00"]
