# SPDX-License-Identifier: GPL-2.0-or-later
from __future__ import annotations

from pathlib import Path

import pytest
from pressed_pairs import press_pairs


@pytest.fixture(scope="session")
def pairs(tmp_path_factory) -> Path:
    """Folder of a run of two pairs of grains with three frames, for tests that only read it."""
    return press_pairs(tmp_path_factory.mktemp("pairs"))
