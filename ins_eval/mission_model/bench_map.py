"""Maps of bias and scale factor as a bench measured them, from its files or its findings."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.stats import norm

from ins_eval.mission_model.gyro_map import HARMONICS, NAMES, TERMS
from pyhrg.bench.outcome import Finding
from pyhrg.common.arrays import Array
from pyhrg.common.toml_table import TomlTable, read_json_table
from pyhrg.common.units import ARCSEC, DEG_PER_H, PPM

INTERVAL = float(norm.ppf(0.975))
"""Half the width of a 95 % interval in standard deviations."""


def _list_keys() -> dict[str, tuple[int, float]]:
    """Place and SI value of the unit of each finding. The scale-factor map is the error of the
    detected angle, whose derivative is the scale-factor error."""
    keys = {f"bias_map_{name}_deg_per_h": (k, DEG_PER_H) for k, name in enumerate(NAMES)}
    keys["scale_factor_error_ppm"] = (TERMS, PPM)
    for k, harmonic in enumerate(HARMONICS):
        cosine, sine = TERMS + 2 * k + 1, TERMS + 2 * k + 2
        keys[f"scale_factor_map_sin{harmonic}_arcsec"] = (cosine, harmonic * ARCSEC)
        keys[f"scale_factor_map_cos{harmonic}_arcsec"] = (sine, -harmonic * ARCSEC)
    return keys


KEYS = _list_keys()
"""Place among the terms, and SI value of the unit, of each finding by its key."""


@dataclass(frozen=True)
class BenchMap:
    """A gyro's map by a bench: (2 TERMS,) terms of the bias, rad/s, then of the scale-factor error,
    and their variances, infinite where nothing was measured."""

    values: Array
    variances: Array


def read_bench_map(path: Path | str, drift: tuple[float, float]) -> BenchMap:
    """The map in a result.json of the bench's test `calibration`, or in a file of its findings.

    drift: standard deviation of a term's change since the bench: of the bias, rad/s, and of the
    scale-factor error.

    Raises:
        HrgError: an unreadable file; no term of the bias map; a term without an interval.
    """
    findings = read_json_table(Path(path)).table("findings")
    known = {key: _read_finding(findings.table(key)) for key in KEYS if key in findings.values}
    bench_map = _assemble(known, drift)
    if not np.isfinite(bench_map.variances[:TERMS]).any():
        expected = f"those of the test calibration, such as {next(iter(KEYS))}"
        raise findings.error("keys", ", ".join(findings.values) or "none", expected)
    return bench_map


def make_bench_map(findings: Iterable[Finding]) -> BenchMap:
    """The map of a bench's findings; others than those of the test `calibration` are left out."""
    widths = {each.key: (each.value, np.ptp(each.interval)) for each in findings}
    known = {key: (value, width / (2 * INTERVAL)) for key, (value, width) in widths.items()}
    return _assemble({key: known[key] for key in KEYS if key in known}, (0.0, 0.0))


def _assemble(findings: Mapping[str, tuple[float, float]], drift: tuple[float, float]) -> BenchMap:
    """findings: value and standard deviation by key, in the key's unit."""
    values, variances = np.zeros(2 * TERMS), np.full(2 * TERMS, np.inf)
    for key, finding in findings.items():
        place, unit = KEYS[key]
        values[place], sigma = (unit * x for x in finding)
        variances[place] = sigma**2 + drift[place // TERMS] ** 2
    return BenchMap(values, variances)


def _read_finding(entry: TomlTable) -> tuple[float, float]:
    """Value and standard deviation."""
    low, high = entry.numbers("interval_95", 2, -1e9, 1e9)
    if not high > low:
        raise entry.error("interval_95", [low, high], "[low, high]")
    return entry.finite_number("value"), (high - low) / (2 * INTERVAL)
