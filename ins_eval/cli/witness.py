"""`hrg witness`: the present bias map of a gyro, from a log of its own channels."""

import argparse
import json
from pathlib import Path

import pyhrg
from pyhrg.common.units import YEAR

HELP = "estimate a gyro's present bias map, its changes since calibration, and their position error"
DAYS_PER_YEAR = 365.25


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("log", type=Path, metavar="LOG", help="log with pattern angle, forces and frequency "
        "(docs/records.md)")  # fmt: skip
    add("--device", required=True, metavar="NAME|FILE", help="the gyro as it was calibrated")
    add("--age-days", type=float, default=180.0, metavar="D", help="time since the calibration "
        "(default 180)")  # fmt: skip
    add("--ageing-share", type=float, metavar="S", help="standard deviation of the change of "
        "damping, pick-offs and drives in a year, as a share of each (default: the "
        "study's)")  # fmt: skip
    add("--bench-error", action="store_true", help="assume that the study's bench measured the "
        "device, which confounds damping with drives")  # fmt: skip
    add("--mission", default="car", metavar="NAME|FILE", help="mission of the position error "
        "(default car)")  # fmt: skip
    add("--hours", type=float, default=1.0, help="duration of that mission (default 1)")
    add("--json", action="store_true", help="print an object instead of the summary")


def run(options: argparse.Namespace) -> None:
    from ins_eval.error_model.error_budget import BODY
    from ins_eval.mission_model.missions import plan_mission
    from ins_eval.mission_model.position_errors import compute_map_worth
    from ins_eval.mission_model.weights_cache import load_mission_weights
    from ins_eval.study.gyros.drift import AGEING_SHARE, LARGEST_LEAKAGE
    from ins_eval.study.gyros.witness_prior import widen_prior
    from pyhrg.common.arguments import check_number

    age = check_number("--age-days", options.age_days, 0.0, 36525.0) / DAYS_PER_YEAR * YEAR
    share = AGEING_SHARE if options.ageing_share is None else options.ageing_share
    check_number("--ageing-share", share, 0.0, 1.0)
    mission = plan_mission(options.mission, options.hours)
    device = pyhrg.load_device(options.device)
    prior = pyhrg.make_drift_prior(device, age, share, LARGEST_LEAKAGE)
    if options.bench_error:
        prior = widen_prior(prior, device)
    result = pyhrg.estimate_map(pyhrg.read_log(options.log), device, prior)
    weights = load_mission_weights(mission)
    after, before = (
        compute_map_worth(weights, covariance, result.angle)
        for covariance in (result.maps_covariance, result.maps_prior)
    )
    if options.json:
        worth = zip(BODY, after.tolist(), before.tolist(), strict=True)
        errors = {axis: {"with_log": a, "without_log": b} for axis, a, b in worth}
        place = {"mission": mission.name, "hours": mission.hours}
        print(json.dumps({**result.document, **place, "position_rms_m": errors}, indent=1))
        return
    print(result.summary)
    print(f"\nrms position error by what is not known, {mission.name}, {mission.hours:g} h, m")
    for axis, known, unknown in zip(BODY, after, before, strict=True):
        print(f"gyro pointing {axis:10s}{known:10.0f} with the log{unknown:10.0f} without it")
