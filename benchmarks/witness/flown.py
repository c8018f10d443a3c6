"""Flights on the FMU at 1 kHz, witnessed triad by triad, as `hrg study` judges them.

Each triad flies one mission, and those of a group the same: many gyros tell more than one gyro in
many missions.
"""

import subprocess
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import groupby
from pathlib import Path

import pandas as pd

from benchmarks.witness.motions import CLASSES
from benchmarks.witness.sealed import draw_effects
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import plan_mission
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study.cosimulated import MissionTruth, sample_truth
from ins_eval.study.gyros.drawn_triad import (
    DrawnTriad,
    TriadDistribution,
    draw_triad,
    make_triad_seed,
    tabulate_triads,
)
from ins_eval.study.predictors.prediction_columns import select_time
from ins_eval.study.witness.believed import BelievedGyro
from ins_eval.study.witness.block import TOGETHER, believe_triad, witness_triads
from ins_eval.study.witness.self_test import SELF_TEST
from ins_eval.study.witness.tabulate import tabulate_witnesses
from pyhrg.common.arrays import Array
from pyhrg.common.files import write_whole
from pyhrg.common.units import ARCSEC, MICRO_G
from pyhrg.fmu import GyroFmu

MISSIONS = ("car", "city", "airliner", "long-haul", "ship")
SENSORS = 10 * MICRO_G, 10 * ARCSEC
INSIDE, SEED = 0.9, 1
HOURS = 2.0
FIRST = 105
"""Number of the first triad that flies: none was developed on from here on."""
TESTS = (SELF_TEST,)
"""Durations of the self-test at power-on, s."""
FILE = Path("docs/witness-flown.csv")
"""A row for each triad, mission and duration of the self-test: flights of `HOURS`, of `SEED`.
Column `commit` names the code that flew."""
DIGITS = 5
KEYS = ("calibration", "triad", "mission", "effects")
NONE = "-"
"""Effects outside the model of a triad that has none."""


@dataclass(frozen=True)
class Fleet:
    """Triads of one calibration.

    fmus: `HRG` and `HRGSlow`; is_sealed: whether each gyro has an effect outside the model.
    """

    fmus: tuple[GyroFmu, GyroFmu]
    distribution: TriadDistribution
    is_sealed: bool = False

    @cached_property
    def drawn(self) -> dict[int, tuple[DrawnTriad, Sequence[BelievedGyro]]]:
        """Triads that were drawn so far, as they are and as they are believed, by number."""
        return {}

    def draw(self, number: int) -> tuple[DrawnTriad, Sequence[BelievedGyro]]:
        if number not in self.drawn:
            triad = draw_triad(self.fmus[1], self.distribution, make_triad_seed(SEED, number))
            self.drawn[number] = triad, believe_triad(self.fmus[1], self.distribution, triad)
        return self.drawn[number]

    def fly(self, mission: str, numbers: Sequence[int], hours: float = HOURS) -> pd.DataFrame:
        """Rows of flights of triads, by numbers, in a mission."""
        weights, truth = _plan(mission, hours)
        flying = {n: self.draw(n) for n in numbers}
        place = MISSIONS.index(mission)
        effects = {n: draw_effects(self.draw(n)[0]) for n in numbers if self.is_sealed}
        found = witness_triads(
            self.fmus,
            truth,
            weights,
            place,
            flying,
            numbers,
            {n: disturbances for n, (_, disturbances) in effects.items()},
            TESTS,
        )
        tables = [
            self._tabulate(n, found, row, weights).assign(
                effects="; ".join(effects[n][0]) if self.is_sealed else NONE
            )
            for row, n in enumerate(numbers)
        ]
        return pd.concat(tables).assign(
            calibration=self.distribution.method,
            mission_class=CLASSES[mission],
            mission=mission,
            commit=describe_code(),
        )

    def _tabulate(
        self, number: int, found: Mapping[str, Array], row: int, weights: MissionWeights
    ) -> pd.DataFrame:
        own = {name: values[[row]] for name, values in found.items()}
        block = tabulate_triads(self.fmus[1], [self.draw(number)[0]])
        rows = tabulate_witnesses(own, block, weights, SENSORS, INSIDE, SEED + number, TESTS)
        return rows.assign(triad=number)


@cache
def _plan(mission: str, hours: float) -> tuple[MissionWeights, MissionTruth]:
    planned = plan_mission(mission, hours)
    return select_time(load_mission_weights(planned), -1), sample_truth(planned)


def fly_triads(fleet: Fleet, numbers: range, file: Path = FILE) -> Iterator[pd.DataFrame]:
    """All rows of a file after each group of triads has flown its mission. What is in the file is
    not flown again."""
    for mission, group in group_triads(numbers):
        done = read_flights(file)
        same = done[(done["mission"] == mission) & ((done["effects"] != NONE) == fleet.is_sealed)]
        flown = set(same.loc[same["calibration"] == fleet.distribution.method, "triad"])
        if left := [n for n in group if n not in flown]:
            rows = fleet.fly(mission, left)
            write_flights(file, pd.concat([done, rows]) if len(done) else rows)
            yield read_flights(file)
        fleet.drawn.clear()


def group_triads(numbers: range) -> Iterator[tuple[str, list[int]]]:
    """The mission of each group of triads: one of `MISSIONS` in turn."""
    for group, members in groupby(numbers, lambda n: (n - FIRST) // TOGETHER):
        yield MISSIONS[group % len(MISSIONS)], list(members)


def read_flights(file: Path = FILE) -> pd.DataFrame:
    """Rows of flights, none if there is no file."""
    if file.exists():
        return pd.read_csv(file, dtype={"commit": str})
    return pd.DataFrame({name: [] for name in KEYS})


def write_flights(file: Path, flights: pd.DataFrame) -> None:
    ordered = flights.sort_values([*KEYS, "self_test_s"])
    ahead = [*KEYS, "self_test_s"]
    columns = [*ahead, *(each for each in ordered.columns if each not in ahead)]
    text = ordered[columns].to_csv(index=False, float_format=f"%.{DIGITS}g")
    write_whole(file, text.encode())


def describe_code() -> str:
    """Short name of the last commit that changed what flies, with a plus if it differs."""
    folders = ["modelica", "fmu_build", "pyhrg", "ins_eval"]
    last = _run_git("log", "-1", "--abbrev=8", "--format=%h", "--", *folders)
    return last + ("+" if _run_git("status", "--porcelain", "--", *folders) else "")


def _run_git(*command: str) -> str:
    run = subprocess.run(["git", *command], capture_output=True, text=True, check=True)
    return run.stdout.strip()
