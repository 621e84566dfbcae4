"""The instrument beside an exercise: a limb to turn, a gait, a chain's registers and wire, the bytes that are typed."""

from collections.abc import Callable
from typing import Any

import numpy as np
from textual import on
from textual.app import ComposeResult
from textual.containers import Horizontal, Vertical

from kinlab.canvas import Canvas
from kinlab.dynamixel.codec.dissect import dissect
from kinlab.dynamixel.codec.hextext import HexError, parse_hex, show_hex
from kinlab.dynamixel.sandbox.display import field_lines, style_of
from kinlab.dynamixel.sandbox.inspection import holdings
from kinlab.dynamixel.sandbox.session import Line
from kinlab.kinematics.transforms import Array
from kinlab.lessons.kinds.state import Workbench
from kinlab.robots import Limb
from kinlab.robots.views import SIDE, TOP, draw_view, size_of, view
from kinlab.tui.numbers import shown
from kinlab.tui.stations.gait.diagram import Diagram
from kinlab.tui.stations.lessons.gait_bench import GaitBench
from kinlab.tui.stations.packet.registers import Registers
from kinlab.tui.stations.packet.sheet import Sheet
from kinlab.tui.stations.packet.traffic import Traffic
from kinlab.tui.widgets import Dial, Picture, Said
from kinlab.tui.widgets.picture import Draw

MOST_JOINTS = 6
FINENESS = 40  # of the outline of what is within reach


class LegBench(Vertical):
    """A limb from the side and from the top, a dial for each joint."""

    DEFAULT_CSS = """
    LegBench {
        #views { height: 1fr; }
        #views Picture { width: 1fr; height: 100%; }
        Dial .name { width: 12; }
    }
    """

    def __init__(self) -> None:
        super().__init__()
        self.limb: Limb | None = None
        self.q: Array = np.zeros(0)
        self.target: Array | None = None
        self._box: Array = np.zeros((2, 3))
        self._dials = [Dial(widest=(-360.0, 360.0)) for _ in range(MOST_JOINTS)]

    def compose(self) -> ComposeResult:
        with Horizontal(id="views"):
            for name in (SIDE, TOP):
                yield Picture(self._drawing(name), self._caption(name), id=name)
        yield from self._dials

    def take(self, limb: Limb, q: Array, target: Array | None = None) -> None:
        """Show a limb in a pose (n,), rad, and a place (3,), metres, limb frame, that it is to reach."""
        if limb is not self.limb:
            self.limb, self._box = limb, size_of(limb)
        self.target = target
        for dial in self._dials[len(limb.joints) :]:
            dial.display = False
        low, high = np.degrees(limb.limits)
        for i, (dial, name) in enumerate(zip(self._dials, limb.joint_names, strict=False)):
            dial.display = True
            dial.label(name)
            dial.span(float(low[i]), float(high[i]), 1.0, "deg")
        self.pose(q)

    def pose(self, q: Array) -> None:
        """Show another pose."""
        self.q = q
        for dial, angle in zip(self._dials, np.degrees(q), strict=False):
            dial.show(float(angle))
        self._redraw()

    def _redraw(self) -> None:
        for picture in self.query(Picture):
            picture.redraw()

    def _drawing(self, name: str) -> Draw:
        def draw(columns: int, rows: int, ascii_only: bool) -> Canvas | None:
            if self.limb is None:
                return None
            tip = self.limb.fk(self.q)[:3, 3]
            seen = view(self.limb, name, tip, self._box, fineness=FINENESS)
            return draw_view(
                seen, self.q, self.target, limits=True, columns=columns, rows=rows, ascii_only=ascii_only
            )

        return draw

    def _caption(self, name: str) -> Callable[[Canvas], str]:
        def caption(canvas: Canvas) -> str:
            return self._say(f"leg.{name}", cell=shown(canvas.cell_width, 1))

        return caption

    def _say(self, key: str, **values: object) -> str:
        station: Any = self.screen
        return str(station.say(key, **values))

    @on(Dial.Changed)
    def _dialled(self, event: Dial.Changed) -> None:
        event.stop()
        if self.limb is not None:
            self.q = np.radians([dial.number for dial in self._dials[: len(self.limb.joints)]])
            self._redraw()


class ChainBench(Vertical):
    """What a chain's servo holds, and what went over the wire."""

    DEFAULT_CSS = """
    ChainBench {
        .head { text-style: bold; padding: 0 1; height: 1; }
        Registers { height: 1fr; }
        Traffic { height: 1fr; }
    }
    """

    def compose(self) -> ComposeResult:
        yield Said("registers", classes="head", id="holder", servo="")
        yield Registers()
        yield Said("wire", classes="head")
        yield Traffic()

    def show(self, bench: Workbench, servo: int, ascii_only: bool, names: dict[str, str]) -> None:
        """Show the bench as it is now; of one that is talked to as a real bus, the wire alone."""
        registers = self.query_one(Registers)
        registers.display = self.query_one("#holder").display = not bench.goal.as_real
        if not bench.goal.as_real:
            registers.label(names)
            self.query_one("#holder", Said).fill(servo=servo)
            registers.put(holdings(bench.session, servo), "<" if ascii_only else "◂")
        self.query_one(Traffic).put(bench.session)

    def bring(self, register: str) -> None:
        """Let a register be seen."""
        self.query_one(Registers).bring(register)


class BytesBench(Vertical):
    """The bytes that are typed, each under the name of the field that it stands for; judged nowhere."""

    def compose(self) -> ComposeResult:
        yield Said("bytes.head", id="bytes-head")
        yield Sheet(id="bytes")

    DEFAULT_CSS = "BytesBench #bytes-head { text-style: bold; padding: 0 1; }"

    def show(self, text: str, *, whole: bool, empty: str) -> None:
        """Take a line of bytes apart; `whole`: with the meaning of each field, as nothing is left to be found."""
        try:
            data = parse_hex(text)
        except HexError as error:
            data = parse_hex(text[: error.position].rpartition(" ")[0])
        lines: list[Line] = [[("dim", empty)]]
        if data:
            found = dissect(data)
            lines = field_lines(found) if whole else []
            for part in found.fields if not whole else ():
                style = style_of(part.name)
                row = [
                    ("dim", f"{part.offset:>3}  "),
                    (style, f"{show_hex(part.data):<15} "),
                    (style, part.name),
                ]
                lines.append(row)
        self.query_one("#bytes", Sheet).put(lines)


class Bench(Vertical):
    """The place of the instrument; one of them is there, or none."""

    DEFAULT_CSS = """
    Bench {
        height: 1fr; padding: 0 1;
        LegBench, GaitBench, ChainBench, BytesBench { display: none; height: 1fr; }
        &.leg LegBench, &.gait GaitBench, &.chain ChainBench, &.bytes BytesBench { display: block; }
    }
    """
    KINDS = ("leg", "gait", "chain", "bytes")

    def compose(self) -> ComposeResult:
        yield LegBench()
        yield GaitBench()
        yield ChainBench()
        yield BytesBench()

    def relabel(self) -> None:
        """Write what stands in pictures in the language of now."""
        for picture in self.query(Picture):
            picture.redraw()
        self.query_one(Diagram).refresh()

    def use(self, kind: str) -> None:
        """Put an instrument there; "" for none."""
        for each in self.KINDS:
            self.set_class(each == kind, each)
