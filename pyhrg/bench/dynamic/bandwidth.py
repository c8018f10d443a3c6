"""Bandwidth: what the output makes of an oscillating table, against its encoder.

The table's rate holds many frequencies at once and repeats every second; each second gives gain and
phase at each of them. In whole-angle mode the pattern itself follows the case at once, so that only
the read-out's sampling and hold are seen.
"""

from dataclasses import dataclass, replace

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from scipy import stats

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.outcome import BenchError, Finding, Outcome, mean_finding
from pyhrg.bench.procedure import Procedure, exclusions_of, tests_of
from pyhrg.bench.programme import Programme
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign, Test

KIND = "bandwidth"
INTERVAL = 1e-3
PERIOD = 1.0
FREQUENCIES = (1, 2, 5, 10, 20, 50, 100, 150, 200, 250, 300, 350, 400, 450)
"""Hz, whole numbers of cycles in a period."""
RATE = 2 * DEG
"""Amplitude of the table's rate at each frequency, rad/s."""
PERIODS = 20
HALF_POWER = 10 ** (-3 / 20)
DRIVEN = 0.05
"""A frequency counts where the table's rate has this share of its strongest."""


@dataclass(frozen=True)
class Response:
    """Gain and phase at frequencies, Hz, of each period: (n,) and (m, n) complex."""

    frequency: NDArray[np.float64]
    ratio: NDArray[np.complex128]

    @property
    def mean(self) -> NDArray[np.complex128]:
        """(n,) over periods."""
        return np.asarray(np.mean(self.ratio, axis=0))

    @property
    def reach(self) -> NDArray[np.float64]:
        """(n,) half of the 95 % interval of the gain."""
        m = len(self.ratio)
        along = np.real(self.ratio * np.exp(-1j * np.angle(self.mean)))
        return np.asarray(stats.t.ppf(0.975, m - 1) * np.std(along, axis=0, ddof=1) / np.sqrt(m))

    @property
    def delays(self) -> NDArray[np.float64]:
        """(m,) of each period, s: slope of the phase over all frequencies."""
        turn = 2 * np.pi * self.frequency
        steps = np.unwrap(np.angle(self.ratio), axis=1)
        return np.asarray(-(steps @ turn) / (turn @ turn))


def programme(bench: Bench, periods: int = PERIODS) -> Programme:
    """One power-on, input axis east: the table oscillates at all frequencies."""
    course = bench.programme(INTERVAL).attitude(0.0).rest(PERIOD)
    time = np.arange(1, round(periods * PERIOD / INTERVAL) + 1) * INTERVAL
    phases = np.pi * np.arange(len(FREQUENCIES)) ** 2 / len(FREQUENCIES)  # a small crest factor
    rate = sum(
        RATE * np.sin(2 * np.pi * f * time + phase)
        for f, phase in zip(FREQUENCIES, phases, strict=True)
    )
    for value in np.asarray(rate):
        course.spin(float(value), INTERVAL)
    return course


def record(bench: Bench, periods: int = PERIODS) -> list[Test]:
    """One power-on, rows and steps of 1 ms."""
    fast = replace(bench, step=INTERVAL)
    return fast.run([PowerOn("bandwidth", KIND, programme(bench, periods))])


def response(log: Log) -> Response:
    """Output over encoder at every frequency that the table was driven with.

    Raises:
        BenchError: fewer than 3 periods, or of frequencies.
    """
    log.require("table_angle", "gyro_angle")
    rows = round(PERIOD / log.interval)
    ratios, lines = [], np.zeros(0, dtype=np.int64)
    stretches = log.stretches("table_angle", "gyro_angle") if rows > 2 else []
    for stretch in stretches:
        table, gyro = (np.diff(a[stretch]) for a in (log.table_angle, log.gyro_angle))
        for begin in range(len(table) % rows, len(table) - rows + 1, rows):
            part = slice(begin, begin + rows)
            given, seen = np.fft.rfft(table[part]), np.fft.rfft(gyro[part])
            strong = np.abs(given[1:]) > DRIVEN * np.max(np.abs(given[1:]))
            if np.max(np.abs(given[1:])) < 1e-9 * rows or begin < rows:
                continue  # at rest, or the first second, in which the table starts
            lines = lines if len(lines) else 1 + np.flatnonzero(strong)
            ratios.append(seen[lines] / given[lines])
    if len(ratios) < 3 or len(lines) < 3:
        raise BenchError(
            f"{log.source}: {len(ratios)} seconds of an oscillating table at {len(lines)} "
            f"frequencies, in rows of {log.interval:g} s; at least 3 of each are needed"
        )
    return Response(lines / (rows * log.interval), np.array(ratios))


def bandwidth(found: Response) -> Finding:
    """Where the gain first falls by 3 dB; its interval is where the gain's bounds do."""
    gain, reach = np.abs(found.mean), found.reach
    low, value, high = (_crossing(found.frequency, g) for g in (gain - reach, gain, gain + reach))
    name, n, turn = "bandwidth", len(found.ratio), 2 * np.pi
    if np.isinf(value):
        last = float(found.frequency[-1])
        note = "at least: no frequency of the table is lower by 3 dB"
        return Finding(
            name, last * turn, "Hz", min(low, last) * turn, np.inf, n, note, at_least=True
        )
    return Finding(name, value * turn, "Hz", low * turn, high * turn, n, "-3 dB", at_least=True)


def _crossing(frequency: NDArray[np.float64], gain: NDArray[np.float64]) -> float:
    """Frequency at which the gain falls through -3 dB, linear between; infinite if it doesn't."""
    below = np.flatnonzero(gain < HALF_POWER)
    if not len(below):
        return float(np.inf)
    i = int(below[0])
    if i == 0:
        return float(frequency[0])
    share = (gain[i - 1] - HALF_POWER) / (gain[i - 1] - gain[i])
    return float(frequency[i - 1] + share * (frequency[i] - frequency[i - 1]))


def evaluate(campaign: Campaign) -> Outcome:
    """Bandwidth, delay, gain at the lowest and highest frequency."""
    tests = tests_of(campaign, KIND)
    found = response(tests[0].log)
    width = bandwidth(found)
    delay = mean_finding("delay", found.delays, "s")
    gains = [
        mean_finding(f"gain at {found.frequency[i]:g} Hz", np.abs(found.ratio[:, i]), "1")
        for i in (0, -1)
    ]
    half = tests[0].log.interval / 2
    limit = "at least " if np.isinf(width.high) else ""
    return Outcome(
        procedure=PROCEDURE.name,
        findings=(width, delay, *gains),
        verdict=(
            f"Bandwidth {limit}{width.shown:.4g} Hz, delay "
            f"{delay.value / 1e-6:.2g} us at the samples; a user who holds the last sample "
            f"sees {half / 1e-3:g} ms more on average."
        ),
        tables=(_table(found),),
        exclusions=exclusions_of(tests),
        draw=lambda figure: draw(figure, found),
    )


def _table(found: Response) -> Table:
    columns = (found.frequency, np.abs(found.mean), found.reach, np.angle(found.mean) / DEG)
    rows = [tuple(f"{value:.6g}" for value in row) for row in zip(*columns, strict=True)]
    header = ("frequency, Hz", "gain", "+- 95 %", "phase, deg")
    return Table("Frequency response", header, tuple(rows))


def draw(figure: Figure, found: Response) -> None:
    """Gain and phase against frequency."""
    above, below = figure.subplots(2, 1, sharex=True)
    decibel = 20 * np.log10(np.abs(found.mean))
    bars = 20 / np.log(10) * found.reach / np.abs(found.mean)
    above.errorbar(found.frequency, decibel, bars, fmt="o", color="#0072B2", ms=4, capsize=3)
    above.axhline(-3, color="k", ls="--", lw=1, label="-3 dB")
    above.set_ylabel("gain, dB")
    above.set_title("Output over encoder, 95 % intervals")
    above.legend()
    below.semilogx(found.frequency, np.angle(found.mean) / DEG, "o", color="#0072B2", ms=4)
    below.set_ylabel("phase, deg")
    below.set_xlabel("frequency of the table, Hz")
    for axes in (above, below):
        axes.grid(alpha=0.3, which="both")


PROCEDURE = Procedure(
    name="bandwidth",
    group="dynamic",
    title="Bandwidth and delay",
    rows=(),
    source="IEEE Std 1431: frequency response; estimator: ratio of spectra over whole periods",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
    step=INTERVAL,
)
