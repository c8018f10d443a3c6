"""Amplitude sweep with the table turning: errors that grow with the square of the amplitude.

A Duffing stiffness moves the loop frequency by its shift at unit amplitude times a^2; a cubic
pick-off b turns the detected angle by -(3/32) b a^2 sin 8th. A differential phase gives an eighth
harmonic too, the same at all amplitudes.
"""

from collections.abc import Sequence

import numpy as np

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.estimation.row_fit import Part
from pyhrg.bench.identification import rate_reversal
from pyhrg.bench.identification.identification_figure import draw_terms
from pyhrg.bench.identification.rate_reversal import EIGHTH, GAIN, SCALE, SKEW
from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.readings import output_rows
from pyhrg.bench.readings.output_rows import BIAS_TERMS, Rows, Terms
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Campaign, Test

KIND = "amplitude"
AMPLITUDES = (0.8, 1.0, 1.2, 1.0, 0.8)
"""Up and down again, so that a drift of the frequency is not taken for stiffness."""
DWELL = 80.0
RATE = 5 * DEG
INTERVAL = 0.1
CUBIC, DUFFING, DRIFT = "pick-off cubic", "Duffing shift", "frequency drift"
REASON = "at least two amplitudes while the pattern turns over most of 90 deg"
DRIFTING = "amplitudes must go up and down again, or temperature may look like stiffness"


def record(
    bench: Bench, amplitudes: Sequence[float] = AMPLITUDES, dwell: float = DWELL
) -> list[Test]:
    course = bench.programme(INTERVAL)
    for amplitude in amplitudes:
        course.command(amplitude_setpoint=amplitude).spin(RATE, dwell)
    return bench.run([PowerOn("amplitude_sweep", KIND, course)])


def find_stretches(campaign: Campaign) -> list[Rows]:
    logs = [test.log for test in require_tests(campaign, KIND)]
    stretches = output_rows.require_steady_rows(logs, "frequency_offset")
    amplitudes = {float(rows.values("amplitude_setpoint")[0]) for rows in stretches}
    if len(amplitudes) < 2:
        raise BenchError(f"{logs[0].source}: {len(amplitudes)} amplitude; the test needs 2")
    return stretches


def fit_cubic(campaign: Campaign, stretches: Sequence[Rows]) -> Terms:
    """Cubic of the pick-offs from the output angle; bias and scale factor may be one."""
    k = output_rows.read_bryan_factor(campaign)
    parts = []
    for rows in stretches:
        excess = float(rows.values("amplitude_setpoint")[0]) ** 2 - 1
        turned = np.diff(np.sin(8 * rows.ends("wave_angle")))
        columns = output_rows.make_bias_columns(rows) | rate_reversal.make_pickoff_columns(rows, k)
        columns[CUBIC] = 3 / (32 * k) * excess * turned
        parts.append(output_rows.make_output_part(rows, campaign.site, columns))
    return output_rows.fit_terms(parts, [*BIAS_TERMS, *EIGHTH, CUBIC, SCALE, GAIN, SKEW], REASON)


def fit_duffing(stretches: Sequence[Rows]) -> Terms:
    """Stiffness from the loop frequency; the split goes with the angle, temperature with time.

    Errors of the electrodes add the eighth harmonic to the split's fourth; those of the pick-offs
    turn the true amplitude, and so the stiffness's share, by the fourth.
    """
    parts = []
    for rows in stretches:
        h, excess = rows.log.interval, rows.values("amplitude_setpoint") ** 2 - 1
        c4, s4, c8, s8 = (rows.mean_trig(trig, n) for n in (4, 8) for trig in (np.cos, np.sin))
        columns = {
            "frequency": np.ones(len(rows)),
            DUFFING: excess,
            "frequency cos4": c4,
            "frequency sin4": s4,
            DRIFT: rows.values("time") / rows.log.time[-1] - 0.5,
            "frequency cos8": c8,
            "frequency sin8": s8,
            f"{DUFFING} cos4": excess * c4,
            f"{DUFFING} sin4": excess * s4,
        }
        scaled = {name: h * values for name, values in columns.items()}
        parts.append(Part(scaled, h * rows.values("frequency_offset"), h))
    return output_rows.fit_terms(parts, list(parts[0].columns), DRIFTING)


def evaluate(campaign: Campaign) -> Outcome:
    """Duffing shift and pick-off cubic."""
    stretches = find_stretches(campaign)
    output, frequency = fit_cubic(campaign, stretches), fit_duffing(stretches)
    title = "Output less table and Earth's rate at several amplitudes"
    labels = [f"amplitude {rows.values('amplitude_setpoint')[0]:g}" for rows in stretches]
    warnings = [output.refused[CUBIC]] if CUBIC in output.refused else []
    warnings += [frequency.refused[name] for name in (DUFFING, DRIFT) if name in frequency.refused]
    return Outcome(
        findings=(
            frequency.finding(DUFFING, "mHz"),
            output.finding(CUBIC, "ppm"),
            *rate_reversal.find_eighth_harmonic(output),
        ),
        verdict=(
            "What follows the square of the amplitude is stiffness (frequency) or a cubic of the "
            "pick-offs (eighth harmonic); the rest of the eighth harmonic is neither."
        ),
        warnings=tuple(warnings),
        draw=lambda figure: draw_terms(figure, title, stretches, output, labels),
    )


PROCEDURE: Procedure = Procedure(
    name="amplitude-sweep",
    group="identification",
    title="Amplitude sweep: Duffing stiffness, cubic of the pick-offs",
    source="envelope X (1 + 3/4 b |X|^2) and gamma |Z|^2 Z to first order; campaign format",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
