"""Bandwidth: frequency response of the output to an oscillating table, against the table encoder.

The table's rate is a sum of sines that repeats every second; each second gives gain and phase at
every frequency. In whole-angle mode the pattern follows the case without delay, so that the
response is that of the read-out's sampling and hold.
"""

from dataclasses import dataclass, replace

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from scipy import stats

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.outcome import BenchError, Finding, Outcome, estimate_mean
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.programme import Programme
from pyhrg.common.arrays import Array
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign, Test

KIND = "bandwidth"
INTERVAL = 1e-3
"""Length of a row, s."""
PERIOD = 1.0
"""Period of the table's oscillation, s."""
FREQUENCIES = (1, 2, 5, 10, 20, 50, 100, 150, 200, 250, 300, 350, 400, 450)
"""Frequencies of the oscillation, Hz; each has whole cycles in a period."""
RATE = 2 * DEG
"""Amplitude of the table's rate at each frequency, rad/s."""
PERIODS = 20
"""Periods of the oscillation in the power-on."""
HALF_POWER = 10 ** (-3 / 20)
"""Gain that defines the bandwidth, -3 dB."""
SMALLEST_DRIVE = 0.05
"""Smallest amplitude of the table's rate, relative to the largest, of a frequency that is used."""


@dataclass(frozen=True)
class Response:
    """Frequency response in m periods.

    Attributes:
        frequency: (n,) Hz.
        ratio: (m, n) complex: output over encoder, in each period.
    """

    frequency: Array
    ratio: NDArray[np.complex128]

    @property
    def mean(self) -> NDArray[np.complex128]:
        """(n,) complex: mean over the periods."""
        return np.asarray(np.mean(self.ratio, axis=0))

    @property
    def reach(self) -> Array:
        """(n,) half width of the gain's 95 % interval."""
        m = len(self.ratio)
        along = np.real(self.ratio * np.exp(-1j * np.angle(self.mean)))
        return np.asarray(stats.t.ppf(0.975, m - 1) * np.std(along, axis=0, ddof=1) / np.sqrt(m))

    @property
    def delays(self) -> Array:
        """(m,) delay in each period, s, from the slope of the phase against the frequency."""
        turn = 2 * np.pi * self.frequency
        steps = np.unwrap(np.angle(self.ratio), axis=1)
        return np.asarray(-(steps @ turn) / (turn @ turn))


def make_programme(bench: Bench, periods: int = PERIODS) -> Programme:
    """Programme of one power-on, input axis east: the table oscillates at all frequencies."""
    course = bench.programme(INTERVAL).attitude(0.0).rest(PERIOD)
    time = np.arange(1, round(periods * PERIOD / INTERVAL) + 1) * INTERVAL
    phases = np.pi * np.arange(len(FREQUENCIES)) ** 2 / len(FREQUENCIES)  # for a small crest factor
    rate = sum(
        RATE * np.sin(2 * np.pi * f * time + phase)
        for f, phase in zip(FREQUENCIES, phases, strict=True)
    )
    for value in np.asarray(rate):
        course.spin(float(value), INTERVAL)
    return course


def record(bench: Bench, periods: int = PERIODS) -> list[Test]:
    """Test of one power-on, in rows and communication steps of 1 ms."""
    fast = replace(bench, step=INTERVAL)
    return fast.run([PowerOn("bandwidth", KIND, make_programme(bench, periods))])


def measure_response(log: Log) -> Response:
    """Frequency response at the frequencies of the table's oscillation."""
    log.require("table_angle", "gyro_angle")
    rows = round(PERIOD / log.interval)
    ratios, lines = [], np.zeros(0, dtype=np.int64)
    stretches = log.stretches("table_angle", "gyro_angle") if rows > 2 else []
    for stretch in stretches:
        table, gyro = (np.diff(a[stretch]) for a in (log.table_angle, log.gyro_angle))
        for begin in range(len(table) % rows, len(table) - rows + 1, rows):
            part = slice(begin, begin + rows)
            encoder, output = np.fft.rfft(table[part]), np.fft.rfft(gyro[part])
            strong = np.abs(encoder[1:]) > SMALLEST_DRIVE * np.max(np.abs(encoder[1:]))
            if np.max(np.abs(encoder[1:])) < 1e-9 * rows or begin < rows:
                continue  # at rest, or the first second, in which the table starts
            lines = lines if len(lines) else 1 + np.flatnonzero(strong)
            ratios.append(output[lines] / encoder[lines])
    if len(ratios) < 3 or len(lines) < 3:
        raise BenchError(
            f"{log.source}: {len(ratios)} seconds of an oscillating table at {len(lines)} "
            f"frequencies, in rows of {log.interval:g} s; at least 3 of each are needed"
        )
    return Response(lines / (rows * log.interval), np.array(ratios))


def find_bandwidth(response: Response) -> Finding:
    """Frequency at which the gain first falls below -3 dB; its interval is from the gain's."""
    gain, reach = np.abs(response.mean), response.reach
    low, value, high = (
        _find_crossing(response.frequency, g) for g in (gain - reach, gain, gain + reach)
    )
    n, turn, note = len(response.ratio), 2 * np.pi, "-3 dB"
    if np.isinf(value):
        value = float(response.frequency[-1])
        low, high = min(low, value), np.inf
        note = "at least: the gain is above -3 dB at every frequency of the table"
    bounds = (value * turn, "Hz", low * turn, high * turn)
    return Finding("bandwidth", *bounds, n, note, at_least=True)


def _find_crossing(frequency: Array, gain: Array) -> float:
    """Frequency at which the gain falls below -3 dB, interpolated linearly; infinite if it never
    does."""
    below = np.flatnonzero(gain < HALF_POWER)
    if not len(below):
        return float(np.inf)
    i = int(below[0])
    if i == 0:
        return float(frequency[0])
    share = (gain[i - 1] - HALF_POWER) / (gain[i - 1] - gain[i])
    return float(frequency[i - 1] + share * (frequency[i] - frequency[i - 1]))


def evaluate(campaign: Campaign) -> Outcome:
    """Bandwidth, delay, and gain at the lowest and the highest frequency."""
    tests = require_tests(campaign, KIND)
    response = measure_response(tests[0].log)
    width = find_bandwidth(response)
    delay = estimate_mean("delay", response.delays, "s")
    gains = [
        estimate_mean(f"gain at {response.frequency[i]:g} Hz", np.abs(response.ratio[:, i]), "1")
        for i in (0, -1)
    ]
    header, mean = ("frequency, Hz", "gain", "+- 95 %", "phase, deg"), response.mean
    columns = (response.frequency, np.abs(mean), response.reach, np.angle(mean) / DEG)
    rows = tuple(tuple(f"{x:.6g}" for x in row) for row in zip(*columns, strict=True))
    half = tests[0].log.interval / 2
    limit = "at least " if np.isinf(width.si_high) else ""
    return Outcome(
        findings=(width, delay, *gains),
        verdict=(
            f"Bandwidth {limit}{width.value:.4g} Hz, delay "
            f"{delay.si_value / 1e-6:.2g} us at the samples; a user who holds the last sample "
            f"sees {half / 1e-3:g} ms more on average."
        ),
        tables=(Table("Frequency response", header, rows),),
        draw=lambda figure: draw(figure, response),
    )


def draw(figure: Figure, response: Response) -> None:
    frequency, mean = response.frequency, response.mean
    above, below = figure.subplots(2, 1, sharex=True)
    decibel = 20 * np.log10(np.abs(mean))
    bars = 20 / np.log(10) * response.reach / np.abs(mean)
    above.errorbar(frequency, decibel, bars, fmt="o", color="#0072B2", ms=4, capsize=3)
    above.axhline(-3, color="k", ls="--", lw=1, label="-3 dB")
    above.set(ylabel="gain, dB", title="Output over encoder, 95 % intervals")
    above.legend()
    below.semilogx(frequency, np.angle(mean) / DEG, "o", color="#0072B2", ms=4)
    below.set(ylabel="phase, deg", xlabel="frequency of the table, Hz")
    for axes in (above, below):
        axes.grid(alpha=0.3, which="both")


PROCEDURE: Procedure = Procedure(
    name="bandwidth",
    group="dynamic",
    title="Bandwidth and delay",
    source="IEEE Std 1431: frequency response; estimator: ratio of spectra over whole periods",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
    step=INTERVAL,
)
