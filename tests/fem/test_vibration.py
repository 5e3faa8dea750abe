# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the vibrations of an elastic sphere after an impact.

The references are exact frequencies of vibration modes and Hertz theory.
"""

from __future__ import annotations

import numpy as np
import pytest
from coarse_sphere import METAL

from plastigran.fem.body.body import Body
from plastigran.fem.body.elastic import ElasticBody
from plastigran.fem.limits import SmallStrainWarning
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.settings import Settings
from plastigran.fem.sphere.spectrum import peaks, spectrum
from plastigran.fem.sphere.vibrate import vibrate
from plastigran.fem.stepping.conservative import SpringPlane
from plastigran.fem.theory.hertz import HertzSphere
from plastigran.physics.impact_modes import impact_modes

RADIUS = 0.01
ICE = ElasticPlastic(youngs_modulus=9.3e9, poissons_ratio=0.25, density=900.0)
SPEED = 5.0
COARSE = Settings(divisions=4)
HERTZ = HertzSphere(ICE, RADIUS)


@pytest.fixture(scope="module")
def vibration():
    return vibrate(ICE, RADIUS, SPEED, 60, COARSE)


@pytest.fixture(scope="module")
def slow():
    return vibrate(ICE, RADIUS, 0.1, 1, COARSE)


@pytest.fixture(scope="module")
def exact():
    """Exact frequencies of the vibration modes that a normal impact can excite [Hz].

    They end at the highest of the 12 computed modes."""
    sphere = ICE.youngs_modulus, ICE.poissons_ratio, ICE.density, RADIUS
    return impact_modes(*sphere, highest=270e3)["frequency"].to_numpy()


def energy(history):
    parts = ["kinetic_energy", "elastic_energy", "penalty_energy"]
    return history[parts].sum(axis=1).to_numpy()


def test_energy_is_conserved(vibration):
    # The method conserves energy; round-off of thousands of steps causes a relative error of 1e-8.
    total = energy(vibration.history)
    assert total == pytest.approx(total[0], rel=1e-8)


def test_impulse_of_the_force_turns_the_momentum(vibration):
    history = vibration.history
    mass = 2 * history["kinetic_energy"].iloc[0] / SPEED**2
    impulse = history["force"].sum() * vibration.timestep
    change = (history["velocity"].iloc[-1] + SPEED) * mass
    # The method conserves momentum, so only round-off remains.
    assert impulse == pytest.approx(change, rel=1e-8)


def test_plane_pushes_only_and_gives_its_energy_back(vibration):
    assert (vibration.history["force"] >= 0).all()
    assert (vibration.flight["penalty_energy"] == 0).all()


def test_energy_left_is_what_the_rebound_lacks(vibration):
    restitution = vibration.coefficient_of_restitution
    assert 1 - restitution**2 == pytest.approx(vibration.vibration_energy, rel=1e-3)
    # Half of the energy of a vibration is kinetic. The kinetic energy of the sphere in flight
    # contains this half.
    lost = 1 - vibration.kinetic_restitution**2
    assert lost == pytest.approx(vibration.vibration_energy / 2, rel=0.05)


def test_less_vibration_is_left_by_a_slower_impact(vibration, slow):
    # The slow impact lasts ten periods of the fundamental mode.
    assert slow.coefficient_of_restitution == pytest.approx(1, abs=1e-5)
    assert slow.coefficient_of_restitution > vibration.coefficient_of_restitution


def test_impact_is_that_of_hertz(slow):
    # A sphere of finite size is stiffer. At a/R = 0.02, the force is 0.7 % larger, also with finer
    # meshes.
    assert slow.force_max == pytest.approx(HERTZ.force(HERTZ.approach_max(0.1)), rel=0.01)
    assert slow.contact_time == pytest.approx(HERTZ.duration(0.1), rel=0.01)


def test_free_vibrations_of_the_mesh_are_those_of_the_sphere(vibration, exact):
    # The coarse mesh has eight elements per quarter of the circle; its error is at most 0.4 %.
    found = vibration.modes["frequency"].to_numpy()
    assert found == pytest.approx(exact[: found.size], rel=0.01)


@pytest.mark.parametrize(
    "signal", ["middle_elastic_energy", "top_displacement", "equator_displacement"]
)
def test_peaks_of_the_spectrum_are_modes_of_the_sphere(vibration, exact, signal):
    found = vibration.peaks(signal)["frequency"].to_numpy()
    assert found.size >= 3
    nearest = exact[np.argmin(np.abs(exact[:, None] - found), axis=0)]
    assert found == pytest.approx(nearest, rel=0.01)


def test_normal_impact_breathes_and_does_not_twist(vibration):
    """The impact excites the radial mode at 143.67 kHz.

    It does not excite the toroidal mode of degree 1 at 186.49 kHz.
    """
    found = vibration.peaks("equator_displacement")["frequency"].to_numpy()
    assert np.min(np.abs(found / 143.67e3 - 1)) < 0.01
    assert np.min(np.abs(found / 186.49e3 - 1)) > 0.03


def test_energies_of_the_modes_are_at_most_what_is_left(vibration):
    left = vibration.vibration_energy * vibration.history["kinetic_energy"].iloc[0]
    assert 0.3 * left < vibration.modes["energy"].sum() < left


@pytest.mark.parametrize("kind", ["vibration", "slow"])
def test_strongest_vibration_is_what_the_pulse_of_the_force_excites(kind, request):
    """The energy of the strongest mode follows from its Fourier integral of the contact force.

    For unit modal mass, the energy is (u F)^2/2, with the modal displacement u at the contact and
    the Fourier integral F of the force at the frequency of the mode. The slow impact excites the
    mode of degree 2 most, the fast impact the mode of degree 3.
    """
    found = request.getfixturevalue(kind)
    mode = found.modes.loc[found.modes["energy"].idxmax()]
    time = found.history["time"] - found.timestep / 2
    phase = np.exp(2j * np.pi * mode["frequency"] * time)
    pulse = np.abs(np.sum(phase * found.history["force"])) * found.timestep
    # The force acts on an area with a/R = 0.02 or 0.1, not at a point, which changes the energy by
    # some per cent.
    assert mode["energy"] == pytest.approx((mode["contact_displacement"] * pulse) ** 2 / 2, rel=0.1)


def test_mean_force_is_the_difference_quotient_of_the_energy():
    mesh = COARSE.mesh(HERTZ, 1e-3, whole=True).build()
    plane = SpringPlane(Body(mesh, ICE), RADIUS, 1e-3)
    random = np.random.default_rng(1)
    start, end = random.normal(size=(2, plane.radii.size))
    forces, slopes = plane.mean_force(start, end)
    work = forces @ (end - start)
    assert work == pytest.approx(plane.energy(start) - plane.energy(end), rel=1e-12)
    change = 1e-6
    numeric = (plane.mean_force(start, end + change)[0] - forces) / change
    assert numeric == pytest.approx(-slopes, rel=1e-4, abs=1e-4 * slopes.max())


def test_vibrations_are_of_unit_modal_mass():
    elastic = ElasticBody(Body(COARSE.mesh(HERTZ, 1e-3, whole=True).build(), ICE))
    frequencies, shapes = elastic.vibrations(3)
    assert shapes.T @ (elastic.mass_matrix @ shapes) == pytest.approx(np.eye(3), abs=1e-8)
    energies = elastic.modal_energies(frequencies, shapes, 0 * shapes[:, 0], 2 * shapes[:, 1])
    assert energies == pytest.approx([0, 2, 0], abs=1e-8)


def test_spectrum_tells_frequency_and_amplitude():
    time = np.arange(4000) * 1e-6
    signal = 7 + 2 * np.sin(2 * np.pi * 30_123 * time) + 0.1 * np.sin(2 * np.pi * 47_456 * time)
    frequency, amplitude = peaks(*spectrum(signal, 1e-6))
    assert frequency == pytest.approx([30_123, 47_456], rel=1e-5)
    assert amplitude == pytest.approx([2, 0.1], rel=1e-3)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"speed": 0.0}, "speed is 0 m/s; it must be positive"),
        ({"speed": 4000.0}, "speed of sound"),
        (
            {"material": ElasticPlastic(youngs_modulus=9.3e3, poissons_ratio=0.25, density=900.0)},
            "of sound",
        ),
        ({"material": METAL}, "only elastic spheres"),
        ({"settings": Settings(strain="finite")}, "vibrations need strain='small'"),
        ({"transits": 0.0}, "transits is 0; it must be positive"),
        ({"speed": 300.0}, "times the radius; the upper limit is 0.5"),
    ],
)
def test_what_cannot_be_followed_is_refused(changes, said):
    good = {"material": ICE, "radius": RADIUS, "speed": 1.0, "transits": 1.0, "settings": COARSE}
    with pytest.raises(ValueError, match=said):
        vibrate(**(good | changes))


def test_wide_contact_is_warned_of():
    soft = ElasticPlastic(youngs_modulus=6e6, poissons_ratio=0.25, density=900.0)
    with pytest.warns(SmallStrainWarning, match=r"0\.42 times the radius"):
        found = vibrate(soft, RADIUS, 5.0, 1, COARSE)
    # The contact lasts only 2.2 periods of the fundamental mode, so 1 % of the energy stays in the
    # sphere.
    assert 0.98 < found.coefficient_of_restitution < 0.995
