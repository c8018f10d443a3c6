"""Files that a challenge hands out: bench records, missions, and what is known of a flight before
it."""

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from ins_eval.mission_model.missions import CASE_WARM_UP, SETTLING, STILL, WARM_UP
from ins_eval.study.experiment import list_methods, load_fmu, make_distribution, open_missions
from ins_eval.study.gyros.bench_plan import WARM_RISE
from ins_eval.study.gyros.drawn_triad import DrawnGyro, draw_gyros, make_triad_seed
from ins_eval.study.gyros.measured_gyro import record_tests
from ins_eval.study.specification import TRAIN, Study
from ins_eval.study.tables import columns
from pyhrg.common.units import DEG
from pyhrg.device.device import Device
from pyhrg.device.device_file import from_table, nominal, write
from pyhrg.records.campaign import Campaign, write_campaign

INDEX, README = "challenge.json", "README.md"
SCHEMA = "hrg-study-challenge/1"
DESIGN_DIGITS = 3
"""Significant digits of the design values in a hand-out. Chosen: as a data sheet states them."""
READ_OUT_CONSTANT = "coriolis_factor"
"""Key of the angular gain that the electronics use; it is known exactly."""
AXES = "xyz"
_TEXT = Path(__file__).with_name("hand_out.md")


def write_hand_out(study: Study, flights: pd.DataFrame, digest: str, folder: Path) -> None:
    """Write the files that are handed out.

    Args:
        study: the study, with one calibration.
        flights: its table; only the errors of the training triads are written.
        digest: SHA-256 of the sealed table.
        folder: an existing folder.
    """
    known = [row for triad in range(study.triads) for row in _write_triad(study, triad, folder)]
    pd.DataFrame(known).to_csv(folder / "flights.csv", index=False)
    training = flights[flights[columns.ROLE] == TRAIN]
    flown = [columns.TRIAD, columns.MISSION, columns.FLOWN_NORTH, columns.FLOWN_EAST]
    training[flown].to_csv(folder / "training.csv", index=False)
    index = {
        "schema": SCHEMA,
        "sha256": digest,
        "calibration": study.calibrations[0],
        "interval_percent": study.interval_percent,
        "accelerometer_bias_micro_g": study.accelerometer_bias_micro_g,
        "mounting_arcsec": study.mounting_arcsec,
        "still_s": STILL,
        "settling_s": SETTLING,
        "case_warm_up_s": CASE_WARM_UP,
        "resonator_warm_up_s": WARM_UP,
        "bench_warm_rise_K": WARM_RISE,
        "missions": _write_missions(study, folder / "missions"),
    }
    (folder / INDEX).write_text(json.dumps(index, indent=1) + "\n")
    text = _TEXT.read_text(encoding="utf-8")
    (folder / README).write_text(text.format_map(index), encoding="utf-8")


def _write_missions(study: Study, folder: Path) -> list[dict[str, Any]]:
    """Write each mission's file, and describe it."""
    folder.mkdir()
    for planned in study.missions:
        (folder / planned.file_name).write_bytes(planned.content)
    with open_missions(study) as missions:
        return [
            {
                columns.MISSION: planned.name,
                columns.CLASS: planned.mission_class,
                columns.HOURS: mission.hours,
                "file": f"missions/{planned.file_name}",
            }
            for planned, mission in zip(study.missions, missions, strict=True)
        ]


def _write_triad(study: Study, triad: int, folder: Path) -> Iterator[dict[str, Any]]:
    """Write the records of a triad's gyros, and give what is known of the flight of each."""
    distribution = make_distribution(study, list_methods(study)[0])
    generator = np.random.default_rng(make_triad_seed(study.seed, triad))
    fmu = load_fmu("HRGSlow")
    for axis, gyro in zip(AXES, draw_gyros(fmu, distribution, generator), strict=True):
        name = f"{triad:04d}-{axis}"
        tests, warm = record_tests(fmu, gyro.device, distribution.bench, gyro.bench_seed)
        _write_records(folder / "gyros" / name, gyro, tests, warm)
        yield {
            columns.TRIAD: triad,
            "axis": axis,
            columns.ROLE: study.role_of(triad),
            "gyro": f"gyros/{name}",
            "start_angle_deg": gyro.flight.power_on_angle / DEG,
            "rise_K": gyro.flight.rise,
        }


def _write_records(folder: Path, gyro: DrawnGyro, tests: Campaign, warm: Campaign) -> None:
    design = _round_nominal(gyro.device)
    heated = tuple(
        replace(test, recording=replace(test.log, temperature=test.log.temperature + WARM_RISE))
        for test in warm.tests
    )
    write_campaign(replace(tests, device=folder.name, nominal=design), folder / "bench")
    write_campaign(
        replace(warm, device=folder.name, nominal=design, tests=heated), folder / "bench-warm"
    )
    device = replace(
        from_table(design, folder.name),
        name=folder.name,
        site=gyro.device.site,
        bias_map=gyro.device.bias_map,
        scale_factor_map=gyro.device.scale_factor_map,
    )
    write(device, folder / "gyro.toml")


def _round_nominal(device: Device) -> dict[str, float]:
    """Design values with `DESIGN_DIGITS`, by the keys of a device file."""
    return {
        key: value if key == READ_OUT_CONSTANT else float(f"{value:.{DESIGN_DIGITS}g}")
        for key, value in nominal(device).items()
    }
