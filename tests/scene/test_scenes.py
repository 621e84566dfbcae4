"""What is drawn is where the kinematics say it is: files read back with rerun's own reader."""

import subprocess

import numpy as np
import pytest

from kinlab.gait import find_gait, plan, stability
from kinlab.gait.limits import joint_rates
from kinlab.papers import as_printed
from kinlab.papers.receptionist_experiments import experiment
from kinlab.rig import Order, Record, Rig, WalkResult, prepare, walk_on
from kinlab.robots import load_robot
from kinlab.robots.body import resting
from kinlab.robots.target import solve_target
from kinlab.robots.workspace import reached
from kinlab.scene import arm_scene, gait_scene, robot_scene, target_scene, walk_scene
from kinlab.scene.recording import Live, part
from kinlab.scene.tree import stood
from kinlab.scene.viewer import program

pytest.importorskip("rerun")
# Floats of four bytes along a chain of some hundred millimetres.
CLOSE = 2e-4
WALKERS = [
    ("xl430-hexapod", "tripod"),
    ("krsri-hexapod", "wave"),
    ("udiebot", "creep"),
    ("eros", "four-step"),
]
ALL = [name for name, _ in WALKERS] + ["receptionist-arm"]


def check_opens(found, *kinds: str) -> None:
    """Its views are of these kinds, and none looks where nothing is."""
    assert {kind for (kind,) in found.opens["ViewBlueprint:class_identifier"]} == set(kinds)
    for (origin,) in found.opens["ViewBlueprint:space_origin"]:
        assert any(path.startswith(origin) for path in found.columns), origin


def off_sight(found, place: np.ndarray) -> float:
    """The angle (rad) between where the eye looks and a place (3,), mm; the picture ends at some 0.4."""
    ((eye,),), ((middle,),) = (found.opens[f"EyeControls3D:{name}"] for name in ("position", "look_target"))
    sight, ray = np.subtract(middle, eye), place - np.array(eye)
    return float(np.arccos(sight @ ray / np.linalg.norm(sight) / np.linalg.norm(ray)))


def entity(limb, *more: str, root: str = "world") -> str:
    return "/".join([f"/{root}/body", limb.name, *limb.joint_names, "tip", *more])


@pytest.mark.parametrize("name", ALL)
def test_every_limb_of_a_resting_robot_is_where_forward_kinematics_puts_it(name, read_back):
    robot = load_robot(name)
    found = read_back(robot_scene(robot, frames=True))
    for limb in robot.limbs.values():
        T = stood(robot) @ limb.fk(resting(robot)[limb.name], frame="body")
        np.testing.assert_allclose(found.pose(entity(limb))[0, :3, 3], T[:3, 3] * 1000, atol=CLOSE)
        np.testing.assert_allclose(found.pose(entity(limb))[0, :3, :3], T[:3, :3], atol=1e-5)
        parts = [f"/world/body/{limb.name}/" + "/".join(limb.joint_names[: i + 1]) for i in range(3)]
        for joint, at in zip(limb.joints, parts, strict=False):
            arrow = np.array(found.values(f"{at}/axis", "vectors")[0][0])
            np.testing.assert_allclose(arrow / np.linalg.norm(arrow), joint.axis, atol=1e-6)
            assert found.values(f"{at}/axis", "labels") == [[f"axis of {limb.name} {joint.name}"]]
            assert "axis_length" in found.columns[at]
            if any(joint.link):
                # A capsule lies along z before it is turned.
                x, y, z, w = found.values(f"{at}/link", "quaternions")[0][0]
                along = [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)]
                np.testing.assert_allclose(along, joint.link / np.linalg.norm(joint.link), atol=1e-6)
                assert found.values(f"{at}/link", "labels") == [[joint.name]]
                length = found.values(f"{at}/link", "lengths")[0][0]
                assert length == pytest.approx(1000 * np.linalg.norm(joint.link), rel=1e-6)
        if limb.sole:
            ((x, y, _),) = found.values(entity(limb, "sole"), "half_sizes")[0]
            np.testing.assert_allclose([2 * x, 2 * y], 1000 * np.array(limb.sole), rtol=1e-6)
    ((centre,),), ((half,),) = (found.values("/world/body/shape", name) for name in ("centers", "half_sizes"))
    mounts = np.array([limb.mount[:3, 3] for limb in robot.limbs.values()]) * 1000
    assert (np.abs(mounts - centre) < np.array(half) + CLOSE).all()
    np.testing.assert_allclose(centre, (mounts.max(axis=0) + mounts.min(axis=0)) / 2, atol=CLOSE)
    assert found.timelines == set()
    check_opens(found, "3D")


@pytest.mark.parametrize(("name", "gait"), WALKERS)
def test_a_gait_has_every_foot_joint_and_margin_of_every_frame(name, gait, read_back):
    robot = load_robot(name)
    walk = plan(robot, find_gait(robot, gait))
    found = read_back(gait_scene(walk, each=20, cycles=2))
    t = np.arange(41) / 20 * walk.period
    motion, state = walk.at(t), stability(walk.at(t))
    assert found.timelines == {"time", "phase"}
    check_opens(found, "3D", "StateTimeline", "TimeSeries")
    grown = found.opens["VisibleTimeRanges:ranges"]
    assert [[r["timeline"] for r in ranges] for ranges in grown] == [["time", "phase"]] * len(robot.legs)
    for i, leg in enumerate(robot.legs):
        tip = found.pose(entity(leg))
        assert len(tip) == 41
        np.testing.assert_allclose(tip[:, :3, 3], motion.ground[:, i] * 1000, atol=CLOSE)
        trail = found.values(f"/world/trails/{leg.name}", "strips")
        ends = np.array([strip[0] for strip in trail if len(strip[0]) == 2])
        np.testing.assert_allclose(ends[:, 1], motion.ground[1:, i] * 1000, atol=CLOSE)
        np.testing.assert_allclose(found.times(f"/world/trails/{leg.name}", "strips"), t[1:], atol=2e-9)
        assert found.values(f"/speeds/{leg.name}", "names") == [[f"{leg.name} {j}" for j in leg.joint_names]]
        for path, angles in (("angles", motion.q), ("speeds", joint_rates(walk, t))):
            curve = np.array(found.values(f"/{path}/{leg.name}", "scalars"))
            np.testing.assert_allclose(curve, np.degrees(angles[:, i]), atol=1e-9)
        lanes = found.columns[f"/legs/{leg.name}"]["state"]
        for row in range(41):
            said = [state for at, _, state in lanes if at <= t[row] + 1e-9][-1]
            assert said == ["swing" if motion.swing[row, i] else "stance"]
    assert found.values("/margins", "names") == [
        ["centre of mass to edge", "energy to tip over", "zero moment point to edge"]
    ]
    margins = np.array(found.values("/margins", "scalars"))
    expected = np.stack([state.static, state.energy, state.zmp_margin], axis=-1) * 1000
    np.testing.assert_allclose(margins, expected, atol=1e-9)
    phases = [phase for _, phase, _ in found.columns["/margins"]["scalars"]]
    assert phases == [round(1000 * p) for p in walk.phase(t)]
    np.testing.assert_allclose(found.times("/margins", "scalars"), t, atol=2e-9)


def test_a_robot_that_walks_in_a_circle_stays_in_sight(read_back):
    robot = load_robot("krsri-hexapod")
    walk = plan(robot, find_gait(robot, "tripod"), forward=0.03, turn=0.1)
    round_once = round(2 * np.pi / 0.1 / walk.period)
    found = read_back(gait_scene(walk, each=2, cycles=round_once))
    for place in np.array(found.values("/world/body", "translation"))[:, 0]:
        assert off_sight(found, place) < 0.4


def test_the_support_polygon_is_spanned_by_the_standing_feet_and_the_mass_is_over_it(read_back):
    robot = load_robot("krsri-hexapod")
    walk = plan(robot, find_gait(robot, "tripod"), turn=0.1)
    found = read_back(gait_scene(walk, each=20, cycles=1))
    t = np.arange(21) / 20 * walk.period
    motion = walk.at(t)
    strips = found.columns["/world/support"]["strips"]
    assert 1 < len(strips) < 21
    for at, _, strip in strips:
        row = int(np.argmin(np.abs(t - at)))
        feet = motion.ground[row][~motion.swing[row]] * 1000
        corners = np.array(strip[0])
        np.testing.assert_allclose(corners[0], corners[-1])
        for corner in corners:
            assert np.linalg.norm(feet - corner, axis=-1).min() < CLOSE
    centre = np.array(found.values("/world/centre_of_mass", "origins"))[:, 0]
    drop = np.array(found.values("/world/centre_of_mass", "vectors"))[:, 0]
    np.testing.assert_allclose(centre, motion.body[:, :3, 3] * 1000, atol=CLOSE)
    np.testing.assert_allclose((centre + drop)[:, 2], 0, atol=CLOSE)
    point = np.array(found.values("/world/zero_moment_point", "positions"))[:, 0]
    np.testing.assert_allclose(point, stability(motion).zmp_over_ground * 1000, atol=CLOSE)


def test_a_target_has_its_ghosts_its_errors_and_its_cloud(read_back):
    robot = load_robot("udiebot")
    limb = robot.limbs["RF"]
    answer = solve_target(robot, limb, [0.16, 0.04, -0.12])
    printed = as_printed(robot, limb, answer.target)
    found = read_back(target_scene(answer, printed, workspace=True))
    chosen = answer.poses[answer.chosen]
    np.testing.assert_allclose(
        found.pose(entity(limb))[0, :3, 3],
        (stood(robot) @ limb.fk(chosen.q, frame="body"))[:3, 3] * 1000,
        atol=CLOSE,
    )
    home = f"/world/body/{limb.name}"
    np.testing.assert_allclose(found.values(f"{home}/target", "positions")[0][0], [160, 40, -120], atol=1e-4)
    for variant in printed:
        ghost = f"/world/body/printed\\ {variant.variant}/{limb.name}"
        tip = found.pose(f"{ghost}/coxa/femur/tibia/tip")[0, :3, 3]
        wanted = stood(robot) @ limb.mount @ np.append(variant.tip, 1)
        np.testing.assert_allclose(tip, wanted[:3] * 1000, atol=CLOSE)
        line = np.array(found.values(f"{ghost}/error", "strips")[0][0])
        assert np.linalg.norm(line[1] - line[0]) == pytest.approx(variant.error_m * 1000, rel=1e-5)
        assert found.values(f"{ghost}/error", "labels")[0][0].endswith("mm off")
    cloud = np.array(found.values(f"{home}/workspace", "positions")[0])
    np.testing.assert_allclose(cloud, reached(limb, 6000) * 1000, atol=CLOSE)
    text = found.values("/answer", "text")[0][0]
    assert "| **knee-up** | 0.0000 | 14.036 | 9.069 | -115.808 |" in text
    check_opens(found, "3D", "TextDocument")
    around = (stood(robot) @ limb.mount @ np.insert(reached(limb, 6000), 3, 1, axis=-1).T)[:3].T
    assert max(off_sight(found, place) for place in around[::50] * 1000) < 0.4


@pytest.mark.parametrize(
    ("name", "limb", "target", "off"),
    [
        ("xl430-hexapod", "L2", [0.3, 0, 0], "155 mm off"),
        # Stretched, and so with a tilted sole, which the closed form has not.
        ("eros", "left_leg", [0.3, 0.02, -0.4], "249 mm off"),
    ],
)
def test_an_unreachable_target_shows_the_limb_where_it_comes_nearest(name, limb, target, off, read_back):
    robot = load_robot(name)
    answer = solve_target(robot, robot.limbs[limb], target)
    found = read_back(target_scene(answer))
    place = stood(robot) @ answer.limb.mount @ np.column_stack([np.append(answer.nearest, 1), [*target, 1]])
    near, wanted = place[:3].T * 1000
    np.testing.assert_allclose(found.pose(entity(answer.limb))[0, :3, 3], near, atol=0.01)
    assert found.values(f"/world/body/{limb}/error", "labels") == [[off]]
    assert off_sight(found, wanted) < 0.4
    text = found.values("/answer", "text")[0][0]
    assert "Not reached" in text
    assert "Nearest place" in text
    assert f"| **nearest** | {answer.missed_mm:.4f} |" in text


def test_a_foot_that_only_its_attitude_keeps_from_the_target_is_said_to_be_so(read_back):
    robot = load_robot("eros")
    answer = solve_target(robot, robot.limbs["right_leg"], [0.1, 0.02, -0.06])
    text = read_back(target_scene(answer)).values("/answer", "text")[0][0]
    assert "With its attitude left free, the tip reaches the place." in text
    assert "Nearest place" not in text


@pytest.fixture(scope="module")
def walked():
    robot = load_robot("krsri-hexapod")
    errand = prepare(Order(robot, find_gait(robot, "tripod"), 0.04, 0.0, 0.06, 25.0))
    packets = []
    with Rig.open(robot) as rig:
        rig.bus.tap = packets.append
        # A servo that falls silent for a moment leaves a gap, not a lie.
        samples = []
        for sample in walk_on(rig, errand):
            samples.append(sample)
            rig.chain.servo(5).dead = 5 < len(samples) < 9
        record = Record(rig.wiring, samples)
    return WalkResult.of(errand, record, rig), packets


def test_a_measured_walk_shows_what_the_servos_said(walked, read_back):
    result, packets = walked
    found = read_back(walk_scene(result, packets))
    record, robot = result.record, result.errand.walk.robot
    body = found.pose("/world/body")
    for leg, q in record.wiring.by_limb(record.q).items():
        known = np.isfinite(q).all(axis=-1)
        limb = robot.limbs[leg]
        if known.all():
            wanted = result.errand.walk.at(record.way).body @ limb.fk(q, frame="body")
            np.testing.assert_allclose(
                found.pose(entity(limb))[:, :3, 3], wanted[:, :3, 3] * 1000, atol=CLOSE
            )
        else:
            assert leg == "R2"
            assert len(found.values("/world/body/R2/coxa/femur", "quaternion")) == known.sum() == len(q) - 3
        speeds = np.array(found.values(f"/speeds/{leg}", "scalars"))
        np.testing.assert_allclose(speeds, np.degrees(record.wiring.by_limb(record.velocity)[leg][known]))
        loads = np.array(found.values(f"/loads/{leg}", "scalars"))
        expected = 100 * record.wiring.by_limb(record.load)[leg][known]
        np.testing.assert_allclose(loads, expected, atol=1e-9)
    assert len(body) == len(record.t)
    check_opens(found, "3D", "StateTimeline", "TimeSeries", "TextLog")
    energy = np.array(found.values("/energy", "scalars"))[:, 0]
    np.testing.assert_allclose(energy, record.joules / 3600, atol=1e-12)
    power = np.array(found.values("/power", "scalars"))[:, 0]
    np.testing.assert_allclose(power, [sample.power for sample in record.samples])
    errors = np.array(found.values("/tracking", "scalars"))
    np.testing.assert_allclose(errors, record.errors[np.isfinite(record.errors).all(axis=1)] * 1000)


def test_every_packet_is_in_the_log_at_the_instant_it_had_passed(walked, read_back):
    result, packets = walked
    found = read_back(walk_scene(result, packets))
    first = result.record.samples[0]
    heard = [p for p in packets if p.at >= first.clock - first.t]
    texts = [text[0] for text in found.values("/bus", "text")]
    assert len(texts) == len(heard) > 1000
    np.testing.assert_allclose(
        found.times("/bus", "text"), [p.at - (first.clock - first.t) for p in heard], atol=2e-9
    )
    # Between two ticks the gait goes on.
    ticks = [(t, phase) for t, phase, _ in found.columns["/energy"]["scalars"]]
    phases = [phase for _, phase, _ in found.columns["/bus"]["text"]]
    between = np.interp(found.times("/bus", "text"), *np.transpose(ticks))
    np.testing.assert_allclose(phases, between, atol=1.01)
    for text, packet in zip(texts, heard, strict=True):
        assert f"  [{packet.data.hex(' ').upper()}]" in text
        assert text.startswith(
            f"{packet.at - (first.clock - first.t):.5f} s  {'->' if packet.sent else '<-'} "
        )
    assert "-> SYNC_WRITE all  [FF FF FE " in texts[0]
    assert "]  servo 1 Goal Position 512 = 150 deg; servo 2 " in texts[0]
    assert any("<- servo 1 ok  [" in text and "]  Present Position 5" in text for text in texts)
    assert {level[0] for level in found.values("/bus", "level")} == {"sent", "heard"}


def test_both_runs_of_the_pushed_arm_have_their_hands_forces_and_packets(read_back):
    robot = load_robot("receptionist-arm")
    outcome = experiment(robot, robot.limb(), "comply")
    found = read_back(arm_scene(robot, outcome))
    for name, record in outcome.runs.items():
        limb = record.limb
        real = limb.fk(record.angles["real"], frame="body")
        root = f"{name}/world"
        np.testing.assert_allclose(
            found.pose(entity(limb, root=root))[:, :3, 3], real[:, :3, 3] * 1000, atol=CLOSE
        )
        command = limb.fk(record.angles["command"], frame="body")[:, :3, 3] * 1000
        ghost = entity(limb, root=root).replace("/body/", "/body/command/")
        np.testing.assert_allclose(found.pose(ghost)[:, :3, 3], command, atol=CLOSE)
        gap = np.array(found.values(f"/{root}/body/{limb.name}/error", "strips"))[:, 0]
        hands = [limb.fk(record.angles[kind])[:, :3, 3] * 1000 for kind in ("real", "command")]
        np.testing.assert_allclose(gap, np.stack(hands, axis=1), atol=CLOSE)
        line = np.array(found.values(f"/{root}/body/{limb.name}/line", "strips")[0][0])
        np.testing.assert_allclose(line, record.track.points * 1000, atol=CLOSE)
        for group, kinds, scale in (("angles", record.angles, 180 / np.pi), ("torques", record.torques, 1)):
            for j, joint in enumerate(limb.joint_names):
                curves = np.array(found.values(f"/{name}/{group}/{joint}", "scalars"))
                np.testing.assert_allclose(curves, np.stack([v[:, j] * scale for v in kinds.values()], -1))
                assert found.values(f"/{name}/{group}/{joint}", "names") == [[f"{joint} {k}" for k in kinds]]
        arrows = found.columns[f"/{root}/body/{limb.name}/push_1"]["origins"]
        (push,) = record.pushes
        hand = limb.fk(record.angles["real"])[:, :3, 3] * 1000
        for row, (t, _, origin) in enumerate(arrows):
            assert bool(origin) == push.acts(record.t[row])
            if origin:
                tip = np.array(origin[0]) + 15 * np.array(push.force)
                np.testing.assert_allclose(tip, hand[row], atol=CLOSE)
                assert t == pytest.approx(record.t[row], abs=2e-9)
        error = np.array(found.values(f"/{name}/error", "scalars"))
        np.testing.assert_allclose(error, np.degrees(record.error), atol=1e-9)
        assert len(found.values(f"/{name}/bus", "text")) == len(record.packets)
    check_opens(found, "3D", "TimeSeries", "TextLog")


def test_rerun_itself_finds_nothing_wrong_with_the_files(tmp_path, read_back, walked, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    robot = load_robot("eros")
    for recording in (robot_scene(robot), walk_scene(*walked)):
        path = read_back(recording).path
        done = subprocess.run([program(), "rrd", "verify", path], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr


def test_the_same_scene_by_rows_and_by_columns_holds_the_same(read_back):
    robot = load_robot("xl430-hexapod")
    walk = plan(robot, find_gait(robot))
    by_columns, by_rows = (read_back(gait_scene(walk, each=8, cycles=1, into=into))
                           for into in (None, Live("rows")))  # fmt: skip
    assert by_columns.columns == by_rows.columns


def test_names_with_blanks_and_slashes_are_one_part_of_a_path():
    assert part("front left", "a/b") == "front\\ left/a\\/b"


# Names that mean something in a scene, and such as a path has to escape.
ODD = """
robots:
  odd:
    title: odd names
    kind: quadruped
    legs:
      a: 30
      b: 60
      c: 80
      joints:
        - {name: tip, axis: z, link: {x: a}}
        - {name: link, axis: -y, link: {x: b}}
        - {name: axis, axis: -y, link: {x: c}}
      limits: {tip: [-90, 90], link: [-100, 100], axis: [-150, 90]}
      stance: {mm: [90, 0, -60], assumed: for the test}
      mountings: {all: {tip: &servo {model: AX-12A, zero: 150, sign: 1}, link: *servo, axis: *servo}}
      members:
        shape: {at: [60, 40, 0], turn: 45, mounting: all, ids: [1, 2, 3]}
        knee-down: {at: [60, -40, 0], turn: -45, mounting: all, ids: [4, 5, 6]}
        __c: {at: [-60, 40, 0], turn: 135, mounting: all, ids: [7, 8, 9]}
        d e/f: {at: [-60, -40, 0], turn: -135, mounting: all, ids: [10, 11, 12]}
"""


def test_a_robot_may_call_its_limbs_and_joints_what_it_likes(tmp_path, read_back):
    (tmp_path / "robots.yaml").write_text(ODD)
    robot = load_robot("odd", tmp_path / "robots.yaml")
    limb = robot.limbs["shape"]
    answer = solve_target(robot, limb, [0.08, 0.01, -0.06])
    found = read_back(target_scene(answer, workspace=True))
    drawn = [path for path, has in found.columns.items() if "lengths" in has or "positions" in has]
    assert len(drawn) > 4 * (3 + 1)
    # What is drawn has no transform of its own, or it would turn away from where it hangs.
    assert not any("translation" in found.columns[path] for path in drawn)
    for name, q in resting(robot).items():
        shown = answer.poses[answer.chosen].q if name == limb.name else q
        wanted = stood(robot) @ robot.limbs[name].fk(shown, frame="body")
        tip = found.pose(f"/world/body/{part(name)}/tip/link/axis/tip_")[0]
        np.testing.assert_allclose(tip[:3, 3], wanted[:3, 3] * 1000, atol=CLOSE)
    ghost = found.pose("/world/body/knee-down_/shape/tip/link/axis/tip_")[0]
    wanted = stood(robot) @ limb.mount @ np.append(answer.target, 1)
    np.testing.assert_allclose(ghost[:3, 3], wanted[:3] * 1000, atol=CLOSE)
