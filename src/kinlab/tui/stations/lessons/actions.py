"""What can be done at the Lessons station."""

from kinlab.tui.actions import Action

ACTIONS = (
    # At an exercise. Letters from a to f are options, and digits are lines: they answer.
    Action("hint", "f7,h"),
    Action("earlier_hint", "f12,u", shown=False),
    Action("solution", "f8,s"),
    Action("next", "f9,n"),
    Action("previous", "ctrl+o,p", shown=False),
    Action("view", "f10,v"),
    Action("check", "ctrl+g,k"),
    Action("again", "ctrl+r,r"),
    Action("contents", "ctrl+y,l"),
    Action("glossary", "f11,g", shown=False),
    Action("scroll", "pageup,pagedown", each=("scroll(-1)", "scroll(1)"), shown=False, priority=True),
    # At the list.
    Action("search", "slash"),
    Action("only_open", "o"),
    Action("profile", "w"),
    Action("reset", "x"),
)
IN_LESSON = frozenset({"earlier_hint", "previous", "view", "contents", "scroll"})
AT_EXERCISE = frozenset({"hint", "solution", "check", "again"})
AT_LIST = frozenset({"search", "only_open", "profile"})
