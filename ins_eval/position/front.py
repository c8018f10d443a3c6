"""The front door of the position gap: from a diagnosis to metres."""

from collections.abc import Sequence
from pathlib import Path

import pandas as pd

from fmu_build.bundle import build_fmu
from ins_eval.mission_model.missions import LONGEST_HOURS
from ins_eval.position.diagnosis import read_diagnosed_gyro
from ins_eval.position.position import (
    MissionGap,
    MissionGaps,
    PositionRequest,
    compute_mission_gaps,
)
from ins_eval.position.report import build_section, write_sentences
from pyhrg.common.arguments import check_number, check_seed, check_whole_number
from pyhrg.common.errors import HrgError, describe_briefly
from pyhrg.common.files import write_whole
from pyhrg.common.progress import Progress, Show
from pyhrg.common.units import HOUR
from pyhrg.fmu import GyroFmu
from pyhrg.gap.report.sections import Section

MISSIONS = ("car", "aircraft", "ship")
SHORTEST_HOURS = 1 / 60
"""Shortest navigation, h: position errors are kept once a minute."""
MIN_TRIADS, MAX_TRIADS = 10, 10_000
"""Bounds of the number of triads. Chosen: fewer give no useful interval."""
UNITS = {
    "time_h": "h",
    "missed_m": "m",
    "low_95": "m",
    "high_95": "m",
    "residual_steady_m": "m",
    "residual_at_most_m": "m",
}


class PositionGap(MissionGaps):
    """Distance between the positions of the nominal and of the identified device, by mission."""

    __repr__ = describe_briefly

    @property
    def table(self) -> pd.DataFrame:
        """One row a mission, at its end. `attrs["units"]` has the units.

        Columns: `mission`; `time_h` since alignment; `missed_m`, horizontal distance between the
        two devices' positions, rms over triads; `low_95`, `high_95`, its 95 % interval;
        `residual_steady_m`, `residual_at_most_m`, bounds of the position error that the residual of
        held-out tests could cause, NaN without such tests.
        """
        table = pd.DataFrame([_make_row(m) for m in self.missions], columns=["mission", *UNITS])
        table = table.astype(dict.fromkeys(UNITS, float))
        table.attrs["units"] = dict(UNITS)
        return table

    @property
    def sentences(self) -> list[str]:
        """The result, its method and its reservations, a sentence each."""
        return write_sentences(self)

    @property
    def section(self) -> Section:
        """The section of the diagnosis's page, with the content of `position.json`."""
        return build_section(self)

    def write(self, folder: Path | str) -> None:
        """Write `position.json` into a folder, whole or not at all.

        Raises:
            OSError: the folder can't be written.
        """
        section = self.section
        write_whole(Path(folder) / section.file, section.to_json())


def compute_position_gap(
    diagnosis: Path | str,
    *,
    missions: Sequence[str | Path] = MISSIONS,
    hours: float = 2.0,
    triads: int = 500,
    seed: int = 1,
    progress: Show = None,
) -> PositionGap:
    """Compute how far the identified device's position is from the nominal device's, in missions.

    Triads of either device are flown by the linear error model (docs/methods/mission_model.md); two
    of them are co-simulated as a check.

    Args:
        diagnosis: folder that `hrg gap diagnose` wrote.
        missions: ready missions, mission files (TOML) or recorded drives.
        hours: duration of the navigation, up to 10; a mission that is shorter ends at its end.
        triads: number of triads, 10 to 10,000.
        seed: seed of the power-on angles and of the bootstrap intervals.
        progress: True prints lines on standard error; a function is called with them.

    Raises:
        HrgError: an argument out of range, a folder without a diagnosis, no such mission, or device
            values that the FMU refuses.
    """
    sources = (missions,) if isinstance(missions, str | Path) else tuple(missions)
    if not sources:
        raise HrgError("missions: found none, expected one or more")
    request = PositionRequest(
        sources,
        check_number("hours", hours, SHORTEST_HOURS, LONGEST_HOURS),
        check_whole_number("triads", triads, MIN_TRIADS, MAX_TRIADS),
        check_seed(seed),
    )
    gyro = read_diagnosed_gyro(Path(diagnosis))
    report = Progress(progress).say
    fmu = GyroFmu(build_fmu("HRGSlow", progress=report))
    fmu.prepare()
    return PositionGap(**vars(compute_mission_gaps(fmu, gyro, request, report)))


def _make_row(mission: MissionGap) -> tuple[str | float | None, ...]:
    end, bound = mission.at_end, mission.residual_bound
    steady, largest = (None, None) if bound is None else (bound.steady, bound.any_course)
    hours = float(mission.time[-1]) / HOUR
    return mission.name, hours, end.value, end.low, end.high, steady, largest
