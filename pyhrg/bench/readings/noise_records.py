"""Stretches of logs that show noise (table at rest, commands constant), and their noise
coefficients."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pyhrg.bench.outcome import BenchError
from pyhrg.bench.procedure import select_tests
from pyhrg.bench.readings.segments import AT_REST, WARM_UP, split_rows
from pyhrg.noise.coefficients import NoiseCoefficients, NoiseError
from pyhrg.noise.fitting import MIN_SAMPLES, check_record, fit_coefficients
from pyhrg.noise.likelihood import Spectrum, compute_spectrum
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign

TURNING = (2, 4, 8)
"""Orders of the harmonics that bias map and pick-offs add to the output under virtual rotation."""
CREEPING = (4,)
"""Orders of the harmonics that the bias map adds while Earth's rate or bias moves the pattern."""


@dataclass(frozen=True)
class NoiseRecord:
    """A stretch with constant commands and the table at rest.

    Attributes:
        source: log that holds the stretch.
        interval: length of the log's rows, s.
        rotation: commanded virtual rotation as an input rate, rad/s.
        swept: change of the pattern angle, rad.
        spectrum: spectrum of the output angle; rate, ramp and harmonics of the pattern angle are
            estimated with it.
    """

    source: str
    interval: float
    rotation: float
    swept: float
    spectrum: Spectrum

    @property
    def n(self) -> int:
        """Number of angle readings."""
        return len(self.spectrum.rest)


def find_noise_records(log: Log, gain: float | None = None) -> list[NoiseRecord]:
    """Stretches of a log without its first 30 s and the 10 s after each change of a command.
    Without a column of pattern angles, they follow from the output by the angular gain."""
    if gain and not log.has_values("wave_angle"):
        commanded = np.cumsum(np.nan_to_num(log.virtual_rotation)) * log.interval
        log = replace(log, wave_angle=gain * (commanded - log.gyro_angle))
    stretches = list(_find_steady(log))
    long = [part for part in stretches if part.stop - part.start >= MIN_SAMPLES]
    if not long:
        longest = max((p.stop - p.start for p in _find_steady(log, 0.0, 0.0)), default=0)
        raise BenchError(
            f"{log.source}: no stretch at rest with constant commands has {MIN_SAMPLES} rows "
            f"{WARM_UP:g} s after power-on; the longest has {longest} in all"
        )
    return [_make_record(log, part) for part in long]


SETTLE = 10.0
"""Time after the change of a command that is not used, s; the loops' transient lasts about 1 s."""


def _find_steady(log: Log, settle: float = SETTLE, warm_up: float = WARM_UP) -> Iterator[slice]:
    """Rows of each stretch without gap, with the drive on, constant commands and table at rest,
    from `settle` seconds after a command and `warm_up` seconds after power-on."""
    log.require("table_angle", "virtual_rotation", "drive_on", "gyro_angle", "wave_angle")
    held = [log.virtual_rotation, log.drive_on, log.amplitude_setpoint, log.phase_offset]
    changed = np.any(np.diff(np.nan_to_num(held), axis=1, prepend=0.0) != 0, axis=0)
    turned = np.abs(np.diff(log.table_angle, prepend=log.table_angle[:1])) >= AT_REST
    broken = changed | turned | log.is_free
    warm = int(np.searchsorted(log.time, warm_up))
    settled = round(settle / log.interval)
    for part in log.stretches("gyro_angle", "wave_angle", "virtual_rotation", "table_angle"):
        for before, after in split_rows(part, broken[part]):
            first = max(before + (settled if broken[before] else 0), warm)
            if after > first:
                yield slice(first, after)


def _make_record(log: Log, rows: slice) -> NoiseRecord:
    time, angle = log.time[rows], log.gyro_angle[rows]
    rotation = float(log.virtual_rotation[rows.start])
    try:
        check_record(angle, log.interval)
    except NoiseError as error:
        raise BenchError(f"{log.source}: {error}") from error
    # a straight line, for the readings of the pattern angle hold the noise that is measured
    pattern = np.polynomial.Polynomial.fit(time, log.wave_angle[rows], 1)(time)
    orders = TURNING if rotation else CREEPING
    trends = [trig(order * pattern) for order in orders for trig in (np.cos, np.sin)]
    swept = abs(float(pattern[-1] - pattern[0]))
    return NoiseRecord(log.source, log.interval, rotation, swept, compute_spectrum(angle, trends))


def select_comparable(records: Sequence[NoiseRecord]) -> tuple[list[NoiseRecord], tuple[str, ...]]:
    """Records that have the same virtual rotation and interval, and why others are not used.

    The fastest virtual rotation is taken, either direction, and of its intervals the one that has
    most rows. Returns the records, and a sentence on each other one.
    """
    fastest = max(abs(record.rotation) for record in records)
    fast = [r for r in records if np.isclose(abs(r.rotation), fastest, rtol=1e-6)]
    rows = {r.interval: sum(x.n for x in fast if x.interval == r.interval) for r in fast}
    usual = max(rows, key=lambda interval: rows[interval])
    chosen = [record for record in fast if record.interval == usual]
    return chosen, tuple(
        f"{r.source}: {r.n} rows left out, for they are at {r.interval:g} s and a virtual rotation "
        f"of {np.rad2deg(r.rotation):g} deg/s, others at {usual:g} s and {np.rad2deg(fastest):g}"
        for r in records
        if r not in chosen
    )


@dataclass(frozen=True)
class Noise:
    """Noise of one state of the gyro.

    Attributes:
        records: records that share the coefficients, at one interval.
    """

    records: tuple[NoiseRecord, ...]
    coefficients: NoiseCoefficients
    exclusions: tuple[str, ...]

    @property
    def n(self) -> int:
        """Number of angles."""
        return sum(record.n for record in self.records)

    @property
    def longest(self) -> NoiseRecord:
        """The record that shows most."""
        return max(self.records, key=lambda record: record.n)


def fit_noise_of_tests(campaign: Campaign, kind: str, turning: bool) -> Noise | None:
    """Coefficients of the tests of one kind together; None where there are none.

    `turning` chooses the stretches with virtual rotation, else those without.
    """
    tests = select_tests(campaign, kind)
    if not tests:
        return None
    gain = campaign.nominal.get("coriolis_factor")
    candidates = (record for test in tests for record in find_noise_records(test.log, gain))
    wanted = [record for record in candidates if (record.rotation != 0) == turning]
    if not wanted:
        state = "with" if turning else "without"
        raise BenchError(
            f"{tests[0].log.source}: no stretch that is long enough is {state} virtual rotation"
        )
    records, exclusions = select_comparable(wanted)
    best = fit_coefficients([record.spectrum for record in records], records[0].interval)
    return Noise(tuple(records), best, exclusions)
