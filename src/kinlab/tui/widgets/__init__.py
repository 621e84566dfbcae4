"""What stations are built from."""

from kinlab.tui.widgets.choice import Choice
from kinlab.tui.widgets.dial import Dial
from kinlab.tui.widgets.number_field import NumberField
from kinlab.tui.widgets.picture import Picture
from kinlab.tui.widgets.plot import Plot
from kinlab.tui.widgets.said import Said
from kinlab.tui.widgets.slider import Slider

__all__ = ["Choice", "Dial", "NumberField", "Picture", "Plot", "Said", "Slider"]
