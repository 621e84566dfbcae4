"""The Lessons station: a student who reads, errs, is helped, and solves, by key and by mouse."""

import json
import os
from pathlib import Path

import pytest
from textual.widgets import Input, OptionList

from kinlab.lessons.kinds import kind_of
from kinlab.lessons.progress import Progress, progress_folder
from kinlab.lessons.template import ENGLISH, new_lesson
from kinlab.tui.stations.gait.diagram import Diagram
from kinlab.tui.stations.lessons.bench import BytesBench, ChainBench, LegBench
from kinlab.tui.stations.lessons.browser import List, Search
from kinlab.tui.stations.lessons.desk import Desk
from kinlab.tui.stations.lessons.dialogs import Profiles, Sure
from kinlab.tui.stations.lessons.flow import Block
from kinlab.tui.stations.lessons.gait_bench import GaitBench
from kinlab.tui.stations.lessons.page import Page
from kinlab.tui.stations.lessons.reply import Options, Reply
from kinlab.tui.stations.lessons.steps import Steps
from kinlab.tui.stations.packet.prompt import Prompt
from kinlab.tui.stations.packet.registers import Registers
from kinlab.tui.stations.packet.tabs import Tabs
from kinlab.tui.widgets import Choice, Slider

KEYS = {" ": "space", "-": "minus", ".": "full_stop", ",": "comma", "[": "left_square_bracket"}


async def settle(pilot):
    """Until the core has answered and all is drawn."""
    await pilot.pause()
    while any(not worker.is_finished for worker in pilot.app.workers):
        await pilot.app.workers.wait_for_complete()
        await pilot.pause()


async def press(pilot, *keys):
    await pilot.press(*keys)
    await settle(pilot)


async def type_in(pilot, text):
    await press(pilot, *(KEYS.get(char, char) for char in text))


def keep(**state):
    """What the station kept from the last run."""
    home = Path(os.environ["KINLAB_HOME"])
    home.mkdir(parents=True, exist_ok=True)
    (home / "tui.json").write_text(json.dumps({"stations": {"lessons": state}}))


@pytest.fixture
def take(lab):
    """`take(script, lesson, step, size)`: Ani at a step of a lesson, or at the list."""

    def taken(script, lesson=None, step=0, size=(80, 24), **more):
        keep(profile="ani", **({"lesson": lesson, "step": step} if lesson else {}), **more)

        async def begin(pilot):
            await settle(pilot)
            await script(pilot, pilot.app.screen)

        return lab.drive(begin, "lessons", size)

    return taken


def replies(station):
    """A right reply to the exercise of now, and wrong ones."""
    kind = kind_of(station.seat.task)
    return kind.right(station.seat.task), kind.wrong(station.seat.task)


def now(station):
    return station.seat.sitting.standing(station.seat.name)


def verdict(station):
    return " ".join(block.markdown for block in station.query_one(Desk).verdict.blocks)


def kept():
    return Progress("ani")


# A student.


@pytest.mark.parametrize(
    ("lesson", "step"),
    [("leg-geometry", 1), ("leg-geometry", 2), ("leg-geometry", 4), ("protocol-1", 2)],
    ids=["number", "vector", "joints", "bytes"],
)
def test_an_answer_is_typed_marked_and_helped_until_it_is_right(take, lab, lesson, step):
    async def script(pilot, station):
        await press(pilot, "f10")
        assert isinstance(station.focused, Reply)
        right, wrong = replies(station)
        await type_in(pilot, "[bold")
        await press(pilot, "enter")
        assert now(station).tries == 0
        assert "[bold" in lab.text(pilot.app)
        await press(pilot, "escape")
        station.query_one(Reply).value = wrong[0]
        await press(pilot, "enter")
        assert now(station).tries == 1
        assert station.query_one(Reply).faults
        assert "^" in lab.text(pilot.app)
        assert verdict(station).startswith("Not yet.")
        await press(pilot, "enter")
        assert now(station).tries == 1
        await press(pilot, "f7")
        assert "Hint 1 of" in lab.text(pilot.app)
        station.query_one(Reply).value = right
        await settle(pilot)
        assert not station.query_one(Reply).faults
        await press(pilot, "enter")
        assert now(station).solved
        assert not station.query_one(Reply).faults
        assert "solved" in lab.text(pilot.app)
        before = station.seat.at
        await press(pilot, "enter")
        assert station.seat.at == before + 1

    take(script, lesson, step)
    assert [event.event for event in kept().events] == ["try", "hint", "try"]


def test_the_part_at_fault_is_marked_where_it_was_typed(take, lab):
    async def script(pilot, station):
        right, _ = replies(station)
        x, y, z = (round(float(v), 2) for v in right.split())
        station.query_one(Reply).value = f"{x} {-y} {z}"
        await press(pilot, "f10", "enter")
        [(start, end)] = station.query_one(Reply).faults
        assert station.query_one(Reply).value[start:end] == str(-y)
        rows = lab.rows(pilot.app)
        line = next(i for i, row in enumerate(rows) if row.startswith(" answer>"))
        assert rows[line + 1].index("^") == rows[line].index(str(-y))

    take(script, "leg-geometry", 2)


def test_a_choice_is_made_by_letter_arrows_and_click_and_its_reason_is_given(take, lab):
    async def script(pilot, station):
        await press(pilot, "f10")
        right, wrong = replies(station)
        await press(pilot, wrong[0])
        assert now(station).tries == 1
        rows = lab.rows(pilot.app)
        assert next(row for row in rows if f"{wrong[0]})" in row).strip().startswith("×")
        options = station.query_one(Options)
        options.highlighted = "abc".index(wrong[1])
        await press(pilot, "enter")
        assert now(station).tries == 2
        await pilot.click(Options, offset=(6, "abc".index(right)))
        await settle(pilot)
        assert now(station).solved
        assert verdict(station)

    take(script, "leg-geometry", 0)


def test_the_wrong_line_is_found_by_its_number(take):
    async def script(pilot, station):
        await press(pilot, "f10")
        right, wrong = replies(station)
        await press(pilot, wrong[0])
        assert pilot.app.current_mode == "lessons"
        assert now(station).tries == 1
        await press(pilot, right)
        assert now(station).solved

    take(script, "reach", 4)


def test_an_order_is_chosen_piece_by_piece_taken_back_and_typed(take, lab):
    async def script(pilot, station):
        right, wrong = replies(station)
        reply = station.query_one(Reply)
        options = station.query_one(Options)
        options.focus()
        for letter in wrong[0].split():
            await press(pilot, letter)
        assert reply.value == wrong[0]
        assert station.focused is reply
        await press(pilot, "enter")
        assert now(station).tries == 1
        assert "^" in lab.text(pilot.app)
        await press(pilot, "up")
        assert station.focused is options
        await pilot.click(Options, offset=(6, 0))
        await settle(pilot)
        assert len(reply.value.split()) == len(right.split()) - 1
        reply.focus()
        reply.value = ""
        await type_in(pilot, right)
        await press(pilot, "enter")
        assert now(station).solved

    take(script, "gaits", 2, size=(120, 40))


def test_lines_go_to_the_chain_of_the_exercise_until_its_state_is_reached(take, lab):
    async def script(pilot, station):
        await press(pilot, "f10")
        assert isinstance(station.focused, Prompt)
        await type_in(pilot, "nonsense")
        await press(pilot, "enter")
        assert "No command is named 'nonsense'" in lab.text(pilot.app)
        await press(pilot, "ctrl+g")
        assert now(station).tries == 0
        await type_in(pilot, "scan")
        await press(pilot, "enter", "ctrl+g")
        assert now(station).tries == 1
        assert "of servo" in verdict(station)
        await press(pilot, "ctrl+r")
        right, _ = replies(station)
        first, *others = right.split("\n")
        station.query_one(Prompt).value = first
        await press(pilot, "enter")
        assert station.seat.table.bench.lines == first.split("; ")
        await press(pilot, "ctrl+r")
        assert station.seat.table.bench.lines == []
        for line in (first, *others):
            station.query_one(Prompt).value = line
            await press(pilot, "enter")
        assert now(station).solved
        await press(pilot, "enter")
        assert station.seat.task is None

    take(script, "protocol-1", 6)


def test_a_bus_that_is_talked_to_as_a_real_one_shows_the_wire_alone(take):
    async def script(pilot, station):
        assert not station.query_one(Registers).display
        station.query_one(Prompt).value = "scan"
        station.query_one(Prompt).focus()
        await press(pilot, "enter")
        assert station.query_one(ChainBench).display

    take(script, "silent-bus", 2, size=(120, 40))


# Help on the way.


def test_hints_come_in_steps_and_go_back(take, lab):
    async def script(pilot, station):
        count = len(station.seat.task.hints)
        for number in range(1, count + 1):
            await press(pilot, "f7")
            assert f"Hint {number} of {count}" in lab.text(pilot.app)
        await press(pilot, "f12")
        assert f"Hint {count - 1} of {count}" in lab.text(pilot.app)
        await press(pilot, "f7", "f7")
        assert f"Hint 1 of {count}" in lab.text(pilot.app)
        assert now(station).hints == count

    take(script, "leg-geometry", 1)


def test_the_solution_comes_after_three_tries_and_the_exercise_counts_as_shown(take, lab):
    async def script(pilot, station):
        await press(pilot, "f10")
        for tries in range(1, 4):
            assert "F8 solution" not in lab.rows(pilot.app)[-1]
            station.query_one(Reply).value = str(tries)
            await press(pilot, "enter")
        assert "F8 solution" in lab.rows(pilot.app)[-1]
        await press(pilot, "f8")
        assert "The solution" in lab.text(pilot.app)
        assert now(station).status == "shown"
        assert "◆" in lab.rows(pilot.app)[2]

    take(script, "leg-geometry", 1)
    assert kept().standing("leg-geometry", 1, "distance").shown


# The way through a lesson.


def test_enter_reads_on_and_leads_to_the_exercise(take):
    async def script(pilot, station):
        page = station.query_one(Page)
        assert station.focused is page
        await press(pilot, "space")
        assert page.scroll_offset.y > 0
        for _ in range(4):
            await press(pilot, "enter")
        assert station.room.view == "exercise"

    take(script, "leg-geometry", 0)


def test_steps_and_views_by_key_and_by_mouse(take):
    async def script(pilot, station):
        await press(pilot, "f9")
        assert station.seat.at == 1
        await press(pilot, "ctrl+o")
        assert station.seat.at == 0
        await pilot.click(Steps, offset=(11, 0))
        await settle(pilot)
        assert station.seat.at == 2
        seen = []
        for _ in range(3):
            await press(pilot, "f10")
            seen.append(station.room.view)
        assert seen == ["exercise", "bench", "text"]
        await pilot.click(Tabs, offset=(10, 0))
        await settle(pilot)
        assert station.room.view == "exercise"
        await press(pilot, "ctrl+y")
        assert station.seat is None
        assert isinstance(station.focused, List)

    take(script, "leg-geometry", 0)


def test_the_end_of_a_lesson_says_how_it_went_and_leads_to_what_is_open(take, lab):
    async def script(pilot, station):
        assert "0 of 5 exercises solved" in lab.text(pilot.app) or station.query_one(Page).max_scroll_y
        await press(pilot, "f9")
        assert station.seat.at == 0

    take(script, "leg-geometry", 5)


def test_a_long_text_scrolls_while_the_answer_has_the_keys(take):
    async def script(pilot, station):
        assert isinstance(station.focused, Options)
        await press(pilot, "pagedown")
        assert station.query_one(Page).scroll_offset.y > 0
        await press(pilot, "pageup")
        assert station.query_one(Page).scroll_offset.y == 0

    take(script, "leg-geometry", 0, size=(120, 24))


def test_the_leg_beside_the_exercise_follows_what_is_typed_and_its_dials(take):
    async def script(pilot, station):
        leg = station.query_one(LegBench)
        assert leg.target is not None
        station.query_one(Reply).value = "0 30 -90"
        await settle(pilot)
        assert [round(float(v), 3) for v in leg.q] == [0.0, 0.524, -1.571]
        await pilot.click(leg.query(Slider).first(), offset=(2, 0))
        await settle(pilot)
        assert leg.q[0] < 0

    take(script, "leg-geometry", 4, size=(120, 40))


def test_bytes_are_taken_apart_while_they_are_typed_and_explained_when_all_is_right(take, lab):
    async def script(pilot, station):
        station.query_one(Reply).focus()
        await type_in(pilot, "ff ff 01 z")
        assert station.query_one(BytesBench).display
        assert "header" in lab.text(pilot.app)
        assert "begins" not in lab.text(pilot.app)
        station.query_one(Reply).value = replies(station)[0]
        await press(pilot, "enter")
        assert "a packet begins" in lab.text(pilot.app)

    take(script, "protocol-1", 2, size=(120, 40))


# The list.


def test_the_list_is_searched_filtered_and_opened(take, lab):
    async def script(pilot, station):
        await press(pilot, "slash")
        assert isinstance(station.focused, Search)
        await type_in(pilot, "crc")
        found = station.query_one(List)
        assert 0 < found.option_count < 5
        await press(pilot, "escape")
        assert found.option_count == len(station.course.lessons)
        await press(pilot, "home", "down", "enter")
        assert station.seat.sitting.lesson.id == list(station.course.lessons)[1]
        await press(pilot, "ctrl+y")
        await pilot.click(List, offset=(10, 0))
        await settle(pilot)
        assert station.seat.sitting.lesson.id == next(iter(station.course.lessons))

    take(script)


def test_only_open_lessons_are_listed_on_demand_and_next_goes_to_the_first(take, lab):
    progress = Progress("ani")
    progress.begin()

    async def script(pilot, station):
        sitting_done(station, "frames")
        await press(pilot, "o")
        assert station.query_one(List).option_count == len(station.course.lessons) - 1
        await press(pilot, "o")
        assert lab.rows(pilot.app)[2].startswith(" ●")
        await press(pilot, "f9")
        assert station.seat.sitting.lesson.id == "leg-geometry"

    take(script)


def sitting_done(station, name):
    from kinlab.lessons import Sitting

    sitting = Sitting(station.course.lesson(name), station.progress, "en")
    for task in sitting.tasks.values():
        sitting.check(task.exercise.id, kind_of(task).right(task))


def test_a_lesson_begins_anew_after_a_question(take):
    async def script(pilot, station):
        sitting_done(station, "frames")
        await press(pilot, "x")
        assert isinstance(pilot.app.screen, Sure)
        await press(pilot, "enter")
        assert station.progress.events[-1].event == "try"
        await press(pilot, "x")
        await press(pilot, "y")
        assert station.progress.events[-1].event == "reset"

    take(script)


def test_another_profile_has_numbers_and_progress_of_its_own(take, lab):
    async def script(pilot, station):
        await press(pilot, "w")
        assert isinstance(pilot.app.screen, Profiles)
        pilot.app.screen.query_one(Input).focus()
        await type_in(pilot, "a b")
        await press(pilot, "enter")
        assert "A name has letters" in lab.text(pilot.app)
        pilot.app.screen.query_one(Input).value = "budi"
        await press(pilot, "enter")
        assert station.progress.profile == "budi"
        await press(pilot, "w")
        assert isinstance(pilot.app.screen.focused, OptionList)
        await press(pilot, "escape")
        assert "budi" in lab.rows(pilot.app)[1]
        pilot.app.keep()

    app = take(script)
    assert app.settings.stations["lessons"]["profile"] == "budi"


# What is kept, and what goes wrong.


def test_the_language_changes_in_the_middle_of_an_exercise(take, lab):
    async def script(pilot, station):
        await press(pilot, "f10", "ctrl+l")
        await settle(pilot)
        text = lab.text(pilot.app)
        assert station.seat.sitting.language == "id"
        assert "Soal 2 dari 5" in text
        assert "jawaban>" in text
        station.query_one(Reply).value = "1"
        await press(pilot, "enter")
        assert verdict(station).startswith("Belum.")

    take(script, "leg-geometry", 1)


def test_the_place_in_the_lesson_is_kept_between_runs(take):
    async def script(pilot, station):
        assert station.seat.at == 3
        await press(pilot, "f9")
        pilot.app.keep()

    app = take(script, "leg-geometry", 3)
    assert app.settings.stations["lessons"] == {"profile": "ani", "lesson": "leg-geometry", "step": 4}


def test_what_was_kept_and_makes_no_sense_is_passed_over(take):
    async def script(pilot, station):
        assert station.progress is not None

    for lesson, step in (("nowhere", 3), ("frames", 99)):
        take(script, lesson, step)


def test_damaged_progress_is_named_and_what_can_be_read_goes_on(take, lab):
    progress = Progress("ani")
    progress.begin()
    path = progress_folder() / "ani.jsonl"
    path.write_bytes(path.read_bytes() + b'{"at": "half a li')

    async def script(pilot, station):
        assert "damaged" in lab.text(pilot.app).replace("\n", "")

    take(script, size=(200, 40))


def test_a_lesson_that_cannot_be_read_is_named_and_the_others_work(take, lab, monkeypatch):
    from kinlab.lessons import course

    read = course.read_lesson

    def broken(folder):
        if folder.name == "frames":
            raise course.LessonError("frames/en.md:7: no [such] field [/] here")
        return read(folder)

    monkeypatch.setattr(course, "read_lesson", broken)

    async def script(pilot, station):
        await press(pilot, "end")
        assert "frames/en.md:7: no [such] field [/] here" in lab.text(pilot.app)
        await press(pilot, "enter")
        assert station.seat is None

    take(script)


# What it looks like.


@pytest.mark.parametrize("size", [(60, 20), (80, 24), (120, 40)])
def test_the_screens(take, lab, size):
    async def script(pilot, station):
        await press(pilot, "down")
        lab.check_screen("lessons", pilot.app)
        station.open_lesson("leg-geometry", 2)
        await settle(pilot)
        if size[0] < 120:
            lab.check_screen("lessons-text", pilot.app)
            await press(pilot, "f10")
        await type_in(pilot, "1 2,5 3")
        await press(pilot, "enter", "f7")
        lab.check_screen("lessons-exercise", pilot.app)

    take(script, size=size)


def test_it_resizes_in_the_middle_of_an_answer(take, lab):
    async def script(pilot, station):
        await press(pilot, "f10")
        await type_in(pilot, "12")
        for size in ((120, 40), (80, 40), (200, 60), (60, 20), (80, 24)):
            await pilot.resize_terminal(*size)
            await settle(pilot)
            assert "answer> 12" in lab.text(pilot.app)

    take(script, "leg-geometry", 1)


def test_without_colours_and_braille_it_says_the_same(take, lab, monkeypatch):
    monkeypatch.setenv("KINLAB_ASCII", "1")
    monkeypatch.setenv("NO_COLOR", "1")

    async def script(pilot, station):
        assert not any("\u2800" <= char <= "\u28ff" for char in lab.text(pilot.app))
        station.query_one(Reply).value = "1"
        station.query_one(Reply).focus()
        await press(pilot, "enter")
        assert "x Not yet." in lab.text(pilot.app)

    take(script, "leg-geometry", 1, size=(120, 40))


def test_every_action_of_the_palette_can_be_run_at_the_list_and_in_any_exercise(take):
    async def script(pilot, station):
        for lesson, step in (("leg-geometry", 1), ("protocol-1", 6), ("", 0)):
            for run in (run for action in station.ACTIONS for run in action.runs):
                if lesson and station.seat is None:
                    station.open_lesson(lesson, step)
                    await settle(pilot)
                await station.run_action(run)
                if pilot.app.screen is not station:
                    await press(pilot, "escape")
            await settle(pilot)
            station.action_contents()

    take(script)


def test_the_text_of_a_lesson_is_shown_and_never_obeyed(take, lab):
    async def script(pilot, station):
        station.room.query_one(Page).flow.put(
            Block("[red]not red[/] [/nothing] **bold** [@click=app.quit]x[/]")
        )
        await settle(pilot)
        assert "[red]not red[/] [/nothing] bold [@click=app.quit]x[/]" in lab.text(pilot.app)

    take(script, "leg-geometry", 0)


# What stands beside.


def test_a_lesson_on_gaits_stands_beside_their_diagram(take, lab):
    async def script(pilot, station):
        assert station.seat.instrument == "gait"
        bench = station.query_one(GaitBench)
        drawn = station.seat.task.values["gait"]
        assert bench.cycle.walk.gait.name == drawn
        assert f"margin {bench.cycle.state.static[0] * 1000:.1f} mm" in lab.text(pilot.app)
        bench.query_one(Diagram).focus()
        await press(pilot, "right", "right", "left")
        assert bench.cycle.frame_at(bench.t) == 1
        await pilot.click(Diagram, offset=(30, 1))
        await settle(pilot)
        assert bench.t / bench.cycle.walk.period == pytest.approx(0.5, abs=0.1)
        bench.query_one(Choice).value = "wave"
        await settle(pilot)
        assert bench.cycle.walk.gait.name == "wave"
        assert bench.t == 0.0
        await press(pilot, "f9")
        assert bench.cycle.walk.gait.name == drawn
        assert "top, cell" in lab.text(pilot.app)
        assert "stance" in lab.text(pilot.app)
        await press(pilot, "ctrl+l")
        assert "atas, sel" in lab.text(pilot.app)
        assert "menumpu" in lab.text(pilot.app)

    take(script, "gaits", 0, (130, 40))


def test_a_word_is_looked_up(take, lab):
    async def script(pilot, station):
        await press(pilot, "f11")
        await type_in(pilot, "femu")
        shown = lab.text(pilot.app)
        assert "femur" in shown
        assert "thigh" in shown
        await type_in(pilot, "zzz")
        assert "thigh" not in lab.text(pilot.app)
        await press(pilot, *["backspace"] * 7)
        await press(pilot, "down", "down", "up", "escape")
        assert pilot.app.screen is station

    take(script, "leg-geometry", 1, (60, 20))


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("{answer:.1f}", "{answr:.1f}", "no value is named 'answr'"),
        ('kind = "number"\nunit = "mm"\ntolerance = 0.5', 'kind = "state"', "needs a Goal"),
    ],
)
def test_a_lesson_of_ones_own_that_fails_is_named_and_not_opened(
    take, lab, tmp_path, monkeypatch, old, new, message
):
    page = new_lesson("mine", tmp_path)[0]
    without = ENGLISH[: ENGLISH.index("\n[feedback]")] + ENGLISH[ENGLISH.index("```\n\nEnd") :]
    page.write_text(without.replace(old, new))
    (page.parent / "id.md").unlink()
    monkeypatch.setenv("KINLAB_LESSONS", str(tmp_path))

    async def script(pilot, station):
        station.open_lesson("mine")
        await settle(pilot)
        assert station.seat is None
        assert "mine/en.md:" in lab.text(pilot.app)
        assert message in lab.text(pilot.app)
        station.open_lesson("leg-geometry")
        await settle(pilot)
        assert station.seat.name

    take(script, size=(160, 30))


def test_the_last_thing_that_a_chain_said_is_in_sight(take, lab):
    async def script(pilot, station):
        for line in ("wait 0.1", "ping 1", "help", "nonsense", "done", "ping 2"):
            await type_in(pilot, line)
            await press(pilot, "enter")
            talk = station.query_one("#talk")
            said = [part for _, part in station.seat.table.talk[-2]]
            assert "".join(said).strip()[:40] in lab.text(pilot.app), line
            assert talk.scroll_offset.y == talk.max_scroll_y, line

    take(script, "silent-bus", 1, (130, 40))
