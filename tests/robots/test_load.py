"""Robots files: what they may say, and what a wrong one is answered with."""

import os

import pytest

import kinlab
from kinlab.errors import FileError, UsageError
from kinlab.robots import load_robot, load_robots, robot_names
from kinlab.robots.provenance import KINDS

SPIDER = """\
robots:
  spider:
    kind: hexapod
    legs:
      coxa: 25
      femur: {mm: 50, printed: "Table 1"}
      tibia: 70
      joints: leg
      limits:
        coxa: [-60, 60]
      mountings:
        right:
          coxa: {model: AX-12A, zero: 150, sign: 1}
          femur: {model: AX-12A, zero: 150, sign: 1}
          tibia: {model: AX-12A, zero: 150, sign: 1}
      members:
        R1: {at: [70, -40, 0], turn: -90, mounting: right, ids: [1, 2, 3]}
        L1: {at: [70, 40, 0], turn: 90}
"""
FEMUR = '{mm: 50, printed: "Table 1"}'


@pytest.fixture
def answer_to(tmp_path):
    """The message that a file with this text is answered with, after the file's name."""

    def load(text):
        path = tmp_path / "mine.yaml"
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        with pytest.raises(FileError) as caught:
            load_robots(path)
        message = str(caught.value)
        assert message.startswith(f"{path}:")
        return message.removeprefix(f"{path}:")

    return load


@pytest.fixture
def answer_instead_of(answer_to):
    """The message after one change to a file that is right."""

    def load(right, wrong):
        assert SPIDER.count(right) >= 1
        return answer_to(SPIDER.replace(right, wrong, 1))

    return load


class TestShippedFile:
    robots = load_robots()

    def test_it_holds_the_five_robots_of_the_papers(self):
        limbs = {
            name: [len(limb.joints) for limb in robot.limbs.values()] for name, robot in self.robots.items()
        }
        assert limbs == {
            "xl430-hexapod": [3] * 6,
            "krsri-hexapod": [3] * 6,
            "udiebot": [3] * 4,
            "eros": [6, 6, 3, 3, 2],
            "receptionist-arm": [3, 3],
        }

    def test_every_figure_says_where_it_comes_from(self):
        for robot in self.robots.values():
            sources = [d.source for d in robot.dimensions]
            for limb in robot.limbs.values():
                sources += [d.source for d in limb.dimensions]
                sources += [limb.mount_source, limb.paper_source]
                sources += [joint.limit_source for joint in limb.joints]
                sources += [j.servo.source for j in limb.joints if j.servo]
                sources += [j.servo.model.source for j in limb.joints if j.servo]
            for source in sources:
                assert source.kind in KINDS
                assert source.text != "the file gives no source", robot.name

    def test_the_servos_are_those_that_the_papers_count(self):
        count = {name: len(robot.servos) for name, robot in self.robots.items()}
        assert count == {
            "xl430-hexapod": 18, "krsri-hexapod": 18, "udiebot": 12, "eros": 0, "receptionist-arm": 6,
        }  # fmt: skip

    def test_the_receptionists_servo_ids_are_the_printed_ones(self):
        limbs = self.robots["receptionist-arm"].limbs
        assert [j.servo.id for j in limbs["right_arm"].joints] == [2, 4, 6]
        assert [j.servo.id for j in limbs["left_arm"].joints] == [1, 3, 5]

    def test_robots_cannot_be_changed_by_accident(self):
        robot = self.robots["eros"]
        with pytest.raises(AttributeError):
            robot.name = "other"
        with pytest.raises(TypeError):
            robot.limbs["new"] = None

    def test_standing_feet_are_within_reach(self):
        for robot in self.robots.values():
            for leg in robot.legs:
                assert leg.ik(leg.stance).reachable, f"{robot.name} {leg.name}"


class TestNames:
    def test_a_robot_is_found_by_its_name_or_a_unique_beginning(self):
        assert load_robot("udiebot").name == load_robot("u").name == "udiebot"

    def test_an_unknown_robot_is_answered_with_the_nearest_names(self):
        with pytest.raises(UsageError, match="no robot is named 'udibot'; did you mean udiebot"):
            load_robot("udibot")

    def test_the_package_gives_the_same_objects(self):
        assert kinlab.load_robot("eros").name == "eros"
        assert list(kinlab.load_robots()) == robot_names()


class TestUsersFile:
    def test_it_adds_robots_to_kinlabs_own(self, tmp_path):
        path = tmp_path / "mine.yaml"
        path.write_text(SPIDER)
        robots = load_robots(path)
        assert list(robots)[-1] == "spider"
        assert "udiebot" in robots
        assert [j.servo.id for j in robots["spider"].limbs["R1"].joints] == [1, 2, 3]
        assert robots["spider"].limbs["L1"].joints[0].servo is None

    def test_it_replaces_a_robot_of_the_same_name(self, tmp_path):
        path = tmp_path / "mine.yaml"
        path.write_text(SPIDER.replace("spider", "udiebot"))
        assert list(load_robot("udiebot", path).limbs) == ["R1", "L1"]
        assert robot_names(path) == robot_names()

    def test_kinlab_robots_names_it_where_no_argument_does(self, tmp_path, monkeypatch):
        path = tmp_path / "mine.yaml"
        path.write_text(SPIDER)
        monkeypatch.setenv("KINLAB_ROBOTS", str(path))
        assert "spider" in robot_names()
        other = tmp_path / "other.yaml"
        other.write_text(SPIDER.replace("spider", "crab"))
        assert "crab" in robot_names(other)
        assert "spider" not in robot_names(other)

    def test_its_servo_models_are_added_too(self, tmp_path):
        path = tmp_path / "mine.yaml"
        path.write_text(
            'servo_models:\n  MY-1: {protocol: "1.0", positions: [0, 99], deg_per_step: 3, '
            "torque_nm: 1, speed_rpm: 60}\n" + SPIDER.replace("AX-12A", "MY-1")
        )
        assert load_robot("spider", path).servos[0].model.range_deg == (0, 297)

    def test_anchors_and_merges_keep_equal_legs_from_being_written_twice(self, tmp_path):
        path = tmp_path / "mine.yaml"
        path.write_text(
            "robots:\n  pair:\n    one: &leg\n"
            "      {coxa: 10, femur: 20, tibia: 30, joints: leg, members: {A: {at: [0, 0, 0]}}}\n"
            "    two: {<<: *leg, femur: 25, members: {B: {at: [0, 9, 0]}}}\n"
        )
        limbs = load_robot("pair", path).limbs
        assert limbs["A"].closed_form.lengths == (0.010, 0.020, 0.030)
        assert limbs["B"].closed_form.lengths == (0.010, 0.025, 0.030)

    def test_a_figure_without_a_source_counts_as_assumed(self, tmp_path):
        path = tmp_path / "mine.yaml"
        path.write_text(SPIDER)
        sources = {d.name: d.source.kind for d in load_robot("spider", path).limbs["R1"].dimensions}
        assert (sources["coxa"], sources["femur"]) == ("assumed", "printed")

    def test_a_mark_at_its_beginning_and_windows_line_ends_are_taken(self, tmp_path):
        path = tmp_path / "mine.yaml"
        path.write_bytes(b"\xef\xbb\xbf" + SPIDER.replace("\n", "\r\n").encode())
        assert "spider" in robot_names(path)


@pytest.mark.parametrize(
    ("right", "wrong", "answer"),
    [
        (FEMUR, "sixty", "6: spider.legs.femur: expected a length in mm, got 'sixty'"),
        (FEMUR, "{mm: sixty}", "6: spider.legs.femur: expected a length in mm, got 'sixty'"),
        (FEMUR, "", "6: spider.legs.femur: expected a length in mm, got nothing"),
        (FEMUR, "yes", "6: spider.legs.femur: expected a length in mm, got yes"),
        (FEMUR, "[50]", "6: spider.legs.femur: expected a length in mm, got [50]"),
        (FEMUR, "-50", "6: spider.legs.femur: expected a length in mm, above 0"),
        (FEMUR, "0", "6: spider.legs.femur: expected a length in mm, above 0"),
        (FEMUR, "5000000", "6: spider.legs.femur: expected a length in mm, above 0 and at most 100000"),
        (FEMUR, ".nan", "6: spider.legs.femur: expected a finite number, got nan"),
        (FEMUR, "-.inf", "6: spider.legs.femur: expected a finite number, got -inf"),
        ("[-60, 60]", "[60, -60]", "10: spider.legs.limits.coxa: the limits are inside out"),
        ("[-60, 60]", "[-60, up]", "10: spider.legs.limits.coxa[1]: expected two angles"),
        ("[-60, 60]", "[-60, 0, 60]", "10: spider.legs.limits.coxa: expected two angles"),
        ("[-60, 60]", "[-60, .nan]", "10: spider.legs.limits.coxa[1]: expected a finite number"),
        ("ids: [1, 2, 3]", "ids: [1, 2]", "17: spider.legs.members.R1.ids: expected 3 servo ids"),
        ("ids: [1, 2, 3]", "ids: [1, 2, 2]", "17: spider.legs.members.R1.ids: servo id 2 is taken by R1 femur"),
        ("ids: [1, 2, 3]", "ids: [1, 2, 253]", "17: spider.legs.members.R1.ids: expected a servo id of 0 to 252"),
        ("ids: [1, 2, 3]", "ids: [1, 2, 3.5]", "17: spider.legs.members.R1.ids[2]: expected a servo id, got 3.5"),
        ("sign: 1}", "sign: 0}", "13: spider.legs.mountings.right.coxa.sign: expected 1 or -1, got 0"),
        ("at: [70, 40, 0]", "at: [70, 40]", "18: spider.legs.members.L1.at: expected a place [x, y, z] in mm"),
        ("turn: 90", "turn: left", "18: spider.legs.members.L1.turn: expected an angle in deg, got 'left'"),
        ("hexapod", "octopod", "3: spider.kind: expected one of hexapod, quadruped, humanoid, arm, got 'octopod'"),
        ("joints: leg", "joints: []", "8: spider.legs.joints: a limb needs at least one joint"),
    ],
)  # fmt: skip
def test_a_wrong_value_is_named_with_file_line_field_and_what_is_allowed(
    answer_instead_of, right, wrong, answer
):
    assert answer_instead_of(right, wrong).startswith(answer)


@pytest.mark.parametrize(
    ("right", "wrong", "answer"),
    [
        ("turn: 90", "trun: 90", "18: spider.legs.members.L1.trun: no such field; did you mean turn?"),
        ("limits:", "limit:", "9: spider.legs.limit: no such field; did you mean limits?"),
        ("printed:", "prnted:", "6: spider.legs.femur.prnted: no such field; did you mean printed?"),
        ("kind:", "knid:", "3: spider.knid: expected a group of limbs, got 'hexapod'; did you mean kind?"),
        ("robots:", "robotz:", "1: robotz: this has no place here; did you mean robots?"),
        ("coxa: [-60", "cxa: [-60", "10: spider.legs.limits.cxa: no joint is named 'cxa'; did you mean coxa?"),
        ("mounting: right", "mounting: rigth",
         "17: spider.legs.members.R1.mounting: no mounting is named 'rigth'; did you mean right?"),
        ("AX-12A", "AX-12B",
         "13: spider.legs.mountings.right.coxa.model: no servo model is named 'AX-12B'; did you mean AX-12A"),
        ("tibia: 70", "tibai: 70",
         "4: spider.legs: 'tibia' is missing: the length of the tibia in mm; did you mean tibai?"),
    ],
)  # fmt: skip
def test_an_unknown_name_is_answered_with_the_nearest(answer_instead_of, right, wrong, answer):
    assert answer_instead_of(right, wrong).startswith(answer)


@pytest.mark.parametrize(
    ("cut", "answer"),
    [
        (f"      femur: {FEMUR}\n", "4: spider.legs: 'femur' is missing"),
        ("      joints: leg\n", "4: spider.legs: 'joints' is missing"),
        ("at: [70, 40, 0], ", "18: spider.legs.members.L1: 'at' is missing"),
        ("          tibia: {model: AX-12A, zero: 150, sign: 1}\n",
         "12: spider.legs.mountings.right: 'tibia' is"),
        ("model: AX-12A, ", "13: spider.legs.mountings.right.coxa: 'model' is missing"),
    ],
)  # fmt: skip
def test_a_missing_field_is_named_with_the_place_where_it_belongs(answer_instead_of, cut, answer):
    assert answer_instead_of(cut, "").startswith(answer)


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("coxa: 25", "coxa: 25\n      coxa: 26"),
        ("L1: {at", "R1: {at"),
        ("    kind:", "    kind: arm\n    kind:"),
    ],
)
def test_nothing_is_said_twice(answer_instead_of, right, wrong):
    assert "stands here twice; first in line" in answer_instead_of(right, wrong)


def test_two_groups_cannot_both_have_a_limb_of_one_name(answer_to):
    extra = SPIDER.split("robots:\n  spider:\n    kind: hexapod\n")[1].replace("legs:", "more:")
    assert "limb R1 exists already, in legs" in answer_to(SPIDER + extra)


@pytest.mark.parametrize(
    ("joints", "answer"),
    [
        ("[{name: a, axis: [0, 0, 0], link: {x: coxa}}]", "an axis must have a direction"),
        ("[{name: a, axis: w, link: {x: coxa}}]", "expected x, y, z, -x, -y, -z or three numbers, got 'w'"),
        ("[{name: a, axis: z, link: {w: coxa}}]", "a link goes along x, y and z, not 'w'"),
        ("[{name: a, axis: z, link: {x: cxoa}}]", "no length is named 'cxoa'; did you mean coxa?"),
        ("[{name: a, axis: z}]", "a limb needs at least one link"),
        ("[{axis: z}]", "'name' is missing"),
        ("arm", "expected 'leg' or a list of joints, got 'arm'"),
        ("[{name: a, axis: z, link: {x: coxa}}, {name: a, axis: z}]", "joint 'a' stands here twice"),
    ],
)
def test_joints_of_ones_own_are_checked_as_closely(answer_instead_of, joints, answer):
    limited = "joints: leg\n      limits:\n        coxa: [-60, 60]\n"
    assert answer in answer_instead_of(limited, f"joints: {joints}\n")


@pytest.mark.parametrize(
    "text",
    ["", "# nothing\n", "[1, 2]", "hello", "5", "robots:\n", "robots: [1]", "robots: {a: }", "robots: {a: hi}",
     "robots: {a: {}}", "robots: {a: {legs: {}}}", "servo_models: hi", "servo_models: {X: hi}", "a: 1\n---\nb: 2\n"],
)  # fmt: skip
def test_a_file_without_robots_is_told_so(answer_to, text):
    assert answer_to(text)[0].isdigit()


def test_a_missing_file_a_directory_and_an_unreadable_one_are_told_apart(tmp_path):
    with pytest.raises(FileError, match="No such file"):
        load_robots(tmp_path / "none.yaml")
    with pytest.raises(FileError, match=r"Is a directory|Permission denied"):
        load_robots(tmp_path)
    with pytest.raises(FileError, match="null byte"):
        load_robots("a\0b")
    closed = tmp_path / "closed.yaml"
    closed.write_text(SPIDER)
    closed.chmod(0)
    if os.access(closed, os.R_OK):
        pytest.skip("this user may read everything")
    with pytest.raises(FileError, match="Permission denied"):
        load_robots(closed)
