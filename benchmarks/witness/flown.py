"""Flights on the FMU at 1 kHz, witnessed triad by triad, as `hrg study` judges them."""

from collections.abc import Iterator
from itertools import islice
from pathlib import Path

import pandas as pd

from benchmarks.witness.motions import CLASSES
from ins_eval.mission_model.missions import plan_mission
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study.cosimulated import sample_truth
from ins_eval.study.gyros.drawn_triad import DrawnTriad, TriadDistribution, tabulate_triads
from ins_eval.study.predictors.prediction_columns import select_time
from ins_eval.study.witness.block import TOGETHER, believe_triad, witness_triads
from ins_eval.study.witness.tabulate import tabulate_witnesses
from pyhrg.common.files import write_whole
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
    folder: Path,
) -> Iterator[pd.DataFrame]:
    """Rows of `TOGETHER` triads after the other in all `MISSIONS`.

    fmus: `HRG` and `HRGSlow`; drawn: triads and their numbers; folder: of a file for each triad and
    mission that was flown, which a later call reads.
    """
    planned = [plan_mission(each, hours) for each in MISSIONS]
    truths = [sample_truth(each) for each in planned]
    weights = [select_time(load_mission_weights(each), -1) for each in planned]
    folder.mkdir(parents=True, exist_ok=True)
    while group := list(islice(drawn, TOGETHER)):
        paths = {
            (number, mission): folder / f"{distribution.method}-{number}-{mission}-{hours:g}h.csv"
            for number, _ in group
            for mission in MISSIONS
        }
        missing = [n for n, _ in group if any(not paths[n, m].exists() for m in MISSIONS)]
        known = {n: (t, believe_triad(fmus[1], distribution, t)) for n, t in group if n in missing}
        blocks = {number: tabulate_triads(fmus[1], [triad]) for number, (triad, _) in known.items()}
        for place, mission in enumerate(MISSIONS):
            flying = {n: each for n, each in known.items() if not paths[n, mission].exists()}
            if not flying:
                continue
            numbers = list(flying)
            found = witness_triads(fmus, truths[place], weights[place], place, flying, numbers)
            for row, number in enumerate(numbers):
                own = {name: values[[row]] for name, values in found.items()}
                rows = tabulate_witnesses(
                    own, blocks[number], weights[place], SENSORS, INSIDE, SEED + number
                ).assign(
                    triad=number,
                    calibration=distribution.method,
                    mission_class=CLASSES[mission],
                    mission=mission,
                )
                write_whole(paths[number, mission], rows.to_csv(index=False).encode())
        tables = [pd.read_csv(path) for path in paths.values()]
        yield pd.concat(tables, ignore_index=True)
