"""The rows of witness.csv, from the results of all triads of a study."""

import pandas as pd

from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study.experiment import (
    list_methods,
    open_missions,
    select_triads,
    select_witnesses,
)
from ins_eval.study.predictors.prediction_columns import select_time
from ins_eval.study.run.block import Arrays
from ins_eval.study.specification import Study
from ins_eval.study.witness.tabulate import KEYS, tabulate_witnesses
from pyhrg.common.units import ARCSEC, MICRO_G


def tabulate_study(study: Study, arrays: Arrays) -> pd.DataFrame:
    """Flights whose gyros' channels were read, of all calibrations and missions."""
    if not study.witnessed:
        return pd.DataFrame(columns=KEYS)
    sensors = study.accelerometer_bias_micro_g * MICRO_G, study.mounting_arcsec * ARCSEC
    inside, parts = study.interval_percent / 100, []
    with open_missions(study) as missions:
        weights = [select_time(load_mission_weights(mission), -1) for mission in missions]
    for method in list_methods(study):
        triads = select_triads(arrays, method)
        for number, mission in enumerate(study.missions):
            found = select_witnesses(arrays, method, number)
            flights = tabulate_witnesses(
                found, triads, weights[number], sensors, inside, study.seed
            )
            named = (method, mission.mission_class, mission.name)
            parts.append(flights.assign(**dict(zip(KEYS, named, strict=False))))
    joined = pd.concat(parts, ignore_index=True)
    return joined[[*KEYS, *joined.columns.drop(list(KEYS))]]
