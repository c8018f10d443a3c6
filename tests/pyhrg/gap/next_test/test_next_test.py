"""The next test separates hypotheses that a test at rest leaves confounded."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H, DEG_PER_SQRT_H, HOUR, HZ
from pyhrg.device.declarations import format_effect
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.gap.effects.catalogue import EFFECTS, Catalogue, Effect
from pyhrg.gap.effects.design import build_design
from pyhrg.gap.effects.linear_test import LinearTest
from pyhrg.gap.effects.sensitivities import compute_sensitivities, linearize_test
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.evidence.evidence import fit
from pyhrg.gap.evidence.rounds.iteration import attribute_gap
from pyhrg.gap.next_test.candidate_tests import list_candidates
from pyhrg.gap.next_test.next_test import (
    SEPARATION_SIGMA,
    Separation,
    compute_separations,
    order_kinds,
    suggest_next_test,
)
from pyhrg.gap.next_test.rivals import Rival, find_rivals, make_rival
from pyhrg.gap.replay.observations import ObservedTest, observe_test
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.whitening.whitening import draw_noise
from pyhrg.records.campaign import Test

BELIEVED = Device(
    damping_anisotropy=1e-6,
    damping_axis=20 * DEG,
    frequency_split=5e-4 * HZ,
    stiffness_axis=65 * DEG,
    angle_random_walk=3e-4 * DEG_PER_SQRT_H,
    angle_white_noise=0.036 * ARCSEC,
)
NOISE = {
    "temperature": 5e-3,
    "amplitude": 1e-6,
    "amplitude_force": 1e-6,
    "quadrature_force": 1e-6,
    "frequency_offset": 1e-3,
}
"""Noise of a row, SI, in channels for which the FMU makes none."""
TRUTH = replace(BELIEVED, drive_gain_mismatch=3e-4)
START = 17 * DEG
WANDERING = 0.01 * DEG_PER_H / HOUR**0.5
"""Rate random walk, rad/s/sqrt(s)."""

Static = Callable[..., Attribution]


@pytest.fixture(scope="module")
def simulation(fmu: GyroFmu, slow_fmu: GyroFmu) -> Simulation:
    return Simulation(fmu, slow_fmu)


def recorded(simulation: Simulation, truth: Device, power_on: PowerOn) -> ObservedTest:
    bench = Bench(simulation.quasi_steady, truth, step=0.1)
    log = bench.log(power_on).log
    generator = np.random.default_rng(5)
    noisy = {
        name: getattr(log, name) + generator.normal(0.0, deviation, len(log.time))
        for name, deviation in NOISE.items()
    }
    test = Test(power_on.id, power_on.kind, "fit", replace(log, **noisy))
    return observe_test(test, BELIEVED)


@pytest.fixture(scope="module")
def static(simulation: Simulation) -> Static:
    """Attribution of half an hour at rest among a few effects."""

    @cache
    def found(truth: Device, *names: str) -> Attribution:
        rest = Bench(simulation.quasi_steady, truth).programme(10.0).rest(HOUR / 2)
        test = recorded(simulation, truth, PowerOn("still", "static", rest, START))
        return attribute_gap(
            simulation,
            BELIEVED,
            [test],
            Catalogue(tuple(EFFECTS[name] for name in names), known=()),
        )

    return found


def alone(found: Attribution, *names: str) -> Rival:
    fitted = fit(found.posterior.best.known.whole, [EFFECTS[name] for name in names])
    assert fitted is not None
    return make_rival(found.posterior.best, fitted)


def test_drive_gain_and_damping_are_separated_where_drives_are_off_or_work(
    simulation: Simulation, static: Static
) -> None:
    names = ("drive_gain_mismatch", "damping_anisotropy")
    found = static(TRUTH, *names)
    alike = [alone(found, name) for name in names]
    assert alike[0].fit.explained == pytest.approx(alike[1].fit.explained, abs=25)
    sigmas = {s.kind: s.sigmas[0, 1] for s in compute_separations(simulation, found, alike)}
    assert max(sigmas[kind] for kind in ("static", "positions", "tumble", "rate")) < 40
    assert min(sigmas[kind] for kind in ("ring_down", "virtual_rotation", "amplitude")) > 150
    said = suggest_next_test(simulation, found, alike)
    assert said is not None
    assert said.kind in ("ring_down", "virtual_rotation", "amplitude")
    assert "drive gain mismatch from damping anisotropy" in said.why


def test_a_g_sensitive_bias_and_a_frame_rotation_are_separated_by_the_tumble(
    simulation: Simulation, static: Static
) -> None:
    names = ("drive_frame_rotation", "g_sensitive_bias")
    found = static(replace(BELIEVED, drive_frame_rotation=1e-4), *names)
    both = [alone(found, name) for name in names]
    said = suggest_next_test(simulation, found, both)
    assert said is not None
    assert said.kind == "tumble"
    as_long = compute_separations(simulation, found, both, said.hours * HOUR)
    parted = next(s for s in as_long if s.kind == "tumble").sigmas[0, 1]
    assert parted >= SEPARATION_SIGMA


def test_pick_off_and_drive_are_separated_by_rotation(
    simulation: Simulation, static: Static
) -> None:
    names = ("pickoff_gain_mismatch", "drive_gain_mismatch")
    found = static(TRUTH, *names)
    sigmas = compute_separations(simulation, found, [alone(found, name) for name in names])
    rate = next(s for s in sigmas if s.kind == "rate")
    still = next(s for s in sigmas if s.kind == "static")
    assert rate.sigmas[0, 1] > 3 * still.sigmas[0, 1]


def test_what_a_rival_can_imitate_by_other_sizes_counts_for_nothing(
    simulation: Simulation, static: Static
) -> None:
    names = ("drive_gain_mismatch", "damping_anisotropy")
    found = static(TRUTH, *names)
    nested = [alone(found, names[0]), alone(found, *names)]
    assert max(s.sigmas[0, 1] for s in compute_separations(simulation, found, nested)) < 0.01
    assert suggest_next_test(simulation, found, nested) is None


def test_a_hidden_effect_is_a_rival_that_a_test_separates(
    simulation: Simulation, static: Static
) -> None:
    """Drives that differ are fitted alone where a damping anisotropy fits as well beside them."""
    effects = [EFFECTS[name] for name in ("drive_gain_mismatch", "damping_anisotropy")]
    found = static(TRUTH, *(effect.name for effect in effects))
    best, *others = find_rivals(found, effects)
    hidden = [rival for rival in others if rival.held]
    assert [set(rival.fit.groups) for rival in hidden] == [set(effects)]
    (cause,) = best.fit.groups
    assert hidden[0].held in effects
    assert hidden[0].held != cause
    said = suggest_next_test(simulation, found, [best, *hidden])
    assert said is not None
    assert said.kind in ("ring_down", "virtual_rotation", "amplitude")
    assert f"{format_effect(hidden[0].held.name)} from its absence" in said.why


def test_a_test_that_separates_all_comes_before_one_that_separates_some_better() -> None:
    some = Separation("static", {(0, 1): 100.0, (0, 2): 0.5, (1, 2): 100.0})
    all_three = Separation("tumble", {(0, 1): 3.0, (0, 2): 4.0, (1, 2): 5.0})
    neither = Separation("thermal", {(0, 1): 0.9, (0, 2): 0.5, (1, 2): 0.0})
    order = order_kinds([neither, some, all_three], list(some.sigmas))
    assert [kind.kind for kind in order] == ["tumble", "static", "thermal"]


def test_where_none_separates_all_the_most_probable_is_separated_first() -> None:
    best = Separation("tumble", {(0, 1): 4.0, (0, 2): 0.0, (1, 2): 0.0})
    others = Separation("rate", {(0, 1): 0.0, (0, 2): 0.9, (1, 2): 50.0})
    order = order_kinds([others, best], [(0, 1), (1, 2)])
    assert [kind.kind for kind in order] == ["tumble", "rate"]


def test_one_hypothesis_needs_no_test(simulation: Simulation, static: Static) -> None:
    found = static(BELIEVED, "drive_gain_mismatch", "damping_anisotropy")
    assert found.ranking.best.groups == ()
    (only,) = find_rivals(found, [EFFECTS["drive_gain_mismatch"]])
    assert only.fit == found.ranking.best
    assert suggest_next_test(simulation, found, [only]) is None


def around(
    simulation: Simulation, device: Device, test: ObservedTest, effects: Sequence[Effect]
) -> LinearTest:
    columns = compute_sensitivities(simulation, device, test, effects)
    answers = simulation.simulate(device, test)
    return linearize_test(simulation, BELIEVED, device, test, answers, columns)


@pytest.mark.parametrize("kind", ["positions", "virtual_rotation"])
def test_the_test_once_made_separates_them_as_predicted(
    kind: str, simulation: Simulation, static: Static
) -> None:
    effects = [EFFECTS[name] for name in ("drive_gain_mismatch", "damping_anisotropy")]
    found = static(TRUTH, *(effect.name for effect in effects))
    alike = [alone(found, effect.name) for effect in effects]
    power_ons = list_candidates(Bench(simulation.quasi_steady, TRUTH), START)[kind]
    expected = compute_separations(
        simulation, found, alike, sum(p.programme.time for p in power_ons)
    )

    def parted(truth: Effect, rival: Effect) -> float:
        (size,) = alone(found, truth.name).fit.values
        device = truth.put(BELIEVED, truth.vector(BELIEVED) + size)
        tests = [found.parts[0].test, *(recorded(simulation, device, p) for p in power_ons)]
        parts = [around(simulation, found.device, test, effects) for test in tests]
        fits = [
            fit(build_design(parts, found.channel_noise), [effect]) for effect in (truth, rival)
        ]
        right, wrong = (each.explained for each in fits if each is not None)
        return math.sqrt(right - wrong)

    made = min(parted(*effects), parted(*effects[::-1]))
    assert abs(made - next(s for s in expected if s.kind == kind).sigmas[0, 1]) < 4


def test_an_effect_and_a_noise_are_separated_as_predicted(
    simulation: Simulation, static: Static
) -> None:
    """Mean over 40 hours at rest, within four standard errors and the one nat that a refit of the
    sizes may gain."""
    effect = EFFECTS["drive_gain_mismatch"]
    found = static(replace(BELIEVED, drive_gain_mismatch=3e-6), effect.name)
    own = alone(found, effect.name)
    wandering = replace(own.noise, angle=replace(own.noise.angle, rate_random_walk=WANDERING))
    old = build_design(found.parts, wandering)
    nothing = fit(old, [])
    assert nothing is not None
    walk = Rival(nothing, wandering, ("rate_random_walk",), old)
    said = suggest_next_test(simulation, found, [own, walk])
    assert said is not None
    assert "drive gain mismatch from rate random walk" in said.why
    (rest,) = list_candidates(Bench(simulation.quasi_steady, found.device), START)["static"]
    still = around(simulation, found.device, recorded(simulation, found.device, rest), [effect])
    (size,) = own.fit.values
    generator = np.random.default_rng(3)

    def gained() -> float:
        angle = still.sensitivities[effect]["gyro_angle"] @ size
        angle += draw_noise(own.noise.angle, len(angle), still.test.log.interval, generator)
        made = replace(still, residual={**still.residual, "gyro_angle": angle})
        return log_ratio([*found.parts, made]) - log_ratio(found.parts)

    def log_ratio(parts: Sequence[LinearTest]) -> float:
        with_effect, without = build_design(parts, own.noise), build_design(parts, wandering)
        explained = fit(with_effect, [effect])
        assert explained is not None
        return with_effect.log_likelihood + explained.explained / 2 - without.log_likelihood

    gains = [gained() for _ in range(40)]
    kinds = compute_separations(simulation, found, [own, walk])
    (expected,) = (kind.sigmas[0, 1] ** 2 / 2 for kind in kinds if kind.kind == "static")
    assert expected > 4
    error = np.std(gains) / np.sqrt(len(gains))
    assert np.mean(gains) == pytest.approx(expected, abs=4 * error + 1)
