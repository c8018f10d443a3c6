"""Figure of a calibration: bias and scale factor over the circumference, before and after."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.calibration.calibration_maps import Calibration
from pyhrg.bench.estimation.harmonics import TILT
from pyhrg.bench.readings.segments import Segments
from pyhrg.common.units import DEG, DEG_PER_H, PPM

COLOURS = {"before": "#D55E00", "after": "#0072B2"}
"""Vermilion and blue of M. Okabe and K. Ito: distinct for colour-blind readers too."""


def draw(figure: Figure, stages: Mapping[str, tuple[Calibration, Sequence[Segments]]]) -> None:
    """Left the position test's points, right the fitted scale factor."""
    bias, scale = figure.subplots(1, 2)
    grid = np.linspace(0.0, np.pi, 361)
    for name, (found, runs) in stages.items():
        angle = np.concatenate([run.pattern_angle for run in runs]) % np.pi
        rate = np.concatenate([_level(found, run) for run in runs])
        bias.plot(angle / DEG, rate / DEG_PER_H, ".", ms=3, color=COLOURS[name], label=name)
        scale.plot(grid / DEG, found.rates.evaluate(grid) / PPM, color=COLOURS[name], label=name)
    bias.set_ylabel("bias, deg/h")
    bias.set_title("Position test, tilt removed")
    scale.set_ylabel("scale factor less its mean, ppm")
    scale.set_title("Turns both ways")
    for axes in (bias, scale):
        axes.set_xlabel("pattern angle, deg")
        axes.set_xlim(0, 180)
        axes.grid(alpha=0.3)
        axes.legend()


def _level(found: Calibration, run: Segments) -> np.ndarray:
    """Rates of a run without the tilt of the input axis, rad/s."""
    if not found.positions.tilt:
        return run.rate
    waves = (np.cos(run.table_angle), np.sin(run.table_angle))
    lean = sum(found.positions.value(name) * wave for name, wave in zip(TILT, waves, strict=True))
    return np.asarray(run.rate - lean)
