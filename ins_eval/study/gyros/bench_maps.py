"""Maps that the bench's tests show, a fit a power-on, by least squares.

The bench's own fits (`pyhrg.bench.calibration`) weigh the angle's noise by its likelihood and look
for tilt; the study has thousands of gyros, whose axes are true, and random walk is what their rates
err by: least squares on rates are as good and cost a hundredth.
"""

import numpy as np
from numpy.typing import NDArray

from ins_eval.error_model.effects import BRYAN_FACTOR
from ins_eval.mission_model.gyro_map import HARMONICS, TERMS, terms
from pyhrg.bench.bias.position import full_circumference
from pyhrg.bench.readings.turns import Turn
from pyhrg.bench.scale_factor.rate_tests import rate_turns
from pyhrg.records.campaign import Campaign

Array = NDArray[np.float64]


def scale_maps(tests: Campaign) -> Array:
    """(runs, TERMS) of the scale factor, a fit a pair of power-ons, one each way.

    Raises:
        BenchError: there are no rate tests.
    """
    turns = rate_turns(tests, slow=True)
    ways = [[turn for turn in turns if np.sign(turn.table_rate) == sign] for sign in (1, -1)]
    return np.array([_scale_map(pair) for pair in zip(*ways, strict=True)])


def bias_maps(tests: Campaign, scale: Array) -> Array:
    """(runs, TERMS) of the bias, rad/s, a fit a power-on over the circumference.

    Args:
        tests: of the gyro.
        scale: (TERMS,) of its scale factor, of which Earth's rate makes a bias.

    Raises:
        BenchError: there are no position tests, or they are not complete.
    """
    fits = [
        np.linalg.lstsq(terms(run.pattern_angle), run.rate, rcond=None)[0]
        for run in full_circumference.runs_of(tests)
    ]
    return np.array(fits) - tests.site.vertical_rate * scale


def _scale_map(pair: tuple[Turn, ...]) -> Array:
    rows, errors = [], []
    for turn in pair:
        bias = terms((turn.pattern_angle[1:] + turn.pattern_angle[:-1]) / 2)
        scale = np.diff(_integrals(turn), axis=0) / turn.interval
        rows.append(np.hstack([bias, scale]))
        errors.append(np.diff(turn.excess) / turn.interval)
    fitted = np.linalg.lstsq(np.vstack(rows), np.concatenate(errors), rcond=None)[0]
    return np.asarray(fitted[TERMS:])


def _integrals(turn: Turn) -> Array:
    """(n, TERMS) rate times each term, integrated along the detected pattern angle: what a
    correction of that angle takes out, to any order."""
    integrals = [turn.input_angle]
    for h in HARMONICS:
        phase, factor = h * turn.pattern_angle, 1 / (h * BRYAN_FACTOR)
        integrals += [-factor * np.sin(phase), factor * np.cos(phase)]
    return np.stack(integrals, axis=-1)
