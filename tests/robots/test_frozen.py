"""A robot cannot be changed by accident."""

import pytest

from kinlab.robots import load_robot


@pytest.mark.parametrize("name", ["axes", "links", "limits", "mount", "stance", "paper_axes"])
def test_a_limbs_arrays_cannot_be_written_to(name):
    values = getattr(load_robot("udiebot").limb(), name)
    with pytest.raises(ValueError, match="read-only"):
        values[0] = 9.0
