"""Ring-downs: free decay of the shell with the drives off.

The pattern moves and its amplitude decays by damping, split and rotation alone, so that the damping
anisotropy is separated from every error of the drives and, nearly, of the pick-offs. Without the
quadrature loop the split makes quadrature, which turns the pattern too: decay, damping anisotropy
and split are fitted together, to angle and amplitude, by the closed form of `free_orbit`. Where the
pattern stays near one angle, only the part of the anisotropy that moves it is seen well.

With dw = 0: tan 2(th - th_tau) = tan 2(th0 - th_tau) e^{D t}.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.estimation.harmonics import Fit
from pyhrg.bench.estimation.sizes import estimate_anisotropy, make_component_findings
from pyhrg.bench.figures import COLOURS
from pyhrg.bench.identification import free_decay, rate_reversal
from pyhrg.bench.identification.free_decay import TERMS, Decay, Gyro
from pyhrg.bench.outcome import BenchError, Finding, Outcome
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.output_rows import SHORTEST_ROWS, TRANSIENT, read_bryan_factor
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.records.campaign import Campaign, Test

KIND = "ring_down"
POSITIONS = 8
PATTERN_STEP = 22.5 * DEG
"""Pattern angle between ring-downs, rad: a quarter of the anisotropy's period."""
TABLE_RATE = 10 * DEG
REST = 20.0
DECAY = 120.0
"""Duration of one ring-down, s: short, as the split turns a walk of the quadrature into angle."""
INTERVAL, FINE_INTERVAL = 1.0, 0.1
"""Length of a row, s, and that for splits from 4 mHz on, which leave too few rows of 1 s."""
GUESS_TOLERANCE = 1.1
"""The fit is repeated on fewer rows where the split comes out larger than guessed by this factor.
"""
LARGEST_SPLIT_ANGLE = 0.5
"""Split times time, rad, up to which rows are used. Beyond, that is more than a few percent of the
noise, which the fit takes for white; at pi/2 a pattern may be a circle, whose angle means nothing.
"""


def make_programme(bench: Bench, positions: int = POSITIONS, decay: float = DECAY) -> Programme:
    """One power-on: at each angle the pattern is brought to amplitude, then left alone."""
    split = bench.device.frequency_split
    enough = SHORTEST_ROWS * INTERVAL * split < LARGEST_SPLIT_ANGLE
    course = bench.programme(INTERVAL if enough else FINE_INTERVAL)
    for position in range(positions):
        if position:
            course.turn(PATTERN_STEP / bench.device.bryan_factor, TABLE_RATE)
        course.rest(REST).command(drive_on=0.0).rest(decay).command(drive_on=1.0)
    return course.rest(REST)


def record(bench: Bench, positions: int = POSITIONS, decay: float = DECAY) -> list[Test]:
    """One power-on with ring-downs at four angles, twice; and the pick-offs by table rate."""
    course = make_programme(bench, positions, decay)
    return [*bench.run([PowerOn("ring_down", KIND, course)]), *rate_reversal.record(bench)]


def fit_ring_downs(campaign: Campaign) -> tuple[Fit, list[Decay], Gyro]:
    """Fit of all ring-downs of the campaign, the pick-offs' errors taken from its rate tests, and
    the ring-downs as far as they were used (`LARGEST_SPLIT_ANGLE`).

    Angle and amplitude alone don't separate a split from its negative; the quadrature force does.
    """
    logs = [test.log for test in require_tests(campaign, KIND)]
    k, site = read_bryan_factor(campaign), campaign.site
    decays = [decay for log in logs for decay in free_decay.find_decays(log, site, k)]
    if not decays:
        raise BenchError(
            f"{', '.join(log.source for log in logs)}: the drive is nowhere off for more than "
            f"{SHORTEST_ROWS} rows after rows with the drive on"
        )
    guess = _split_guess(campaign)
    gyro, used = Gyro(k, _pickoff(campaign)), _cut_decays(decays, guess)
    first = used[0]
    rate = float(np.log(first.amplitude[0] / first.amplitude[-1]) / np.ptp(first.time))
    fit = free_decay.fit_decays(used, gyro, np.array([rate, 0.0, 0.0, guess.real, guess.imag]))
    split = free_decay.describe_shell(fit.values).split
    if abs(split) > GUESS_TOLERANCE * abs(guess):
        used = _cut_decays(decays, split)
        fit = free_decay.fit_decays(used, gyro, fit.values)
        split = free_decay.describe_shell(fit.values).split
    if (split.conjugate() * guess).real < 0:
        fit = replace(fit, values=fit.values * [1, 1, 1, -1, -1])
    return fit, used, gyro


def _cut_decays(decays: Sequence[Decay], split: complex) -> list[Decay]:
    """Ring-downs up to `LARGEST_SPLIT_ANGLE` of a split, rad/s."""
    duration = LARGEST_SPLIT_ANGLE / max(abs(split), 1e-12)
    used = [decay.cut(duration) for decay in decays]
    if short := [decay for decay in used if len(decay.time) < SHORTEST_ROWS]:
        raise BenchError(
            f"{short[0].source}: a frequency split of {abs(split) / (2e-3 * np.pi):.3g} mHz allows "
            f"{duration:.3g} s of a ring-down ({LARGEST_SPLIT_ANGLE} rad), "
            f"{len(short[0].time)} rows of {short[0].interval:g} s; "
            f"expected {SHORTEST_ROWS} or more"
        )
    return used


def _pickoff(campaign: Campaign) -> complex:
    """g + i d; zero where the campaign holds no rate test that shows them."""
    if not any(test.kind == rate_reversal.KIND for test in campaign.tests):
        return 0j
    terms = rate_reversal.fit_pickoff_errors(campaign)
    if {rate_reversal.GAIN, rate_reversal.SKEW} & terms.refused.keys():
        return 0j
    return complex(terms.fit.value(rate_reversal.GAIN), terms.fit.value(rate_reversal.SKEW))


def _split_guess(campaign: Campaign) -> complex:
    """From the quadrature force while the drive is on: enough to begin with.

    What a ring-down left of quadrature is driven out first, with a far greater force.
    """
    columns, values = [], []
    for test in require_tests(campaign, KIND):
        log = test.log
        log.require("quadrature_force", "amplitude_setpoint")
        wait = int(np.ceil(TRANSIENT / log.interval))
        off = np.convolve(log.is_free, np.ones(wait + 1))[: len(log.time)] > 0.5
        on = ~off & np.isfinite(log.quadrature_force + log.wave_angle)
        angle = 4 * log.wave_angle[on]
        columns.append(np.column_stack([np.sin(angle), -np.cos(angle)]) / 2)
        values.append(log.quadrature_force[on] / log.amplitude_setpoint[on])
    parts = np.linalg.lstsq(np.vstack(columns), np.concatenate(values), rcond=1e-3)[0]
    return complex(*parts)


def evaluate(campaign: Campaign) -> Outcome:
    """Decay time, damping anisotropy and split with their axes."""
    fit, used, gyro = fit_ring_downs(campaign)
    rate, (low, high) = fit.value(TERMS[0]), fit.interval(TERMS[0])
    damping, split = (
        (TERMS[1], TERMS[2]),
        (TERMS[3], TERMS[4]),
    )
    return Outcome(
        findings=(
            Finding("decay time", 1 / rate, "s", 1 / high, 1 / low, len(fit.residual)),
            *estimate_anisotropy(fit, damping, "damping anisotropy", "damping axis", "1/s"),
            *make_component_findings(fit, damping, "damping anisotropy", "1/s"),
            *estimate_anisotropy(fit, split, "frequency split", "stiffness axis", "mHz"),
            *make_component_findings(fit, split, "frequency split", "mHz"),
        ),
        verdict=(
            f"Ring-downs: {len(used)}. The damping anisotropy here is the shell's: errors of the "
            "drives take no part. Held to be zero: quadrature when the drive was switched off "
            "(q0/a would add 2 q0/a times the split), tilt of the input axis."
        ),
        warnings=tuple(_list_warnings(used, gyro)),
        exclusions=tuple(_list_exclusions(used)),
        draw=lambda figure: draw(figure, used, fit, gyro),
        values={"terms": fit.terms},
    )


def _list_exclusions(used: Sequence[Decay]) -> Iterator[str]:
    for source in dict.fromkeys(decay.source for decay in used if decay.left_out > 0):
        cut = [decay for decay in used if decay.source == source and decay.left_out > 0]
        yield (
            f"{source}: the last {max(decay.left_out for decay in cut):.4g} s of ring-downs left "
            f"out: split times time exceeds {LARGEST_SPLIT_ANGLE} rad after "
            f"{float(cut[0].time[-1]):.3g} s, where noise of the quadrature turns into angle"
        )


def _list_warnings(decays: Sequence[Decay], gyro: Gyro) -> Iterator[str]:
    # the resultant of the fourth harmonic of the angles that the pattern saw
    if abs(np.mean(np.concatenate([np.exp(4j * decay.angle) for decay in decays]))) >= 0.75:
        yield (
            "all ring-downs lie near one pattern angle: what of the damping anisotropy changes the "
            "decay alone is seen only as far as the pattern moved, or not at all"
        )
    if not gyro.pickoff:
        yield (
            "no table rate both ways in this campaign: the pick-offs' errors are held to be zero; "
            "a gain mismatch g errs by g/4 of the angle that the pattern turns over"
        )


STYLES = (("-", "."), ("--", "x"), (":", "+"))
"""Line and mark of the ring-downs, anew where colours repeat."""


def draw(figure: Figure, decays: Sequence[Decay], fit: Fit, gyro: Gyro) -> None:
    """Above: how the damping anisotropy turns the pattern; below: what the fit leaves."""
    above, below = figure.subplots(2, 1, sharex=True)
    isotropic = fit.values.copy()
    isotropic[1:3] = 0.0
    for number, decay in enumerate(decays):
        colour = COLOURS[number % len(COLOURS)]
        style, mark = STYLES[number // len(COLOURS) % len(STYLES)]
        with_damping, without = (gyro.orbit(decay, values)[0] for values in (fit.values, isotropic))
        label = f"from {decay.angle_at_start % (np.pi / 2) / DEG:.1f} deg"
        above.plot(decay.time, (decay.angle - without) / ARCSEC, mark, ms=3, color=colour)
        drawn = (decay.time, (with_damping - without) / ARCSEC, style)
        above.plot(*drawn, color=colour, lw=1, label=label)
        below.plot(decay.time, (decay.angle - with_damping) / ARCSEC, style, color=colour, lw=0.8)
    above.plot([], [], "k.", ms=3, label="measured")
    above.plot([], [], "k", lw=1, label="fit")
    title = "Ring-downs: pattern angle less rotation and split"
    above.set(title=title, ylabel="turned by damping, arcsec")
    below.set(ylabel="residual of the fit, arcsec")
    below.set_xlabel("time since the drive was switched off, s")
    figure.legend(title="pattern", fontsize="small", loc="outside right upper")
    for axes in (above, below):
        axes.grid(alpha=0.3)


PROCEDURE: Procedure = Procedure(
    name="ring-down",
    group="identification",
    title="Ring-down: decay time, damping anisotropy and its axis, frequency split",
    source="Lynch 1995, averaged equations without drive, in closed form (free_orbit)",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
