"""Many triads out of a few: the bench takes its time. They are as those in all but size."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.experiment import FLOWN, LEAD, NUMBERS, compute_block
from ins_eval.study.run import block
from ins_eval.study.run.block import Arrays
from ins_eval.study.specification import CONDITION, Study
from pyhrg.common.units import DEG_PER_H

FEW = 3


def few(study: Study) -> Arrays:
    """Of the first that are judged; in conditions too, if the study has any."""
    first = study.training
    return compute_block(study, range(first, first + FEW))


def many(study: Study, few: Arrays) -> Arrays:
    """Of the whole study; those in conditions all at once."""
    random = np.random.default_rng(1)
    arrays = {}
    sizes = {True: random.uniform(0.5, 2.0, study.conditions)}
    sizes[False] = random.uniform(0.5, 2.0, study.triads)
    for name, values in few.items():
        arrays[name] = _sized(values, sizes[name.startswith(f"{CONDITION}/")])
    if study.lead:
        arrays |= {
            f"{LEAD}/{FLOWN}": random.normal(0.0, 5000.0, (study.lead, 6, 2)),
            f"{LEAD}/angle": random.uniform(0.0, np.pi, (study.lead, 3)),
            f"{LEAD}/bench": np.array([[0.0009, 0.1]]) * DEG_PER_H,
        }
    if study.conditions:
        arrays[f"{CONDITION}/{NUMBERS}"] = np.array(_numbers(study, range(study.triads)))
    return arrays


def blocks(study: Study, arrays: Arrays) -> Iterator[dict[str, NDArray[Any]]]:
    """Of a study, as its workers would make them; the lead case is in the first."""
    conditioned = 0
    for number in range(block.count_blocks(study)):
        triads = block.list_triads(study, number)
        count = len(_numbers(study, triads))
        rows = {True: slice(conditioned, conditioned + count)}
        rows[False] = slice(triads.start, triads.stop)
        conditioned += count
        flown = {
            name: values[rows[apart]]
            for name, values in arrays.items()
            if count or not name.startswith(f"{CONDITION}/")
            if not name.startswith(f"{LEAD}/")
            for apart in [name.startswith(f"{CONDITION}/")]
        }
        lead = {name: values for name, values in arrays.items() if name.startswith(f"{LEAD}/")}
        yield flown if number else flown | lead


def _numbers(study: Study, triads: range) -> list[int]:
    return [number for number in triads if study.is_in_sample(number, study.conditions)]


def _sized(values: NDArray[Any], sizes: NDArray[np.float64]) -> NDArray[Any]:
    some = values[np.arange(len(sizes)) % len(values)]
    if some.dtype.kind != "f":
        return some
    return np.asarray(some * sizes.reshape(-1, *[1] * (some.ndim - 1)))
