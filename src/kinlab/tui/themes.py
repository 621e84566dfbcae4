"""Colours that stay apart for every eye (after Okabe and Ito), on dark and on light ground."""

from textual.theme import Theme

# What is drawn, and in which of the theme's colours. A shape or a word says the same: colour only repeats it.
_DARK = {
    "sky": "#56b4e9",
    "orange": "#e69f00",
    "green": "#2fb58c",
    "purple": "#d68fb5",
    "vermillion": "#f0703a",
    "quiet": "#8a949c",
    "faint": "#4c565e",
}
_LIGHT = {
    "sky": "#0068a8",
    "orange": "#8f5a00",
    "green": "#00674c",
    "purple": "#94447a",
    "vermillion": "#b03a00",
    "quiet": "#5c666e",
    "faint": "#a9b2b9",
}


def _variables(colours: dict[str, str], ground: str) -> dict[str, str]:
    """The theme's variables; scrollbars keep in the background."""
    bars = {f"scrollbar{state}": colours["faint"] for state in ("", "-hover")}
    grounds = {f"scrollbar-background{state}": ground for state in ("", "-hover", "-active")}
    return colours | bars | {"scrollbar-active": colours["quiet"]} | grounds


DARK = Theme(
    name="kinlab-dark",
    primary=_DARK["sky"],
    secondary=_DARK["green"],
    accent=_DARK["orange"],
    warning=_DARK["orange"],
    error=_DARK["vermillion"],
    success=_DARK["sky"],
    foreground="#dfe5e9",
    background="#11171c",
    surface="#182026",
    panel="#212b32",
    dark=True,
    variables=_variables(_DARK, "#182026"),
)
LIGHT = Theme(
    name="kinlab-light",
    primary=_LIGHT["sky"],
    secondary=_LIGHT["green"],
    accent=_LIGHT["orange"],
    warning=_LIGHT["orange"],
    error=_LIGHT["vermillion"],
    success=_LIGHT["sky"],
    foreground="#1b2227",
    background="#fbfbf9",
    surface="#f1f2f0",
    panel="#e3e6e6",
    dark=False,
    variables=_variables(_LIGHT, "#f1f2f0"),
)
THEMES = (DARK, LIGHT)
DEFAULTS = _DARK
