"""Make the 3-D pictures, one for each robot: `python docs/scenes.py [FOLDER]`, with Chromium installed.

Each is a recording of `kinlab.scene` in rerun's web viewer, drawn by software in a browser without a window.
"""

import io
import sys
from collections.abc import Callable
from pathlib import Path
from shutil import which
from time import sleep

from PIL import Image
from playwright.sync_api import Page, sync_playwright

from kinlab.gait import find_gait, plan
from kinlab.papers import as_printed
from kinlab.papers.receptionist_experiments import experiment
from kinlab.robots import load_robot
from kinlab.robots.target import solve_target
from kinlab.scene import Recording, View, arm_scene, gait_scene, target_scene
from kinlab.scene.viewer import free_port, viewing

WIDTH, HEIGHT, BAR = 1200, 760, 36
COLOURS = 128
# On the time line at the lower edge, and where the mouse points at nothing.
HALFWAY, BESIDE = (620, HEIGHT - 14), (5, HEIGHT - 5)
SOFTWARE = [
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist",
]
LOADED, DRAWN = 120, 12  # s that the viewer may take to appear, and to draw


def target(name: str, limb: str, *place: float, workspace: bool = False) -> Recording:
    """A limb at a target, in mm."""
    robot = load_robot(name)
    answer = solve_target(robot, robot.limbs[limb], [v / 1000 for v in place])
    return target_scene(
        answer, as_printed(robot, answer.limb, answer.target, answer.rotation), workspace=workspace
    )


def gait(name: str, which: str) -> Recording:
    """A gait at the usual speed."""
    robot = load_robot(name)
    return gait_scene(plan(robot, find_gait(robot, which)))


def arm(name: str) -> Recording:
    """An experiment of the arm."""
    robot = load_robot("receptionist-arm")
    return arm_scene(robot, experiment(robot, robot.limb(), name))


PICTURES: dict[str, Callable[[], Recording]] = {
    "xl430-hexapod": lambda: target("xl430-hexapod", "R1", 75, 10, -46, workspace=True),
    "krsri-hexapod": lambda: gait("krsri-hexapod", "wave"),
    "udiebot": lambda: target("udiebot", "RF", 160, 40, -120),
    "eros": lambda: gait("eros", "four-step"),
    "receptionist-arm": lambda: arm("comply"),
}
MOVING = ("krsri-hexapod", "eros", "receptionist-arm")


def opened(page: Page, address: str) -> None:
    """Go to the viewer, and wait until it has drawn."""
    page.goto(address)
    page.wait_for_selector("canvas", timeout=LOADED * 1000)
    sleep(DRAWN)


def halfway(page: Page) -> None:
    """Move to the middle of the time line."""
    page.mouse.click(*HALFWAY)
    page.mouse.move(*BESIDE)
    sleep(1)


def small(png: bytes) -> Image.Image:
    """The picture with few colours, without the viewer's own bar."""
    whole = Image.open(io.BytesIO(png)).convert("RGB")
    return whole.crop((0, BAR, *whole.size)).quantize(COLOURS, dither=Image.Dither.NONE)


def main(folder: Path, names: list[str]) -> None:
    with sync_playwright() as browsers:
        browser = browsers.chromium.launch(executable_path=which("chromium"), args=SOFTWARE)
        for name in names or PICTURES:
            view = View(browser=True, port=free_port(), page_port=free_port())
            with viewing(PICTURES[name](), view):
                page = browser.new_page(viewport={"width": WIDTH, "height": HEIGHT})
                opened(page, view.page)
                if name in MOVING:
                    halfway(page)
                file = folder / f"view-{name}.png"
                small(page.screenshot(timeout=LOADED * 1000)).save(file, optimize=True)
                page.close()
        browser.close()


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent), sys.argv[2:])
