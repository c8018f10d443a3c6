"""Size and axis of an anisotropy from its two components."""

import numpy as np
from scipy import stats

from pyhrg.bench.estimation.harmonics import Fit
from pyhrg.bench.outcome import Finding


def estimate_anisotropy(
    fit: Fit, components: tuple[str, str], name: str, axis: str, unit: str
) -> tuple[Finding, Finding]:
    """Size m and axis th of an anisotropy with the components m cos 4th and m sin 4th.

    Where the components' 95 % confidence ellipse holds zero, the size has an upper bound only and
    the axis has no value.
    """
    index = [fit.names.index(component) for component in components]
    value = fit.values[index]
    covariance = fit.covariance[np.ix_(index, index)]
    n = len(fit.residual)
    size = float(np.hypot(*value))
    distance = float(value @ np.linalg.pinv(covariance) @ value)
    reach = float(stats.t.ppf(0.975, fit.freedom))
    if distance <= 2 * stats.f.ppf(0.95, 2, fit.freedom):
        bound = size + reach * float(np.sqrt(np.linalg.eigvalsh(covariance)[-1]))
        note = "not different from zero: upper bound"
        return (
            Finding(name, size, unit, 0.0, bound, n, note),
            Finding(axis, np.nan, "deg", n=n, note=f"{name} is not different from zero"),
        )
    along = value / size
    across = np.array([-along[1], along[0]])
    radial = reach * float(np.sqrt(along @ covariance @ along))
    turned = reach * float(np.sqrt(across @ covariance @ across)) / size / 4
    angle = float(np.arctan2(value[1], value[0])) / 4 % (np.pi / 2)
    return (
        Finding(name, size, unit, max(0.0, size - radial), size + radial, n),
        Finding(axis, angle, "deg", angle - turned, angle + turned, n, "modulo 90 deg"),
    )


def make_component_findings(
    fit: Fit, components: tuple[str, str], name: str, unit: str
) -> tuple[Finding, ...]:
    """Findings of the two components m cos 4th and m sin 4th."""
    n = len(fit.residual)
    return tuple(
        Finding(f"{name} {trig}4", fit.value(term), unit, *fit.interval(term), n)
        for term, trig in zip(components, ("cos", "sin"), strict=True)
    )
