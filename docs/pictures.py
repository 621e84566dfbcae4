"""Make the pictures of the README from what the program prints: `python docs/pictures.py`."""

import asyncio
import io
import os
import re
import tempfile
from collections.abc import Sequence
from pathlib import Path

from rich.console import Console

from kinlab.cli import show
from kinlab.cli.ik_tables import show_answer
from kinlab.robots import load_robot
from kinlab.robots.target import solve_target

HERE = Path(__file__).parent


def ik_picture() -> str:
    """`kinlab ik` on the first row of a paper's table, as SVG."""
    out = Console(record=True, width=96, force_terminal=True, color_system="truecolor", file=io.StringIO())
    show.console = lambda: out
    robot = load_robot("xl430-hexapod")
    out.print("$ kinlab ik xl430-hexapod 75 10 -46 --limb R1", style="bold", highlight=False)
    answer = solve_target(robot, robot.limbs["R1"], [0.075, 0.010, -0.046])
    show_answer(answer)
    return without_fonts(out.export_svg(title="kinlab ik"))


def without_fonts(svg: str) -> str:
    """The picture as it is drawn with the fonts of the reader's machine: no request leaves the page."""
    return re.sub(r"@font-face \{.*?\}\s*", "", svg, flags=re.DOTALL)


# Of each station: the size, what is pressed, and how long (s) is waited after each key.
STATIONS: dict[str, tuple[tuple[int, int], Sequence[str], float]] = {
    "robot": ((110, 42), ("escape", "right", "up"), 0.5),
    "gait": ((110, 34), ("escape", "n", "right", "right", "right", "right", "right", "right"), 0.3),
    "packet": ((110, 34), (*"write 1 goal_position 90deg", "enter"), 0.05),
    "arm": ((110, 34), ("escape", "space", "left", "left"), 0.8),
}


def station_picture(name: str) -> str:
    """A station of the laboratory after some keys, as SVG."""
    from kinlab.tui.app import KinlabApp

    size, keys, pause = STATIONS[name]
    app = KinlabApp(name)

    async def run() -> str:
        async with app.run_test(size=size) as pilot:
            await pilot.pause(1.0)
            for key in keys:
                await pilot.press({" ": "space", "_": "underscore"}.get(key, key))
                await pilot.pause(pause)
            await pilot.pause(1.0)
            return app.export_screenshot(title=f"kinlab: {name}")

    return without_fonts(asyncio.run(run()))


(HERE / "ik.svg").write_text(ik_picture(), encoding="utf-8")
os.environ |= {"KINLAB_LANG": "en", "TEXTUAL_ANIMATIONS": "none"}
for name in STATIONS:
    with tempfile.TemporaryDirectory() as home:
        os.environ["KINLAB_HOME"] = home
        (HERE / f"tui-{name}.svg").write_text(station_picture(name), encoding="utf-8")
