"""The packet sandbox: one line in, what happened out."""

from contextlib import suppress

import pytest

from kinlab.dynamixel import MemoryPort, PortError
from kinlab.dynamixel.sandbox import VERBS, ExpectationError, Session, execute, run_script
from kinlab.errors import FileError, KinlabError, UsageError


@pytest.fixture
def session():
    return Session("AX-12A:1,2,XL430-W250:3")


def say(session, *lines):
    """What the last of these lines leads to."""
    for line in lines:
        outcome = execute(session, line)
    return outcome


def test_sent_and_received_bytes_stand_under_each_other_dissected_and_timed(session):
    text = say(session, "read 1 present_position").text.splitlines()
    assert text[0] == "-> FF FF 01 04 02 24 02 D2   8 bytes, 80 us at 1 Mbps"
    (answer,) = [n for n, line in enumerate(text) if line.startswith("<- ")]
    assert "FF FF 01 04 00 00 02 F8" in text[answer]
    assert "here after 660 us" in text[answer]
    assert any("Goal" not in line and "address 36: Present Position" in line for line in text[:answer])
    assert text[-1] == "servo 1: ok  Present Position 512 = 150 deg"


@pytest.mark.parametrize(
    ("line", "sent"),
    [
        ("ping 1", "FF FF 01 02 01 FB"),
        ("write 1 goal_position 512", "FF FF 01 05 03 1E 00 02 D6"),
        ("write 1 goal_position 90deg", "FF FF 01 05 03 1E 33 01 A4"),
        ("write 1 @25 1", "FF FF 01 04 03 19 01 DD"),
        ("write 1 @30:2 0x200", "FF FF 01 05 03 1E 00 02 D6"),
        ("regwrite 1 goal_position 500", "FF FF 01 05 04 1E F4 01 E2"),
        ("action", "FF FF FE 02 05 FA"),
        ("read 1 @36 2", "FF FF 01 04 02 24 02 D2"),
        ("syncwrite goal_position 1=16 2=32", "FF FF FE 0A 83 1E 02 01 10 00 02 20 00 21"),
        ("ping 3", "FF FF FD 00 03 03 00 01 1A E6"),
        ("syncread present_position 3", "FF FF FD 00 FE 08 00 82 84 00 04 00 03 F1 4F"),
        ("reboot 3", None),
        ("clear 3", None),
        ("backup 3", None),
        ("reset 3 id+baud", None),
        ("bulkread 3:present_position fast", None),
        ("bulkwrite 3:led=1", None),
    ],
)
def test_every_verb_sends_the_packet_it_means(session, line, sent):
    built = say(session, f"build {line}").data["packet"]
    assert built == say(session, line).data["exchange"]["sent"]["bytes"]
    assert sent in (None, built)


def test_build_sends_nothing(session):
    say(session, "build write 1 led 1")
    assert not session.exchanges


def test_send_never_repairs_a_packet_but_dots_ask_for_the_check(session):
    wrong = say(session, "send FF FF 01 02 01 FA")
    assert "the checksum is FA, but the bytes before it give FB" in wrong.text
    assert wrong.data["exchange"]["answers"] == []
    assert say(session, "send FF FF 01 02 01 ..").data["exchange"]["sent"]["bytes"] == "FF FF 01 02 01 FB"
    assert say(session, "send FF FF FD 00 03 03 00 01 ..").ok


def test_a_pointless_packet_is_pointed_out(session):
    assert (
        "did you mean READ (02)? Then the checksum is D2" in say(session, "send FF FF 01 04 03 24 02 D1").text
    )
    assert "there is no servo 9" in say(session, "ping 9").text


class TestStep:
    def test_a_packet_is_assembled_byte_by_byte_and_sent(self, session):
        says = [say(session, line).text for line in ("step", "FF FF", "01", "02", "01")]
        assert "next: header" in says[0]
        assert "next: id" in says[1]
        assert "servo 1" in says[2]
        assert "PING: ask whether the servo is there" in says[4]
        assert "checksum so far: FB" in says[4]
        assert "next: checksum, and it should be FB" in says[4]
        assert "the packet is whole" in say(session, "FB").text
        assert say(session, "send").data["exchange"]["answers"][0]["bytes"] == "FF FF 01 02 00 FC"
        assert session.assembling is None

    def test_a_wrong_byte_can_be_taken_back(self, session):
        assert "the bytes before it give FB" in say(session, "step FF FF 01 02 01", "FA").text
        assert "it should be FB" in say(session, "step back").text
        say(session, "step off")
        assert session.assembling is None

    def test_protocol_2_shows_the_running_crc(self, session):
        assert "CRC so far: 22 28" in say(session, "step FF FF FD 00 01").text

    def test_a_command_is_walked_through_with_the_running_check(self, session):
        text = say(session, "step write 1 goal_position 512").text
        assert "checksum so far: D6" in text
        assert not session.exchanges

    def test_nothing_to_send(self, session):
        with pytest.raises(UsageError, match="usage: send"):
            say(session, "send")


class TestExpect:
    @pytest.mark.parametrize(
        "expectation",
        [
            "FF FF 01 04 00 00 02 F8",
            "FF FF 01 04 00 ?? ?? ??",
            "error=0",
            "count=1",
            "present_position=512",
            "present_position=150deg+-1deg",
        ],
    )
    def test_what_happened(self, session, expectation):
        assert say(session, "read 1 present_position", f"expect {expectation}").ok

    @pytest.mark.parametrize(
        "expectation",
        ["FF FF 01 02 00 FC", "silence", "error=32", "count=2", "present_position=500", "led=1"],
    )
    def test_what_did_not(self, session, expectation):
        with pytest.raises(ExpectationError, match="expected") as failed:
            say(session, "read 1 present_position", f"expect {expectation}")
        assert failed.value.exit_code == 1

    def test_errors_by_name(self, session):
        assert say(
            session, "write 1 goal_position 512", "send FF FF 01 05 03 1E FF 0F ..", "expect error=range"
        ).ok

    def test_before_anything_was_sent(self, session):
        with pytest.raises(UsageError, match="nothing has been sent"):
            say(session, "expect silence")


class TestBench:
    def test_time_passes_only_when_waited_for(self, session):
        say(session, "write 1 goal_position 700", "read 1 present_position")
        with pytest.raises(ExpectationError):
            say(session, "expect present_position=700+-5")
        assert say(session, "wait 2", "read 1 present_position", "expect present_position=700+-5").ok

    def test_power(self, session):
        assert "the supply is off" in say(session, "power off", "ping 1").text
        assert say(session, "power on", "ping 1").ok
        assert say(session, "power 5.5", "ping 1", "expect error=1").ok

    def test_faults_of_a_servo(self, session):
        assert say(session, "fault 1 overload", "ping 1", "expect error=overload").ok
        assert say(session, "fault 1 off", "write 1 torque_limit 1023", "ping 1", "expect error=0").ok
        assert say(session, "fault 1 dead", "ping 1", "expect silence").ok
        assert (
            "set to 57143 bps, you speak at 1000000"
            in say(session, "fault 1 off", "fault 1 baud 57600", "ping 1").text
        )
        assert say(session, "baud 57600", "ping 1", "expect count=1").ok

    def test_a_stuck_servo_overloads(self, session):
        say(session, "fault 2 stuck", "write 2 goal_position 1000", "wait 5", "ping 2")
        assert say(session, "expect error=overload").ok

    def test_noise_is_the_same_for_the_same_seed(self):
        def heard():
            session = Session("AX-12A:1")
            say(session, "noise 0.05 seed=7")
            return [say(session, "ping 1").text for _ in range(20)]

        first = heard()
        assert first == heard()
        assert len(set(first)) > 1

    def test_echo_delay_drop_and_flip(self, session):
        heard = say(session, "echo on", "ping 1").data["exchange"]["answers"]
        assert [answer["bytes"] for answer in heard] == ["FF FF 01 02 01 FB", "FF FF 01 02 00 FC"]
        assert "here after 5620 us" in say(session, "echo off", "delay 5", "ping 1").text
        assert say(session, "drop 1", "ping 1", "expect silence").ok
        assert say(session, "drop 0", "flip 1", "ping 1", "expect silence").ok

    def test_looking_inside_and_reaching_in(self, session):
        state = say(session, "set 1 present_temperature 60", "servo 1").data["servo"]
        assert state["model"] == "AX-12A"
        assert say(session, "push 1 0.5", "wait 1", "read 1 present_position").ok

    def test_tables(self, session):
        assert "goal_position" in say(session, "table 1").text
        assert len(say(session, "table RX-24F goal_position led").lines) == 4

    def test_another_chain(self, session):
        assert say(session, "chain 2XL430-W250:4,5", "scan").data["servos"][0]["model"] == "2XL430-W250-T"
        assert [s["id"] for s in say(session, "chain krsri-hexapod", "scan").data["servos"]] == list(
            range(1, 19)
        )

    def test_a_real_bus_has_no_emulated_servos(self, session):
        real = Session(port=MemoryPort(session.chain, session.port.clock))
        assert say(real, "ping 1").ok
        assert say(real, "write 3 led 1").ok
        assert say(real, "scan").ok
        with pytest.raises(UsageError, match="needs an emulated chain"):
            say(real, "power off")

    def test_a_port_that_fails_leaves_the_session_alive(self, session):
        class Broken(MemoryPort):
            broken = False

            def send(self, data):
                if self.broken:
                    raise PortError("the port is gone")
                super().send(data)

        real = Session(port=Broken(session.chain, session.port.clock))
        real.port.broken = True
        with pytest.raises(PortError):
            say(real, "ping 1")
        real.port.broken = False
        assert say(real, "ping 1").ok


class TestScripts:
    def test_lines_and_semicolons_and_comments(self, session):
        script = "# a lesson\nping 1; ping 2  # two\n\nexpect error=0\n"
        assert [o.data["line"] for o in run_script(session, script)] == ["ping 1", "ping 2", "expect error=0"]

    def test_an_answer_that_was_due_ends_the_script(self, session):
        with pytest.raises(ExpectationError, match="line 2: ping 9: no intact answer"):
            list(run_script(session, "ping 1\nping 9\nping 2"))

    def test_unless_the_next_line_expects_that(self, session):
        assert len(list(run_script(session, "ping 9; expect silence; ping 1"))) == 3

    def test_a_bad_line_is_named_by_its_number(self, session):
        with pytest.raises(
            UsageError, match=r"line 3 .pong 1.: no command is named 'pong'; did you mean ping"
        ):
            list(run_script(session, "ping 1\n\npong 1"))

    def test_a_session_is_saved_as_a_script_and_loaded_again(self, session, tmp_path):
        path = tmp_path / "session.dxl"
        say(session, "write 1 goal_position 700", "wait 2", f"save {path}")
        assert path.read_text().splitlines() == [
            "chain AX-12A:1,2,XL430-W250:3",
            "write 1 goal_position 700",
            "wait 2",
        ]
        later = Session("RX-24F:9")
        assert say(later, f"load {path}", "read 1 present_position", "expect present_position=700+-5").ok

    def test_files_that_load_themselves_come_to_an_end(self, session, tmp_path):
        path = tmp_path / "loop.dxl"
        path.write_text(f"load {path}\n")
        with pytest.raises(FileError, match="load each other"):
            say(session, f"load {path}")

    def test_a_file_that_cannot_be_read(self, session, tmp_path):
        with pytest.raises(FileError, match="cannot be read"):
            say(session, f"load {tmp_path / 'none'}")
        with pytest.raises(FileError, match="cannot be written"):
            say(session, f"save {tmp_path / 'none' / 'x'}")

    def test_trace_off_leaves_the_results(self, session):
        assert say(session, "trace off", "ping 1").text == "servo 1: ok"


@pytest.mark.parametrize("verb", VERBS)
@pytest.mark.parametrize(
    "rest", ["", " 1", " x y z", " -1", " 999 999", " 1 2 3 4 5", " @", " =", " 1:", " .."]
)
def test_no_line_does_more_than_be_refused(session, verb, rest, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with suppress(KinlabError):
        execute(session, verb + rest)


def test_help_has_every_command(session):
    text = say(session, "help").text
    assert all(verb in text for verb in VERBS)
    assert "set a register" in say(session, "help write").text


@pytest.mark.parametrize(
    ("line", "word"),
    [
        ("pong 1", "did you mean ping"),
        ("read 1 goal_positon", "did you mean goal_position"),
        ("read 8 goal_position", "no servo 8 is known"),
        ("send FF GG", "position 4"),
        ("ping 300", "no id"),
        ("chain AX-21:1", "did you mean AX-12A"),
        ("write 1 goal_position", "usage: write ID REGISTER VALUE"),
        ("write 1 goal_position 90kg", "unit"),
    ],
)
def test_mistakes_are_answered_with_what_helps(session, line, word):
    with pytest.raises(UsageError, match=word):
        execute(session, line)
