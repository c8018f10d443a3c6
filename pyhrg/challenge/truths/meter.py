"""Strength of a gap in the tests of a campaign, sigmas, from Fisher information
(docs/methods/challenge.md, Eqs. 1 to 4)."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial

import numpy as np
from scipy.optimize import minimize_scalar

from pyhrg.bench.programme import Course, Programme, make_course
from pyhrg.challenge.campaigns.gyro import Disturbance, TrueGyro
from pyhrg.challenge.campaigns.instruments import Instruments
from pyhrg.challenge.campaigns.laboratory import Laboratory
from pyhrg.challenge.truths.channel_noise import build_noises, state_angle_noise
from pyhrg.challenge.truths.noise_strength import measure_noise, set_noise
from pyhrg.challenge.truths.unsteadiness import measure_unsteadiness
from pyhrg.common.arrays import Array, Mask
from pyhrg.device.device import Device
from pyhrg.fmu import CONTROL_PERIOD
from pyhrg.gap.effects.catalogue import DETERMINISTIC, EFFECTS, NOISE_EFFECTS, Effect, NoiseEffect
from pyhrg.gap.replay.angle_derivatives import AngleDerivatives
from pyhrg.gap.replay.carrier_terms import compute_carrier_terms
from pyhrg.gap.replay.free_pattern import find_known_rows
from pyhrg.gap.replay.inputs.inputs import ReplayInputs, prepare_inputs
from pyhrg.gap.replay.observations import (
    CHANNELS,
    COARSE_STEP,
    observe_test,
)
from pyhrg.gap.replay.replay import replay_inputs
from pyhrg.gap.replay.sampled import is_short
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.whitening.whitening import NoiseModel, whiten
from pyhrg.records import Log
from pyhrg.records.campaign import Test

NOTHING = Disturbance()
STEP = 1e-3
"""Step of a sensitivity over the effect's scale, small enough to be linear."""
RANK_TOLERANCE = 1e-7
"""Relative singular value below which a combination of effects counts as dependent."""
LOG_SIZE_RANGE = (math.log(1e-4), math.log(10.0))
"""Range of a noise over its scale that is searched, natural logarithms."""
MIN_FORCE = 1e-9
"""Smallest force that another is divided by, 1/s."""
Residual = dict[str, Array]
"""(n,) by channel."""


@dataclass(frozen=True)
class NominalTest:
    """A test of the nominal device, without a gap.

    Attributes:
        rows: (n,) by channel: rows that are compared.
        by_angle: derivatives of the simulated channels by the pattern angle.
        carrier_terms: (n,) by channel: what the average over a carrier period leaves out. A record
            may contain it or not, so it counts as noise of this shape.
    """

    log: Log
    rows: Mapping[str, Mask]
    by_angle: AngleDerivatives
    carrier_terms: Mapping[str, Array]


@dataclass(frozen=True)
class Meter:
    """Measures the strength of gaps on the inputs of a campaign. No noise is simulated. Short tests
    are simulated with sampled loops, all others with quasi-steady loops.

    A residual is the true gyro's log less a simulation of the nominal device, which gets the inputs
    that the log shows. It is whitened with the true gyro's noise. This noise turns the pattern, so
    it enters every channel that depends on the pattern angle. Therefore the other channels are
    simulated at the pattern angle that the output angle shows. Rows with moving loops are left out,
    because settled loops don't show them.

    Attributes:
        simulation: both fidelities.
        nominal: the nominal device.
        tests: course and start angle, rad, of each test that a diagnosis may fit.
        laboratories: one for each parameter that is known within a tolerance, with that parameter
            off by one standard deviation. What these parameters imitate of a gap within their
            tolerances counts as noise.
    """

    simulation: Simulation
    nominal: Device
    tests: Sequence[tuple[Course, float]]
    instruments: Instruments
    laboratories: Sequence[Laboratory] = ()
    _known_shapes: dict[NoiseModel, tuple[Array, Array]] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    def sigmas_of(self, name: str, parameters: Mapping[str, float]) -> float:
        """Strength of an effect of the catalogue, by the campaign format's parameters.

        Raises:
            KeyError: the catalogue has no such effect.
        """
        if name in EFFECTS:
            effect = EFFECTS[name]
            return self.sigmas(effect.put(self.nominal, effect.vector_of(parameters)))
        noise = NOISE_EFFECTS[name]
        value = noise.key.to_si(parameters[noise.key.name])
        return self.sigmas_of_noise(set_noise(self.nominal, noise, value))

    def sigmas(self, device: Device, disturbance: Disturbance = NOTHING) -> float:
        """Strength of the gap between a true gyro and the nominal device (Eq. 1)."""
        return float(np.linalg.norm(self.residual(device, disturbance)))

    def sigmas_beyond(self, effect: Effect, gap: Array) -> float:
        """Strength of a gap, (n,) of `residual`, without the part that an effect can imitate: its
        projection on the effect's sensitivities."""
        basis = np.linalg.qr(self._compute_sensitivities([effect]))[0]
        return float(np.linalg.norm(gap - basis @ (basis.T @ gap)))

    def sigmas_beyond_catalogue(self, gap: Array) -> float:
        """Strength of a gap without the part that the effects of the catalogue can imitate
        (Eq. 3)."""
        return float(np.linalg.norm(gap - self._catalogue @ (self._catalogue.T @ gap)))

    @cached_property
    def _catalogue(self) -> Array:
        """(n, p) orthonormal basis of the sensitivities to all effects."""
        columns = self._compute_sensitivities(DETERMINISTIC)
        left, sizes, _ = np.linalg.svd(columns, full_matrices=False)
        return np.asarray(left[:, sizes > RANK_TOLERANCE * sizes[0]])

    def _compute_sensitivities(self, effects: Sequence[Effect]) -> Array:
        """(n, p) sensitivities to the components of the effects, each of length 1."""
        steps = [
            effect.put(self.nominal, effect.vector(self.nominal) + STEP * effect.scale * unit)
            for effect in effects
            for unit in np.eye(effect.size)
        ]
        columns = [self.residual(device) for device in steps]
        return np.column_stack([c / (np.linalg.norm(c) or 1.0) for c in columns])

    def residual(self, device: Device, disturbance: Disturbance = NOTHING) -> Array:
        """(n,) whitened residual of all tests and channels, known parameters integrated out
        (Eq. 4)."""
        noise = state_angle_noise(device)
        gap = _concatenate(self._whiten(noise, self._compute_residuals(device, disturbance)))
        if not self.laboratories:
            return gap
        shapes, shrinking = self._find_known_shapes(noise)
        return np.asarray(gap - shapes @ (shrinking * (shapes.T @ gap)))

    def _find_known_shapes(self, noise: NoiseModel) -> tuple[Array, Array]:
        """(n, k) orthonormal shapes of what known parameters make of whitened residuals, and (k,)
        the shares of them by which these become white: (I + K K^T)^(-1/2) for the (n, k) responses
        K to parameters of unit variance."""
        if noise not in self._known_shapes:
            known = [_concatenate(self._whiten(noise, own)) for own in self._known_residuals]
            shapes, sizes, _ = np.linalg.svd(np.column_stack(known), full_matrices=False)
            self._known_shapes[noise] = shapes, 1 - 1 / np.sqrt(1 + sizes**2)
        return self._known_shapes[noise]

    def sigmas_of_unsteady(self, disturbance: Disturbance) -> float:
        """Strength of noise bursts beyond the best stationary noise."""
        series: dict[tuple[str, float], list[Array]] = {}
        noise = state_angle_noise(self.nominal)
        white = self._whiten(noise, self._compute_residuals(self.nominal, disturbance))
        for (course, _), residuals in zip(self.tests, white, strict=True):
            for channel, residual in residuals.items():
                series.setdefault((channel, course.interval), []).append(residual)
        return measure_unsteadiness(list(series.values()))

    def _compute_residuals(self, device: Device, disturbance: Disturbance) -> list[Residual]:
        """Residuals of each test, less what they are without a gap."""
        logs = self._simulate_logs(device, disturbance)
        every = zip(logs, self._nominal_tests, self._expected, strict=True)
        return [
            {n: r - expected[n] for n, r in self._compute_residual(log, test).items()}
            for log, test, expected in every
        ]

    def _simulate_logs(self, device: Device, disturbance: Disturbance) -> list[Log]:
        logs = []
        for course, start in self.tests:
            fmu = self.simulation.model(len(course), course.interval)
            gyro = TrueGyro(fmu, device, self.instruments, disturbance)
            logs.append(disturbance.shown(gyro.exact("", course, start, np.zeros((1, 1)))))
        return logs

    @cached_property
    def _known_residuals(self) -> list[list[Residual]]:
        """Residuals of all tests of the nominal device in each laboratory."""
        reference = self.nominal.reference_temperature
        return [
            self._compute_residuals(
                laboratory.true_device(self.nominal),
                Disturbance(shown=partial(laboratory.read, reference_temperature=reference)),
            )
            for laboratory in self.laboratories
        ]

    def _replay(self, inputs: ReplayInputs) -> dict[str, Array]:
        shape = len(inputs.log.time), inputs.log.interval
        fmu = self.simulation.model(*shape)
        return replay_inputs(fmu, self.nominal, inputs, _choose_step(*shape))

    def _whiten(self, angle: NoiseModel, residuals: Sequence[Residual]) -> list[Residual]:
        """The compared rows of residuals of each test, whitened; the output angle with this
        noise."""
        white = []
        for test, gaps in zip(self._nominal_tests, residuals, strict=True):
            noises = build_noises(self.nominal, self.instruments, test.log)
            noises, own = noises | {"gyro_angle": angle}, Residual()
            for name, gap in gaps.items():
                rows, out = test.rows[name], test.carrier_terms[name]
                steps = np.diff(test.log.time[rows], prepend=0.0)
                own[name] = whiten(gap[rows, None], steps, noises[name], out[rows]).series[:, 0]
            white.append(own)
        return white

    @cached_property
    def _nominal_tests(self) -> list[NominalTest]:
        logs = self._simulate_logs(self.nominal, NOTHING)
        return [self._prepare_nominal_test(log) for log in logs]

    def _prepare_nominal_test(self, log: Log) -> NominalTest:
        test = observe_test(Test("", "", "fit", log), self.nominal)
        by_angle = self.simulation.differentiate_by_angle(self.nominal, test)
        kept = find_known_rows(by_angle, self.nominal, log)
        rows = {name: test.rows[name] & kept for name in CHANNELS}
        out = _scale_force(log, compute_carrier_terms(self.nominal, test, log.wave_angle))
        return NominalTest(log, rows, by_angle, out)

    @cached_property
    def _expected(self) -> list[Residual]:
        """Residual of each test without a gap. It is not zero, because a replay knows the inputs
        only from the log."""
        return [self._compute_residual(test.log, test) for test in self._nominal_tests]

    def _compute_residual(self, log: Log, test: NominalTest) -> Residual:
        noise = self.instruments.temperature
        answer = self._replay(prepare_inputs(log, self.nominal, thermometer_noise=noise))
        residual = {name: getattr(log, name) - answer[name] for name in CHANNELS}
        turned = self.nominal.bryan_factor * residual["gyro_angle"]
        for name in CHANNELS[1:]:
            residual[name] = residual[name] + test.by_angle.turn(name, turned, log)
        return _scale_force(log, residual)

    def sigmas_of_noise(self, device: Device, against: Device | None = None) -> float:
        """Strength of a device's noise beyond that of another device, the nominal one by default
        (Eq. 2)."""
        return measure_noise(device, against or self.nominal, [course for course, _ in self.tests])

    def sigmas_of_noise_beyond(self, noise: NoiseEffect, device: Device) -> float:
        """Strength of a device's noise when another noise, at its best level, imitates it."""

        def compute_strength(logarithm: float) -> float:
            added = math.exp(logarithm) * noise.scale
            value = math.hypot(getattr(self.nominal, noise.field), added)
            return self.sigmas_of_noise(device, set_noise(self.nominal, noise, value))

        return float(minimize_scalar(compute_strength, bounds=LOG_SIZE_RANGE, method="bounded").fun)


def _concatenate(residuals: Sequence[Residual]) -> Array:
    return np.concatenate([series for test in residuals for series in test.values()])


def make_measured_course(programme: Programme) -> Course:
    """A test's course, in the steps that its strengths are measured in."""
    return make_course(programme, _choose_step(len(programme), programme.interval))


def _choose_step(rows: int, interval: float) -> float:
    return CONTROL_PERIOD if is_short(rows, interval) else min(COARSE_STEP, interval)


def _scale_force(log: Log, by_channel: Mapping[str, Array]) -> Residual:
    """The channels, with the amplitude force relative to the logged one, as its noise is stated."""
    force = np.maximum(np.abs(log.amplitude_force), MIN_FORCE)
    return {**by_channel, "amplitude_force": by_channel["amplitude_force"] / force}
