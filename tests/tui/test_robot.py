"""The Robot station: every action by key and by mouse, what is typed, and what it shows."""

import asyncio

import numpy as np
import pytest
from textual.widgets import Static

from kinlab.errors import KinlabError
from kinlab.robots import load_robot
from kinlab.tui.stations.robot.form import Form
from kinlab.tui.widgets import Choice, Dial, Picture


async def settle(pilot):
    """Until the core has answered."""
    await pilot.pause()
    await pilot.app.workers.wait_for_complete()
    await pilot.pause()


@pytest.fixture
def run(lab):
    """`run(script, size=...)`: a script with the station, which has its first answer and no field in focus."""

    def opened(script, size=(80, 24)):
        async def begin(pilot):
            await settle(pilot)
            await pilot.press("escape")
            await script(pilot, pilot.app.screen)

        return lab.drive(begin, "robot", size)

    return opened


def dial(station, i):
    return list(station.query(Dial))[i]


def shown_rows(station):
    return str(station.query_one("#rows", Static).content)


# Typing.


def test_a_target_is_typed_with_comma_or_point_and_any_unit(run):
    async def script(pilot, station):
        dial(station, 0).field.focus()
        for typed, metres in (
            ("80", 0.08),
            ("81,5", 0.0815),
            ("8 cm", 0.08),
            ("0.079m", 0.079),
            ("+80.0 mm", 0.08),
        ):
            dial(station, 0).field.value = typed
            await settle(pilot)
            np.testing.assert_allclose(station.answer.path.answer.target, [metres, 0.010, -0.046])

    run(script)


def test_what_is_typed_first_takes_the_place_of_the_number(lab):
    async def script(pilot):
        await settle(pilot)
        await pilot.press("9", "0")
        await settle(pilot)
        assert pilot.app.screen.target[0] == pytest.approx(0.090)

    lab.drive(script)


def test_what_is_typed_while_an_answer_comes_is_not_lost(run):
    async def script(pilot, station):
        field, before = dial(station, 0).field, station.answer
        field.focus()
        field.value = "90"
        while field.number != 90:
            await asyncio.sleep(0)
        station._show(before)
        await settle(pilot)
        assert station.target[0] == pytest.approx(0.090)

    run(script)


def test_the_dials_are_those_of_angles_as_soon_as_the_path_begins_there(run):
    async def script(pilot, station):
        station.action_begin()
        assert station.query_one(Form).angles(3) == pytest.approx(station.angles)

    run(script)


def test_what_is_no_number_is_explained_and_the_last_good_state_stays(run):
    async def script(pilot, station):
        field = dial(station, 0).field
        field.focus()
        for typed in ("", "-", "[", "[/]", "[bold", "1..2", "nan", "1e999", "ä", "3 deg"):
            field.value = typed
            await settle(pilot)
            assert field.has_class("-wrong"), typed
            assert station.query_one("Message").kind == "bad"
            np.testing.assert_allclose(station.answer.path.answer.target, [0.075, 0.010, -0.046])
        await pilot.press("escape")
        assert field.value == "75"
        assert not field.has_class("-wrong")

    run(script)


def test_a_target_out_of_reach_says_why_and_where_the_nearest_point_is(run, lab):
    async def script(pilot, station):
        dial(station, 0).field.value = "300"
        await settle(pilot)
        seen = lab.text(pilot.app)
        assert "Not reached: out of reach" in seen
        assert "Nearest: (143.3, 4.8, -19.8) mm" in seen

    run(script)


def test_angles_beyond_a_limit_are_named(run, lab):
    async def script(pilot, station):
        await pilot.press("f7")
        dial(station, 0).field.value = "80"
        await settle(pilot)
        assert "coxa would stand at 80 deg, and its limit is 60" in " ".join(lab.text(pilot.app).split())

    run(script)


# What is shown.


def test_no_number_is_cut_where_a_limb_has_many_joints(run):
    async def script(pilot, station):
        station.take(station.robots["eros"])
        await settle(pilot)
        rows = shown_rows(station).splitlines()
        assert "z -235" in rows[0]
        pose = station.answer.path.pose
        assert rows[2].split()[1:7] == [f"{angle:.0f}" for angle in np.degrees(pose.q) + 0.0]

    run(script, (60, 20))


def test_a_limb_of_any_number_of_joints_has_a_dial_for_each(lab, tmp_path, monkeypatch):
    joints = "".join(f"        - {{name: j{i}, axis: {'zyx'[i % 3]}, link: {{x: a}}}}\n" for i in range(9))
    file = tmp_path / "mine.yaml"
    file.write_text(
        f"robots:\n  worm:\n    arm:\n      a: 60\n      joints:\n{joints}"
        "      members:\n        arm: {at: [0, 0, 0]}\n"
    )
    monkeypatch.setenv("KINLAB_ROBOTS", str(file))

    async def script(pilot):
        station = pilot.app.screen
        station.take(station.robots["worm"])
        await settle(pilot)
        await pilot.press("escape", "f7")
        dial(station, 8).field.value = "20"
        await settle(pilot)
        assert station.answer.path.answer.poses[0].q[8] == pytest.approx(np.radians(20))
        await pilot.press("f7", "r")
        await settle(pilot)
        assert [dial.display for dial in station.query(Dial)] == [True] * 3 + [False] * 6

    lab.drive(script)


def test_the_path_of_table_1_stands_there_from_target_to_foot(run):
    async def script(pilot, station):
        rows = shown_rows(station)
        for part in ("7.595", "82.405", "151.725", "67.159", "938", "1726", "764"):
            assert part in rows
        sent = bytes.fromhex("FFFFFD00FE160083740004000 1AA030000 02BE060000 03FC020000".replace(" ", ""))
        assert station.answer.path.arrival.sent.startswith(sent)
        assert station.answer.path.arrival_error_m < 1e-3

    run(script)


def test_each_robot_shows_what_it_has(run):
    async def script(pilot, station):
        for robot, words in (
            ("udiebot", "these servos take pulses"),
            ("eros", "the paper names no servos"),
            ("krsri-hexapod", "FF FF FE 0D"),
        ):
            station.query_one("#robot", Choice).value = robot
            await settle(pilot)
            assert words in shown_rows(station)

    run(script)


def test_as_printed_stands_beside_corrected(run):
    async def script(pilot, station):
        station.take(load_robot("udiebot"))
        await settle(pilot)
        rows = shown_rows(station)
        assert "its tables" in rows
        assert "21.779" in rows

    run(script)


# Keys.


def test_arrows_move_the_tip_in_the_view_from_the_side(run):
    async def script(pilot, station):
        for key, moved in (
            ("left", (-1, 0)),
            ("right", (1, 0)),
            ("up", (0, 1)),
            ("down", (0, -1)),
            ("shift+up", (0, 10)),
        ):
            before = station.target
            await pilot.press(key)
            await settle(pilot)
            outwards = np.hypot(*station.target[:2]) - np.hypot(*before[:2])
            np.testing.assert_allclose(
                [outwards, station.target[2] - before[2]], np.array(moved) / 1000, atol=2e-4
            )

    run(script)


def test_arrows_move_the_tip_in_the_view_from_the_top_when_it_has_the_focus(run):
    async def script(pilot, station):
        station.query(Picture).last().focus()
        await pilot.press("up", "right")
        await settle(pilot)
        np.testing.assert_allclose(station.target, [0.076, 0.011, -0.046], atol=1e-9)

    run(script)


def test_a_view_shows_that_it_has_the_focus(run):
    async def script(pilot, station):
        picture = station.query(Picture).first()
        for focused in (True, False):
            station.set_focus(picture if focused else None)
            await pilot.pause()
            assert bool(next(iter(picture.render_line(0))).style.reverse) is focused

    run(script)


def test_f7_begins_at_angles_and_back_at_the_place_where_they_led(run):
    async def script(pilot, station):
        await pilot.press("f7")
        await settle(pilot)
        dial(station, 1).field.value = "20"
        await settle(pilot)
        assert station.answer.path.answer.poses[0].name == "as given"
        reached = station.answer.path.answer.target
        await pilot.press("f7")
        await settle(pilot)
        assert station.angles is None
        np.testing.assert_allclose(station.target, reached)

    run(script)


def test_f8_sends_the_other_solution_to_the_servos(run):
    async def script(pilot, station):
        dial(station, 2).field.value = "-10"
        await settle(pilot)
        first = station.answer.path.pose.name
        await pilot.press("f8")
        await settle(pilot)
        second = station.answer.path.pose.name
        assert {first, second} <= {"knee-up", "knee-down"}
        names = [pose.name for pose in station.answer.path.answer.poses if pose.within_limits]
        assert second == names[1 % len(names)]

    run(script)


def test_letters_take_the_next_limb_robot_and_frame(run):
    async def script(pilot, station):
        await pilot.press("l", "r", "f")
        await settle(pilot)
        assert (station.robot.name, station.limb.name, station.frame) == ("krsri-hexapod", "R1", "body")
        assert "mm body" in shown_rows(station)

    run(script)


def test_keys_pressed_faster_than_the_core_answers_do_no_harm(run):
    async def script(pilot, station):
        for _ in range(3):
            for action in (
                "next_robot",
                "begin",
                "next_limb",
                "next_solution",
                "begin",
                "next_frame",
                "home",
            ):
                await station.run_action(action)
        await settle(pilot)
        assert station.answer.question.limb is station.limb
        assert station.answer.question.robot is station.robot

    run(script)


def test_power_off_says_so_and_on_again_the_servos_answer(run, lab):
    async def script(pilot, station):
        await pilot.press("o")
        await settle(pilot)
        assert "o switches the chain on" in lab.text(pilot.app)
        await pilot.press("o")
        await settle(pilot)
        assert station.answer.path.arrival.answered

    run(script)


def test_the_printed_solution_and_the_limits_are_drawn_or_not(run):
    async def script(pilot, station):
        station.take(load_robot("udiebot"))
        await settle(pilot)
        picture = station.query(Picture).first()
        plain = picture.canvas.text()
        await pilot.press("p")
        await pilot.pause()
        ghost = picture.canvas.text()
        await pilot.press("p", "b")
        await pilot.pause()
        assert len({plain, ghost, picture.canvas.text()}) == 3

    run(script)


def test_the_limb_is_mirrored_to_a_viewer_and_a_missing_one_is_told(run, lab, monkeypatch):
    shown = []

    class Viewer:
        def __init__(self, robot):
            self.robot = robot

        def show(self, angles):
            shown.append(angles)

        def close(self):
            shown.append("closed")

    def missing(robot):
        raise KinlabError("no viewer answers")

    async def script(pilot, station):
        monkeypatch.setattr("kinlab.scene.Mirror", missing)
        await pilot.press("m")
        await settle(pilot)
        assert "no viewer answers" in lab.text(pilot.app)
        assert not station.mirrored
        monkeypatch.setattr("kinlab.scene.Mirror", Viewer)
        await pilot.press("m", "up")
        await settle(pilot)
        np.testing.assert_allclose(shown[-1]["R1"], station.answer.path.arrival.q)
        await pilot.press("m")
        await settle(pilot)
        assert shown[-1] == "closed"

    run(script)


def test_a_guest_reaches_no_viewer(run, lab, monkeypatch):
    monkeypatch.setenv("KINLAB_GUEST", "1")

    async def script(pilot, station):
        await pilot.press("m")
        await settle(pilot)
        assert "out of reach of a session in the browser" in " ".join(lab.text(pilot.app).split())

    run(script)


def test_home_goes_back_to_where_the_paper_begins(run):
    async def script(pilot, station):
        await pilot.press("up", "up", "h")
        await settle(pilot)
        np.testing.assert_allclose(station.target, [0.075, 0.010, -0.046])

    run(script)


def test_a_narrow_terminal_shows_one_view_and_v_the_other(run):
    async def script(pilot, station):
        side, top = station.query(Picture)
        assert side.display
        assert not top.display
        await pilot.press("v")
        await pilot.pause()
        assert top.display
        assert not side.display

    run(script, (60, 20))


# Mouse.


def test_a_click_in_a_view_sends_the_tip_there(run):
    async def script(pilot, station):
        side = station.query(Picture).first()
        before = station.target
        await pilot.click(side, offset=(side.size.width // 2 + 3, side.size.height // 2 + 2))
        await settle(pilot)
        assert not np.allclose(station.target, before)
        tip = station.answer.side.flat(station.target[None])[0]
        x, y = side.canvas.place(side.size.width // 2 + 3, side.size.height // 2 + 1)
        assert tip == pytest.approx((x, y), abs=0.2)

    run(script)


def test_a_slider_is_dragged_and_turned_by_the_wheel(run):
    async def script(pilot, station):
        slider = dial(station, 2).slider
        await pilot.mouse_down(slider, offset=(1, 0))
        await pilot.hover(slider, offset=(slider.size.width - 2, 0))
        await pilot.mouse_up(slider, offset=(slider.size.width - 2, 0))
        await settle(pilot)
        assert station.target[2] == pytest.approx(slider.value / 1000)
        assert station.target[2] > 0

    run(script)


def test_lists_choose_limb_frame_and_beginning(run):
    async def script(pilot, station):
        for choice, value in (("#limb", "L2"), ("#frame", "paper"), ("#begin", "angles")):
            await pilot.click(choice)
            await pilot.pause()
            assert station.query_one(choice, Choice).query_one("SelectOverlay").has_focus
            await pilot.press("escape")
            station.query_one(choice, Choice).value = value
            await settle(pilot)
        assert (station.limb.name, station.frame) == ("L2", "paper")
        assert station.angles is not None

    run(script)


def test_a_click_on_a_key_of_the_line_presses_it(run, lab):
    async def script(pilot, station):
        line = lab.rows(pilot.app)[-1]
        await pilot.click("KeyLine", offset=(line.index("F7") + 1, 0))
        await settle(pilot)
        assert station.angles is not None

    run(script)


# Keeping, languages, sizes.


def test_what_is_set_is_kept_until_the_next_run(run):
    async def first(pilot, station):
        await pilot.press("r", "l", "up", "ctrl+q")

    run(first)

    async def second(pilot, station):
        assert (station.robot.name, station.limb.name) == ("krsri-hexapod", "R2")

    run(second)


def test_kept_nonsense_is_left_aside(run):
    async def script(pilot, station):
        for kept in (
            {"robot": 7},
            {"robot": "gone"},
            {"robot": "eros", "limb": "R1"},
            {"robot": "udiebot", "limb": "LF", "target_m": ["x", 1, 2], "angles_rad": [float("inf")] * 3},
        ):
            station.restore(kept)
            station.ask()
            await settle(pilot)
            assert station.answer.path.pose is not None

    run(script)


def test_a_robots_file_that_cannot_be_read_is_named_and_ours_remain(lab, tmp_path, monkeypatch):
    file = tmp_path / "mine.yaml"
    file.write_text("robots: [")
    monkeypatch.setenv("KINLAB_ROBOTS", str(file))

    async def script(pilot):
        await settle(pilot)
        assert "mine.yaml" in pilot.app.screen.query_one("Message").text
        assert "xl430-hexapod" in pilot.app.screen.robots

    lab.drive(script)


def test_the_screen_at_three_sizes(lab):
    for size in lab.sizes:

        async def script(pilot):
            await settle(pilot)
            lab.check_screen("robot", pilot.app)

        lab.drive(script, "robot", size)


def test_without_braille_no_braille_is_drawn(lab, monkeypatch):
    monkeypatch.setenv("KINLAB_ASCII", "1")

    async def script(pilot):
        await settle(pilot)
        drawing = pilot.app.screen.query(Picture).first().canvas.text()
        assert drawing.isascii()
        assert drawing.strip()

    lab.drive(script)
