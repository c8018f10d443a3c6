"""Gyros with a form of error outside the model, as a challenge's campaigns have them."""

import math

import numpy as np

from ins_eval.study.gyros.drawn_triad import AXES, DrawnTriad
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.challenge.truths.form import Form, load_forms

SIZES = 1.0, 30.0
"""Least and largest size of a form, in typical sizes; their logarithm is uniform. The largest is
that of a challenge."""
SEALED = (1, 0, 0)
"""Key, in a triad's seed, of the forms."""


def list_forms() -> list[Form]:
    """Forms that a gyro shows in flight, where the amplitude stays and no turntable is."""
    return [f for f in load_forms() if f.place != "bench" and f.coordinate != "amplitude"]


def draw_effects(triad: DrawnTriad) -> tuple[list[str], list[Disturbance]]:
    """A form for each gyro, by the triad's seed: names with sizes, and disturbances."""
    seed = np.random.SeedSequence(triad.seed.tolist(), spawn_key=SEALED)
    generator = np.random.default_rng(seed)
    forms, names, disturbances = list_forms(), [], []
    for axis in range(AXES):
        form = forms[generator.integers(len(forms))]
        size = math.exp(generator.uniform(*np.log(SIZES)))
        names.append(f"{form.name} {size:.3g}")
        disturbances.append(form.disturbance(triad.flights[axis].device, size, generator))
    return names, disturbances
