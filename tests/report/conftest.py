# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of each kind, whole, broken and cut short, and the page on them in a browser."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from fcntl import LOCK_EX, flock
from pathlib import Path

import pytest
from playwright.sync_api import Browser, ConsoleMessage, Page, Request, expect, sync_playwright

from plastigran.experiments.central import CentralImpact
from plastigran.report.page import write_report

#: A loaded machine draws slowly [ms].
PATIENCE = 60_000
#: Sides of the window [px].
DESK = {"width": 1000, "height": 700}
LAWS = ("kogut_etsion", "thornton", "universal")
SPEEDS = (0.001, 0.01, 0.1)


@pytest.fixture(scope="session")
def hopper(brief_run) -> Path:
    """Folder of a short run of the hopper, with frames."""
    return brief_run("hopper").folder


@pytest.fixture(scope="session")
def shared(workers_folder) -> Path:
    """A folder for these tests that pytest's workers share."""
    folder = workers_folder / "report"
    folder.mkdir(exist_ok=True)
    return folder


@pytest.fixture(scope="session")
def sweep_folder(shared) -> Path:
    """Folder of a sweep of three laws over three speeds."""
    folder = shared / "speeds"
    with open(shared / "speeds.lock", "w") as lock:
        flock(lock, LOCK_EX)
        if not (folder / "done").exists():
            study = CentralImpact.study(folder, 2, False, True, law=LAWS, speed=SPEEDS)
            study.write(folder)
            (folder / "done").touch()
    return folder


@pytest.fixture(scope="session")
def page_file(shared, sweep_folder, hopper) -> Path:
    """A page on both, and on a folder that holds nothing."""
    page = shared / "report.html"
    with open(shared / "report.lock", "w") as lock:
        flock(lock, LOCK_EX)
        if not page.exists():
            (shared / "empty").mkdir()
            folder = shared / "hopper"
            shutil.copytree(hopper, folder)
            write_report([sweep_folder, folder, shared / "empty"], page, "A test")
    return page


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """Chromium without a screen, which draws in three dimensions by software."""
    drawing = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    expect.set_options(timeout=PATIENCE)
    with sync_playwright() as driver:
        chromium = shutil.which("chromium")
        assert chromium, "Debian's chromium is missing: ./run setup installs it"
        browser = driver.chromium.launch(executable_path=chromium, args=[*drawing, "--no-sandbox"])
        yield browser
        browser.close()


class Visit:
    """A page that was opened, and what the browser said and asked for meanwhile."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.said: list[str] = []
        self.asked: list[str] = []
        page.on("console", self._take_word)
        page.on("pageerror", lambda error: self.said.append(str(error)))
        page.on("request", self._take_request)

    def _take_word(self, message: ConsoleMessage) -> None:
        self.said.append(message.text)

    def _take_request(self, request: Request) -> None:
        self.asked.append(request.url)

    def open(self, file: Path) -> Page:
        """Open a file and wait until every chart is drawn."""
        self.page.goto(file.as_uri())
        self.page.wait_for_selector("html[data-ready]")
        expect(self.page.locator(".plot:not([data-drawn])")).to_have_count(0)
        return self.page


@pytest.fixture(scope="session")
def visit(browser, page_file) -> Iterator[Visit]:
    """The page, opened once; tests leave its switches as they find them."""
    with browser.new_context(viewport=DESK) as context:
        context.set_default_timeout(PATIENCE)
        visited = Visit(context.new_page())
        visited.open(page_file)
        yield visited


@pytest.fixture
def page(visit) -> Page:
    return visit.page
