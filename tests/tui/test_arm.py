"""The Arm lab: pushes by key and mouse, gains and laws that change while the arm moves, and an arm that runs away."""

import numpy as np
import pytest
from textual.widgets import Button, Static

from kinlab.control import Environment, PositionGains
from kinlab.rig.arm import GAIN_SETS
from kinlab.rig.arm.drawing import pull
from kinlab.tui.stations.arm.curves import PLOTS
from kinlab.tui.stations.arm.hand import PULSE
from kinlab.tui.stations.arm.station import ArmStation
from kinlab.tui.widgets import Choice, Dial, Plot


@pytest.fixture
def run(lab):
    """`run(script, size=...)`: a script with the station, at whose arm nothing has moved yet."""

    def opened(script, size=(80, 24)):
        async def begin(pilot):
            await pilot.pause()
            await script(pilot, pilot.app.screen)

        return lab.drive(begin, "arm", size)

    return opened


def moments(station):
    return station.bench.moments


def message(station):
    return station.query_one("Message")


def go_on(station, seconds):
    """Let so much of the arm's own time pass, and show it."""
    station._run(round(seconds / station.settings.dt))
    station._show(plots=True)


def tick(station, seconds=0.2):
    """Let so much of everybody's time pass."""
    station._seen -= seconds
    station._tick()


# Time.


def test_a_key_or_a_click_lets_the_arm_go_on_and_holds_it(run):
    async def script(pilot, station):
        await pilot.press("space")
        tick(station)
        assert moments(station)
        assert str(station.query_one("#play", Button).label) == "pause"
        await pilot.press("space")
        count = len(moments(station))
        tick(station)
        assert len(moments(station)) == count
        await pilot.press("s", "s")
        assert len(moments(station)) == count + 2
        await pilot.click("#play")
        assert station.playing
        await pilot.click("#play")
        assert not station.playing
        await pilot.click("#reset")
        assert not moments(station)

    run(script)


def test_time_does_not_pass_in_a_lab_that_nobody_sees(run):
    async def script(pilot, station):
        await pilot.press("space")
        await pilot.app.open_station("gait")
        count = len(moments(station))
        tick(station)
        assert len(moments(station)) == count

    run(script)


# Hands.


def test_keys_push_in_the_plane_of_the_side_view_and_across_it(run, monkeypatch):
    monkeypatch.setattr("kinlab.tui.stations.arm.hand.PULSE", 60)

    async def script(pilot, station):
        for key, force in (
            ("left", (-3, 0, 0)), ("right", (3, 0, 0)), ("up", (0, 0, 3)), ("down", (0, 0, -3)),
            ("comma", (0, 3, 0)), ("full_stop", (0, -3, 0)),
        ):  # fmt: skip
            await pilot.press(key)
            assert station.hand.force == pytest.approx(force)
            assert station.playing
        station.query_one("#push", Dial).field.value = "6"
        await pilot.pause()
        await pilot.press("up")
        assert station.hand.force == pytest.approx((0, 0, 6))

    run(script)


def test_a_push_ends_by_itself(run):
    async def script(pilot, station):
        station.action_push("left")
        station._play(False)
        go_on(station, PULSE / 2)
        assert np.abs(moments(station)[-1].torques["pushed"]).max() > 0.3
        go_on(station, PULSE)
        assert np.abs(moments(station)[-1].torques["pushed"]).max() == 0
        assert station.hand.force is None

    run(script)


def test_the_mouse_pulls_the_hand_while_it_is_held(run):
    async def script(pilot, station):
        view = station.query_one("#side")
        go_on(station, 0.1)
        await pilot.pause()
        columns, rows = view.canvas.columns, view.canvas.rows
        place = (columns // 2, rows - 1)
        await pilot.mouse_down("#side", (place[0], place[1] + 1))
        await pilot.pause()
        assert station.playing
        station._play(False)
        go_on(station, 0.05)
        # A rubber band from where the hand was to the mouse.
        before = moments(station)[-2].angles["real"]
        expected = pull(station.limb, before, "side", view.canvas.place(*place))
        assert station.hand.force == pytest.approx(expected)
        assert np.linalg.norm(expected) > 1
        assert np.abs(moments(station)[-1].torques["pushed"]).max() > 0
        await pilot.mouse_up("#side", (place[0], place[1] + 1))
        await pilot.pause()
        go_on(station, 0.05)
        assert station.hand.force is None
        assert np.abs(moments(station)[-1].torques["pushed"]).max() == 0

    run(script)


def test_a_click_on_a_plot_pulls_at_nothing(run):
    async def script(pilot, station):
        await pilot.click("#torque", (9, 3))
        await pilot.pause()
        assert not station.playing
        assert not moments(station)

    run(script)


# Gains and laws.


def test_compliance_goes_on_and_off_while_the_arm_moves(run):
    async def script(pilot, station):
        go_on(station, 0.2)
        await pilot.press("c")
        assert station.bench.settings.law == station.query_one("#law", Choice).value == "compliance"
        assert "yields" in message(station).text
        assert len(moments(station)) > 10
        await pilot.press("f8")
        assert station.bench.settings.law == "position"
        await pilot.press("w", "w")
        assert station.bench.settings.law == "none"
        await pilot.click("#law")
        await pilot.pause()
        await pilot.click("#law SelectOverlay", (3, 3))
        await pilot.pause()
        assert station.bench.settings.law == "compliance"

    run(script)


def test_gains_turn_by_field_and_by_slider_while_the_arm_moves(run):
    async def script(pilot, station):
        go_on(station, 0.1)
        for name, typed, number in (
            ("kp", "25,5", 25.5), ("kv", "9", 9), ("kf", "0.2", 0.2), ("kenv", "10", 10), ("denv", "7", 7),
            ("menv", "2", 2),
        ):  # fmt: skip
            station.query_one(f"#{name}", Dial).field.value = typed
            await pilot.pause()
            settings = station.bench.settings
            assert (settings.gains._asdict() | settings.environment._asdict())[name] == number
        kp = station.query_one("#kp", Dial)
        await pilot.click(kp.slider, (kp.slider.size.width - 1, 0))
        assert station.bench.settings.gains.kp == kp.field.number == kp.slider.high
        assert "7.7 rad/s" in str(station.query_one("#facts", Static).content)

    run(script)


def test_what_is_no_gain_is_explained_and_the_last_good_one_stays(run):
    async def script(pilot, station):
        for name, typed in (
            ("menv", "0"),
            ("kp", "-1"),
            ("kv", "["),
            ("kf", "1e9"),
            ("kenv", "nan"),
            ("push", "x"),
        ):
            station.query_one(f"#{name}", Dial).field.value = typed
            await pilot.pause()
            assert message(station).kind == "bad", (name, typed)
        gains, environment = GAIN_SETS["firm"]
        assert (station.bench.settings.gains, station.bench.settings.environment) == (
            gains,
            environment,
        )
        assert station.newtons == 3

    run(script)


def test_an_arm_that_runs_away_is_stopped_says_so_and_can_be_put_back(run, lab):
    async def script(pilot, station):
        await pilot.press("g")
        assert station.bench.settings.gains == GAIN_SETS["printed"][0]
        await pilot.press("space")
        go_on(station, 6)
        await pilot.pause()
        assert message(station).kind == "bad"
        assert "the loop ran away at 4.464 s" in lab.text(pilot.app)
        assert "r puts the arm back" in " ".join(lab.text(pilot.app).split())
        assert not station.playing
        # Nothing moves it any more, whatever is pressed.
        count = len(moments(station))
        await pilot.press("space", "s", "left")
        tick(station)
        assert len(moments(station)) == count
        await pilot.press("g", "r")
        assert message(station).kind == "note"
        await pilot.press("space")
        tick(station)
        assert moments(station)
        assert moments(station)[-1].t < 4

    run(script)


# What it shows.


def test_plots_show_what_was_measured_of_the_joint_that_is_chosen(run, lab):
    async def script(pilot, station):
        go_on(station, 0.5)
        series = station.query_one("#position", Plot)._series
        assert set(series) == {"line", "goal", "arm"}
        real = np.degrees([moment.angles["real"][2] for moment in moments(station)])
        assert series["arm"][-1] == pytest.approx((moments(station)[-1].t, real[-1]))
        await pilot.press("j")
        assert station.query_one("#joint", Choice).value == "shoulder_pitch"
        pitch = np.degrees(moments(station)[-1].angles["real"][0])
        assert station.query_one("#position", Plot)._series["arm"][-1][1] == pytest.approx(pitch)
        assert set(station.query_one("#torque", Plot)._series) == {"servo", "model", "observer"}
        assert set(station.query_one("#estimate", Plot)._series) == {"hand", "eq. (2.23)", "observer"}
        await pilot.press("l")
        assert station.limb.name == station.query_one("#limb", Choice).value == "left_arm"
        assert not moments(station)

    run(script)


def test_a_narrow_terminal_shows_one_plot_and_changes_it_at_a_key(run, lab):
    async def script(pilot, station):
        go_on(station, 0.3)
        for name in (*PLOTS, "position"):
            await pilot.pause()
            assert [plot.id for plot in station.query(Plot) if plot.display] == [name]
            assert station.say(f"plot.{name}") in lab.text(pilot.app)
            await pilot.press("v")

    run(script, (60, 20))


@pytest.mark.parametrize("size", [(60, 20), (80, 24), (120, 40)])
def test_the_screen(run, lab, size):
    async def script(pilot, station):
        go_on(station, 1.0)
        station.action_push("left")
        station._play(False)
        go_on(station, 0.2)
        await pilot.pause()
        lab.check_screen("arm", pilot.app)

    run(script, size)


# What is kept.


def test_everything_is_as_it_was_the_next_time(run):
    async def leave(pilot, station):
        station.query_one("#kp", Dial).field.value = "25"
        await pilot.pause()
        await pilot.press("escape", "c", "j", "l", "ctrl+q")

    async def come_back(pilot, station):
        assert station.bench.settings.law == "compliance"
        assert station.bench.settings.gains.kp == station.query_one("#kp", Dial).number == 25
        assert station.query_one("#joint", Choice).value == "shoulder_pitch"
        assert station.bench.limb.name == station.query_one("#limb", Choice).value == "left_arm"

    run(leave)
    run(come_back)


@pytest.mark.parametrize(
    "kept",
    [
        {"limb": "third_arm", "joint": 9, "plot": [], "newtons": -1, "law": "position", "gains": [1, 2]},
        {"limb": {}, "joint": "elbow", "newtons": "much", "law": "firmly", "gains": [1, 1, 1, 1, 1, 1]},
        {"gains": "nothing", "law": "position", "newtons": 1e300},
        {"gains": [1, 1, 1, 1, 1, float("nan")], "law": "position"},
    ],
)
def test_what_was_kept_is_not_trusted(kept):
    station = ArmStation()
    before = station.state()
    station.restore(kept)
    assert station.state() == before
    assert station.settings.gains == PositionGains(20, 8)
    assert station.settings.environment == Environment(0.1, 12, 8, 1)
