"""What can be done at the Robot station."""

from kinlab.tui.actions import Action

ACTIONS = (
    Action(
        "nudge",
        "left,right,up,down",
        each=("nudge(-1,0)", "nudge(1,0)", "nudge(0,1)", "nudge(0,-1)"),
        display="arrows",
    ),
    Action(
        "leap",
        "shift+left,shift+right,shift+up,shift+down",
        each=("nudge(-10,0)", "nudge(10,0)", "nudge(0,10)", "nudge(0,-10)"),
        display="shift+arrows",
        shown=False,
    ),
    Action("begin", "f7,a"),
    Action("next_solution", "f8,s"),
    Action("next_limb", "f9,l"),
    Action("next_robot", "r"),
    Action("next_frame", "f"),
    Action("view", "v"),
    Action("power", "o"),
    Action("ghost", "p"),
    Action("bounds", "b", shown=False),
    Action("home", "h", shown=False),
    Action("mirror", "m", shown=False),
)
