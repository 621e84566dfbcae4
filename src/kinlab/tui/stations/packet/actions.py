"""What can be done at the Packet station. While the line has the focus, letters belong to it."""

from kinlab.tui.actions import Action

ACTIONS = (
    Action("revive", "ctrl+r,p"),
    Action("assemble", "f7,a"),
    Action("send", "f8,s"),
    Action("faults", "f9,f"),
    Action("view", "f10,v"),
    Action("next_servo", "ctrl+o,n"),
    Action("next_chain", "ctrl+g,c", shown=False),
    Action("line", "i,colon", shown=False),
    Action("back", "backspace", shown=False),
    Action("hold", "ctrl+y,t", shown=False),
    Action("scroll", "pageup,pagedown", each=("scroll(-1)", "scroll(1)"), shown=False),
)
