"""Where people's units meet metres."""

import numpy as np
import pytest

from kinlab.errors import UsageError
from kinlab.units import check_place, finite, to_metres, to_mm


@pytest.mark.parametrize(("unit", "metres"), [("mm", 0.025), ("cm", 0.25), ("m", 25.0)])
def test_lengths_become_metres(unit, metres):
    assert to_metres([25, 0, -25], unit) == pytest.approx([metres, 0, -metres])


def test_metres_become_millimetres():
    assert to_mm([0.025]).tolist() == [25.0]


def test_an_unknown_unit_is_refused():
    with pytest.raises(UsageError, match="no unit is named 'inch'"):
        to_metres(1, "inch")


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_only_finite_numbers_pass(value):
    with pytest.raises(UsageError, match="angles must be finite numbers"):
        finite([0, value], "angles")


def test_a_place_beyond_all_reason_is_refused():
    with pytest.raises(UsageError, match="is the unit right"):
        check_place([0, 0, 1e7], "a target")
