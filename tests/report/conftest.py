# SPDX-License-Identifier: GPL-2.0-or-later
"""Fixtures: results of a sweep and of a bulk run, and their report page in a browser."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from fcntl import LOCK_EX, flock
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect, sync_playwright

from plastigran.experiments.central import CentralImpact
from plastigran.report.page import write_report

#: Longest time that a loaded machine may take to draw [ms].
TIMEOUT = 60_000
#: Sides of the window [px].
WINDOW = {"width": 1000, "height": 700}
LAWS = ("kogut_etsion", "thornton", "universal")
SPEEDS = (0.001, 0.01, 0.1)


@pytest.fixture(scope="session")
def hopper(brief_run) -> Path:
    """Folder of a short bulk run of the hopper deck, with snapshots of the grains."""
    return brief_run("hopper").folder


@pytest.fixture(scope="session")
def shared(workers_folder) -> Path:
    """Folder that the workers of pytest share."""
    folder = workers_folder / "report"
    folder.mkdir(exist_ok=True)
    return folder


@pytest.fixture(scope="session")
def sweep_folder(shared) -> Path:
    """Folder of a sweep of three laws and three speeds."""
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
    """Report page on the sweep, the bulk run of the hopper and an empty folder."""
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
    """Headless Chromium that computes WebGL in software."""
    drawing = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    expect.set_options(timeout=TIMEOUT)
    with sync_playwright() as driver:
        chromium = shutil.which("chromium")
        assert chromium, "Debian's chromium is missing: ./run setup installs it"
        browser = driver.chromium.launch(executable_path=chromium, args=[*drawing, "--no-sandbox"])
        yield browser
        browser.close()


class Visit:
    """A page in the browser, with its console messages and its network requests."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.messages: list[str] = []
        self.requests: list[str] = []
        page.on("console", lambda message: self.messages.append(message.text))
        page.on("pageerror", lambda error: self.messages.append(str(error)))
        page.on("request", lambda request: self.requests.append(request.url))

    def open(self, file: Path) -> Page:
        """Open a file and wait until all charts are drawn."""
        self.page.goto(file.as_uri())
        self.page.wait_for_selector("html[data-ready]")
        expect(self.page.locator(".plot:not([data-drawn])")).to_have_count(0)
        return self.page


@pytest.fixture(scope="session")
def visit(browser, page_file) -> Iterator[Visit]:
    """The report page, opened once for all tests; each test resets the switches that it uses."""
    with browser.new_context(viewport=WINDOW) as context:
        context.set_default_timeout(TIMEOUT)
        visit = Visit(context.new_page())
        visit.open(page_file)
        yield visit


@pytest.fixture
def page(visit) -> Page:
    return visit.page
