"""A right input of every format, and what reads it; those of results are in `results.py`."""

import tempfile
from collections.abc import Callable
from importlib import resources
from pathlib import Path
from unittest.mock import patch

import numpy as np

import ins_eval
import pyhrg
from fmu_build import check_fmu
from fmu_build.bundle import build_fmu
from fmu_build.check import fmu_checks
from fmu_build.check.system import system_checks
from ins_eval.imu.specification import load_imu
from ins_eval.trajectories.catalogue import load_trajectory
from pyhrg.device.device_file import from_table
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.gap.preparation import describe_preparation
from pyhrg.gap.static_record.belief import read_beliefs
from pyhrg.gap.static_record.record import read_static_record
from pyhrg.records import read_log, write_log
from pyhrg.records.campaign import Campaign, Test, read_campaign, write_campaign
from pyhrg.records.campaign_import import draft_mapping, import_campaign
from tests.fmu_build.check.two_fmus import write as write_system
from tests.fuzzing.mutations import ARCHIVE, BYTES, DOCUMENT, TABLE
from tests.fuzzing.results import RESULTS
from tests.fuzzing.sample import Sample
from tests.ins_eval.imu import logs, messages
from tests.ins_eval.study import cases
from tests.ins_eval.trajectories.test_recorded_drive import make_drive
from tests.pyhrg.records.campaign_import import labs
from tests.pyhrg.records.made_up import made_up_log

BELIEF = """\
[gyros]
angle_random_walk_deg_sqrt_h = 0.001
sinusoid_periods_s = [10.0, 60.0]
tolerance_percent = 20
"""
PSINS = """\
% a log
0.1 -0.2 30.0 0 0 0
34.0 108.0 400.0 0 10.0 9.7964
0.1 0.1 0.1 10.0 10.0 10.0
"""


def _copy(package: str, name: str) -> Callable[[Path], object]:
    data = resources.files(package).joinpath(name).read_bytes()
    return lambda folder: (folder / "file.toml").write_bytes(data)


def _write_campaign(folder: Path) -> None:
    still, turning = made_up_log(), made_up_log(table_rate=0.02)
    tests = (Test("still", "static", "fit", still), Test("rate", "rate", "holdout", turning))
    write_campaign(Campaign("made up", TYPICAL.site, NOMINAL, tests), folder)


NOMINAL = {"coriolis_factor": 0.277, "decay_time_s": 450.0, "frequency_Hz": 7000.0}


def _read_campaign(folder: Path) -> None:
    campaign = read_campaign(folder)
    from_table(campaign.nominal, campaign.device)
    describe_preparation(campaign)


def _write_foreign(folder: Path) -> None:
    log = made_up_log(60)
    labs.foreign(
        Campaign("made up", TYPICAL.site, NOMINAL, (Test("a", "static", "fit", log),)), folder
    )


def _write_drive(folder: Path) -> None:
    text = "".join(",".join(row) + "\n" for row in make_drive())
    (folder / "drive.csv").write_text(text)


def _write_imu(folder: Path) -> None:
    logs.saved(logs.frame(logs.resting(35.0)), folder)


def _write_parquet(folder: Path) -> None:
    logs.frame(logs.resting(15.0)).to_parquet(folder / "log.parquet")


def _write_psins(folder: Path) -> None:
    counts = np.random.default_rng(1).integers(-50, 50, (1500, 6)) + np.array(
        [0, 0, 10, 0, 0, 10_000]
    )
    text = "".join(" ".join(map(str, row)) + "\n" for row in counts.tolist())
    (folder / "log.txt").write_text(PSINS + text)


def _write_messages(folder: Path, lines: list[str]) -> None:
    (folder / "log.txt").write_text("\n".join(lines) + "\n")


def _write_fmu(folder: Path) -> None:
    (folder / "HRG.fmu").write_bytes(build_fmu().read_bytes())


def _check(name: str) -> Callable[[Path], object]:
    """All rules, FMPy's validation and the plan of the run; importers are other people's."""

    def check(folder: Path) -> None:
        with (
            patch.object(fmu_checks, "IMPORTERS", ()),
            patch.object(system_checks, "IMPORTERS", ()),
        ):
            check_fmu(folder / name)

    return check


MISSIONS = "ins_eval.trajectories.missions"
SAMPLES = {
    "device": Sample(
        _copy("pyhrg.device.ready", "table2.toml"),
        *("file.toml", DOCUMENT),
        lambda folder: pyhrg.load_device(folder / "file.toml"),
    ),
    "mission": Sample(
        _copy(MISSIONS, "city.toml"),
        *("file.toml", DOCUMENT),
        lambda folder: load_trajectory(folder / "file.toml", 60.0, 10.0),
    ),
    "weaving mission": Sample(
        _copy(MISSIONS, "ship.toml"),
        *("file.toml", DOCUMENT),
        lambda folder: load_trajectory(folder / "file.toml", 60.0),
    ),
    "IMU": Sample(
        _copy("ins_eval.imu.ready", "typical-hrg.toml"),
        *("file.toml", DOCUMENT),
        lambda folder: load_imu(folder / "file.toml"),
    ),
    "study": Sample(
        cases.study_file,
        *("study.toml", DOCUMENT),
        lambda folder: ins_eval.load_study(folder / "study.toml"),
    ),
    "small study": Sample(
        _copy("ins_eval.study.ready", "small.toml"),
        *("file.toml", DOCUMENT),
        lambda folder: ins_eval.load_study(folder / "file.toml"),
    ),
    "belief": Sample(
        lambda folder: (folder / "belief.toml").write_text(BELIEF),
        *("belief.toml", DOCUMENT),
        lambda folder: read_beliefs(folder / "belief.toml"),
    ),
    "mapping": Sample(
        _write_foreign,
        *("mapping.toml", DOCUMENT),
        lambda folder: import_campaign(folder / "mapping.toml").preview,
    ),
    "laboratory's log": Sample(
        _write_foreign,
        *("a.txt", TABLE),
        lambda folder: import_campaign(folder / "mapping.toml").preview,
    ),
    "campaign": Sample(_write_campaign, "campaign.json", DOCUMENT, _read_campaign),
    "campaign's log": Sample(_write_campaign, "rate.csv.gz", BYTES, _read_campaign),
    "log": Sample(
        lambda folder: write_log(made_up_log(table_rate=0.02), folder / "log.csv"),
        *("log.csv", TABLE),
        lambda folder: read_log(folder / "log.csv", latitude_deg=40.0),
    ),
    "static bench log": Sample(
        lambda folder: write_log(made_up_log(1100), folder / "log.csv"),
        *("log.csv", TABLE),
        lambda folder: read_static_record(folder / "log.csv"),
    ),
    "drive": Sample(
        _write_drive,
        *("drive.csv", TABLE),
        lambda folder: load_trajectory(folder / "drive.csv", 300.0, 10.0),
    ),
    "IMU log": Sample(
        _write_imu, "log.csv", TABLE, lambda folder: read_static_record(folder / "log.csv")
    ),
    "trusted IMU log": Sample(
        _write_imu,
        *("log.csv", TABLE),
        lambda folder: read_static_record(folder / "log.csv", trusted=True),
    ),
    "aligned IMU log": Sample(
        _write_imu,
        *("log.csv", TABLE),
        lambda folder: ins_eval.align(folder / "log.csv", seconds=30.0, latitude_deg=45.8).summary,
    ),
    "Parquet IMU log": Sample(
        _write_parquet,
        *("log.parquet", BYTES),
        lambda folder: read_static_record(folder / "log.parquet"),
    ),
    "PSINS log": Sample(
        _write_psins, "log.txt", TABLE, lambda folder: read_static_record(folder / "log.txt", True)
    ),
    "NovAtel log": Sample(
        lambda folder: _write_messages(folder, messages.write_rawimu(logs.resting(15.0))),
        *("log.txt", TABLE),
        lambda folder: read_static_record(folder / "log.txt", True),
    ),
    "VectorNav log": Sample(
        lambda folder: _write_messages(
            folder, messages.write_vectornav("VNDTV", logs.resting(15.0))
        ),
        *("log.txt", TABLE),
        lambda folder: read_static_record(folder / "log.txt", True),
    ),
    "log that a mapping is drafted for": Sample(
        _write_imu, *("log.csv", TABLE), lambda folder: draft_mapping([folder / "log.csv"], folder)
    ),
    "FMU": Sample(_write_fmu, "HRG.fmu", ARCHIVE, _check("HRG.fmu")),
    "SSP": Sample(write_system, "two.ssp", ARCHIVE, _check("two.ssp")),
    **RESULTS,
}
"""Formats by their names."""


def read_all() -> None:
    """Read every right input once, so that what is compiled and loaded is there for all cases."""
    for sample in SAMPLES.values():
        with tempfile.TemporaryDirectory() as folder:
            sample.put(Path(folder), sample.content[sample.spoilt])
            sample.read(Path(folder))
