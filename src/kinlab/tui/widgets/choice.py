"""One of a few names, in one row; a list opens to choose from."""

from collections.abc import Iterable
from typing import Any

from textual.content import Content
from textual.widgets import Select
from textual.widgets._select import SelectCurrent


class Choice(Select[str]):
    """A list of names, of which one is chosen; posts `Select.Changed`, and nothing when it is set by `put`."""

    DEFAULT_CSS = """
    Choice { width: 20; }
    Choice > SelectOverlay { max-height: 12; }
    """

    def __init__(self, names: Iterable[str], value: str, **settings: Any) -> None:
        self.names = self.labels = list(names)
        super().__init__(
            [(Content(name), name) for name in names],
            value=value,
            allow_blank=False,
            compact=True,
            **settings,
        )

    def offer(self, names: Iterable[str], value: str, labels: Iterable[str] | None = None) -> None:
        """Other names, one of them chosen; tells nobody.

        Args:
            labels: what is shown for each; default the names.
        """
        self.names = list(names)
        self.labels = self.names if labels is None else list(labels)
        with self.prevent(Select.Changed):
            self.set_options(
                [(Content(label), name) for label, name in zip(self.labels, self.names, strict=True)]
            )
            self.value = value
        # The same name may be called otherwise now, in another language.
        for current in self.query(SelectCurrent):
            current.update(Content(self.labels[self.names.index(value)]))

    def put(self, value: str) -> None:
        """Choose; tells nobody."""
        with self.prevent(Select.Changed):
            self.value = value
