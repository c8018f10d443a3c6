"""Flights on the FMU at 1 kHz, witnessed triad by triad, as `hrg study` judges them."""

from collections.abc import Iterator

import pandas as pd

from benchmarks.witness.motions import CLASSES
from ins_eval.mission_model.missions import plan_mission
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study.cosimulated import sample_truth
from ins_eval.study.gyros.drawn_triad import DrawnTriad, TriadDistribution, tabulate_triads
from ins_eval.study.predictors.prediction_columns import select_time
from ins_eval.study.witness.block import believe_triad, witness_triads
from ins_eval.study.witness.tabulate import tabulate_witnesses
from pyhrg.common.units import ARCSEC, MICRO_G
from pyhrg.fmu import GyroFmu

MISSIONS = ("car", "city", "airliner", "long-haul", "ship")
SENSORS = 10 * MICRO_G, 10 * ARCSEC
INSIDE, SEED = 0.9, 1


def fly_triads(
    fmus: tuple[GyroFmu, GyroFmu],
    distribution: TriadDistribution,
    drawn: Iterator[tuple[int, DrawnTriad]],
    hours: float,
) -> Iterator[pd.DataFrame]:
    """Rows of each triad in all `MISSIONS`; fmus: `HRG` and `HRGSlow`; drawn: triads and their
    numbers."""
    planned = [plan_mission(each, hours) for each in MISSIONS]
    truths = [sample_truth(each) for each in planned]
    weights = [select_time(load_mission_weights(each), -1) for each in planned]
    for number, triad in drawn:
        believed = {0: (triad, believe_triad(fmus[1], distribution, triad))}
        block, tables = tabulate_triads(fmus[1], [triad]), []
        for place, mission in enumerate(MISSIONS):
            found = witness_triads(fmus, truths[place], weights[place], place, believed, [0])
            rows = tabulate_witnesses(found, block, weights[place], SENSORS, INSIDE, SEED + number)
            rows["triad"] = number
            tables.append(
                rows.assign(
                    calibration=distribution.method, mission_class=CLASSES[mission], mission=mission
                )
            )
        yield pd.concat(tables, ignore_index=True)
