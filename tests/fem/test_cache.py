# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the cache of finite-element results on disk."""

from __future__ import annotations

import json
import pickle
import resource
from hashlib import sha256
from io import BytesIO

import attrs
import numpy as np
import pandas as pd
import pytest
from coarse_sphere import COARSE, METAL, RADIUS

from plastigran.fem.cache import CacheWarning, _sources, cached, folder
from plastigran.fem.result_file import from_bytes, to_bytes
from plastigran.fem.sphere.press import press


@pytest.fixture
def counted(tmp_path, monkeypatch):
    """A function to cache, and the list of the calls that it received."""
    monkeypatch.setenv("PLASTIGRAN_CACHE", str(tmp_path))
    calls = []

    def compute(metal, radius, forces, settings, progress):
        calls.append(settings)
        return forces[-1]

    return compute, calls


def test_same_computation_is_done_once(counted):
    compute, calls = counted
    assert [cached(compute, METAL, RADIUS, [5.0], settings=COARSE) for _ in range(2)] == [5.0, 5.0]
    assert len(calls) == 1


@pytest.mark.parametrize(
    "other",
    [
        (attrs.evolve(METAL, youngs_modulus=71e9), RADIUS, [5.0], COARSE),
        (attrs.evolve(METAL, hardening=None), RADIUS, [5.0], COARSE),
        (METAL, 0.2, [5.0], COARSE),
        (METAL, RADIUS, [6.0], COARSE),
        (METAL, RADIUS, [5.0], attrs.evolve(COARSE, growth=1.2)),
    ],
)
def test_another_computation_is_done_anew(counted, other):
    compute, calls = counted
    cached(compute, METAL, RADIUS, [5.0], settings=COARSE)
    *arguments, settings = other
    cached(compute, *arguments, settings=settings)
    assert len(calls) == 2


def test_long_arrays_are_told_apart(counted):
    compute, calls = counted
    forces = np.linspace(1, 5, 2001)
    other = forces.copy()
    other[1000] += 1e-3
    for array in (forces, other, forces):
        cached(compute, METAL, RADIUS, array, settings=COARSE)
    assert len(calls) == 2


def test_another_library_is_another_computation(counted, monkeypatch):
    compute, calls = counted
    cached(compute, METAL, RADIUS, [5.0], settings=COARSE)
    monkeypatch.setattr("plastigran.fem.cache.version", lambda name: f"99 of {name}")
    _sources.cache_clear()
    cached(compute, METAL, RADIUS, [5.0], settings=COARSE)
    _sources.cache_clear()
    assert len(calls) == 2


class Trap:
    def __reduce__(self):
        return pytest.fail, ("a cache was unpickled",)


def trapped(_: bytes) -> bytes:
    content = pickle.dumps(Trap())
    return sha256(content).digest() + content


@pytest.mark.parametrize(
    "damage",
    [lambda _: b"half", lambda whole: whole[:-9] + b"7" + whole[-8:], lambda _: b"", trapped],
)
def test_broken_file_is_computed_again(counted, damage):
    """A damaged file, or a pickle file in place of a result, is not loaded but computed again."""
    compute, calls = counted
    cached(compute, METAL, RADIUS, [5.0], settings=COARSE)
    (file,) = folder().iterdir()
    file.write_bytes(damage(file.read_bytes()))
    assert cached(compute, METAL, RADIUS, [5.0], settings=COARSE) == 5.0
    assert len(calls) == 2


def test_a_result_comes_back_whole(tmp_path, monkeypatch):
    """A result from the cache has the same tables and fields, bitwise identical."""
    monkeypatch.setenv("PLASTIGRAN_CACHE", str(tmp_path))
    first, again = (cached(press, METAL, RADIUS, [20.0], settings=COARSE) for _ in range(2))
    assert again is not first and again.material == first.material
    for table in ("history", "unloadings"):
        pd.testing.assert_frame_equal(
            getattr(again, table), getattr(first, table), check_exact=True
        )
    assert len(again.snapshots) == len(first.snapshots) > 0
    for one, other in zip(first.snapshots, again.snapshots, strict=True):
        for field in attrs.fields(type(one)):
            value, kept = getattr(one, field.name), getattr(other, field.name)
            assert np.array_equal(value, kept, equal_nan=True)


def test_a_table_comes_back_with_its_texts_and_its_index():
    table = pd.DataFrame({"metal": ["steel", "copper"], "force": [1.0, np.nan]}, index=[7, 3])
    again = from_bytes(to_bytes([table]))[0]
    pd.testing.assert_frame_equal(again, table, check_exact=True)


def crafted(tree: object, **arrays: np.ndarray) -> bytes:
    file = BytesIO()
    np.savez(file, tree=np.frombuffer(json.dumps(tree).encode(), np.uint8), **arrays)
    return file.getvalue()


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"PK",
        b"{}",
        to_bytes([1.0])[:-30],
        crafted({"array": "none"}),
        crafted({"table": 3}),
        crafted({"class": ["plastigran.nothing", "Nothing"], "fields": {}}),
        crafted({"class": ["plastigran.fem.settings", "Settings"], "fields": {"x": 1}}),
        crafted({"list": None}),
        crafted({"one": 1, "two": 2}),
        crafted(1).replace(b"tree.npy", b"eert.npy"),
        crafted(0).replace(b"NUMPY", b"YPMUN"),
    ],
)
def test_other_content_is_no_result(content):
    with pytest.raises(ValueError, match="not a result"):
        from_bytes(content)


def test_a_deep_tree_is_no_result():
    tree = json.dumps(0).join(['{"list": [' * 100_000, "]}" * 100_000]).encode()
    file = BytesIO()
    np.savez(file, tree=np.frombuffer(tree, np.uint8))
    with pytest.raises(ValueError, match="not a result"):
        from_bytes(file.getvalue())


def test_a_cache_that_cannot_be_made_loses_no_result(counted, monkeypatch, tmp_path):
    """If the cache folder cannot be created, a warning appears and the result is returned.

    The parent of the folder is a file, so that even root cannot create the folder.
    """
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("PLASTIGRAN_CACHE", str(tmp_path / "file" / "cache"))
    compute, _ = counted
    with pytest.warns(
        CacheWarning, match=r"cannot write .*file/cache/compute_\w+\.result \(Not a dir"
    ):
        assert cached(compute, METAL, RADIUS, [5.0], settings=COARSE) == 5.0


def test_a_limit_of_file_sizes_loses_no_result(counted):
    """If a cache file cannot be completed, it is deleted and the result is returned.

    A limit of file sizes has the same effect as a full disk.
    """
    compute, _ = counted
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, limits[1]))
    try:
        with pytest.warns(CacheWarning, match=r"cannot write .* \(File too large\)"):
            assert cached(compute, METAL, RADIUS, [5.0], settings=COARSE) == 5.0
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert not list(folder().iterdir())
