"""`kinlab fk`, `body`, `workspace`, `robots` and `tour`."""

from xml.etree import ElementTree as ET

import numpy as np
import pytest

ROBOTS = ["xl430-hexapod", "krsri-hexapod", "udiebot", "eros", "receptionist-arm"]


def test_fk_json_holds_the_contract(kinlab):
    found = kinlab("fk", "xl430-hexapod", 0, 0, -90, "--json").json
    assert set(found) >= {"robot", "limb", "frame", "angles_deg", "position_mm", "rotation"}
    assert found["position_mm"] == pytest.approx([75, 0, -70])
    assert np.linalg.det(found["rotation"]) == pytest.approx(1)
    assert "jacobian" not in found


def test_fk_gives_the_jacobian_on_demand(kinlab):
    found = kinlab("fk", "xl430-hexapod", 0, 0, -90, "--jacobian", "--json").json
    J = np.array(found["jacobian"])
    assert J.shape == (6, 3)
    # The coxa swings the foot sideways by its distance of 75 mm; the tibia swings it outwards by 70 mm.
    assert J[:3, 0] == pytest.approx([0, 0.075, 0])
    assert J[:3, 2] == pytest.approx([0.070, 0, 0])
    assert found["manipulability"] == pytest.approx(abs(np.linalg.det(J[:3])))


def test_fk_gives_dh_parameters_on_demand(kinlab):
    rows = kinlab("fk", "udiebot", 0, 0, 0, "--dh", "--json").json["dh"]["joints"]
    assert [row["a_mm"] for row in rows] == pytest.approx([60, 150, 150])
    assert [row["alpha_deg"] for row in rows] == pytest.approx([90, 0, 0])


def test_fk_says_what_is_beyond_the_limits(kinlab):
    assert "femur 120.00 deg is above its limit of 100.0" in kinlab("fk", "xl430-hexapod", 0, 120, 0).out


@pytest.mark.parametrize("angles", [(1, 2), (1, 2, 3, 4), ("nan", 0, 0), ("a", 0, 0)])
def test_fk_refuses_what_is_not_three_angles(kinlab, angles):
    assert kinlab("fk", "xl430-hexapod", *angles).code == 2


def test_body_keeps_the_feet_where_they_are(kinlab):
    found = kinlab("body", "krsri-hexapod", "--xyz", 0, -10, 20, "--rpy", 5, -3, 10, "--json").json
    assert found["reachable"]
    assert set(found["legs"]) == {"R1", "R2", "R3", "L1", "L2", "L3"}
    at_rest = kinlab("body", "krsri-hexapod", "--json").json
    # Rotations keep the distances between feet.
    moved, rest = (np.array([leg["foot_mm"] for leg in data["legs"].values()]) for data in (found, at_rest))
    assert np.linalg.norm(moved[:, None] - moved, axis=-1) == pytest.approx(
        np.linalg.norm(rest[:, None] - rest, axis=-1)
    )
    assert found["legs"]["R1"]["angles_deg"] != at_rest["legs"]["R1"]["angles_deg"]


def test_body_out_of_reach_names_the_legs_and_exits_1(kinlab):
    answer = kinlab("body", "xl430-hexapod", "--xyz", 0, 0, 200)
    assert answer.code == 1
    assert "not reachable" in answer.out


def test_body_needs_legs(kinlab):
    answer = kinlab("body", "receptionist-arm")
    assert answer.code == 2
    assert "no legs" in answer.err


@pytest.mark.parametrize("robot", ROBOTS)
def test_workspace_of_every_robot(kinlab, robot):
    found = kinlab("workspace", robot, "--samples", 2000, "--json").json
    assert found["farthest_mm"] > found["nearest_mm"] >= 0
    assert np.array(found["side"]["reachable"]).any()
    assert kinlab("workspace", robot, "--samples", 500).code == 0


def test_workspace_volume_of_a_leg_without_limits_is_that_of_its_torus(kinlab, tmp_path):
    """Coxa 40, femur = tibia = 10: the foot reaches a full torus, 2 pi R times pi r^2."""
    path = tmp_path / "ring.yaml"
    path.write_text(
        "robots:\n  ring:\n    legs:\n      coxa: 40\n      femur: 10\n      tibia: 10\n"
        "      joints: leg\n      members:\n        A: {at: [0, 0, 0]}\n"
    )
    found = kinlab("workspace", "ring", "--robots", path, "--samples", 200_000, "--json").json
    truth = 2 * np.pi * 4.0 * np.pi * 2.0**2
    assert abs(found["volume_cm3"] - truth) < 5 * found["volume_error_cm3"] + 0.01 * truth


@pytest.mark.parametrize("samples", [0, 99, 10**9])
def test_workspace_refuses_a_useless_number_of_samples(kinlab, samples):
    assert kinlab("workspace", "eros", "--samples", samples).code == 2


@pytest.mark.parametrize("robot", ROBOTS)
def test_robots_shows_the_source_of_every_figure(kinlab, robot):
    found = kinlab("robots", robot, "--json").json
    for limb in found["limbs"]:
        for figure in [*limb["lengths"], limb["mount"], *(j["limits"] for j in limb["joints"])]:
            assert figure["source"] in ("printed", "inferred", "assumed")
            assert len(figure["why"]) > 5
    shown = kinlab("robots", robot).out
    assert "where from, and why" in shown


def test_robots_lists_all_five(kinlab):
    assert all(name in kinlab("robots").out for name in ROBOTS)
    assert [r["robot"] for r in kinlab("robots", "--json").json["robots"]] == ROBOTS


def test_urdf_goes_to_standard_output(kinlab):
    root = ET.fromstring(kinlab("robots", "udiebot", "--urdf").out)
    names = {joint.get("name") for joint in root.iter("joint")}
    assert {"LF_coxa", "RH_tibia", "LF_tip"} <= names
    assert root.find("link").get("name") == "body"  # type: ignore[union-attr]


@pytest.mark.parametrize("args", [("--urdf",), ("eros", "--urdf", "--json"), ("erros",)])
def test_robots_refuses_what_makes_no_sense(kinlab, args):
    assert kinlab("robots", *args).code == 2


def test_a_robots_file_adds_robots_by_option_and_by_variable(kinlab, tmp_path, monkeypatch):
    path = tmp_path / "mine.yaml"
    path.write_text(
        "robots:\n  mine:\n    legs:\n      coxa: 10\n      femur: 20\n      tibia: 30\n"
        "      joints: leg\n      members:\n        A: {at: [0, 0, 0]}\n"
    )
    assert kinlab("fk", "mine", 0, 0, 0, "--robots", path, "--json").json["position_mm"] == [60, 0, 0]
    monkeypatch.setenv("KINLAB_ROBOTS", str(path))
    assert kinlab("fk", "mine", 0, 0, 0, "--json").code == 0
    path.write_text(path.read_text().replace("femur: 20", "femur: sixty"))
    answer = kinlab("fk", "udiebot", 0, 0, 0)
    assert answer.code == 2
    assert answer.err == f"kinlab: {path}:5: mine.legs.femur: expected a length in mm, got 'sixty'\n"


def test_tour_walks_all_five_papers(kinlab):
    found = kinlab("tour", "--json").json
    assert [stop["robot"] for stop in found["stops"]] == ROBOTS
    for stop in found["stops"]:
        assert stop["reachable"]
        assert stop["solutions"][stop["chosen"]]["error_mm"] < 1e-9
    arrivals = {stop["robot"]: stop["arrival"] for stop in found["stops"]}
    assert "unsent" in arrivals["eros"]
    assert arrivals["xl430-hexapod"]["sync_write"].startswith("FF FF FD 00 FE 16 00 83 74 00 04 00")
    assert 0.1 < arrivals["xl430-hexapod"]["error_mm"] < 2
    shown = kinlab("tour")
    assert shown.code == 0
    assert all(name in shown.out for name in ROBOTS)
    assert "82.40" in shown.out


PLANAR = """
robots:
  planar:
    arm:
      shoulder: 100
      elbow: 80
      joints:
        - {name: shoulder, axis: z, link: {x: shoulder}}
        - {name: elbow, axis: z, link: {x: elbow}}
      members:
        arm: {at: [0, 0, 0]}
"""


def test_a_planar_arm_has_a_workspace_too(kinlab, tmp_path):
    path = tmp_path / "planar.yaml"
    path.write_text(PLANAR)
    assert kinlab("workspace", "planar", "--robots", path).code == 0
    found = kinlab("workspace", "planar", "--robots", path, "--json").json
    assert found["farthest_mm"] == pytest.approx(180, abs=0.5)


def test_tour_walks_kinlabs_own_robots_whatever_the_variable_says(kinlab, tmp_path, monkeypatch):
    path = tmp_path / "broken.yaml"
    path.write_text("robots: nonsense")
    monkeypatch.setenv("KINLAB_ROBOTS", str(path))
    assert kinlab("tour").code == 0


def test_a_body_without_a_stance_is_told_what_is_missing(kinlab, tmp_path):
    path = tmp_path / "planar.yaml"
    path.write_text(PLANAR)
    answer = kinlab("body", "planar", "--robots", path)
    assert answer.code == 2
    assert "no group of its limbs has a stance" in answer.err
