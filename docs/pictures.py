"""Make the pictures of the README from what the program prints: `python docs/pictures.py`."""

import io
import re
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
    svg = out.export_svg(title="kinlab ik")
    # No request leaves the page: the fonts of the reader's machine serve.
    return re.sub(r"@font-face \{.*?\}\s*", "", svg, flags=re.DOTALL)


(HERE / "ik.svg").write_text(ik_picture(), encoding="utf-8")
