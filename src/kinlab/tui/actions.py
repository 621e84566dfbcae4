"""What a person can do, declared once: the key, the line of keys, the palette and the help are made from it."""

import os
from collections.abc import Iterable
from dataclasses import dataclass

from textual.binding import Binding, BindingType

from kinlab.guests import is_guest

KEPT_BY_BROWSERS = ("ctrl+n", "ctrl+t", "ctrl+w")  # a window, a tab, its end: no page ever hears of them


@dataclass(frozen=True)
class Action:
    """Something that a person can do.

    Attributes:
        id: its name; its texts are `action.ID.label` and `action.ID.help`.
        keys: as Textual names them, separated by commas; empty where only palette and mouse lead to it.
        run: what is run, as Textual writes it ("step(-1)"); default: its name.
        each: what is run for each of the keys, where they do different things (arrows).
        shown: whether it stands on the line of keys.
        display: how the keys are called; default: the first one's name.
        priority: whether its keys work before those of the widget that has the focus.
    """

    id: str
    keys: str = ""
    run: str = ""
    each: tuple[str, ...] = ()
    shown: bool = True
    display: str = ""
    priority: bool = False

    @property
    def runs(self) -> tuple[str, ...]:
        """Everything that it may run: one for each key, or one."""
        return self.each or (self.run or self.id,)

    def bindings(self) -> list[Binding]:
        """Its keys as Textual takes them, those alone that reach it."""
        keys = self.keys.split(",") if self.keys else []
        runs = self.each or self.runs * len(keys)
        return [
            Binding(
                key,
                run,
                self.id,
                show=self.shown,
                key_display=self.display or None,
                priority=self.priority,
                id=f"{self.id}.{i}",
            )
            for i, (key, run) in enumerate(zip(keys, runs, strict=True))
            if not (is_guest() and key in KEPT_BY_BROWSERS)
        ]


def bindings(actions: Iterable[Action]) -> list[BindingType]:
    """The keys of all these."""
    return [binding for action in actions for binding in action.bindings()]


def named(binding: Binding) -> str:
    """The id of the action that a key belongs to; empty for keys that no action declares."""
    return (
        binding.description
        if binding.id == f"{binding.description}.{(binding.id or '').rpartition('.')[2]}"
        else ""
    )


SUSPEND = Action("suspend", "ctrl+z", "app.suspend_process", display="^z", shown=False)

# What works on every station, in the order of the line of keys. The stations' own keys are added by the app.
SHELL = (
    Action("help", "question_mark,f1", "app.help", display="?"),
    Action("palette", "ctrl+p", "app.command_palette", display="^p"),
    Action("leave", "escape", "screen.leave", shown=False),
    Action("next_station", "ctrl+n", "app.next_station", display="^n"),
    Action("theme", "ctrl+t", "app.theme", display="^t", shown=False),
    Action("language", "ctrl+l", "app.language", display="^l", shown=False),
    # Behind a browser there is no shell to go back to.
    *(() if is_guest() or os.name != "posix" else (SUSPEND,)),
    Action("quit", "ctrl+q", "app.quit", display="^q", priority=True),
)
