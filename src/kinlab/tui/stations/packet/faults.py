"""The faults, each at a key."""

from typing import TYPE_CHECKING, ClassVar

from textual import on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.screen import ModalScreen
from textual.widgets import OptionList, Static

from kinlab.dynamixel.sandbox.inspection import Fault, faults

if TYPE_CHECKING:
    from kinlab.tui.stations.packet.station import PacketStation

KEYS = {
    "drop": "d",
    "flip": "f",
    "noise": "n",
    "delay": "l",
    "echo": "e",
    "power": "p",
    "overload": "o",
    "overheating": "h",
    "stuck": "s",
    "dead": "x",
}


class Faults(ModalScreen[None]):
    """Over the station: what can go wrong, turned on and off by a letter, Enter or a click."""

    DEFAULT_CSS = """
    Faults { align: center middle; }
    Faults > Vertical {
        width: 66; max-width: 100%; height: auto; max-height: 100%;
        background: $surface; border: round $quiet; padding: 0 1;
    }
    Faults Static { height: auto; }
    Faults .head { text-style: bold; }
    Faults OptionList { height: auto; max-height: 12; border: none; padding: 0; background: $surface; }
    Faults OptionList, Faults OptionList:focus {
        background-tint: $surface 0%;
        & > .option-list--option-highlighted { background: $faint; color: $foreground; }
    }
    """
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,q,f9", "dismiss", show=False),
        Binding("ctrl+q", "app.quit", show=False, priority=True),
        *(Binding(key, f"turn('{name}')", show=False) for name, key in KEYS.items()),
    ]

    def __init__(self, station: "PacketStation") -> None:
        super().__init__()
        self._station = station

    def compose(self) -> ComposeResult:
        say = self._station.say
        with Vertical():
            yield Static(say("faults.head", servo=self._station.servo), classes="head", markup=False)
            yield OptionList(compact=True, markup=False)
            yield Static(say("faults.close"), markup=False)

    def on_mount(self) -> None:
        self._show(0)
        self.query_one(OptionList).focus()

    def _found(self) -> list[Fault]:
        return faults(self._station.session, self._station.servo)

    def _show(self, at: int) -> None:
        rows = self.query_one(OptionList)
        rows.clear_options()
        rows.add_options([self._row(fault) for fault in self._found()])
        rows.highlighted = at

    def _row(self, fault: Fault) -> Content:
        say = self._station.say
        state = say("faults.on" if fault.on else "faults.off")
        return Content.assemble(
            Content.styled(f"{KEYS[fault.name]}  ", "bold $orange"),
            Content.styled(f"{state:<4} ", "bold $vermillion" if fault.on else "$quiet"),
            say(f"fault.{fault.name}"),
            Content.styled(f"  {fault.detail}" if fault.on else "", "bold"),
        )

    def action_turn(self, name: str) -> None:
        """Turn one over."""
        found = self._found()
        at = next(i for i, fault in enumerate(found) if fault.name == name)
        self._station.carry_out(found[at].line)
        self._show(at)

    @on(OptionList.OptionSelected)
    def _chosen(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        self.action_turn(self._found()[event.option_index].name)
