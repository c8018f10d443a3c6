"""Sizes of a whole-angle gyro's maps against units that are drawn, and closed forms."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.map_sizes import size_maps
from pyhrg.device.device import AngleMap, Device
from pyhrg.device.ready_devices import TABLE2, TYPICAL
from pyhrg.theory import closed_forms as theory

UNITS = 4000


def test_sizes_are_those_of_drawn_units() -> None:
    """4000 units, seed 3: rms of each constant within 5 %, at five of its standard errors."""
    generator = np.random.default_rng(3)
    device = replace(TYPICAL, drive_nonorthogonality=2e-4, pickoff_gain_mismatch=3e-4)
    units = [device.another(generator) for _ in range(UNITS)]
    pick_off = [
        complex(unit.pickoff_gain_mismatch, unit.pickoff_nonorthogonality) for unit in units
    ]
    others = [
        theory.static_bias_phasor(
            replace(unit, pickoff_gain_mismatch=0.0, pickoff_nonorthogonality=0.0)
        )
        for unit in units
    ]
    sizes = size_maps(device, own_axes=True, calibrated=False)
    for found, values in (
        (sizes.bias[4], np.real(others)),
        (sizes.bias[4], np.imag(others)),
        (sizes.pick_off[4], np.real(pick_off)),
        (sizes.pick_off[4], np.imag(pick_off)),
        (sizes.mean, [theory.mean_bias(unit) for unit in units]),
    ):
        assert found == pytest.approx(np.sqrt(np.mean(np.square(values))), rel=0.05)
    biases = [theory.static_bias(unit, 0.3) - theory.mean_bias(unit) for unit in units]
    calibrated = size_maps(device, own_axes=True, calibrated=True)
    assert calibrated.rest_bias == pytest.approx(np.sqrt(np.mean(np.square(biases))), rel=0.05)


def test_stated_axes_cancel_in_the_map_that_is_taken_out() -> None:
    """A unit whose axes are known has its own amplitude, none where its map is taken out."""
    bare = replace(TYPICAL, pickoff_gain_mismatch=0.0, pickoff_nonorthogonality=0.0)
    phasor = theory.static_bias_phasor(bare)
    sizes = size_maps(bare, own_axes=False, calibrated=True)
    assert sizes.bias[4] == pytest.approx(abs(phasor) / np.sqrt(2))
    mended = replace(bare, bias_map=AngleMap(cos4=phasor.real, sin4=phasor.imag))
    assert size_maps(mended, own_axes=False, calibrated=True).bias[4] < 1e-9 * abs(phasor)
    skewed = Device(pickoff_nonorthogonality=4e-4, scale_factor_map=AngleMap(cos4=1e-4, sin8=2e-5))
    left = size_maps(skewed, own_axes=False, calibrated=True).pick_off
    assert left[4] == pytest.approx(0.0, abs=1e-12)
    assert left[8] == pytest.approx(8 * 2e-5 / np.sqrt(2))


def test_second_harmonic_is_that_of_the_demodulation_offset() -> None:
    sizes = size_maps(replace(TYPICAL, demodulation_offset=1e-4), own_axes=True, calibrated=True)
    assert sizes.pick_off[2] == pytest.approx(1e-4 / np.sqrt(2))


def test_parametric_drive_takes_what_forces_misaim() -> None:
    """Of pick-offs the scale factor's map stays; of the pump its anisotropy comes."""
    pumped = replace(TYPICAL, parametric_share=1.0, pump_anisotropy=1e-3, damping_anisotropy=0.0)
    bare = replace(pumped, pickoff_gain_mismatch=0.0, pickoff_nonorthogonality=0.0)
    sizes = size_maps(pumped, own_axes=False, calibrated=False)
    expected = abs(theory.static_bias_phasor(bare)) / np.sqrt(2)
    assert sizes.rest_bias == pytest.approx(expected) == sizes.bias[4]
    assert sizes.pick_off == size_maps(TYPICAL, own_axes=False, calibrated=False).pick_off
    assert sizes.mean == sizes.scale_factor == 0.0


def test_turn_on_scatter_counts() -> None:
    steady = replace(TABLE2, turn_on_scatter={})
    with_it, without = (size_maps(each, False, True) for each in (TABLE2, steady))
    scatter = 9e-6 / (4 * TABLE2.bryan_factor * TABLE2.decay_time)
    assert with_it.bias[4] ** 2 - without.bias[4] ** 2 == pytest.approx(scatter**2)
    assert with_it.mean**2 - without.mean**2 == pytest.approx(2 * scatter**2)


def test_typical_units_keep_their_bias() -> None:
    """In quadrature they are as large as their kind: 0.1 deg/h, as before."""
    expected = theory.circumferential_bias_stability(TYPICAL)
    assert FmuGyros().errors.gyro_bias == pytest.approx(expected, rel=1e-3)
