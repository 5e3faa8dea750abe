# SPDX-License-Identifier: GPL-2.0-or-later
"""Settings of every bulk deck are declared, and checked before a run."""

from __future__ import annotations

from math import inf

import attrs
import pytest

from plastigran.bulk.deck import BulkDeck
from plastigran.bulk.decks import deck_class, deck_names
from plastigran.bulk.outcome import open_run
from plastigran.bulk.plan import PLACES
from plastigran.bulk.run import run_bulk
from plastigran.declared import Declaration
from plastigran.engine.process import EngineError, inputs_folder
from plastigran.materials import BODY_CONSTANTS


def test_every_deck_has_a_class_and_a_short_run():
    scripts = {file.stem for file in (inputs_folder() / "bulk").glob("*.in")}
    assert scripts == set(deck_names())
    assert all(deck_class(name).briefs for name in deck_names())


def test_declared_settings_are_the_decks(case):
    """The Python class and the input script of a deck have the same settings.

    Only the script has the setting `host`, the DEM code that runs the deck.
    """
    assert attrs.fields_dict(case.deck_type).keys() - {"output"} == case.settings().keys() - {
        *PLACES,
        "host",
    }


def wrong_values(field: attrs.Attribute) -> list[object]:
    """Return values that the declaration does not allow."""
    declared: Declaration = field.metadata["declaration"]
    if declared.choices:
        return ["nonsense"]
    wrong: list[object] = ["many"]
    if field.name not in BODY_CONSTANTS or BODY_CONSTANTS[field.name]["default"] != inf:
        wrong.append(inf)
    if abs(declared.lower) < inf:
        wrong.append(declared.lower - declared.lower_allowed)
    if abs(declared.upper) < inf:
        wrong.append(declared.upper + declared.upper_allowed)
    return [*wrong, 1.5] if declared.value_type is int else wrong


def test_impossible_values_are_refused_by_name(case, field):
    settings = case.settings(output="results")
    for value in wrong_values(attrs.fields_dict(case.deck_type)[field]):
        with pytest.raises(ValueError, match=rf"^{field} is .*(must|not a)"):
            case.deck_type.read({**settings, field: value})


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"law": "lim_stronge"}, "law is 'lim_stronge'; it must be one of brake_2012, "),
        ({"law": "hertz"}, "ledger is on, but LIGGGHTS' own hertz has no energy balance"),
        ({"rows": 20, "checkpoints": 3}, "checkpoints is 3; it must divide rows, 20"),
        ({"options": "viscous"}, "options is 'viscous'; it must be made of pairs"),
        ({"law": "viscoelastic_hertz"}, "needs dissipative_constant, which"),
        ({"material": "cheese"}, "includes .*cheese.in, which does not exist"),
        ({"colour": "red"}, "has no setting 'colour'; the deck has "),
    ],
)
def test_impossible_runs_are_refused(case, change, message, tmp_path):
    with pytest.raises((ValueError, RuntimeError), match=message):
        run_bulk(case.name, {**case.brief.settings, **change}, tmp_path / "run", show=False)
    assert not (tmp_path / "run").exists()


def test_every_law_is_accepted(case, sphere_law):
    settings = case.settings(law=sphere_law, dissipative_constant=1e-5)
    assert case.deck_type.read(settings).grains.contact_law() is not None


def test_missing_setting_is_refused(case):
    settings = case.settings()
    del settings["radius"]
    with pytest.raises(ValueError, match="declares the field radius, but"):
        case.deck_type.read(settings)


def test_frames_may_change_in_a_continued_run(case):
    """A continued run may not change the settings of the grains or the time step."""
    allowed = case.deck_type.continuable_settings()
    shared = {field.name for field in attrs.fields(BulkDeck)}
    assert "frames" in allowed and allowed & shared <= {
        "frames",
        "contact_history",
        "rows",
        "checkpoints",
    }


def test_ranks_below_one_are_refused(tmp_path):
    with pytest.raises(ValueError, match="ranks is 0; it must be 1 or more"):
        run_bulk("cooling_gas", {}, tmp_path / "run", ranks=0)
    assert not (tmp_path / "run").exists()


@pytest.mark.parametrize(
    "record", ["{}", "[]", '{"deck": "hop', '{"deck": "hopper", "values": {}, "settings": 3}']
)
def test_broken_record_is_refused(record, tmp_path):
    (tmp_path / "run.json").write_text(record)
    with pytest.raises(EngineError, match=r"run\.json"):
        open_run(tmp_path)
