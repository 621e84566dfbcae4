"""Two links, and a place seen from a leg and from the body."""

import pytest

from kinlab.lessons.answers import frames

XL430, KRSRI = "xl430-hexapod", "krsri-hexapod"


def test_a_femur_straight_up_and_a_tibia_square_to_it_end_at_their_own_lengths() -> None:
    assert frames.two_links(XL430, 90, -90) == pytest.approx([70, 50])


def test_a_tibia_measured_from_the_ground_ends_elsewhere() -> None:
    assert frames.two_links_with_bare_gamma(XL430, 90, -90) == pytest.approx([0, 50 - 70])


def test_a_stiff_knee_takes_the_tibia_along() -> None:
    assert frames.tibia_turns(XL430, 10, -80, 20) == "along"


def test_a_foot_straight_out_of_the_left_front_leg_is_ahead_and_to_the_left() -> None:
    # L1 sits at (80, 55) and is turned by 45 deg: 130 mm outwards are 91.924 on both axes.
    assert frames.in_body(KRSRI, "L1", 130, 0, -90) == pytest.approx([171.924, 146.924, -90], abs=1e-3)
    assert frames.stance_in_body(KRSRI, "L1") == frames.in_body(KRSRI, "L1", 130, 0, -90)


@pytest.mark.parametrize("limb", ["R1", "R3", "L1", "L3"])
def test_what_the_leg_sees_of_a_place_goes_back_to_it(limb: str) -> None:
    seen = frames.in_leg(KRSRI, limb, 150, 120, -80)
    assert frames.in_body(KRSRI, limb, *seen) == pytest.approx([150, 120, -80])
