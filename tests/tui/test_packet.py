"""The Packet station: lines, bytes, answers, registers, faults, by key and by mouse."""

import pytest
from textual.events import Paste
from textual.widgets import OptionList

from kinlab.dynamixel.sandbox.inspection import elapse, holdings
from kinlab.dynamixel.sandbox.session import DEFAULT_CHAIN
from kinlab.tui.stations.packet.faults import KEYS, Faults
from kinlab.tui.stations.packet.prompt import LONGEST, Prompt
from kinlab.tui.stations.packet.registers import Registers
from kinlab.tui.stations.packet.sheet import Sheet
from kinlab.tui.stations.packet.traffic import Traffic
from kinlab.tui.widgets import Choice

NAMES = {
    " ": "space",
    "_": "underscore",
    ":": "colon",
    ",": "comma",
    "-": "minus",
    "=": "equals_sign",
    ";": "semicolon",
    "[": "left_square_bracket",
    "]": "right_square_bracket",
    "/": "slash",
    "\\": "backslash",
    "#": "number_sign",
}


class Person:
    """Somebody at the station, whose time stands still unless it is let go."""

    def __init__(self, pilot, lab):
        self.pilot, self.lab = pilot, lab
        self.station = pilot.app.screen
        self.prompt = self.station.query_one(Prompt)

    async def press(self, *keys):
        await self.pilot.press(*keys)
        await self.pilot.pause()

    async def type(self, text):
        await self.press(*(NAMES.get(char, char) for char in text))

    async def enter(self, line):
        self.prompt.focus()
        self.prompt.value = line
        await self.press("enter")

    async def click(self, widget, **place):
        await self.pilot.click(widget, **place)
        await self.pilot.pause()

    async def click_text(self, text):
        """Click in the middle of a text on the screen."""
        row, line = next((i, line) for i, line in enumerate(self.lab.rows(self.pilot.app)) if text in line)
        await self.pilot.click(offset=(line.index(text) + len(text) // 2, row))
        await self.pilot.pause()

    @property
    def seen(self):
        return self.lab.text(self.pilot.app)

    def register(self, name, servo=1):
        return next(h.ticks for h in holdings(self.station.session, servo) if h.register.name == name)


@pytest.fixture
def at_station(lab):
    """`at_station(script, size=(80, 24))`: a script with a person at the station."""

    def run(script, size=(80, 24)):
        async def play(pilot):
            person = Person(pilot, lab)
            person.station.held = True
            await script(person)

        return lab.drive(play, "packet", size)

    return run


# Lines.


def test_a_line_that_says_nothing_puts_an_end_to_what_was_said_before(at_station):
    async def script(person):
        await person.enter("foo")
        assert "no command is named 'foo'" in person.seen
        await person.enter("trace on")
        assert "no command" not in person.seen
        assert "Done." in person.seen

    at_station(script)


@pytest.mark.parametrize("word", ["quit", "exit"])
def test_the_words_that_end_a_sandbox_leave(at_station, word):
    async def script(person):
        await person.enter(word)
        assert person.pilot.app._exit

    at_station(script)


def test_what_is_pasted_has_the_length_that_a_line_may_have(at_station):
    async def script(person):
        person.prompt.focus()
        person.prompt.post_message(Paste("FF " * 5000))
        await person.pilot.pause()
        assert len(person.prompt.value) <= LONGEST
        assert "? help" in person.seen

    at_station(script)


def test_a_packet_forms_while_it_is_typed_and_is_sent_by_enter(at_station):
    async def script(person):
        await person.type("read 1 present_position")
        assert "FF FF 01 04 02 24 02 D2   8 bytes, not sent yet" in person.seen
        assert "~(01+04+02+24+02) = D2" in person.seen
        assert not person.station.session.exchanges
        await person.press("enter")
        assert "<- FF FF 01 04 00 00 02 F8" in person.seen
        assert "● servo 1: ok  Present Position 512 = 150 deg" in person.seen

    at_station(script)


def test_a_wrong_line_says_so_and_leaves_what_was_there(at_station):
    async def script(person):
        await person.enter("ping 1")
        for line, text in (("pong 1", "did you mean ping"), ("write 1 goal_position x", "is no number")):
            await person.enter(line)
            assert text in person.seen
            assert "-> FF FF 01 02 01 FB" in person.seen

    at_station(script)


def test_anything_may_be_typed(at_station):
    async def script(person):
        for line in ("[", "[/]", "[bold", "send [/x]", "\\[", "send FF ; [", "#", ";;", "x" * 3000):
            await person.type(line[:9])
            await person.enter(line)
        await person.enter("ping 1")
        assert "servo 1: ok" in person.seen

    at_station(script)


def test_several_commands_in_a_line_and_every_verb_work(at_station):
    async def script(person):
        await person.enter("write 1 goal_position 90deg; wait 1; read 1 present_position")
        assert "Present Position 307" in person.seen
        assert len(person.station.session.exchanges) == 2
        await person.enter("expect present_position=90deg+-2deg")
        assert "as expected" in person.seen
        await person.enter("expect silence")
        assert "expected silence" in person.seen
        await person.enter("help crc")
        assert "crc BYTES" in person.seen

    at_station(script)


def test_a_file_is_carried_out_and_stopped_by_whoever_types(at_station, tmp_path):
    script_file, long_file = tmp_path / "a.dxl", tmp_path / "b.dxl"
    script_file.write_text("ping 1\nping 2\n")
    long_file.write_text("ping 1\n" * 5000)

    async def script(person):
        await person.enter(f"load {script_file}")
        assert "servo 2: ok" in person.seen
        assert len(person.station.session.exchanges) == 2
        await person.enter(f"load {tmp_path / 'none'}")
        assert "cannot be read" in person.seen
        person.station.carry_out(f"load {long_file}")
        await person.pilot.pause(0)
        assert "is running" in person.seen
        await person.enter("")
        assert "was stopped" in person.seen
        assert len(person.station.session.history) < 5000

    at_station(script, (120, 24))


def test_tab_completes_and_goes_through_what_may_be_meant(at_station):
    async def script(person):
        await person.type("pi")
        await person.press("tab")
        assert person.prompt.value == "ping "
        person.prompt.value = ""
        await person.type("read 1 pres")
        await person.press("tab")
        assert person.prompt.value == "read 1 present_"
        assert "present_position" in person.seen.splitlines()[-3]
        await person.press("tab")
        assert person.prompt.value == "read 1 present_position"
        await person.press("tab")
        assert person.prompt.value == "read 1 present_speed"
        assert "[present_speed]" in person.seen
        person.prompt.value = ""
        await person.press("tab")
        assert person.station.focused is not person.prompt

    at_station(script)


def test_what_was_typed_before_comes_back(at_station):
    async def script(person):
        for line in ("ping 1", "ping 2"):
            await person.enter(line)
        await person.type("pi")
        await person.press("up")
        assert person.prompt.value == "ping 2"
        await person.press("up", "up")
        assert person.prompt.value == "ping 1"
        await person.press("down", "down", "down")
        assert person.prompt.value == "pi"
        # The line that was typed last is offered as well.
        await person.press("n")
        await person.press("right")
        assert person.prompt.value == "ping 2"
        await person.press("escape")
        assert person.prompt.value == ""

    at_station(script)


def test_escape_gives_the_keys_to_the_station_and_i_takes_them_back(at_station):
    async def script(person):
        await person.press("escape")
        assert isinstance(person.station.focused, Sheet)
        await person.press("i")
        assert person.station.focused is person.prompt
        assert person.prompt.value == ""

    at_station(script)


# Bytes.


def test_a_packet_byte_by_byte_with_its_running_checksum(at_station):
    async def script(person):
        await person.press("f7")
        assert "step 0>" in person.seen
        await person.type("FF FF 01 04 02")
        assert "checksum so far: F8" in person.seen
        await person.press("enter")
        assert "step 5>" in person.seen
        await person.type("24 02")
        assert "checksum, and it should be D2" in person.seen
        await person.press("enter")
        await person.press("backspace")
        assert "step 6>" in person.seen
        await person.enter("02 D2")
        assert "the packet is whole" in person.seen
        assert not person.station.session.exchanges
        await person.press("enter")
        assert "Present Position 512 = 150 deg" in person.seen
        assert "dxl>" in person.seen

    at_station(script)


def test_bytes_are_sent_and_dropped_by_key_and_by_click(at_station):
    async def script(person):
        await person.click_text("F7 bytes")
        await person.enter("FF FF 01 02 01 FA")
        assert "the checksum is FA, but the bytes before it give FB" in person.seen
        await person.press("f7")
        assert person.station.session.assembling is None
        await person.press("f7")
        await person.enter("FF FF 02 02 01 FA")
        await person.click_text("F8 send")
        assert "servo 2: ok" in person.seen
        await person.press("f7")
        await person.enter("FF FF 01 02 01 FB")
        await person.press("f8")
        assert "servo 1: ok" in person.seen

    at_station(script)


def test_sending_and_taking_back_want_bytes(at_station):
    async def script(person):
        assert "F8" not in person.seen
        await person.press("f8", "backspace")
        assert not person.station.session.exchanges
        assert person.station.session.assembling is None

    at_station(script)


# Registers and wire.


def test_views_by_key_and_by_click(at_station):
    async def script(person):
        await person.press("f10")
        assert "goal_position" in person.seen
        await person.press("f10")
        assert person.station.view == "traffic"
        await person.click_text(" Registers ")
        assert person.station.view == "registers"
        await person.click_text(" Packet ")
        assert person.station.view == "packet"

    at_station(script)


def test_a_wide_terminal_shows_everything_at_once(at_station):
    async def script(person):
        await person.enter("read 1 present_position")
        for text in ("checksum", "goal_position", "READ 1", "STATUS 1"):
            assert text in person.seen
        assert "F10" not in person.seen

    at_station(script, (120, 40))


def test_registers_move_with_the_servo_and_mark_what_changes(at_station):
    async def script(person):
        await person.enter("write 1 goal_position 30deg")
        await person.press("f10")
        elapse(person.station.session, 0.3)
        person.station._show_registers()
        await person.pilot.pause()
        row = next(line for line in person.seen.splitlines() if "present_position" in line)
        assert row.endswith("◂")
        assert "512" not in row
        elapse(person.station.session, 2.0)
        assert person.register("present_position") == person.register("goal_position") == 102

    at_station(script)


def test_the_chains_time_passes_as_the_real_one_does(at_station):
    async def script(person):
        clock = person.station.session.port.clock
        begun = clock.now()
        person.station._seen -= 0.3
        person.station._tick()
        assert clock.now() == begun
        person.station.held = False
        person.station._seen -= 0.3
        person.station._tick()
        assert clock.now() >= begun + 0.3

    at_station(script)


def test_time_can_be_stopped(at_station):
    async def script(person):
        await person.press("ctrl+y")
        assert not person.station.held
        await person.press("escape", "t")
        assert person.station.held
        assert "time stands still" in person.seen

    at_station(script, (120, 40))


def test_a_register_is_chosen_and_written_by_key_and_by_click(at_station):
    async def script(person):
        await person.press("f10")
        person.station.query_one(Registers).focus()
        person.station.query_one(Registers).bring("led")
        await person.press("enter")
        assert person.prompt.value == "write 1 led 0"
        await person.press("1", "enter")
        assert person.register("led") == 1
        await person.press("f10")
        await person.click_text("goal_position")
        await person.click_text("goal_position")
        assert person.prompt.value == "write 1 goal_position 512"
        await person.type("0x100")
        await person.press("enter")
        assert person.register("goal_position") == 256
        await person.press("f10")
        person.station.query_one(Registers).focus()
        person.station.query_one(Registers).bring("present_load")
        await person.press("enter")
        assert person.prompt.value == "read 1 present_load"
        assert "can only be read" in person.seen

    at_station(script)


def test_an_exchange_on_the_wire_is_looked_at_again(at_station):
    async def script(person):
        await person.enter("ping 1")
        await person.enter("ping 9")
        await person.press("f10", "f10")
        assert "silence" in person.seen
        person.station.query_one(Traffic).focus()
        await person.press("up", "enter")
        assert "-> FF FF 01 02 01 FB" in person.seen
        await person.press("f10", "f10")
        await person.click_text("PING 9")
        assert "-> FF FF 09 02 01 F3" in person.seen

    at_station(script)


# Servos and chains.


def test_the_servo_by_key_and_by_list_and_it_follows_what_is_said(at_station):
    async def script(person):
        await person.press("ctrl+o")
        assert person.station.servo == 2
        await person.press("escape", "n")
        assert person.station.servo == 3
        await person.enter("ping 1")
        assert person.station.servo == 1
        person.station.query_one("#servo", Choice).value = "3 XL430-W250-T"
        await person.pilot.pause()
        assert person.station.servo == 3
        await person.enter("write 3 id 7")
        assert person.station.servo != 3
        await person.enter("ping 7")
        assert "7 XL430-W250-T" in person.seen

    at_station(script)


def test_the_chain_by_key_by_click_and_by_command(at_station):
    async def script(person):
        await person.press("ctrl+g")
        assert "krsri-hexapod" in person.seen
        await person.press("down", "down", "enter")
        assert person.station.session.chain_text == "krsri-hexapod"
        assert len(person.station.session.ids()) == 18
        await person.click("#chain")
        await person.click_text("RX-24F:1")
        assert person.station.session.chain_text == "RX-24F:1"
        await person.enter("chain AX-12A:5-7")
        assert "AX-12A:5-7" in person.seen
        assert person.station.servo == 5
        await person.enter("chain AX-12A:5-400")
        assert person.station.session.ids() == [5, 6, 7]
        assert "■" in person.seen

    at_station(script)


# Faults.


def test_each_fault_is_turned_on_and_off_at_a_key(at_station):
    async def script(person):
        await person.press("f9")
        found = person.pilot.app.screen._found
        assert [fault.name for fault in found()] == list(KEYS)
        for name, key in KEYS.items():
            assert not any(fault.on for fault in found())
            await person.press(key)
            assert [fault.name for fault in found() if fault.on] == [name]
            assert any(line.strip(" │").startswith(f"{key}  on") for line in person.seen.splitlines())
            await person.press(key)
        assert not any(fault.on for fault in found())
        await person.press("escape")
        assert person.pilot.app.screen is person.station

    at_station(script)


def test_faults_by_click_and_what_they_do_to_an_answer(at_station):
    async def script(person):
        await person.click_text("F9 faults")
        assert isinstance(person.pilot.app.screen, Faults)
        await person.click(OptionList, offset=(8, 4))
        await person.press("escape")
        assert "echo" in person.seen
        await person.enter("echo off; drop 1")
        assert "drop 100%" in person.seen
        await person.enter("ping 1")
        assert "no intact answer" in person.seen

    at_station(script)


def test_a_silent_chain_is_told_and_brought_back_by_key_or_click(at_station):
    unpowered, dead = "its supply is off", "every servo is dead"

    async def script(person):
        ways = (lambda: person.press("ctrl+r"), lambda: person.click("#silence"))
        assert "power on" not in person.seen
        for lines, why, bring_back in (
            ("power off", unpowered, ways[0]),
            ("power 2", unpowered, ways[1]),
            ("fault 1 dead; fault 2 dead; fault 3 dead", dead, ways[0]),
        ):
            await person.enter(lines)
            assert f"The chain is silent: {why}" in person.seen
            assert "^r power on" in person.seen
            await bring_back()
            assert "The chain is silent" not in person.seen
            await person.enter("ping 1")
            assert "servo 1: ok" in person.seen

    at_station(script)


# The rest.


def test_a_long_answer_is_scrolled(at_station):
    async def script(person):
        await person.enter("table 1")
        await person.press("pagedown")
        assert person.station.query_one(Sheet).scroll_offset.y > 5
        await person.press("pageup")
        assert person.station.query_one(Sheet).scroll_offset.y == 0

    at_station(script)


def test_the_station_comes_back_as_it_was_left(at_station):
    async def leave(person):
        await person.enter("chain RX-24F:4,5")
        await person.press("ctrl+o", "f10", "ctrl+q")

    async def come_back(person):
        assert person.station.session.chain_text == "RX-24F:4,5"
        assert (person.station.servo, person.station.view) == (5, "registers")
        await person.press("up")
        assert person.prompt.value == "chain RX-24F:4,5"

    at_station(leave)
    at_station(come_back)


def test_what_was_kept_is_not_trusted(at_station):
    async def script(person):
        for state in (
            {},
            {"chain": "nonsense", "servo": "x", "view": 3, "history": 5},
            {"chain": 1, "history": [1, None]},
        ):
            person.station.restore(state)
            assert person.station.session.ids() == [1, 2, 3]
            assert (person.station.servo, person.station.view) == (1, "packet")

    at_station(script)


def test_another_language_and_another_size_change_nothing_but_the_looks(at_station):
    async def script(person):
        await person.enter("read 1 present_position")
        await person.type("ping 2")
        await person.press("ctrl+l")
        assert "tanpa" in person.seen or "bersih" in person.seen
        for size in ((60, 20), (200, 60), (80, 24)):
            await person.pilot.resize_terminal(*size)
            await person.pilot.pause()
            assert person.prompt.value == "ping 2"
            assert "FF FF 02 02 01 FA" in person.seen

    at_station(script)


@pytest.mark.parametrize("size", [(60, 20), (80, 24), (120, 40)])
def test_the_screen(at_station, lab, size):
    async def script(person):
        # A new chain, whose time has not begun yet.
        person.station.session.use_chain(DEFAULT_CHAIN, 1_000_000)
        await person.enter("write 1 goal_position 90deg")
        await person.type("read 1 pres")
        lab.check_screen("packet", person.pilot.app)

    at_station(script, size)
