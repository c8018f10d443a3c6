"""One test linearized around a simulated device, and its series whitened."""

from collections.abc import Collection, Hashable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array
from pyhrg.common.robust import estimate_robust_deviation
from pyhrg.device.device import Device
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.coordinates import Coordinates, compute_temperatures
from pyhrg.gap.effects.form import Form, build_form_columns, build_reading_columns
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.effects.term_columns import build_term_columns
from pyhrg.gap.replay.angle_derivatives import AngleDerivatives
from pyhrg.gap.replay.carrier_terms import compute_carrier_terms
from pyhrg.gap.replay.inputs.table_steps import shape_rounding_errors
from pyhrg.gap.replay.inputs.thermometer import estimate_thermometer_noise
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.replay.recorder import list_read_out_fields
from pyhrg.gap.soundness.origin import is_origin_set
from pyhrg.gap.whitening.campaign_noise import CampaignNoise
from pyhrg.gap.whitening.channel_noise import compute_temperature_slopes
from pyhrg.gap.whitening.smoothing import is_coarsely_quantized, smooth_readings
from pyhrg.gap.whitening.whitening import WhitenedSeries, whiten

MAX_ORIGIN = 1.0
"""Standard deviation of the angle from which an output angle counts, rad. Chosen: far above any, so
that the prior is flat."""
ORIGIN_SIGMA = 1.0
"""Departure of the first reading from the nominal one, in standard deviations of the readings'
differences, above which the origin is free. Chosen: a smaller one is lost in the noise."""
MAX_KEPT_NUMBERS = 2_000_000
"""Largest whitened series of a channel that is kept, in numbers. Chosen: 16 MB, of a test with 6000
rows."""
Group = Effect | CandidateTerm
"""What a group of the design's columns stands for."""


@dataclass(frozen=True)
class WhitenedTerms:
    """Products of a channel's columns in a test, whitened.

    sizes: number of columns of each candidate term, form and jump, in their order, after those of
        the effects.
    gram: (q, q) products; the residual is last.
    """

    sizes: Mapping[CandidateTerm, int]
    gram: Array
    log_determinant: float


@dataclass(frozen=True)
class _WhitenedBase:
    """Effects and candidate terms of a channel in a test: their products, which columns show in it
    at all, and the whitened (m, p) series of these, with which those of forms and jumps are made;
    None where the series are too long to be kept."""

    terms: WhitenedTerms
    shown: NDArray[np.int64]
    series: Array | None


def shape_origin(bryan_factor: float, slopes: Array) -> Array:
    """(n,) change of an output angle per change of its origin (docs/methods/whitening.md, Eq. 19).

    slopes: (n,) derivative of the output angle by the pattern angle at power-on.
    """
    return 1 - bryan_factor * slopes


def shape_late_reading(test: ObservedTest, device: Device) -> Array:
    """(n,) change of the resonator's temperature that the second order of the thermometer's lag
    makes, K (docs/methods/whitening.md, Eq. 18): of the readings, since what a late reading lacks
    is a series in their derivatives."""
    lag, read = device.thermometer_lag, replace(device, thermometer_lag=0.0)
    case, resonator, case_rate = compute_temperatures(test, read)
    bend = case_rate - (case - resonator) / device.thermal_lag
    return np.asarray(lag * (lag + test.log.interval) / 2 / device.thermal_lag * bend)


@dataclass(frozen=True)
class LinearTest:
    """One test linearized around a simulated device.

    device: that is simulated.
    simulated: (n,) by field of a log, of the device.
    residual: (n,) by channel, record less simulation, referred to the nominal device.
    sensitivities: (n, d) by channel, for each effect: change of a channel per unit of its vector.
    where: coordinates of the rows.
    by_angle: derivatives of the channels by the pattern angle.
    candidates: the candidate terms that take part; None of all.
    kept: last whitened series of a channel, with their noise.
    """

    test: ObservedTest
    device: Device
    simulated: Mapping[str, Array]
    residual: Mapping[str, Array]
    sensitivities: Mapping[Effect, Mapping[str, Array]]
    where: Coordinates
    by_angle: AngleDerivatives
    candidates: Collection[Group] | None = None
    kept: dict[str, tuple[Hashable, _WhitenedBase]] = field(
        default_factory=dict, init=False, compare=False, repr=False
    )

    @property
    def nominal(self) -> Device:
        """The device from which sizes count."""
        return self.where.nominal

    @property
    def bryan_factor(self) -> float:
        """Angular gain of the nominal device."""
        return self.nominal.bryan_factor

    def observe(self, test: ObservedTest) -> "LinearTest":
        """A copy of this linear model for the test with more observed of it."""
        return replace(self, test=test, where=replace(self.where, test=test))

    def responses(self, channel: str) -> Array:
        """(n, p + 1) sensitivities to all effects, and the residual."""
        effects = [own[channel] for own in self.sensitivities.values()]
        return np.column_stack([*effects, self.residual[channel]])

    def gyro_residual(self, channel: str) -> Array:
        """(n,) residual without what the simulated device's recorder makes of it, which is
        exact."""
        residual, exact = self.residual[channel], set(list_read_out_fields(self.test.log))
        for effect, own in self.sensitivities.items():
            if exact.issuperset(effect.fields):
                away = effect.vector(self.device) - effect.vector(self.nominal)
                residual = residual - own[channel] @ away
        return residual

    @cached_property
    def unmodelled(self) -> Mapping[str, Array]:
        """(n,) or (n, m) shapes by channel that the simulation lacks, each of a size up to about 1:
        the next order of the carrier's average, and of the thermometer's lag; in the output angle
        its origin, with which the pattern's start is wrong too, the encoder's rounding, and what
        the thermometer's noise makes of it (docs/methods/whitening.md, Eqs. 18 to 19).
        """
        device = self.device
        shapes = dict(compute_carrier_terms(device, self.test, self.where.pattern_angle))
        if device.thermometer_lag:
            kelvin = shape_late_reading(self.test, device)
            for channel, slope in compute_temperature_slopes(device).items():
                shapes[channel] = np.column_stack([shapes[channel], slope * kelvin])
        if is_origin_set(self.test.test.log, self.device.site) or self._begins_elsewhere():
            origin = shape_origin(self.bryan_factor, self.by_angle.slopes["gyro_angle"])
            shapes["gyro_angle"] = MAX_ORIGIN * origin
        table = self.test.log.table_angle
        if (rounding := shape_rounding_errors(table, self.test.encoder_step)).size:
            shapes["gyro_angle"] = np.column_stack([shapes["gyro_angle"], rounding])
        if slope := device.bias_per_temperature_rate:
            case = self.test.inputs.find_case_temperatures(device)
            noise = slope * estimate_thermometer_noise(case)[1:]
            shapes["gyro_angle"] = np.column_stack([shapes["gyro_angle"], noise])
        return shapes

    def _begins_elsewhere(self) -> bool:
        """Whether the first output angle is another than the nominal gyro's."""
        residual = self.residual["gyro_angle"]
        residual = residual[np.isfinite(residual)]
        noise = estimate_robust_deviation(np.diff(residual))
        return len(residual) > 0 and abs(float(residual[0])) > ORIGIN_SIGMA * noise

    def at_measured_angle(self, series: Array, angles: Array, channel: str) -> Array:
        """(n, p) series of a channel, referred to the measured pattern angle instead of the
        simulated one; `angles` are the same series of the output angle, rad.

        Noise that turns the pattern then appears in the output angle alone
        (docs/methods/effects.md, Eq. 3). Readings that are coarsely quantized are smoothed: their
        error does not turn the pattern (Eq. 3a).
        """
        if channel == "gyro_angle":
            return series
        log = self.test.log
        if is_coarsely_quantized(self.device):
            angles = smooth_readings(angles, np.isfinite(log.gyro_angle), log.interval, self.device)
        return series + self.by_angle.turn(channel, self.bryan_factor * angles, log)


def whiten_terms(
    part: LinearTest,
    channel: str,
    jumps: Sequence[Jump],
    forms: Collection[Form],
    noise: CampaignNoise,
) -> WhitenedTerms:
    """Products of a channel's columns: of effects, candidate terms, forms and jumps."""
    base, extra = _whiten_base(part, channel, noise), _build_extra(part, channel, jumps, forms)
    if not extra:
        return base.terms
    series = base.series
    if series is None:
        own = _build_base(part, channel)[1][:, base.shown]
        series = whiten_rows(part, channel, own, noise).series
    added = whiten_rows(part, channel, np.column_stack([*extra.values()]), noise).series
    gram = base.terms.gram
    across = np.zeros((len(gram), added.shape[1]))
    across[base.shown] = series.T @ added
    gram = np.block(
        [
            [gram[:-1, :-1], across[:-1], gram[:-1, -1:]],
            [across[:-1].T, added.T @ added, across[-1:].T],
            [gram[-1:, :-1], across[-1:], gram[-1:, -1:]],
        ]
    )
    sizes = {**base.terms.sizes, **{g: values.shape[1] for g, values in extra.items()}}
    return WhitenedTerms(sizes, gram, base.terms.log_determinant)


def _whiten_base(part: LinearTest, channel: str, noise: CampaignNoise) -> _WhitenedBase:
    """What does not change from one search to the next; it is kept under the last noise."""
    key = noise.get_own_model(channel, part.test)
    kept = part.kept.get(channel)
    if kept and kept[0] == key:
        return kept[1]
    sizes, series = _build_base(part, channel)
    shown = np.flatnonzero(series[part.test.rows[channel]].any(axis=0))
    white = whiten_rows(part, channel, series[:, shown], noise)
    gram = np.zeros((series.shape[1], series.shape[1]))
    gram[np.ix_(shown, shown)] = white.series.T @ white.series
    terms = WhitenedTerms(sizes, gram, white.log_determinant)
    is_kept = white.series.size <= MAX_KEPT_NUMBERS
    base = _WhitenedBase(terms, shown, white.series if is_kept else None)
    part.kept[channel] = key, base
    return base


def _build_base(part: LinearTest, channel: str) -> tuple[dict[CandidateTerm, int], Array]:
    """Number of columns of each candidate term, and (n, q) columns: of effects and candidate terms,
    and the residual."""
    terms = dict(build_term_columns(part.where, channel, part.candidates))
    if channel != "gyro_angle":
        read = build_reading_columns(part.where, part.candidates)
        _add_reading_errors(terms, part, channel, dict(read))
    responses = part.at_measured_angle(
        part.responses(channel), part.responses("gyro_angle"), channel
    )
    series = [responses[:, :-1], *terms.values(), responses[:, -1]]
    return {term: values.shape[1] for term, values in terms.items()}, np.column_stack(series)


def _build_extra(
    part: LinearTest, channel: str, jumps: Sequence[Jump], forms: Collection[Form]
) -> dict[CandidateTerm, Array]:
    """(n, b) columns of forms, and of jumps. A step of the output alone shows in all channels,
    which are compared at the angle that was put out; other jumps turn the pattern."""
    if channel == "gyro_angle":
        columns: dict[CandidateTerm, Array] = dict(build_form_columns(part.where, channel, forms))
        return columns | {jump: jump.columns(part.where) for jump in jumps}
    forms = [f for f in forms if f.channel != "gyro_angle" or f.is_reading_error]
    columns = dict(build_form_columns(part.where, channel, forms))
    _add_reading_errors(columns, part, channel, dict(build_reading_columns(part.where, forms)))
    for jump in (jump for jump in jumps if jump.kind == "output"):
        step = jump.columns(part.where)
        columns[jump] = part.at_measured_angle(np.zeros_like(step), step, channel)
    return columns


def _add_reading_errors(
    columns: dict[CandidateTerm, Array],
    part: LinearTest,
    channel: str,
    angles: Mapping[CandidateTerm, Array],
) -> None:
    """Add to another channel's columns what errors of the output angle make of the angle at which
    the channel is compared."""
    for group, values in angles.items():
        own = columns.get(group, np.zeros_like(values))
        columns[group] = part.at_measured_angle(own, values, channel)


def whiten_gyro_residual(part: LinearTest, channel: str, noise: CampaignNoise) -> Array:
    """(m,) compared rows of a channel's residual at the measured pattern angle, whitened, without
    what the recorder makes."""
    own, angle = (part.gyro_residual(name)[:, None] for name in (channel, "gyro_angle"))
    series = part.at_measured_angle(own, angle, channel)
    return whiten_rows(part, channel, series, noise).series[:, 0]


def whiten_rows(
    part: LinearTest, channel: str, series: Array, noise: CampaignNoise
) -> WhitenedSeries:
    """Whiten the compared rows of (n, p) series of a channel."""
    rows = part.test.rows[channel]
    steps = np.diff(part.test.log.time[rows], prepend=0.0)
    unmodelled = part.unmodelled[channel][rows]
    return whiten(series[rows], steps, noise.get_model(channel, part.test, rows), unmodelled)
