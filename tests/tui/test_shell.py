"""What every station has: keys, help, palette, languages, themes, settings, and a notice where there is no room."""

import asyncio
import gc
import json
import os
import signal
import sys
import threading

import pytest
from textual.command import CommandList
from textual.widgets import Static

from kinlab.errors import FileError
from kinlab.guests import GUEST
from kinlab.language import LANGUAGES, words_of
from kinlab.tui.actions import SHELL, bindings
from kinlab.tui.app import KinlabApp, _station, run
from kinlab.tui.help import Help
from kinlab.tui.palette import Actions
from kinlab.tui.station import Station
from kinlab.tui.stations import STATIONS
from kinlab.tui.widgets import NumberField


@pytest.fixture(params=STATIONS)
def station(request) -> str:
    return request.param


def test_every_action_has_a_label_and_a_help_in_every_language(station):
    screen = _station(station)()
    assert isinstance(screen, Station)
    own, shell = words_of(screen.words).entries, words_of("kinlab.tui").entries
    for action in (*screen.ACTIONS, *SHELL):
        for part in ("label", "help"):
            entry = own.get(f"action.{action.id}.{part}") or shell[f"action.{action.id}.{part}"]
            assert all(entry.values())


def test_keys_that_a_browser_keeps_for_itself_are_not_offered_to_a_guest(monkeypatch):
    keys = {binding.key for binding in bindings(SHELL)}
    monkeypatch.setenv(GUEST, "1")
    assert keys - {binding.key for binding in bindings(SHELL)} == {"ctrl+n", "ctrl+t"}


def test_the_line_of_keys_holds_help_and_quit_at_every_size_and_focus(lab, station):
    async def script(pilot):
        for size in ((60, 20), (80, 24), (200, 60)):
            await pilot.resize_terminal(*size)
            for key in ("tab", "escape"):
                await pilot.press(key)
                await pilot.pause()
                line = lab.rows(pilot.app)[-1]
                assert "? help" in line
                assert line.endswith("^q quit")

    lab.drive(script, station)


def test_the_bar_names_the_keys_that_open_the_stations_now(lab):
    async def script(pilot):
        assert "F2 Robot  F3 Gait" in lab.rows(pilot.app)[0]
        await pilot.press("escape")
        await pilot.pause()
        assert "1 Robot  2 Gait" in lab.rows(pilot.app)[0]

    lab.drive(script, "robot")


def test_a_station_is_brought_in_beside_the_event_loop_and_the_last_wish_counts(lab, monkeypatch):
    threads = []
    monkeypatch.setattr(_station("gait"), "prepare", lambda: threads.append(threading.current_thread()))

    async def script(pilot):
        await asyncio.gather(*map(pilot.app.open_station, ("gait", "packet")))
        assert pilot.app.current_mode == "packet"
        await pilot.press("f3")
        assert pilot.app.current_mode == "gait"

    lab.drive(script, "robot")
    assert threads
    assert threading.main_thread() not in threads


def test_the_bar_has_room_for_every_station_at_every_size_in_every_language(lab):
    async def script(pilot):
        for _ in LANGUAGES:
            await pilot.press("ctrl+l")
            await pilot.pause()
            bar = lab.rows(pilot.app)[0]
            assert all(
                words_of("kinlab.tui").say(pilot.app.tongue, f"station.{name}") in bar for name in STATIONS
            )

    lab.drive(script, "robot", (60, 20))


def test_the_question_mark_asks_for_help_in_the_middle_of_a_number(lab):
    async def script(pilot):
        await pilot.press("7", "question_mark")
        await pilot.pause()
        assert isinstance(pilot.app.screen, Help)
        await pilot.press("escape", "5")
        await pilot.pause()
        assert pilot.app.focused.value == "75"

    lab.drive(script, "robot")


def test_a_terminal_too_small_is_told_the_size_it_needs_and_goes_on_when_it_grows(lab, station):
    async def script(pilot):
        await pilot.resize_terminal(40, 12)
        await pilot.pause()
        assert "40 x 12" in lab.text(pilot.app)
        assert "60 x 20" in lab.text(pilot.app)
        await pilot.resize_terminal(80, 24)
        await pilot.pause()
        assert "^q quit" in lab.text(pilot.app)

    lab.drive(script, station)


def test_numbers_are_in_sight_when_a_terminal_that_was_too_small_grows(lab):
    async def script(pilot):
        await pilot.resize_terminal(80, 24)
        await pilot.pause()
        fields = [field for field in pilot.app.screen.query(NumberField) if field.region]
        assert fields
        for field in fields:
            x, y, width, _ = field.region
            assert lab.rows(pilot.app)[y][x : x + width].strip() == field.value

    lab.drive(script, "robot", (40, 10))


def test_help_lists_every_key_and_escape_closes_it(lab, station):
    async def script(pilot):
        await pilot.press("f1")
        await pilot.pause()
        said = " ".join(str(part.content) for part in pilot.app.screen.query(Static))
        speaker = pilot.app.screen.station
        for action in speaker.all_actions():
            assert speaker.say(f"action.{action.id}.help").split()[0] in said
        await pilot.press("escape")
        assert isinstance(pilot.app.screen, Station)

    lab.drive(script, station)


def test_the_language_changes_at_run_time(lab, station):
    async def script(pilot):
        await pilot.press("ctrl+l")
        await pilot.pause()
        assert "bantuan" in lab.rows(pilot.app)[-1]

    app = lab.drive(script, station)
    assert app.tongue == "id"


def test_theme_and_language_are_kept_until_the_next_run(lab):
    async def script(pilot):
        await pilot.press("ctrl+t")
        await pilot.press("ctrl+l")
        await pilot.press("ctrl+q")

    first = lab.drive(script)
    kept = json.loads((first.folder / "tui.json").read_text())
    assert (kept["theme"], kept["language"]) == ("kinlab-light", "id")


@pytest.mark.parametrize("damaged", ['{"theme": 7', "[]", "[" * 100_000], ids=["cut", "list", "deep"])
def test_damaged_settings_are_put_aside_and_named(lab, tmp_path, damaged):
    folder = tmp_path / "state"
    folder.mkdir()
    (folder / "tui.json").write_text(damaged)

    async def script(pilot):
        assert pilot.app.theme == "kinlab-dark"

    app = lab.drive(script)
    assert app.set_aside == folder / "tui.damaged"
    assert app.set_aside.read_text() == damaged


def test_a_robots_file_that_cannot_be_read_is_named_before_anything_opens(tmp_path, monkeypatch, capsys):
    broken = tmp_path / "robots.yaml"
    broken.write_text("robots: [\n")
    monkeypatch.setenv("KINLAB_ROBOTS", str(broken))
    assert run() == 2
    assert capsys.readouterr().err.startswith(f"kinlab: {broken}:")


def test_a_folder_without_lessons_is_named_before_anything_opens(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("KINLAB_LESSONS", str(tmp_path))
    assert run() == 2
    assert capsys.readouterr().err == f"kinlab: {tmp_path}: holds no lessons: folders with a file en.md\n"


def test_a_robots_file_that_breaks_meanwhile_is_no_mistake_of_kinlab(lab, tmp_path, monkeypatch, capsys):
    async def script(pilot):
        broken = tmp_path / "robots.yaml"
        broken.write_text("robots: [\n")
        monkeypatch.setenv("KINLAB_ROBOTS", str(broken))
        await pilot.press("f3")
        await pilot.pause()

    with pytest.raises(FileError):
        lab.drive(script)
    told = capsys.readouterr().err
    assert "not valid YAML" in told
    assert "mistake" not in told
    assert not list((tmp_path / "state").glob("crash-*"))


def test_a_crash_report_does_not_tell_whose_machine_it_was(lab, tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("HOME", str(tmp_path))

    async def script(pilot):
        pilot.app.action_theme = lambda: (tmp_path / "thesis").read_text()
        await pilot.press("escape", "ctrl+t")
        await pilot.pause()

    with pytest.raises(FileNotFoundError):
        lab.drive(script)
    assert "report it" in capsys.readouterr().err
    (report,) = (tmp_path / "state").glob("crash-*")
    assert "~/thesis" in report.read_text()
    assert str(tmp_path) not in report.read_text()


@pytest.mark.skipif(sys.platform == "win32", reason="there are no such signals")
def test_a_terminal_that_is_closed_keeps_what_was_chosen(lab, tmp_path):
    async def script(pilot):
        await pilot.press("ctrl+t")
        os.kill(os.getpid(), signal.SIGHUP)
        await pilot.pause()

    lab.drive(script)
    assert json.loads((tmp_path / "state" / "tui.json").read_text())["theme"] == "kinlab-light"


def test_going_to_and_fro_between_stations_keeps_nothing_more(lab):
    async def script(pilot):
        for _ in range(len(STATIONS)):
            await pilot.press("ctrl+n")
            await pilot.pause()
        kept = gc.get_freeze_count()
        assert kept
        for _ in range(len(STATIONS)):
            await pilot.press("ctrl+n")
            await pilot.pause()
        assert gc.get_freeze_count() <= kept
        assert gc.isenabled()

    lab.drive(script)


def test_the_palette_finds_an_action_by_its_name(lab):
    async def script(pilot):
        await pilot.press("ctrl+p")
        await pilot.press(*"dark or")
        hits = pilot.app.screen.query_one(CommandList)
        await pilot.app.workers.wait_for_complete()
        await lab.until(
            pilot, lambda: hits.highlighted == 0 and "dark or light" in str(hits.options[0].prompt)
        )
        await pilot.press("enter")
        await lab.until(pilot, lambda: pilot.app.theme == "kinlab-light")

    lab.drive(script)


def test_the_palette_holds_every_action_of_the_station(lab, station):
    async def script(pilot):
        found = Actions(pilot.app.screen)
        titles = [title for title, _, _ in found._entries()]
        for action in pilot.app.screen.all_actions():
            label = pilot.app.screen.say(f"action.{action.id}.label")
            assert action.id == "palette" or any(label in title for title in titles)

    lab.drive(script, station)


def test_a_mistake_of_our_own_leaves_a_report_and_no_page_of_code(lab, capsys):
    async def script(pilot):
        pilot.app.call_later(lambda: 1 / 0)
        await pilot.pause()

    with pytest.raises(ZeroDivisionError):
        lab.drive(script)
    said = capsys.readouterr().err
    assert "KinLab has stopped because of a mistake of its own: ZeroDivisionError" in said
    assert "Please report it" in said
    assert "Traceback" not in said


def test_an_answer_that_comes_after_somebody_has_left_is_no_mistake(lab, capsys):
    async def script(pilot):
        async def answer():
            while pilot.app.is_running:
                await asyncio.sleep(0)
            pilot.app.screen.query_one("Nothing")

        pilot.app.screen.run_worker(answer())

    lab.drive(script)
    assert not capsys.readouterr().err


def test_ctrl_c_leaves_cleanly(lab):
    async def script(pilot):
        await pilot.press("ctrl+c")
        await pilot.pause()

    assert lab.drive(script).return_code == 0


def test_a_bare_kinlab_opens_the_laboratory_in_a_terminal_only(monkeypatch, capsys):
    from kinlab.cli import main

    opened = []
    monkeypatch.setattr("kinlab.tui.app.run", lambda: opened.append(True) or 0)
    for terminal in (False, True):
        monkeypatch.setattr("sys.stdin.isatty", lambda terminal=terminal: terminal, raising=False)
        monkeypatch.setattr("sys.stdout.isatty", lambda terminal=terminal: terminal, raising=False)
        monkeypatch.setenv("TERM", "xterm")
        with pytest.raises(SystemExit) as ended:
            main([])
        assert ended.value.code in (0, None)
        assert bool(opened) is terminal
    assert "Commands:" in capsys.readouterr().out


def test_settings_that_cannot_be_written_are_told_after_leaving_and_harm_nothing(lab, tmp_path):
    (tmp_path / "state").write_text("a file where a folder should be")

    async def script(pilot):
        await pilot.press("ctrl+q")

    app = lab.drive(script)
    assert "state" in app.unkept


def test_what_could_not_be_kept_is_told_in_the_language_that_was_spoken(tmp_path, monkeypatch, capsys):
    (tmp_path / "state").write_text("a file where a folder should be")
    monkeypatch.setattr(KinlabApp, "run", lambda app: setattr(app, "tongue", "id") or app.keep())
    assert run() == 0
    told = capsys.readouterr().err
    assert told.startswith("kinlab: pilihan Anda tidak tersimpan")
    assert "state" in told
