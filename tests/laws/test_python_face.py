# SPDX-License-Identifier: GPL-2.0-or-later
"""The Python interface of the laws: arrays of any shape, reprs, pickles, types for editors."""

from __future__ import annotations

import ast
import copy
import inspect
import pickle
from pathlib import Path

import contact_constants
import numpy as np
import pandas as pd
import pytest

import plastigran
from plastigran import laws

RADIUS, MASS = 0.01, 1e-3
BODY = laws.Body(7e10, 0.3, 1e8, 1.61)
PAIR = laws.combine(BODY, laws.Body(2.1e11, 0.28, 3e8))
RESPONSE = ["force", "contact_radius", "elastic_energy", "plastic_work", "viscous_force"]
RESPONSE += ["surface_energy"]
IMPACT = [
    "overlap_max",
    "force_max",
    "overlap_res",
    "coefficient_of_restitution",
    "stiffness_max",
    "damping_max",
    "in_range",
]
STUB = Path(plastigran.__file__).with_name("laws.pyi")


@pytest.fixture
def law(law_between, law_name):
    return law_between(law_name, PAIR)


def test_contacts_of_any_shape_answer_as_each_alone(law):
    radius = np.array([[0.005], [0.01]])
    overlap = [1e-7, 2e-6, 1e-5]
    rate = 0.2
    answer = law.respond(radius, overlap, overlap_rate=rate)
    for name in RESPONSE:
        alone = [
            [getattr(law.respond(r, x, None, rate), name) for x in overlap] for r in (0.005, 0.01)
        ]
        assert np.array_equal(getattr(answer, name), alone), name


def test_impacts_of_any_shape_come_out_as_each_alone(law):
    radius, mass, speed = np.array([0.005, 0.01]), 1e-3, np.array([[0.02], [0.2], [2.0]])
    found = law.central_impact(radius, mass, speed)
    for name in IMPACT:
        alone = [
            [getattr(law.central_impact(r, mass, v), name) for r in radius] for v in speed.flat
        ]
        assert np.array_equal(getattr(found, name), alone), name
    assert found.in_range.dtype == bool
    steps = law.recommended_timestep(radius, mass, speed)
    alone = [[law.recommended_timestep(r, mass, v) for r in radius] for v in speed.flat]
    assert np.array_equal(steps, alone)


def test_paths_of_any_shape_are_followed_as_each_alone(law):
    paths = np.array([[[0, 1e-5, 5e-6], [0, 2e-5, 1.9e-5]]]) * np.ones((4, 1, 1))
    radius = np.array([[0.005], [0.006], [0.007], [0.008]])
    rates = np.array([0.1, 0.0, -0.1])
    states = np.array([[law.State() for _ in range(2)] for _ in range(4)])
    found = law.follow(radius, paths, states, rates)
    assert list(found) == RESPONSE
    for i, j in np.ndindex(4, 2):
        state = law.State()
        alone = law.follow(radius[i, 0], paths[i, j], state, rates)
        for name in RESPONSE:
            assert np.array_equal(found[name][i, j], alone[name]), name
        assert states[i, j] == state
    again = law.follow(radius, paths, overlap_rate=rates)  # new contacts by default
    assert all(np.array_equal(found[name], again[name]) for name in RESPONSE)


@pytest.mark.parametrize(
    "given",
    [[0.1, 0.2], (0.1, 0.2), pd.Series([0.1, 0.2], index=["a", "b"]), np.array([0.1, 9, 0.2])[::2]],
)
def test_lists_series_and_slices_are_arrays(given):
    found = laws.Thornton(PAIR).central_impact(RADIUS, MASS, given).overlap_max
    assert isinstance(found, np.ndarray) and found.shape == (2,)
    assert found[0] == laws.Thornton(PAIR).central_impact(RADIUS, MASS, 0.1).overlap_max


@pytest.mark.parametrize("speed", [1, 1.0, np.float64(1), np.int64(1), np.array(1.0), np.array(1)])
def test_numbers_are_answered_by_numbers(speed):
    law = laws.VuQuocZhang(PAIR)
    found = law.central_impact(RADIUS, MASS, speed)
    assert type(found.overlap_max) is float and type(found.in_range) is bool
    assert type(law.recommended_timestep(RADIUS, MASS, speed)) is float
    assert type(law.respond(RADIUS, speed).force) is float
    assert type(law.follow(RADIUS, speed)["force"]) is float
    assert type(law.overlap(RADIUS, speed)) is float
    assert type(law.yield_force(speed)) is float
    assert type(laws.hertz_yield_pressure_factor(0.3 * speed)) is float


def test_nothing_asked_is_nothing_answered():
    law = laws.Thornton(PAIR)
    assert law.central_impact(RADIUS, MASS, []).overlap_max.shape == (0,)
    assert law.follow(RADIUS, np.zeros((3, 0)))["force"].shape == (3, 0)


def test_force_driven_form_takes_arrays():
    law = laws.VuQuocZhang(PAIR)
    force = np.geomspace(1, 1e3, 6).reshape(2, 3)
    overlap = law.overlap(RADIUS, force)
    assert law.respond(RADIUS, overlap).force == pytest.approx(force, rel=1e-10)
    assert law.yield_force([0.01, 0.02])[1] == pytest.approx(4 * law.yield_force(0.01), rel=1e-14)


def test_histories_move_on_one_for_each_contact(law):
    """A call updates the history for the next call, for a single contact and for an array."""
    one, many = law.State(), [law.State(), law.State()]
    law.respond(RADIUS, 1e-5, one)
    law.respond(RADIUS, [1e-5, 2e-5], many)
    assert one == many[0]
    assert (one == law.State()) is not (law.yields)
    assert (law.respond(RADIUS, 1e-6, one) == law.respond(RADIUS, 1e-6)) is not law.yields


@pytest.mark.parametrize(
    ("ask", "said"),
    [
        (lambda law: law.respond(0, 1e-5), r"radius_eff is 0; it must be positive and fin.* \[m\]"),
        (lambda law: law.respond(1, [[0, np.nan]]), r"overlap\[0, 1\] is nan; it must be finite"),
        (lambda law: law.central_impact(1, 1e-300, 1), "mass_eff 1e-300 kg .* Check the units"),
        (lambda law: law.central_impact(1, 1, 1e-300), "speed is 1e-300 m/s, mass_eff 1 kg and"),
        (lambda law: law.recommended_timestep(1, 1, [1, 1e-300]), "speed is 1e-300 m/s, mass_eff"),
        (lambda law: law.follow(1, [0, 1], None, [0, np.inf]), r"overlap_rate\[1\] is inf; .*m/s"),
        (lambda law: law.follow([1, -1], [0, 1]), r"radius_eff\[1\] is -1; it must be positive"),
        (lambda law: law.central_impact(1, [1, 0], 1), r"mass_eff\[1\] is 0; .* \[kg\]"),
        (lambda law: law.central_impact(1, 1, "fast"), r"speed is 'fast'; it must be a number or"),
        (lambda law: law.recommended_timestep(1, 1, -3), r"speed is -3; it must be positive"),
        (lambda law: law.respond([1, 2], [1, 2, 3]), r"radius_eff \(2,\), overlap \(3,\), over"),
        (lambda law: law.respond(1, [1, 2], law.State()), r"state has shape \(\); .* \(2,\)"),
        (lambda law: law.overlap(1, [0, -1]), r"force\[1\] is -1; it must be zero or positive"),
        (lambda law: laws.VuQuocZhang(PAIR, curvature_coefficient="x"), r"is 'x'; it must be a n"),
        (
            lambda law: laws.hertz_yield_pressure_factor([0, 0.51]),
            r"poissons_ratio\[1\] is 0.51; it",
        ),
    ],
)
def test_values_out_of_range_are_named(ask, said):
    with pytest.raises(ValueError, match=said):
        ask(laws.VuQuocZhang(PAIR))


def test_histories_of_other_laws_are_refused():
    for state in (laws.Stronge.State(), [laws.Stronge.State()], 3):
        with pytest.raises(TypeError, match="it must be a thornton State"):
            laws.Thornton(PAIR).respond(RADIUS, 1e-5, state)


def test_everything_is_told_copied_and_pickled(law):
    state = law.State()
    response = law.respond(RADIUS, [1e-6, 1e-5], overlap_rate=0.1)
    law.respond(RADIUS, 1e-5, state)
    for thing in (BODY, PAIR, law, state, response, law.central_impact(RADIUS, MASS, 0.2)):
        for twin in (pickle.loads(pickle.dumps(thing)), copy.copy(thing), copy.deepcopy(thing)):
            assert twin == thing and twin is not thing
            assert repr(twin) == repr(thing)
        assert repr(thing).startswith(type(thing).__qualname__ + "(")
        assert thing != 1
    twin = pickle.loads(pickle.dumps(law))
    assert hash(twin) == hash(law)
    assert twin.central_impact(RADIUS, MASS, 0.2) == law.central_impact(RADIUS, MASS, 0.2)
    for row in [*law.parameters(), *law.options()]:
        assert f"{row['name']}=" in repr(law)
    assert repr(law.pair) in repr(law) and law.pair == PAIR
    for name, value in zip(law.state_names, state.values(), strict=True):
        assert getattr(state, name) == value
        assert f"{name}={value!r}" in repr(state)


def test_what_differs_is_not_equal():
    assert laws.Body(7e10, 0.3, 1e8) != laws.Body(7e10, 0.3, 2e8)
    assert laws.Stronge(PAIR) != laws.Stronge(PAIR, unloading="area")
    assert laws.Stronge(PAIR) == laws.Stronge(PAIR, unloading="book")
    assert laws.Thornton(PAIR) != laws.Hertz(PAIR)
    assert laws.Thornton(PAIR) != laws.Thornton(laws.combine(BODY, BODY))
    law = laws.Thornton(PAIR)
    assert law.respond(RADIUS, [1e-6, 1e-5]) != law.respond(RADIUS, [1e-6, 2e-5])
    for thing in (BODY, PAIR, law, law.State(), law.respond(RADIUS, 1e-6)):
        with pytest.raises(AttributeError):
            thing.name_of_nothing = 1


def public(names) -> set[str]:
    return {name for name in names if not name.startswith("_")}


def declared(body: list[ast.stmt]) -> dict[str, ast.stmt]:
    """Return the public names that a stub declares in a module or class."""
    found = {}
    for node in body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            found[node.name] = node
        elif isinstance(node, ast.AnnAssign):
            found[node.target.id] = node
    return {name: node for name, node in found.items() if name in public(found)}


def test_stub_has_the_types_and_docstrings_of_the_module():
    assert STUB.with_name("py.typed").exists()
    module = ast.parse(STUB.read_text())
    stub = declared(module.body)
    assert set(stub) == public(vars(laws))
    assert set(laws.LAWS) == {law.name for law in laws.LAWS.values()}
    for name, node in stub.items():
        if isinstance(node, ast.ClassDef):
            its_class = getattr(laws, name)
            members = declared(node.body)
            # The stub declares the members that all laws share in its class Law. In the module,
            # each law has these members.
            common = (
                set(members) - public(vars(its_class)) if name in ("Law", "ContactState") else set()
            )
            assert set(members) == public(vars(its_class)) | common, name
            if name == "Law":
                for law in laws.LAWS.values():
                    assert common <= public(vars(law)), law
            for member, its_node in members.items():
                if isinstance(its_node, ast.FunctionDef) and member not in common:
                    assert_documented(its_node, inspect.getattr_static(its_class, member))
        elif isinstance(node, ast.FunctionDef):
            assert_documented(node, getattr(laws, name))


def assert_documented(node: ast.FunctionDef, function: object) -> None:
    said = ast.get_docstring(node)
    assert said, node.name
    assert inspect.cleandoc(said) in inspect.cleandoc(function.__doc__), node.name
    assert node.returns is not None
    arguments = node.args.args + node.args.kwonlyargs
    assert all(given.annotation is not None for given in arguments if given.arg != "self")
    if len(arguments) > ("self" in {given.arg for given in arguments}):
        for given in arguments:
            assert given.arg in ("self", "pair") or f"{given.arg}:" in said, (node.name, given.arg)


@pytest.mark.parametrize(
    "name", [n for n, law in laws.LAWS.items() if law.shape == "sphere" and law.elastic_first]
)
def test_ranges_hold_for_a_soft_body_that_does_not_yield_first(name):
    """The validity range of a law has a limit also if the softer body does not yield.

    Steel touches rubber, so most of the overlap is in the rubber. Overlaps of the order of the
    radius must be outside the range. Laws with fitted stiffnesses are not tested.
    """
    steel = laws.Body(2.1e11, 0.3, 3e8)
    rubber = laws.Body(1e7, 0.49, 1e30)
    law = laws.LAWS[name](laws.combine(steel, rubber), **contact_constants.required(name))
    assert law.overlap_range < 0.2
