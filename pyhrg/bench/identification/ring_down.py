"""Ring-downs: what the shell does by itself, drives off.

The pattern moves and its amplitude decays by damping, split and rotation alone, so that the damping
anisotropy is separated from every error of the drives and, nearly, of the pick-offs. Without the
quadrature loop the split makes quadrature, which turns the pattern too: decay, damping anisotropy
and split are fitted together, to angle and amplitude, by the closed form of `free_orbit`.
Where the pattern stays near one angle, only the part of the anisotropy that moves it is seen well.

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
WALKING = 0.5
"""Split times duration, rad, beyond which that is more than a few percent of the noise."""


def make_programme(bench: Bench, positions: int = POSITIONS, decay: float = DECAY) -> Programme:
    """One power-on: at each angle the pattern is brought to amplitude, then left alone."""
    course = bench.programme()
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
    """Fit of all ring-downs of the campaign, the pick-offs' errors taken from its rate tests.

    Angle and amplitude alone don't separate a split from its negative; the quadrature force does.
    """
    logs = [test.log for test in require_tests(campaign, KIND)]
    k, site = read_bryan_factor(campaign), campaign.site
    found = [decay for log in logs for decay in free_decay.find_decays(log, site, k)]
    if not found:
        raise BenchError(
            f"{', '.join(log.source for log in logs)}: the drive is nowhere off for more than "
            f"{SHORTEST_ROWS} rows after rows with the drive on"
        )
    first = found[0]
    rate = float(np.log(first.amplitude[0] / first.amplitude[-1]) / np.ptp(first.time))
    split = _split_guess(campaign)
    gyro = Gyro(k, _pickoff(campaign))
    fit = free_decay.fit_decays(found, gyro, np.array([rate, 0.0, 0.0, split.real, split.imag]))
    if (free_decay.describe_shell(fit.values).split.conjugate() * split).real < 0:
        fit = replace(fit, values=fit.values * [1, 1, 1, -1, -1])
    return fit, found, gyro


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
        off = np.convolve(log.drive_on <= 0.5, np.ones(wait + 1))[: len(log.time)] > 0.5
        on = ~off & np.isfinite(log.quadrature_force + log.wave_angle)
        angle = 4 * log.wave_angle[on]
        columns.append(np.column_stack([np.sin(angle), -np.cos(angle)]) / 2)
        values.append(log.quadrature_force[on] / log.amplitude_setpoint[on])
    found = np.linalg.lstsq(np.vstack(columns), np.concatenate(values), rcond=1e-3)[0]
    return complex(*found)


def evaluate(campaign: Campaign) -> Outcome:
    """Decay time, damping anisotropy and split with their axes."""
    fit, found, gyro = fit_ring_downs(campaign)
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
            f"Ring-downs: {len(found)}. The damping anisotropy here is the shell's: errors of the "
            "drives take no part. Held to be zero: quadrature when the drive was switched off "
            "(q0/a would add 2 q0/a times the split), tilt of the input axis."
        ),
        warnings=tuple(_list_warnings(found, gyro, free_decay.describe_shell(fit.values).split)),
        draw=lambda figure: draw(figure, found, fit, gyro),
        values={"terms": fit.terms},
    )


def _list_warnings(found: Sequence[Decay], gyro: Gyro, split: complex) -> Iterator[str]:
    # the resultant of the fourth harmonic of the angles that the pattern saw
    if abs(np.mean(np.concatenate([np.exp(4j * decay.angle) for decay in found]))) >= 0.75:
        yield (
            "all ring-downs lie near one pattern angle: what of the damping anisotropy changes the "
            "decay alone is seen only as far as the pattern moved, or not at all"
        )
    if not gyro.pickoff:
        yield (
            "no table rate both ways in this campaign: the pick-offs' errors are held to be zero; "
            "a gain mismatch g errs by g/4 of the angle that the pattern turns over"
        )
    longest = max(float(decay.time[-1]) for decay in found)
    if abs(split) * longest > WALKING:
        yield (
            f"split times duration is {abs(split) * longest:.2g} rad ({longest:.4g} s): the "
            "quadrature walks with the noise of the forces and the split turns that into angle, "
            "which the fit takes for white noise; at 0.75 rad its 95 % intervals hold the truth in "
            "about 90 % only"
        )


def draw(figure: Figure, found: Sequence[Decay], fit: Fit, gyro: Gyro) -> None:
    """Above: how the damping anisotropy turns the pattern; below: what the fit leaves."""
    above, below = figure.subplots(2, 1, sharex=True)
    isotropic = fit.values.copy()
    isotropic[1:3] = 0.0
    for number, decay in enumerate(found):
        colour = COLOURS[number % len(COLOURS)]
        with_damping, without = (gyro.orbit(decay, values)[0] for values in (fit.values, isotropic))
        label = f"from {decay.angle_at_start % (np.pi / 2) / DEG:.1f} deg"
        above.plot(decay.time, (decay.angle - without) / ARCSEC, ".", ms=3, color=colour)
        above.plot(decay.time, (with_damping - without) / ARCSEC, color=colour, lw=1, label=label)
        below.plot(decay.time, (decay.angle - with_damping) / ARCSEC, color=colour, lw=0.8)
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
