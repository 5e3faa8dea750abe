# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of numbers on the report page: packed frames, table cells, axes and colors."""

from __future__ import annotations

import base64
import gzip
import json
from math import hypot

import numpy as np
import pytest
import pyvista

from plastigran.plot.frame_files import find_frames
from plastigran.plot.frames import read_frame
from plastigran.plot.quantities import scale
from plastigran.report.page.colours import LEAST, luminance, on_dark
from plastigran.report.page.movie import pack_movie
from plastigran.report.page.sections import number


def test_frames_are_packed_to_16_bits(hopper):
    movie, _ = pack_movie(hopper, lambda step: 2e-5 * step)
    raw = gzip.decompress(base64.b64decode(movie.data))
    at = raw.index(b"\n") + 1
    assert at % 2 == 0  # the browser reads 16-bit numbers from here
    head = json.loads(raw[:at])
    numbers = np.frombuffer(raw[at:], "<u2") / 65535
    frames = [read_frame(frame) for frame in find_frames(hopper)]
    assert [frame["grains"] for frame in head["frames"]] == [len(f.radii) for f in frames]
    first, count = frames[0], len(frames[0].radii)
    low = np.concatenate([np.r_[f.positions, f.walls.reshape(-1, 3)] for f in frames]).min(axis=0)
    places = numbers[: 3 * count].reshape(-1, 3) * head["size"] + low
    half = 0.51 / 65535  # round-off
    np.testing.assert_allclose(places, first.positions, atol=half * head["size"])
    radii = numbers[3 * count : 4 * count] * head["radius"]
    np.testing.assert_allclose(radii, first.radii, atol=half * head["radius"])
    assert [colour["name"] for colour in head["colours"]] == ["plastic_work", "force", "speed"]
    last = frames[-1]
    before = sum(7 * frame["grains"] + (frame["corners"] or 0) * 3 for frame in head["frames"][:-1])
    colours = numbers[before + 4 * len(last.radii) :][: 3 * len(last.radii)].reshape(3, -1)
    for values, colour in zip(colours, head["colours"], strict=True):
        expected = getattr(last, colour["name"])
        assert expected.max() > 0
        top = colour["top"] * {"m": 1e-3, "µ": 1e-6, "n": 1e-9}.get(colour["unit"][:-1], 1)
        np.testing.assert_allclose(values * top, expected, atol=half * top)


def test_times_of_frames_are_those_of_the_charts(hopper):
    """Snapshots of the grains have the same times as the charts.

    Snapshots before the start of the charts have negative times.
    """
    last = find_frames(hopper)[-1].step
    movie, _ = pack_movie(hopper, lambda step: (step - last) * 2e-5)
    head = gzip.decompress(base64.b64decode(movie.data)).split(b"\n", 1)[0]
    labels = [frame["label"] for frame in json.loads(head)["frames"]]
    assert labels[-1] == "0 s"
    assert labels[0] == f"−{2e-5 * last * 1e3:.3g} ms"


def test_force_of_a_grain_is_the_largest_of_its_contacts(hopper):
    files = find_frames(hopper)[-1]
    frame = read_frame(files)
    assert 0.3 < (frame.force > 0).mean() < 1  # some grains are falling
    contacts = pyvista.read(files.contacts)
    largest = dict.fromkeys(pyvista.read(files.grains)["id"], 0.0)
    for one, other, force in zip(contacts["id1"], contacts["id2"], contacts["force"], strict=True):
        for grain in (one, other):
            largest[grain] = max(largest[grain], hypot(*force))
    np.testing.assert_allclose(frame.force, list(largest.values()), rtol=1e-12)


@pytest.mark.parametrize(
    ("value", "text"),
    [(1234.5, "1234"), (-2e-6, "−2 × 10⁻⁶"), (1e-9, "10⁻⁹"), (float("nan"), ""), (True, "yes")],
)
def test_numbers_are_written_with_superscripts(value, text):
    assert number(value) == text


def test_axes_have_prefixes_of_units():
    axis = scale("overlap_max", [1e-9, 3e-6])
    assert (axis.axis, axis.factor) == ("largest overlap (µm)", pytest.approx(1e6))
    assert scale("speed", [2e-3]).axis == "impact speed (m/s)"
    assert scale("unheard_of", [1.0]).axis == "unheard of (as in the log)"


@pytest.mark.parametrize("colour", ["#000000", "#332288", "#661100", "#0072B2"])
def test_colours_are_light_on_a_dark_background(colour):
    assert luminance(on_dark(colour)) >= LEAST
