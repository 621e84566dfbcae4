"""The Gait stage: every action by key and by mouse, time that plays, stops and goes back, and what it shows."""

import numpy as np
import pytest
from textual.events import MouseScrollDown, MouseScrollUp
from textual.widgets import Static

from kinlab.tui.stations.gait.diagram import Diagram
from kinlab.tui.stations.gait.station import GaitStation
from kinlab.tui.stations.gait.transport import Transport
from kinlab.tui.widgets import Choice, Dial


async def settle(pilot):
    """Until the rig has taken up the walk and measured the instant that is shown."""
    station = pilot.app.screen
    await pilot.pause()
    while station.rig.mill is None and not station.rig.problem:
        await pilot.pause(0.02)
    while station.rig.tread(station.t):
        pass
    station._show()
    await pilot.pause()


def tick(station, seconds=0.2):
    """Let so much of everybody's time pass."""
    station._seen -= seconds
    station._tick()


@pytest.fixture(autouse=True)
def _no_slider_is_dragged(monkeypatch):
    """The rig takes up every walk at once."""
    monkeypatch.setattr("kinlab.tui.stations.gait.rig.QUIET", 0.001)


@pytest.fixture
def run(lab):
    """`run(script, size=...)`: a script with the station, whose rig walks."""

    def opened(script, size=(80, 24)):
        async def begin(pilot):
            await settle(pilot)
            await script(pilot, pilot.app.screen)

        return lab.drive(begin, "gait", size)

    return opened


def facts(station):
    return f"{station.query_one('#facts', Static).content} {station.rig.content}"


def phase(station):
    return station.cycle.phase(station.cycle.frame_at(station.t)).number


# Time.


def test_a_key_plays_and_stops_and_frames_and_phases_step_both_ways(run):
    async def script(pilot, station):
        await pilot.press("space")
        tick(station)
        assert station.playing
        assert station.t >= 0.2
        await pilot.press("space")
        stopped = station.t
        tick(station)
        assert station.t == stopped
        frame = station.cycle.frame_at(stopped)
        await pilot.press("right", "right", "left")
        assert station.cycle.frame_at(station.t) == frame + 1
        await pilot.press("home")
        assert station.cycle.frame_at(station.t) == 0
        station.seek(0.0)
        await pilot.press("n")
        assert phase(station) == 2
        await pilot.press("p")
        assert phase(station) == 1
        # Before the beginning comes the end of the cycle.
        await pilot.press("left")
        assert station.cycle.frame_at(station.t) == len(station.cycle) - 1
        # Whoever steps does not play any more.
        await pilot.press("f9", "right")
        assert not station.playing

    run(script)


def test_buttons_do_the_same_at_a_click(run):
    async def script(pilot, station):
        transport = station.query_one(Transport)
        places, at = [], 0
        for text, _ in transport._parts():
            places.append((at + 1, 0))
            at += len(text) + 1
        back, before, play, after, on = places
        await pilot.click(Transport, on)
        assert phase(station) == 2
        await pilot.click(Transport, back)
        assert phase(station) == 1
        await pilot.click(Transport, after)
        await pilot.click(Transport, after)
        await pilot.click(Transport, before)
        assert station.cycle.frame_at(station.t) == 1
        await pilot.click(Transport, play)
        assert station.playing
        await pilot.click(Transport, play)
        assert not station.playing

    run(script)


def test_the_mouse_moves_the_cursor_of_the_diagram(run):
    async def script(pilot, station):
        diagram = station.query_one(Diagram)
        width = diagram._columns()
        await pilot.click(Diagram, (diagram._names + width // 2, 2))
        assert station.t / station.cycle.walk.period == pytest.approx(0.5, abs=0.03)
        await pilot.mouse_down(Diagram, (diagram._names + 2, 2))
        await pilot.hover(Diagram, (diagram._names + width - 1, 2))
        await pilot.mouse_up(Diagram, (diagram._names + width - 1, 2))
        assert station.t / station.cycle.walk.period == pytest.approx(1, abs=0.05)
        frame = station.cycle.frame_at(station.t)
        for kind, expected in ((MouseScrollUp, frame - 1), (MouseScrollDown, frame)):
            diagram.post_message(kind(diagram, 5, 1, 0, 0, 0, False, False, False))
            await pilot.pause()
            assert station.cycle.frame_at(station.t) == expected

    run(script)


def test_time_does_not_pass_on_a_stage_that_nobody_sees(run):
    async def script(pilot, station):
        await pilot.press("space")
        await pilot.app.open_station("arm")
        before = station.t
        tick(station)
        assert station.t == before
        await pilot.app.open_station("gait")
        tick(station)
        assert station.t > before

    run(script)


# What is walked.


def test_robots_gaits_and_legs_by_key(run):
    async def script(pilot, station):
        assert station.robot.name == "xl430-hexapod"
        await pilot.press("g")
        assert station.gait_name == station.query_one("#gait", Choice).value == "wave"
        assert len(station.cycle.walk.gait.phases) == 6
        await pilot.press("l", "l")
        assert station.robot.legs[station.leg].name == station.query_one("#leg", Choice).value == "R3"
        await pilot.press("r", "r")
        assert station.robot.name == station.query_one("#robot", Choice).value == "udiebot"
        assert station.gait_name == "creep"
        assert station.leg == 0
        for _ in station.robots:
            await pilot.press("f7")
        assert station.robot.name == "udiebot"

    run(script)


def test_robots_gaits_and_legs_by_mouse(run):
    async def choose(pilot, box, row):
        await pilot.click(box)
        await pilot.pause()
        await pilot.click(f"{box} SelectOverlay", (3, row + 1))
        await pilot.pause()

    async def script(pilot, station):
        await choose(pilot, "#robot", 1)
        assert station.robot.name == "krsri-hexapod"
        await choose(pilot, "#gait", 2)
        assert station.gait_name != "tripod"
        assert station.cycle.walk.gait.name == station.gait_name
        await choose(pilot, "#leg", 3)
        assert station.leg > 0

    run(script)


def test_the_share_of_the_cycle_stays_when_the_walk_changes(run):
    async def script(pilot, station):
        station.seek(0.4 * station.cycle.walk.period)
        await pilot.press("g")
        assert station.t == pytest.approx(0.4 * station.cycle.walk.period)
        await pilot.press("plus")
        assert station.t == pytest.approx(0.4 * station.cycle.walk.period)

    run(script)


def test_speed_and_turn_by_key_by_field_and_by_slider(run):
    async def script(pilot, station):
        await pilot.press("plus", "plus", "minus")
        assert station.cycle.walk.velocity[0] == pytest.approx(0.021)
        await pilot.press("less_than_sign", "less_than_sign")
        assert np.degrees(station.cycle.walk.turn) == pytest.approx(2)
        await pilot.press("greater_than_sign", "greater_than_sign", "greater_than_sign")
        assert np.degrees(station.cycle.walk.turn) == pytest.approx(-1)
        speed, turn = station.query_one("#speed", Dial), station.query_one("#turn", Dial)
        speed.field.focus()
        speed.field.value = "1,5 cm/s"
        await pilot.pause()
        assert station.cycle.walk.velocity[0] == pytest.approx(0.015)
        turn.field.focus()
        await pilot.pause()
        await pilot.press("up", "up")
        assert station.turn_deg_s == 1
        await pilot.click(turn.slider, (0, 0))
        assert station.turn_deg_s == turn.field.number == turn.slider.low

    run(script)


def test_a_speed_beyond_the_servos_is_explained_and_the_walk_stays(run):
    async def script(pilot, station):
        dial = station.query_one("#speed", Dial)
        dial.field.focus()
        dial.field.value = "900"
        await pilot.pause()
        message = station.query_one("Message")
        assert message.kind == "bad"
        assert "the fastest possible speed" in message.text
        assert station.cycle.walk.velocity[0] == 0.020
        assert dial.has_class("-refused")
        for typed in ("", "[", "ten", "1e9", "nan"):
            dial.field.value = typed
            await pilot.pause()
            assert message.kind == "bad"
            assert station.cycle.walk.velocity[0] == 0.020
        dial.field.value = "-30"
        await pilot.pause()
        assert message.kind == "note"
        assert not dial.has_class("-refused")
        assert station.cycle.walk.velocity[0] == -0.030

    run(script)


# What it shows.


def test_the_margins_are_those_of_the_core(run):
    async def script(pilot, station):
        least = min(found.static for found in station.cycle.least) * 1000
        assert f"least {least:.1f} mm" in facts(station)
        station.seek(0.3 * station.cycle.walk.period)
        await settle(pilot)
        now = station.cycle.state.static[station.cycle.frame_at(station.t)] * 1000
        assert f"margin {now:.1f} mm" in facts(station)

    run(script)


def test_the_rig_walks_along_and_tells_power_energy_and_cost(run):
    async def script(pilot, station):
        assert "Wh/m" not in facts(station)
        station.seek(1.2 * station.cycle.walk.period)
        await settle(pilot)
        sample = station.rig.at(station.t)
        assert sample.t == pytest.approx(station.t, abs=0.03)
        assert f"{sample.power:.1f} W" in facts(station)
        assert f"{sample.energy:.4f} Wh" in facts(station)
        assert f"{station.rig.mill.per_metre:.3f} Wh/m" in facts(station)
        # Back in time it is what was measured then.
        station.seek(0.5 * station.cycle.walk.period)
        assert station.rig.at(station.t).energy < sample.energy
        # Another walk begins anew.
        await pilot.press("g")
        await settle(pilot)
        assert station.rig.mill.walk is station.cycle.walk
        assert station.rig.at(station.t).energy < sample.energy

    run(script)


@pytest.mark.parametrize(("presses", "why"), [(2, "not on a bus"), (3, "names no servos")])
def test_robots_that_no_rig_can_walk_say_so_and_still_show_their_geometry(run, lab, presses, why):
    async def script(pilot, station):
        await pilot.press(*"r" * presses)
        await settle(pilot)
        assert "geometry only" in facts(station)
        assert why in facts(station)
        await pilot.press("n", "right")
        assert "✚" in lab.text(pilot.app)
        await pilot.press("v")
        await pilot.pause()
        assert "joint speed" in lab.text(pilot.app)
        assert "power" not in lab.text(pilot.app)

    run(script)


def test_the_other_half_shows_joint_speeds_and_power(run, lab):
    async def script(pilot, station):
        assert "joint speed" not in lab.text(pilot.app)
        await pilot.press("v")
        await pilot.pause()
        seen = lab.text(pilot.app)
        assert "joint speed now/peak, % of servo" in seen
        assert "stability margin" in seen
        peaks = station.cycle.used.max(axis=0) * 100
        rows = [row for row in seen.splitlines() if " R1 " in row]
        assert f"/{peaks[0, 1]:.0f}" in rows[-1]
        await pilot.press("f10")
        await pilot.pause()
        assert "from above" in lab.text(pilot.app)

    run(script)


def test_a_wide_terminal_shows_both_halves_and_nobody_turns_the_page(run, lab):
    async def script(pilot, station):
        seen = lab.text(pilot.app)
        for text in ("from above", "side R1", "joint speed", "stability margin", "power"):
            assert text in seen
        assert not station.check_action("page", ())

    run(script, (120, 40))


def test_the_stage_goes_on_when_the_terminal_changes_its_size_while_it_plays(run, lab):
    async def script(pilot, station):
        await pilot.press("space")
        for size in ((120, 40), (60, 20), (40, 10), (200, 60), (80, 24)):
            await pilot.resize_terminal(*size)
            tick(station)
        assert station.playing
        assert "from above" in lab.text(pilot.app)

    run(script)


def test_no_braille_where_a_terminal_cannot_show_it(lab, monkeypatch):
    monkeypatch.setenv("KINLAB_ASCII", "1")

    async def script(pilot):
        await settle(pilot)
        body = "\n".join(lab.rows(pilot.app)[6:-2])
        assert not any(0x2800 <= ord(char) < 0x2900 for char in body)
        assert "#" in body
        assert "V" in body

    lab.drive(script, "gait")


@pytest.mark.parametrize("size", [(60, 20), (80, 24), (120, 40)])
def test_the_screen(run, lab, size):
    async def script(pilot, station):
        station.seek(0.3 * station.cycle.walk.period)
        await settle(pilot)
        lab.check_screen("gait", pilot.app)

    run(script, size)


# What is kept.


def test_everything_is_as_it_was_the_next_time(run):
    async def leave(pilot, station):
        await pilot.press("r", "g", "l", "plus", "less_than_sign", "v", "ctrl+q")

    async def come_back(pilot, station):
        assert (station.robot.name, station.gait_name) == ("krsri-hexapod", "wave")
        assert (station.speed_mm_s, station.turn_deg_s) == (21, 1)
        assert station.robot.legs[station.leg].name == station.query_one("#leg", Choice).value == "R2"
        assert station.page == "servos"

    run(leave)
    run(come_back)


@pytest.mark.parametrize(
    "kept",
    [
        {"robot": "nobody"},
        {"robot": 7, "gait": []},
        {"robot": "eros", "gait": "tripod", "speed_mm_s": 20, "turn_deg_s": 0},
        {"robot": "udiebot", "gait": "trot", "speed_mm_s": 1e300, "turn_deg_s": 0},
        {"robot": "udiebot", "gait": "trot", "speed_mm_s": "fast", "turn_deg_s": None, "leg": {}, "page": 3},
    ],
)
def test_what_was_kept_is_not_trusted(kept):
    station = GaitStation()
    before = station.state()
    station.restore(kept)
    assert station.state() == before


def test_robots_without_a_gait_for_their_legs_are_not_offered(tmp_path, monkeypatch):
    file = tmp_path / "robots.yaml"
    file.write_text(
        """
robots:
  spider:
    kind: hexapod
    legs:
      coxa: 20
      femur: 60
      tibia: 90
      joints: leg
      stance: [90, 0, -70]
      members:
        A1: {at: [80, -40, 0], turn: -90}
        A2: {at: [0, -40, 0], turn: -90}
        B1: {at: [80, 40, 0], turn: 90}
        B2: {at: [0, 40, 0], turn: 90}
"""
    )
    monkeypatch.setenv("KINLAB_ROBOTS", str(file))
    assert list(GaitStation().robots) == ["xl430-hexapod", "krsri-hexapod", "udiebot", "eros"]
