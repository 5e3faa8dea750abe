# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw docs/figures/report.png: the demo's report in Chromium, in light and dark mode.

python docs/report_picture.py [results/demo/report.html]
"""

from __future__ import annotations

import shutil
import sys
from io import BytesIO
from pathlib import Path

from PIL import Image
from playwright.sync_api import Browser, expect, sync_playwright

FIGURE = Path(__file__).parent / "figures" / "report.png"
PAGE = Path("results/demo/report.html")
SIZE = {"width": 960, "height": 1330}
#: Script that scrolls to an element, and shortens paths so that they begin at `results`.
TO_TOP = """at => {
  for (const path of document.querySelectorAll("code"))
    path.textContent = path.textContent.replace(/^.*(?=results)/, "");
  const element = document.querySelector(at);
  document.documentElement.style.scrollPaddingTop = element.style.scrollMarginTop = 0;
  element.scrollIntoView();
}"""
#: Time-out [ms], long enough for a busy machine.
TIMEOUT = 120_000


def look(browser: Browser, page_file: Path, mode: str, at: str, frame: float) -> Image.Image:
    """Return a picture of the page in a browser.

    Args:
        browser: Browser of Playwright.
        page_file: File of the page.
        mode: "light" or "dark".
        at: Selector of the element at the top.
        frame: Position in the movies, from 0 to 1.
    """
    with browser.new_context(viewport=SIZE, color_scheme=mode) as context:
        context.set_default_timeout(TIMEOUT)
        page = context.new_page()
        page.goto(page_file.resolve().as_uri())
        page.wait_for_selector("html[data-ready]")
        expect(page.locator(".plot:not([data-drawn])")).to_have_count(0)
        for slider in page.locator("[data-movie] .time").all():
            slider.fill(str(round(frame * int(slider.get_attribute("max")))))
        page.evaluate("document.activeElement.blur()")
        page.evaluate(TO_TOP, at)
        page.wait_for_timeout(2000)
        return Image.open(BytesIO(page.screenshot())).convert("RGB")


def draw(page_file: Path, figure: Path) -> None:
    """Write the picture: the head of the page in light mode, and the hopper in dark mode."""
    expect.set_options(timeout=TIMEOUT)
    drawing = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    with sync_playwright() as driver:
        browser = driver.chromium.launch(
            executable_path=shutil.which("chromium"), args=[*drawing, "--no-sandbox"]
        )
        shown = [
            look(browser, page_file, "light", "header", 0),
            look(browser, page_file, "dark", "main > section.run:last-child", 0.5),  # the hopper
        ]
        browser.close()
    whole = Image.new("RGB", (2 * SIZE["width"], SIZE["height"]))
    for k, part in enumerate(shown):
        whole.paste(part, (k * SIZE["width"], 0))
    whole.save(figure, optimize=True)


if __name__ == "__main__":
    draw(Path(sys.argv[1]) if len(sys.argv) > 1 else PAGE, FIGURE)
    print(f"written: {FIGURE}")
