"""The line of keys: those that work now, as many as there is room for; each at a click as well."""

from collections.abc import Callable
from typing import Any

from textual.app import App
from textual.binding import Binding
from textual.content import Content
from textual.events import Click
from textual.widget import Widget

from kinlab.language import words_of
from kinlab.tui.actions import named
from kinlab.tui.widgets.said import SHELL_WORDS, say

GAP = "  "


def key_name(app: App[Any], say_it: Callable[[str], str], binding: Binding) -> str:
    """What a key is called; several that belong together ("arrows") by a word of the language."""
    name = app.get_key_display(binding)
    return say_it(f"key.{name}") if f"key.{name}" in words_of(SHELL_WORDS).entries else name


class KeyLine(Widget):
    """Keys and what they do. What finds no room is left out whole, and help and quit keep their places."""

    DEFAULT_CSS = "KeyLine { height: 1; background: $panel; color: $foreground; padding: 0 1; }"
    LAST = ("help", "palette", "quit")

    def on_mount(self) -> None:
        self.screen.bindings_updated_signal.subscribe(self, lambda _: self.refresh())

    def entries(self) -> list[tuple[str, str, Binding]]:
        """Of each action that can be used now: the name of its key, its label, and the key."""
        found: dict[str, tuple[str, str, Binding]] = {}
        focused = self.screen.focused
        for active in self.screen.active_bindings.values():
            binding, name = active.binding, named(active.binding)
            if not (binding.show and active.enabled and name) or name in found:
                continue
            key = key_name(self.app, self._say, binding)
            # A letter that the field with the focus would take for itself does not work now.
            plain = (
                binding.key
                if len(binding.key) == 1
                else {"question_mark": "?", "space": " "}.get(binding.key)
            )
            if plain and focused is not None and focused.check_consume_key(binding.key, plain):
                continue
            found[name] = (key, self._say(f"action.{name}.label"), binding)
        last = [found.pop(name) for name in self.LAST if name in found]
        room = self.size.width - sum(len(k) + len(t) + 1 + len(GAP) for k, t, _ in last) + len(GAP)
        kept = []
        for entry in found.values():
            room -= len(entry[0]) + len(entry[1]) + 1 + len(GAP)
            if room < 0:
                break
            kept.append(entry)
        return kept + last

    def _say(self, key: str) -> str:
        speaker = getattr(self.screen, "say", None)
        return str(speaker(key)) if speaker else say(self, key)

    def render(self) -> Content:
        pieces: list[Content | str] = []
        for key, label, _ in self.entries():
            pieces += [Content.styled(key, "bold $orange"), Content(f" {label}{GAP}")]
        return Content.assemble(*pieces)

    def on_click(self, event: Click) -> None:
        at = 1
        for key, label, binding in self.entries():
            end = at + len(key) + 1 + len(label)
            if at <= event.x < end:
                self.app.simulate_key(binding.key)
                return
            at = end + len(GAP)
