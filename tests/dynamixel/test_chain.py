"""The chain: who answers what, when, and what the wire does to it."""

import random
from itertools import pairwise

import pytest

from kinlab.dynamixel.chain import Chain, Faults, Receiver
from kinlab.dynamixel.chain.eeprom import load_eeprom, save_eeprom
from kinlab.dynamixel.codec.instructions import BROADCAST, BY_NAME, pack
from kinlab.dynamixel.codec.packets import Packet, decode, encode
from kinlab.dynamixel.codec.stream import StreamParser
from kinlab.errors import FileError, UsageError

MBPS = 1_000_000
DELAY = 500e-6  # the factory's return delay


def packet(protocol, servo, name, head=None, rows=()):
    instruction = BY_NAME[protocol][name]
    return Packet(protocol, servo, instruction.code, pack(instruction, head, rows))


def ask(chain, request, now=1.0, baud=MBPS):
    """The answers as packets."""
    data = b"".join(burst.data for burst in chain.obey(request, now, baud))
    frames = StreamParser(request.protocol).feed(data)
    return [decode(frame, request.protocol, as_status=True) for frame in frames]


@pytest.fixture
def ax():
    return Chain.of([("AX-12A", [i]) for i in (1, 2, 3)])


@pytest.fixture
def x():
    return Chain.of([("XL430", [i]) for i in (1, 2, 3)])


def test_an_id_may_stand_only_once():
    with pytest.raises(UsageError, match="stands twice"):
        Chain.of([("AX-12A", [1]), ("RX-24F", [1])])


def test_an_unknown_id_is_answered_with_those_that_there_are(ax):
    with pytest.raises(UsageError, match="1, 2, 3"):
        ax.servo(77)


class TestWhoAnswers:
    def test_a_ping_is_answered_by_the_one_that_was_asked(self, ax, x):
        assert [p.id for p in ask(ax, packet(1, 2, "PING"))] == [2]
        (answer,) = ask(x, packet(2, 2, "PING"))
        assert answer.params == (1060).to_bytes(2, "little") + bytes([46])

    def test_nobody_answers_orders_to_all(self, ax):
        assert ask(ax, packet(1, BROADCAST, "WRITE", {"address": 25, "data": b"\1"})) == []
        assert all(servo.memory["led"] == 1 for servo in ax.servos)

    @pytest.mark.parametrize(("level", "answers"), [(0, [1, 0, 0]), (1, [1, 1, 0]), (2, [1, 1, 1])])
    def test_the_status_return_level_silences(self, ax, level, answers):
        ask(ax, packet(1, 1, "WRITE", {"address": 16, "data": bytes([level])}))
        asked = [
            packet(1, 1, "PING"),
            packet(1, 1, "READ", {"address": 36, "count": 2}),
            packet(1, 1, "WRITE", {"address": 25, "data": b"\1"}),
        ]
        assert [len(ask(ax, request)) for request in asked] == answers

    def test_the_write_that_silences_is_still_answered(self, ax):
        assert len(ask(ax, packet(1, 1, "WRITE", {"address": 16, "data": b"\0"}))) == 1

    def test_a_new_id_is_answered_for_under_the_old_one(self, ax):
        assert [p.id for p in ask(ax, packet(1, 1, "WRITE", {"address": 3, "data": b"\x09"}))] == [1]
        assert [p.id for p in ask(ax, packet(1, 9, "PING"))] == [9]
        assert ask(ax, packet(1, 1, "PING")) == []

    def test_another_speed_hears_nothing(self, x):
        assert ask(x, packet(2, 1, "PING"), baud=57600) == []
        assert len(ask(x, packet(2, 1, "PING"), baud=990_000)) == 1

    def test_an_unknown_instruction_is_an_error_of_its_own(self, ax, x):
        assert ask(ax, Packet(1, 1, 0x77))[0].error == 64
        assert ask(x, Packet(2, 1, 0x77))[0].error == 2
        assert ask(ax, packet(1, 1, "REBOOT"))[0].error == 64

    def test_a_secondary_id_is_obeyed_and_never_answered(self, x):
        ask(x, packet(2, 1, "WRITE", {"address": 12, "data": b"\x63"}))
        assert ask(x, packet(2, 99, "WRITE", {"address": 65, "data": b"\1"})) == []
        assert x.servo(1).memory["led"] == 1
        ask(x, packet(2, 99, "WRITE", {"address": 7, "data": b"\5"}))
        assert x.servo(1).id == 1

    def test_an_x_servo_can_speak_protocol_1(self, x):
        ask(x, packet(2, 1, "WRITE", {"address": 13, "data": b"\1"}))
        assert ask(x, packet(2, 1, "PING")) == []
        assert [p.id for p in ask(x, packet(1, 1, "PING"))] == [1]
        (answer,) = ask(x, packet(1, BROADCAST, "BULK_READ", {}, [{"count": 4, "id": 1, "address": 132}]))
        assert int.from_bytes(answer.params, "little") == 2048
        assert ask(x, packet(1, 1, "WRITE", {"address": 116, "data": b"\xff" * 4}))[0].error == 2

    def test_two_with_one_id_garble_each_other(self, ax):
        ax.servo(2).memory["id"] = 1
        ax.servo(2).memory["present_position"] = 0
        ax.servos[1].plant.angle = 0.0
        ax.take_census()
        (burst,) = ax.obey(packet(1, 1, "READ", {"address": 36, "count": 2}), 1.0, MBPS)
        assert StreamParser(1).feed(burst.data) == []

    def test_a_ping_to_all_garbles_protocol_1_and_comes_in_turn_in_protocol_2(self, ax, x):
        assert ask(ax, packet(1, BROADCAST, "PING")) == []
        bursts = x.obey(packet(2, BROADCAST, "PING"), 1.0, MBPS)
        assert [decode(b.data, 2).id for b in bursts] == [1, 2, 3]
        assert all(a.end <= b.start for a, b in pairwise(bursts))


class TestManyAtOnce:
    def test_sync_write_reaches_the_listed(self, ax):
        rows = [{"id": 1, "data": b"\x10\0"}, {"id": 3, "data": b"\x20\0"}, {"id": 77, "data": b"\0\0"}]
        assert ask(ax, packet(1, BROADCAST, "SYNC_WRITE", {"address": 30, "length": 2}, rows)) == []
        assert [servo.memory["goal_position"] for servo in ax.servos] == [16, 512, 32]

    def test_a_sync_write_with_leftover_bytes_does_nothing(self, ax):
        whole = packet(
            1, BROADCAST, "SYNC_WRITE", {"address": 30, "length": 2}, [{"id": 1, "data": b"\x10\0"}]
        )
        ask(ax, Packet(1, BROADCAST, whole.code, whole.params + b"\3"))
        assert ax.servo(1).memory["goal_position"] == 512

    def test_sync_read_answers_in_the_order_of_the_list(self, x):
        request = packet(
            2, BROADCAST, "SYNC_READ", {"address": 132, "count": 4}, [{"id": i} for i in (3, 1, 2)]
        )
        assert [p.id for p in ask(x, request)] == [3, 1, 2]

    def test_one_that_is_missing_silences_those_behind_it(self, x):
        request = packet(
            2, BROADCAST, "SYNC_READ", {"address": 132, "count": 4}, [{"id": i} for i in (1, 9, 2)]
        )
        assert [p.id for p in ask(x, request)] == [1]

    def test_bulk_write(self, x):
        rows = [
            {"id": 1, "address": 65, "length": 1, "data": b"\1"},
            {"id": 2, "address": 112, "length": 4, "data": b"\7\0\0\0"},
        ]
        ask(x, packet(2, BROADCAST, "BULK_WRITE", {}, rows))
        assert (x.servo(1).memory["led"], x.servo(2).memory["profile_velocity"]) == (1, 7)

    def test_a_fast_read_is_one_packet_with_a_crc_for_each(self, x):
        request = packet(2, BROADCAST, "FAST_SYNC_READ", {"address": 132, "count": 4}, [{"id": 1}, {"id": 2}])
        (burst,) = x.obey(request, 1.0, MBPS)
        assert StreamParser(2).feed(burst.data) == [burst.data]
        assert burst.data[:8] == bytes.fromhex("FF FF FD 00 FE 11 00 55")

    def test_ax_does_not_know_bulk_read(self, ax):
        assert ask(ax, packet(1, BROADCAST, "BULK_READ", {}, [{"count": 2, "id": 1, "address": 36}])) == []

    def test_2xl_do_not_know_fast_reads(self):
        chain = Chain.of([("2XL430", [1, 2])])
        request = packet(2, BROADCAST, "FAST_SYNC_READ", {"address": 132, "count": 4}, [{"id": 1}])
        assert ask(chain, request) == []


class TestRegisteredWrites:
    @pytest.mark.parametrize(
        ("protocol", "address", "name", "error"),
        [(1, 25, "registered", 64), (2, 65, "registered_instruction", 2)],
    )
    def test_they_wait_for_the_action(self, ax, x, protocol, address, name, error):
        chain = ax if protocol == 1 else x
        assert ask(chain, packet(protocol, 1, "REG_WRITE", {"address": address, "data": b"\1"}))[0].error == 0
        assert (chain.servo(1).memory[name], chain.servo(1).memory["led"]) == (1, 0)
        ask(chain, packet(protocol, BROADCAST, "ACTION"))
        assert (chain.servo(1).memory[name], chain.servo(1).memory["led"]) == (0, 1)
        assert ask(chain, packet(protocol, 1, "ACTION"))[0].error == error


class TestTime:
    def test_the_return_delay_is_kept(self, ax):
        (burst,) = ax.obey(packet(1, 1, "PING"), 1.0, MBPS)
        assert burst.start == pytest.approx(1.0 + DELAY)
        assert burst.end - burst.start == pytest.approx(60e-6)
        ask(ax, packet(1, 1, "WRITE", {"address": 5, "data": b"\x0a"}))
        assert ax.obey(packet(1, 1, "PING"), 2.0, MBPS)[0].start == pytest.approx(2.0 + 20e-6)

    def test_bytes_take_longer_at_a_lower_speed(self):
        slow = Chain.of([("AX-12A", [1])], baud=9600)
        (burst,) = slow.obey(packet(1, 1, "PING"), 1.0, 9615)
        assert burst.end - burst.start == pytest.approx(60 / 9615, rel=1e-3)

    def test_without_byte_times_only_the_delays_count(self):
        chain = Chain.of([("XL430", [i]) for i in (1, 2)], byte_times=False)
        request = packet(2, BROADCAST, "SYNC_READ", {"address": 132, "count": 4}, [{"id": 1}, {"id": 2}])
        assert [b.start for b in chain.obey(request, 1.0, MBPS)] == [
            pytest.approx(1.0 + DELAY),
            pytest.approx(1.0 + 2 * DELAY),
        ]

    def test_a_reboot_makes_deaf_for_a_moment(self, x):
        assert len(ask(x, packet(2, 1, "REBOOT"))) == 1
        assert ask(x, packet(2, 1, "PING"), now=1.01) == []
        assert len(ask(x, packet(2, 1, "PING"), now=2.0)) == 1


class TestReset:
    def test_protocol_1_goes_back_to_id_1_and_answers_under_the_old(self, ax):
        chain = Chain.of([("AX-12A", [7])])
        chain.servo(7).memory["max_torque"] = 5
        assert [p.id for p in ask(chain, packet(1, 7, "FACTORY_RESET"))] == [7]
        assert chain.servo(1).memory["max_torque"] == 1023

    @pytest.mark.parametrize(("option", "servo", "baud"), [(0xFF, 1, 57600), (1, 7, 57600), (2, 7, MBPS)])
    def test_protocol_2_keeps_what_it_is_told_to(self, option, servo, baud):
        chain = Chain.of([("XL430", [7])])
        chain.servo(7).memory["velocity_limit"] = 5
        ask(chain, packet(2, 7, "FACTORY_RESET", {"option": option}))
        assert chain.servo(servo).memory["velocity_limit"] == 265
        assert chain.servo(servo).baud == baud

    def test_nobody_resets_all_at_once(self, x):
        ask(x, packet(2, BROADCAST, "FACTORY_RESET", {"option": 0xFF}))
        assert [servo.id for servo in x.servos] == [1, 2, 3]

    def test_a_backup_restores_what_was(self, x):
        key = bytes.fromhex("4354524C")
        ask(x, packet(2, 1, "WRITE", {"address": 44, "data": b"\x64\0\0\0"}))
        assert ask(x, packet(2, 1, "CONTROL_TABLE_BACKUP", {"option": 1, "key": key}))[0].error == 0
        ask(x, packet(2, 1, "WRITE", {"address": 44, "data": b"\x05\0\0\0"}))
        assert ask(x, packet(2, 1, "CONTROL_TABLE_BACKUP", {"option": 2, "key": key}))[0].error == 0
        assert x.servo(1).memory["velocity_limit"] == 100
        assert ask(x, packet(2, 2, "CONTROL_TABLE_BACKUP", {"option": 2, "key": key}))[0].error == 1


class TestPower:
    def test_without_it_nobody_answers_and_the_ram_is_lost(self, ax):
        ask(ax, packet(1, 1, "WRITE", {"address": 25, "data": b"\1"}))
        ask(ax, packet(1, 1, "WRITE", {"address": 14, "data": b"\0\2"}))
        ax.set_volts(0.0, 2.0)
        assert ask(ax, packet(1, 1, "PING"), now=3.0) == []
        ax.set_volts(12.0, 4.0)
        assert len(ask(ax, packet(1, 1, "PING"), now=5.0)) == 1
        assert ax.servo(1).memory["led"] == 0
        assert ax.servo(1).memory["max_torque"] == 512

    def test_a_brown_out_is_reported_while_it_lasts(self, ax):
        ax.set_volts(5.5, 2.0)
        assert ask(ax, packet(1, 1, "PING"), now=3.0)[0].error == 1


class TestFaults:
    def test_they_are_the_same_each_time_for_one_seed(self):
        def spoilt(seed):
            return Faults(drop=0.2, flip=0.2, noise=0.2, seed=seed).pass_on(bytes(200))

        assert spoilt(7) == spoilt(7) != spoilt(8)

    def test_without_faults_nothing_happens_to_bytes(self):
        assert Faults().pass_on(b"\1\2\3") == b"\1\2\3"

    def test_everything_can_be_dropped_or_turned_over(self):
        assert Faults(drop=1.0).pass_on(bytes(9)) == b""
        assert all(bin(byte).count("1") == 1 for byte in Faults(flip=1.0).pass_on(bytes(9)))

    def test_echo_and_delay(self, ax):
        ax.faults = Faults(echo=True, delay=0.01)
        ping = encode(packet(1, 1, "PING"))
        echo, answer = Receiver(ax).feed(ping, 1.0, MBPS)
        assert echo.data == ping
        assert answer.start == pytest.approx(1.0 + DELAY + 0.01)

    def test_a_dead_servo_is_silent(self, ax):
        ax.servo(1).dead = True
        assert ask(ax, packet(1, 1, "PING")) == []


class TestReceiver:
    def test_an_unfinished_packet_is_forgotten_after_a_pause(self, ax):
        receiver, ping = Receiver(ax), encode(packet(1, 1, "PING"))
        receiver.feed(b"\xff\xff\x01\xc8\x03", 1.0, MBPS)
        assert len(receiver.feed(ping, 1.2, MBPS)) == 1

    def test_bytes_that_trickle_in_make_a_packet(self, ax):
        receiver, bursts = Receiver(ax), []
        for n, byte in enumerate(encode(packet(1, 1, "PING"))):
            bursts += receiver.feed(bytes([byte]), 1.0 + n * 0.05, MBPS)
        assert len(bursts) == 1

    def test_two_instructions_in_one_chunk_are_answered_one_after_the_other(self, ax):
        both = encode(packet(1, 1, "PING")) + encode(packet(1, 2, "PING"))
        first, second = Receiver(ax).feed(both, 1.0, MBPS)
        assert first.end <= second.start

    def test_answers_of_others_are_not_obeyed(self, x):
        assert Receiver(x).feed(bytes.fromhex("FF FF FD 00 01 04 00 55 00 A1 0C"), 1.0, MBPS) == []

    def test_a_chain_can_speak_both_protocols(self):
        chain = Chain.of([("AX-12A", [1]), ("XL430", [2])])
        receiver = Receiver(chain)
        for request in (packet(1, 1, "PING"), packet(2, 2, "PING"), packet(1, 1, "PING")):
            assert len(receiver.feed(encode(request), 1.0, MBPS)) == 1

    def test_mutated_packets_never_stop_the_next_good_one(self, x):
        source = random.Random(11)
        receiver, now = Receiver(x), 0.0
        good = encode(packet(2, 2, "READ", {"address": 132, "count": 4}))
        originals = [
            encode(packet(2, 1, "WRITE", {"address": 116, "data": bytes(4)})),
            encode(packet(2, BROADCAST, "SYNC_READ", {"address": 132, "count": 4}, [{"id": 1}, {"id": 2}])),
            encode(packet(2, BROADCAST, "FAST_BULK_READ", {}, [{"id": 1, "address": 132, "count": 4}])),
            encode(packet(2, 3, "CLEAR", {"option": 1, "key": b"DXL\x22"})),
        ]
        for _ in range(2000):
            bad = bytearray(source.choice(originals))
            for _ in range(source.randrange(1, 4)):
                bad[source.randrange(len(bad))] = source.randrange(256)
            receiver.feed(bytes(bad), now := now + 0.01, MBPS)
            answers = receiver.feed(good, now := now + 0.01, MBPS)
            assert [decode(b.data, 2).id for b in answers][-1:] == [2]

    def test_sound_packets_with_senseless_contents_do_no_harm(self, ax, x):
        source, now = random.Random(12), 0.0
        for chain, protocol in ((ax, 1), (x, 2)):
            for _ in range(3000):
                request = Packet(
                    protocol,
                    source.choice([1, 2, 3, BROADCAST]),
                    source.choice(list(BY_NAME[protocol].values())).code,
                    source.randbytes(source.randrange(12)),
                )
                chain.obey(request, now := now + 0.01, MBPS)


class TestEeprom:
    def test_it_outlives_the_program(self, tmp_path, x):
        path = tmp_path / "eeprom.json"
        ask(x, packet(2, 1, "WRITE", {"address": 7, "data": b"\x21"}))
        ask(x, packet(2, 2, "WRITE", {"address": 112, "data": b"\7\0\0\0"}))
        save_eeprom(x, path)
        later = Chain.of([("XL430", [i]) for i in (1, 2, 3)])
        load_eeprom(later, path)
        assert [servo.id for servo in later.servos] == [0x21, 2, 3]
        assert later.servo(2).memory["profile_velocity"] == 0
        assert list(tmp_path.iterdir()) == [path]

    def test_a_file_that_is_not_there_changes_nothing(self, tmp_path, ax):
        load_eeprom(ax, tmp_path / "none.json")

    def test_values_that_cannot_be_are_refused(self, tmp_path, x):
        path = tmp_path / "wrong.json"
        save_eeprom(x, path)
        path.write_text(path.read_text().replace('"baud_rate": 3', '"baud_rate": 99', 1))
        with pytest.raises(FileError, match="baud_rate cannot be 99"):
            load_eeprom(x, path)

    @pytest.mark.parametrize(
        "text", ["", "[]", '{"servos": 3}', '{"servos": [{"model": "RX-24F", "eeprom": {}}]}']
    )
    def test_another_file_is_refused_by_its_name(self, tmp_path, ax, text):
        path = tmp_path / "wrong.json"
        path.write_text(text)
        with pytest.raises(FileError, match=r"wrong\.json"):
            load_eeprom(ax, path)


def test_servos_are_switched_on_when_the_clock_says_so(ax):
    """A machine's clock has run for days before a chain is made; the servos have not."""
    ax.begin(1e7)
    assert ax.servo(1).time == 1e7
    ax.servo(1).memory["led"] = 1
    ax.begin(2e7)
    assert ax.servo(1).memory["led"] == 1


@pytest.mark.parametrize("protocol", [1, 2])
def test_ten_million_random_bytes_leave_the_chain_as_able_as_before(protocol):
    chain = Chain.of([("AX-12A" if protocol == 1 else "XL430", [i]) for i in (1, 2, 3)])
    receiver, source, now = Receiver(chain), random.Random(5), 0.0
    for _ in range(2500):
        receiver.feed(source.randbytes(4000), now := now + 0.01, MBPS)
        good = encode(packet(protocol, 2, "PING"))
        answers = receiver.feed(good, now := now + 0.01, MBPS)
        ids = [decode(burst.data, protocol, True).id for burst in answers]
        # Random bytes may have given servo 2 another id.
        assert ids[-1:] == [2] or all(servo.id != 2 for servo in chain.servos)
