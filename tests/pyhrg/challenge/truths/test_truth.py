"""What is drawn, and how strong it is."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.programme import Programme, make_course
from pyhrg.challenge.campaigns.instruments import Instruments
from pyhrg.challenge.truths.form import PLACES
from pyhrg.challenge.truths.meter import Meter
from pyhrg.challenge.truths.truth import LARGEST_SIZE, Drawing, solve_size
from pyhrg.common.units import DEG
from pyhrg.fmu import GyroError
from pyhrg.gap.effects.catalogue import EFFECT_NAMES, EFFECTS
from pyhrg.gap.replay.simulation import Simulation
from tests.pyhrg.challenge.short import GRAVITY, GYRO

SEEN = ("damping_anisotropy", "pickoff_gain_mismatch", "coriolis_factor_error", "loop_delay")
"""That a turning table shows."""


@pytest.fixture(scope="module")
def meter(simulation: Simulation) -> Meter:
    courses = [
        make_course(Programme(1.0, GRAVITY).spin(rate * DEG, 300.0), 1.0) for rate in (-5, 0, 20)
    ]
    return Meter(simulation, GYRO, [(course, 0.3) for course in courses], Instruments())


def drawing(meter: Meter, seed: int, effects: tuple[str, ...] = SEEN) -> Drawing:
    return Drawing(meter, np.random.default_rng(seed), (6.0, 60.0), effects)


@pytest.mark.parametrize("effect", [*SEEN, "angle_white_noise", "angle_quantisation"])
def test_an_effect_is_as_strong_as_it_was_drawn(meter: Meter, effect: str) -> None:
    state = drawing(meter, 1, (effect,)).draw_state("single")
    (strength,) = state.truth.strengths
    assert 6 <= strength <= 60
    assert meter.sigmas_of(effect, state.truth.parameters) == pytest.approx(strength, rel=0.02)
    field = "quantization_step" if effect == "angle_quantisation" else "name"
    assert (getattr(state.device, field) != getattr(GYRO, field)) == (field == "quantization_step")


def test_none_is_the_nominal_gyro(meter: Meter) -> None:
    state = drawing(meter, 1).draw_state("none")
    assert state.device == GYRO
    assert state.truth.effects == ()


def test_a_pair_is_two_that_cannot_stand_in_for_each_other(
    meter: Meter, monkeypatch: pytest.MonkeyPatch
) -> None:
    state = drawing(meter, 4).draw_state("pair")
    assert len(set(state.truth.effects)) == 2
    noises = ("angle_white_noise", "angle_quantisation")
    monkeypatch.setattr("pyhrg.challenge.truths.truth.MAX_ATTEMPTS", 10)
    with pytest.raises(ValueError, match="pair: the tests show nothing"):
        drawing(meter, 1, noises).draw_state("pair")


def test_several_are_three_to_eight(meter: Meter) -> None:
    more = ("pickoff_nonorthogonality", "frequency_split", "angle_random_walk")
    truth = drawing(meter, 2, (*SEEN, *more)).draw_state("several").truth
    assert 3 <= len(set(truth.effects)) == len(truth.strengths) <= 8


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_an_effect_beside_noise_stands_out_of_it(meter: Meter, seed: int) -> None:
    state = drawing(meter, seed, ("angle_random_walk", "coriolis_factor_error")).draw_state("pair")
    walking = replace(GYRO, angle_random_walk=state.device.angle_random_walk)
    coriolis = EFFECTS["coriolis_factor_error"]
    beside = coriolis.put(walking, coriolis.vector(state.device))
    assert 6 <= meter.sigmas(beside) < meter.sigmas(coriolis.put(GYRO, coriolis.vector(beside)))


def test_outside_names_its_form(meter: Meter) -> None:
    state = drawing(meter, 2).draw_state("outside")
    assert state.truth.form
    assert state.truth.coordinate
    assert state.truth.place in PLACES
    assert 0 < (state.truth.size or 0.0) <= LARGEST_SIZE
    gap = meter.residual(state.device, state.disturbance)
    found = meter.sigmas_beyond_catalogue(gap)
    assert found == pytest.approx(state.truth.strengths[0], rel=0.05)


def test_an_effect_left_out_tells_its_stand_ins(meter: Meter) -> None:
    state = drawing(meter, 1, ("angle_quantisation",)).draw_state("left_out")
    assert "angle_white_noise" in state.truth.stand_ins
    assert "angle_quantisation" not in state.truth.stand_ins
    assert set(state.truth.stand_ins) <= set(EFFECT_NAMES)


def test_what_tests_cannot_show_is_refused(meter: Meter) -> None:
    with pytest.raises(ValueError, match="single: the tests show nothing at"):
        drawing(meter, 1, ("temperature_rate_bias",)).draw_state("single")
    with pytest.raises(ValueError, match="other: expected one of none"):
        drawing(meter, 1).draw_state("other")


def test_size_is_solved() -> None:
    assert solve_size(lambda size: 1e4 * size, 8.0) == pytest.approx(8e-4, rel=0.01)
    assert solve_size(lambda size: 1e-3 * size, 8.0) is None


@pytest.mark.parametrize(("most", "found"), [(2.0, True), (0.1, False), (1e-10, False)])
def test_sizes_that_cannot_be_simulated_are_none(most: float, found: bool) -> None:
    def strength(size: float) -> float:
        if size > most:
            raise GyroError("gyroAngle is no longer finite at 62 s")
        return 8.0 * size

    size = solve_size(strength, 8.0)
    assert size == (pytest.approx(1.0, rel=0.01) if found else None)
