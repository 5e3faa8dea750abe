# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the report page in a browser: no errors, no network, and all controls work."""

from __future__ import annotations

from io import BytesIO

import numpy as np
import pytest
from axe_playwright_python.sync_playwright import Axe
from PIL import Image
from playwright.sync_api import Locator, Page, expect


def pixels(element: Locator) -> np.ndarray:
    """Return a screenshot of an element as an array (height, width, 3)."""
    element.scroll_into_view_if_needed()
    return np.asarray(Image.open(BytesIO(element.screenshot())).convert("RGB"), int)


def drawn(seen: np.ndarray) -> float:
    """Return the fraction of the pixels of a picture that differ from the background."""
    ground = seen[2, 2]
    return float((np.abs(seen - ground).max(axis=2) > 24).mean())


def settle(page: Page) -> None:
    """Wait until the browser has drawn the page two more times."""
    page.evaluate(
        "() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"
    )


def shown_laws(page: Page, chart: str) -> set[str]:
    return set(
        page.evaluate(
            "n => document.getElementById(n).data.filter(t => t.visible).map(t => t.meta.law)"
            ".filter(law => law)",
            chart,
        )
    )


def test_page_is_small_and_needs_no_network(visit, page_file):
    assert visit.messages == []
    assert visit.requests == [page_file.as_uri()]
    assert page_file.stat().st_size < 5e6


def test_every_chart_has_lines_and_titles_with_units(page):
    charts = page.locator(".plot")
    assert charts.count() == 6
    for k in range(charts.count()):
        chart = charts.nth(k)
        assert chart.locator(".scatterlayer .trace path").count() >= 1
        titles = chart.locator(".xtitle, .ytitle, .y2title").all_text_contents()
        assert len(titles) >= 2
        assert all(titles)
        assert drawn(pixels(chart)) > 0.01


def test_chart_shows_values_under_the_pointer(page):
    chart = page.locator("#run-0-measured")
    point = chart.locator(".point").nth(2)
    point.scroll_into_view_if_needed()
    point.hover(force=True)
    hover = chart.locator(".hoverlayer .hovertext")
    expect(hover.first).to_contain_text("coefficient of restitution")
    expect(hover.first).to_contain_text("m/s")


def test_laws_are_switched_on_and_off(page):
    row = page.locator("tr[data-of-law=thornton]").first
    laws = {"kogut_etsion", "thornton", "universal"}
    charts = [f"run-0-{name}" for name in ("measured", "loops", "verification", "validation")]
    for chart in charts:
        assert shown_laws(page, chart) == laws
    page.get_by_label("Thornton").uncheck()
    expect(row).to_be_hidden()
    settle(page)
    for chart in charts:
        assert shown_laws(page, chart) == laws - {"thornton"}
    page.get_by_role("button", name="None").click()
    settle(page)
    assert shown_laws(page, "run-0-measured") == set()
    page.get_by_role("button", name="All").click()
    settle(page)
    assert shown_laws(page, "run-0-measured") == laws
    expect(row).to_be_visible()


@pytest.mark.parametrize(
    ("chart", "choice", "title"),
    [
        ("run-0-measured", "Largest force", "largest force"),
        ("run-0-verification", "Largest force", "difference"),
        ("run-0-validation", "Largest force, hardening", "difference"),
        ("run-2-series", "Plastic work", "plastic work"),
    ],
)
def test_menu_selects_another_quantity(page, chart, choice, title):
    menu, element = page.locator(f"[data-chart={chart}]"), page.locator(f"#{chart}")
    before, first = pixels(element), menu.input_value()
    menu.select_option(label=choice)
    expect(element.locator(".ytitle")).to_contain_text(title)
    settle(page)
    assert (pixels(element) != before).any()
    menu.select_option(first)


def test_the_movie_plays_and_stops(page):
    movie = page.locator("[data-movie]")
    canvas, now = movie.locator("canvas"), movie.locator(".now")
    before, last_time = pixels(canvas), now.inner_text()
    assert drawn(before) > 0.02
    movie.get_by_role("button", name="Play").click()
    expect(now).not_to_have_text(last_time)
    movie.get_by_role("button", name="Pause").click()
    movie.locator(".time").fill("0")
    settle(page)
    assert (np.abs(pixels(canvas) - before).max(axis=2) > 24).mean() > 0.01
    movie.locator(".time").fill(movie.locator(".time").get_attribute("max"))
    expect(now).to_have_text(last_time)


def test_pointer_and_keys_turn_and_zoom_the_grains(page):
    canvas = page.locator("[data-movie] canvas")
    before = pixels(canvas)
    box = canvas.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] / 2 + 90, box["y"] + box["height"] / 2 + 40, steps=3)
    page.mouse.up()
    settle(page)
    turned = pixels(canvas)
    assert (np.abs(turned - before).max(axis=2) > 24).mean() > 0.01
    canvas.press("+")
    settle(page)
    assert drawn(pixels(canvas)) > 1.2 * drawn(turned)
    canvas.dblclick()  # resets the view
    settle(page)
    np.testing.assert_allclose(drawn(pixels(canvas)), drawn(before), rtol=0.05)


@pytest.mark.parametrize("view", ["front", "side", "top"])
def test_grains_are_shown_from_every_side(page, view):
    canvas, choice = page.locator("[data-movie] canvas"), page.locator("[data-movie] .view")
    before = pixels(canvas)
    choice.select_option(view)
    settle(page)
    seen = pixels(canvas)
    assert drawn(seen) > 0.02
    assert (seen != before).any()
    choice.select_option("corner")


def test_grains_have_colours_and_show_their_values(page):
    movie = page.locator("[data-movie]")
    canvas, colour = movie.locator("canvas"), movie.locator(".colour")
    title, before = movie.locator(".scale-title"), pixels(canvas)
    assert "plastic work (" in title.inner_text()
    for name, text in (("force", "largest contact force ("), ("speed", "speed (m/s)")):
        colour.select_option(name)
        expect(title).to_contain_text(text)
        settle(page)
        assert (pixels(canvas) != before).any()
    colour.select_option("plastic_work")
    seen = pixels(canvas)
    bright = np.argwhere(np.ptp(seen, axis=2) > 60)
    row, column = bright[len(bright) // 2]
    canvas.hover(position={"x": int(column), "y": int(row)})
    tip = movie.locator(".tip")
    for text in ("plastic work", "largest contact force", "m/s", "radius 5 mm"):
        expect(tip).to_contain_text(text)


def test_walls_are_switched_off(page):
    canvas, walls = page.locator("[data-movie] canvas"), page.locator("[data-movie] .walls")
    before = pixels(canvas)
    walls.uncheck()
    settle(page)
    assert (pixels(canvas) != before).any()
    walls.check()


def test_page_has_a_dark_and_a_light_theme(page):
    def background() -> int:
        return int(pixels(page.locator("h1"))[0, 0].sum())

    def text() -> str:
        return page.locator("#run-0-measured .xtitle").evaluate("e => getComputedStyle(e).fill")

    theme = page.get_by_label("Theme")
    theme.select_option("light")
    settle(page)
    light, ink = background(), text()
    theme.select_option("dark")
    page.wait_for_selector("#run-0-measured[data-drawn=dark]")
    assert light > 720
    assert background() < 120
    assert text() != ink
    assert drawn(pixels(page.locator("[data-movie] canvas"))) > 0.02
    page.emulate_media(media="print")
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
    assert not page.locator(".laws").is_visible()
    page.emulate_media(media="screen")
    theme.select_option("auto")
    page.wait_for_selector("#run-0-measured[data-drawn=light]")


#: Script that adds switches of laws to the page, or removes them if the number is negative.
MORE_LAWS = """number => {
  const row = document.querySelector(".chips");
  for (let k = 0; k < number; k++) row.append(row.lastElementChild.cloneNode(true));
  for (let k = 0; k < -number; k++) row.lastElementChild.remove();
}"""


def test_phone_needs_no_horizontal_scrolling(page):
    window = page.viewport_size
    page.evaluate(MORE_LAWS, 17)
    page.set_viewport_size({"width": 390, "height": 844})
    chart = page.locator("#run-0-measured .main-svg[width^='3']").first  # 300 to 399 px
    expect(chart).to_be_attached()
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    assert page.locator("[data-movie] canvas").bounding_box()["width"] > 300
    page.evaluate(MORE_LAWS, -17)
    page.set_viewport_size(window)
    expect(chart).not_to_be_attached()


@pytest.mark.parametrize("mode", ["light", "dark"])
def test_page_meets_accessibility_rules(page, mode):
    page.get_by_label("Theme").select_option(mode)
    page.wait_for_selector(f"#run-0-measured[data-drawn={mode}]")
    results = Axe().run(page)
    page.get_by_label("Theme").select_option("auto")
    assert results.violations_count == 0, results.generate_report()
