"""Bias and scale-factor maps from bench tests, one least-squares fit for each power-on.

The bench's own fit of the scale factor (`pyhrg.bench.calibration`) weights the angle noise by its
likelihood and estimates tilt. The study has thousands of gyros, whose input axes are exact and
whose rate errors are dominated by random walk. Least squares on rates are as accurate there, at a
hundredth of the cost.
"""

import numpy as np

from ins_eval.error_model.effects import ANGULAR_GAIN
from ins_eval.mission_model.gyro_map import HARMONICS, TERMS, evaluate_terms, fit_coefficients
from pyhrg.bench.bias.position import full_circumference
from pyhrg.bench.readings.turns import Turn
from pyhrg.bench.scale_factor.scale_factor import read_rate_turns
from pyhrg.common.arrays import Array
from pyhrg.records.campaign import Campaign


def fit_scale_maps(tests: Campaign) -> Array:
    """(runs, TERMS) scale-factor maps; each fit takes two power-ons, one in each direction.

    Raises:
        BenchError: there are no rate tests.
    """
    turns = read_rate_turns(tests, slow=True)
    ways = [[turn for turn in turns if np.sign(turn.table_rate) == sign] for sign in (1, -1)]
    return np.array([_fit_scale_map(pair) for pair in zip(*ways, strict=True)])


def fit_bias_maps(tests: Campaign, scale: Array) -> Array:
    """(runs, TERMS) bias maps, rad/s, one fit for each power-on of the circumference test.

    Args:
        scale: (TERMS,) scale-factor map, which makes a bias of the Earth's rate.

    Raises:
        BenchError: there are no position tests, or they are not complete.
    """
    fits = [
        fit_coefficients(evaluate_terms(run.pattern_angle), run.rate)
        for run in full_circumference.read_runs(tests)
    ]
    return np.array(fits) - tests.site.vertical_rate * scale


def _fit_scale_map(pair: tuple[Turn, ...]) -> Array:
    rows, errors = [], []
    for turn in pair:
        bias = evaluate_terms((turn.pattern_angle[1:] + turn.pattern_angle[:-1]) / 2)
        scale = np.diff(_integrate_terms(turn), axis=0) / turn.interval
        rows.append(np.hstack([bias, scale]))
        errors.append(np.diff(turn.excess) / turn.interval)
    fitted = fit_coefficients(np.vstack(rows), np.concatenate(errors))
    return np.asarray(fitted[TERMS:])


def _integrate_terms(turn: Turn) -> Array:
    """(n, TERMS) integral of rate times each term along the detected pattern angle, rad: what a
    correction of that angle removes, to any order."""
    integrals = [turn.input_angle]
    for h in HARMONICS:
        phase, factor = h * turn.pattern_angle, 1 / (h * ANGULAR_GAIN)
        integrals += [-factor * np.sin(phase), factor * np.cos(phase)]
    return np.stack(integrals, axis=-1)
