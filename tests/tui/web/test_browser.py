"""The page in a browser: nothing fails, nothing is asked from elsewhere, and the laboratory is painted."""

import asyncio
import os
import shutil
from pathlib import Path
from urllib.parse import urlsplit

import pytest

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
FLAGS = (
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
)
WHERE = "KINLAB_SCREENSHOTS"
MS = 90_000


def browser_path() -> str:
    """An installed Chromium; without one the test is skipped."""
    found = next((path for name in NAMES if (path := shutil.which(name))), None)
    if found is None:
        pytest.skip("no browser is installed; on Debian: apt-get install chromium")
    return found


def test_the_page_fails_nowhere_asks_nobody_else_and_paints_the_laboratory(serve, tmp_path):
    api = pytest.importorskip(
        "playwright.async_api", reason="playwright is not installed: pip install playwright"
    )
    path = browser_path()
    folder = Path(os.environ.get(WHERE, tmp_path))
    asked, wrong = [], []

    async def script(served):
        async with api.async_playwright() as playwright:
            browser = await playwright.chromium.launch(executable_path=path, args=list(FLAGS), timeout=MS)
            page = await browser.new_page(viewport={"width": 1000, "height": 620})
            page.set_default_timeout(MS)
            page.on("request", lambda request: asked.append(request.url))
            page.on("websocket", lambda line: asked.append(line.url))
            page.on("requestfailed", lambda request: wrong.append(request.url))
            page.on("response", lambda answer: wrong.append(answer.url) if answer.status >= 400 else None)
            page.on("pageerror", lambda error: wrong.append(str(error)))
            page.on("console", lambda said: wrong.append(said.text) if said.type == "error" else None)
            await page.goto(f"http://{served.place}/")
            await page.wait_for_selector("body.-first-byte", timeout=MS)
            assert await page.evaluate("document.fonts.check('16px \"Roboto Mono\"')")
            # Without a click, keys reach the laboratory: the picture changes with what is typed.
            before = await settled(page)
            await page.keyboard.press("F3")
            after = await settled(page, other_than=before)
            (folder / "serve.png").write_bytes(after)
            await page.keyboard.press("Control+q")
            await page.wait_for_selector("body.-closed .ended", state="visible", timeout=MS)
            await browser.close()

    serve(script, small=False)
    assert not wrong
    assert {urlsplit(url).hostname for url in asked} == {"127.0.0.1"}
    assert any(url.startswith("ws://") for url in asked)


async def settled(page, other_than=b""):
    """The page's picture, as soon as it stands still, and shows something else than another one did."""
    last = b""
    async with asyncio.timeout(MS / 1000):
        while True:
            seen = await page.locator("#terminal").screenshot()
            if seen == last and seen != other_than:
                return seen
            last = seen
            await asyncio.sleep(0.3)
