"""Calibration maps of a gyro, from its position and rate tests, and the gyro that applies them.

The scale-factor map is the error e of the detected pattern angle. The rate tests give the harmonics
c cos h th + s sin h th of the scale factor; with d th = -k W dt their integral is

    e = sum over h of (c sin h th - s cos h th)/h

(paper, Eqs. 2 and 3). At rest with the input axis up, Earth's rate W_e makes them part of what the
position test takes for bias; the bias map is its map less W_e times theirs.
"""

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace

import numpy as np
from scipy import stats

from pyhrg.bench.bias.position import full_circumference
from pyhrg.bench.bias.position.full_circumference import RestRateMap, fit_map, read_runs
from pyhrg.bench.estimation.harmonics import MEAN, name_terms
from pyhrg.bench.outcome import Finding
from pyhrg.bench.procedure import require_tests
from pyhrg.bench.readings.output_rows import read_bryan_factor
from pyhrg.bench.scale_factor.scale_factor import (
    SCALE,
    ScaleFactorMap,
    fit_scale_factor_map,
    read_rate_turns,
)
from pyhrg.device.device import AngleMap, Device
from pyhrg.records.campaign import Campaign


@dataclass(frozen=True)
class Calibration:
    """Calibration maps from the tests of a campaign.

    Attributes:
        bias_map, scale_factor_map: a finding for each field of `AngleMap`; a term that the records
            can't identify is missing.
        positions, rates: the fits of the position and the rate tests.
    """

    bias_map: Mapping[str, Finding]
    scale_factor_map: Mapping[str, Finding]
    positions: RestRateMap
    rates: ScaleFactorMap

    @property
    def scale_factor(self) -> float:
        return self.rates.fit.value(SCALE)

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All terms of both maps, and the scale factor error."""
        scale = self.rates.fit.finding(SCALE, "scale factor error", "ppm")
        return (*self.bias_map.values(), *self.scale_factor_map.values(), scale)

    @property
    def refused(self) -> tuple[str, ...]:
        """A sentence on each term that the records can't identify."""
        return (*self.positions.refused, *self.rates.refused)


def fit_maps(campaign: Campaign) -> Calibration:
    """Maps from the campaign's position tests and its slow rate tests, both ways."""
    positions = fit_map(read_runs(campaign))
    rates = fit_scale_factor_map(read_rate_turns(campaign, slow=True), read_bryan_factor(campaign))
    logs = [test.log for test in require_tests(campaign, full_circumference.KIND)]
    axis_up = float(np.mean(np.concatenate([log.axis_up for log in logs])))
    earth = campaign.site.vertical_rate * axis_up
    names = [name for name in positions.names if name in AngleMap.__dataclass_fields__]
    n = sum(len(fit.residual) for fit in positions.fits)
    return Calibration(
        bias_map={name: _bias(name, positions, rates, earth, n) for name in names},
        scale_factor_map=dict(_angle_errors(rates)),
        positions=positions,
        rates=rates,
    )


def make_angle_map(findings: Mapping[str, Finding]) -> AngleMap:
    """Coefficients, SI; zero where nothing was found."""
    return AngleMap(**{name: finding.si_value for name, finding in findings.items()})


def turn_map(coefficients: AngleMap, angle: float) -> AngleMap:
    """The map of a gyro whose pattern axes are turned by an angle, rad: f(th - angle)."""
    values = {MEAN: coefficients.mean}
    for order in (2, 4, 8):
        cosine, sine = name_terms(order)
        phasor = complex(getattr(coefficients, cosine), getattr(coefficients, sine))
        phasor *= np.exp(1j * order * angle)
        values[cosine], values[sine] = phasor.real, phasor.imag
    return AngleMap(**values)


def add_maps(
    device: Device, bias_map: AngleMap, scale_factor_map: AngleMap, scale_factor: float = 0.0
) -> Device:
    """A gyro with maps added to those that its electronics have already.

    The bias map is the output bias that is left, rad/s; the scale-factor map the error of the
    detected pattern angle that is left, rad; the mean scale-factor error that is left corrects the
    Bryan factor that the read-out believes.
    """
    return replace(
        device,
        bias_map=_sum(device.bias_map, bias_map),
        scale_factor_map=replace(_sum(device.scale_factor_map, scale_factor_map), mean=0.0),
        bryan_factor=device.bryan_factor * (1 + scale_factor),
        bryan_factor_error=(1 + device.bryan_factor_error) / (1 + scale_factor) - 1,
    )


def _sum(first: AngleMap, second: AngleMap) -> AngleMap:
    return AngleMap(
        **{f.name: getattr(first, f.name) + getattr(second, f.name) for f in fields(first)}
    )


def _bias(
    name: str, positions: RestRateMap, rates: ScaleFactorMap, earth: float, n: int
) -> Finding:
    """A term of the position test (`RestRateMap.estimate`) less Earth's rate times the scale
    factor's (degrees of freedom: F. E. Satterthwaite, 1946)."""
    value, error, freedom = positions.estimate(name)
    term = SCALE if name == MEAN else f"{SCALE} {name}"
    if term in rates.fit.names:
        value -= earth * rates.fit.value(term)
        other = rates.fit.freedom_of(term)
        parts = np.array([error, abs(earth) * rates.fit.deviation(term)]) ** 2
        inverse = float(parts @ (parts / np.array([freedom, other])))
        variance = float(parts.sum())
        freedom = variance**2 / inverse if inverse > 0 else min(freedom, other)
        error = float(np.sqrt(variance))
    reach = float(stats.t.ppf(0.975, freedom)) * error
    return Finding(f"bias map {name}", value, "deg/h", value - reach, value + reach, n)


def _angle_errors(rates: ScaleFactorMap) -> list[tuple[str, Finding]]:
    findings = []
    for order in sorted(rates.orders):
        cosine, sine = name_terms(order)
        for name, source, factor in ((cosine, sine, -1 / order), (sine, cosine, 1 / order)):
            label = f"scale factor map {name}"
            findings.append((name, rates.fit.finding(f"{SCALE} {source}", label, "arcsec", factor)))
    return findings
