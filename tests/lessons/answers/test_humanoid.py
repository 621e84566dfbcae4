"""The six-joint leg, whose sole has an attitude besides its place."""

import pytest

from kinlab.lessons import Task, Verdict, load_course
from kinlab.lessons.answers import humanoid
from kinlab.lessons.kinds import judge

ROBOT, STEP = "eros", {"ahead": 30, "aside": 20, "down": 180}


def said(angles: tuple[float, ...]) -> Verdict:
    task = Task.of(load_course().lesson("six-joint-leg"), "whole", "ani", "en")
    task.__dict__["answer"] = humanoid.whole_leg(ROBOT, **STEP)
    return judge(task, " ".join(f"{angle:.6f}" for angle in angles))


def test_a_sole_in_its_place_that_leans_is_told_by_how_much() -> None:
    right = humanoid.whole_leg(ROBOT, **STEP).solution_deg
    assert said(right).ok
    leaning = said((*right[:5], right[5] + 2.5))
    assert not leaning.ok
    assert leaning.code == "tilt"
    assert "2.5 degrees askew" in leaning.message


def test_the_legs_three_pitch_angles_add_up_to_a_level_sole_and_the_rolls_cancel() -> None:
    yaw, hip_roll, hip, knee, ankle, ankle_roll = humanoid.whole_leg(ROBOT, **STEP).solution_deg
    assert hip + knee + ankle == pytest.approx(0, abs=1e-9)
    assert hip_roll + ankle_roll == pytest.approx(0, abs=1e-9)
    assert yaw == pytest.approx(0, abs=1e-9)
