"""Figures of docs/witness-results.md: `python -m benchmarks.witness COMMAND [NUMBERS]`.

command                    what it prints
bounds [GYROS]             bound of the bias map in each mission class
mechanisms [GYROS]         how well each mechanism is known after an hour
confounded                 directions among the mechanisms that simple motions see
study [CALIBRATION TRAINING JUDGED]
                           R2 of the position error in linear flights of two hours, of triads whose
                           maps are calibrated (seed 1, as `hrg study standard`)
flown [CALIBRATION sealed TRIADS FIRST]
                           flies triads on the FMU at 1 kHz, from number FIRST on, five in each
                           mission in turn, after a self-test; with the word
                           sealed, each gyro has a form outside the model. Those whose rows
                           docs/witness-flown.csv has are not flown again
tables                     writes the tables of these rows into docs/witness-results.md
benched [GYROS]            NEES of estimates with an error of the bench, and of their maps
electronics [FLIGHTS MINUTES]
                           bias maps that the estimator in the electronics corrects, of gyros that
                           drifted or did not, with and without a self-test, beside the log's
outside                    the estimate where something changed that its prior holds for constant
"""

import sys
from collections.abc import Sequence

import numpy as np
from scipy.stats import chi2

from benchmarks.witness import benched, bounds, electronics, flown, outside, study, tables
from fmu_build.bundle import build_fmu
from ins_eval.study.experiment import load_fmu
from ins_eval.study.gyros.drawn_triad import (
    TriadDistribution,
    draw_triad,
    make_triad_seed,
    tabulate_triads,
)
from ins_eval.study.gyros.population import RAW, TRIMMED
from ins_eval.study.witness.self_test import HALF_PERIOD, ROTATION
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.fmu import GyroFmu
from pyhrg.witness.design import Motion, stack_signals
from pyhrg.witness.mechanisms import NAMES

GYROS, TRAINING, JUDGED, FLOWN, BENCHED, ELECTRONICS = 24, 60, 80, 20, 16, 12
FIRST_JUDGED = 100
"""Number of the first judged triad, as in `hrg study standard`."""
STUDY_SEED = 1
DURATION, ROW = 600.0, 0.1


def print_bounds(count: int) -> None:
    sample = bounds.draw_sample(load_fmu("HRGSlow"), count)
    for name, value in bounds.compute_prior_figures(sample).items():
        print(f"before the flight, {name}: {1e3 * value:.2f} mdeg/h")
    print("map (mean), mdeg/h, after the alignment and 1, 10, 60 min of flight")
    for title, axis, test, found in bounds.tabulate_bounds(sample):
        cells = "".join(f"{1e3 * a:8.2f} ({1e3 * m:5.2f})" for a, m in found)
        print(f"{title:24s} {axis:9s} self-test {test:6s}{cells}", flush=True)


def print_mechanisms(count: int) -> None:
    sample = bounds.draw_sample(load_fmu("HRGSlow"), count)
    thermal = bounds.compute_thermal_bound(sample)
    print(f"map by thermal coefficients after the bench: {1e3 * thermal:.2f} mdeg/h")
    for mission in ("car", "long-haul"):
        for title, ratios in bounds.tabulate_mechanisms(sample, mission):
            print(f"{mission}, {title}: sigma after an hour over sigma before")
            for name, ratio in zip(NAMES, ratios, strict=True):
                print(f"    {name:34s}{ratio:8.3f}")


def print_confounded() -> None:
    (gyro,) = bounds.draw_sample(load_fmu("HRGSlow"), 1)
    time = np.arange(0.0, DURATION, ROW)
    alternating = np.sign(np.sin(np.pi * time / HALF_PERIOD))
    for title, rate, rotation in (
        ("at rest", 0.0, 0.0),
        ("turning at 5 deg/s", 5 * DEG, 0.0),
        ("turning by +-5 deg/s", 5 * DEG * alternating, 0.0),
        ("virtual rotation of 5 deg/s", 0.0, ROTATION),
        ("virtual rotation of +-5 deg/s", 0.0, ROTATION * alternating),
    ):
        w, v = (np.broadcast_to(each, time.shape) for each in (rate, rotation))
        angle = ROW * gyro.device.bryan_factor * np.cumsum(v - w)
        motion = Motion(ROW, angle, w, v, 0 * time, stack_signals(0 * time))
        print(f"{title}, {DURATION / 60:g} min", *bounds.list_confounded(gyro, motion), sep="\n")


def make_distribution(method: str) -> TriadDistribution:
    """What triads are drawn from, as in `hrg study`."""
    if method == "mean":
        return TriadDistribution(population=TRIMMED, method="mean")
    return TriadDistribution(population=RAW, method="map")


def draw(distribution: TriadDistribution, first: int, count: int) -> list[study.DrawnTriad]:
    fmu, numbers = load_fmu("HRGSlow"), range(first, first + count)
    return [draw_triad(fmu, distribution, make_triad_seed(STUDY_SEED, n)) for n in numbers]


def print_study(method: str, training: int, judged: int) -> None:
    fmu, distribution = load_fmu("HRGSlow"), make_distribution(method)
    drawn = draw(distribution, FIRST_JUDGED, judged)
    known = study.measure_triads(fmu, distribution, drawn)
    learned = tabulate_triads(fmu, draw(distribution, 0, training))
    for title, scores in study.compute_scores(learned, tabulate_triads(fmu, drawn), known):
        print(title)
        for name, score in scores.items():
            print(f"    {name:28s} {score}", flush=True)


def fly(words: Sequence[str], count: int, first: int) -> None:
    fmus = load_fmu("HRG"), load_fmu("HRGSlow")
    distribution = make_distribution("mean" if "mean" in words else "map")
    fleet = flown.Fleet(fmus, distribution, "sealed" in words)
    for flights in flown.fly_triads(fleet, range(first, first + count)):
        print(f"{len(flights)} rows", flush=True)


def print_benched(count: int) -> None:
    for self_test in (True, False):
        found = list(
            benched.estimate_benched(load_fmu("HRG"), load_fmu("HRGSlow"), count, self_test)
        )
        square, degrees = sum(x.square for x in found), sum(x.degrees for x in found)
        estimated, believed, sigma = (
            1e3 * np.sqrt(np.mean(np.square([getattr(x, name) for x in found])))
            for name in ("estimated", "believed", "sigma")
        )
        low, high = chi2.ppf((0.005, 0.995), degrees) / degrees
        print(
            f"self-test {self_test}: NEES {square / degrees:.2f} of {degrees} degrees "
            f"({low:.2f} to {high:.2f}); map {estimated:.2f} mdeg/h, stated {sigma:.2f}, before "
            f"{believed:.2f}; smallest p {min(x.p_value for x in found):.2g}",
            flush=True,
        )


def print_electronics(flights: int, minutes: int) -> None:
    print("rms bias map, mdeg/h: change; left by the electronics, the log, another gyro's; sigma")
    fmus = load_fmu("HRG"), load_fmu("HRGSlow"), GyroFmu(build_fmu("HRGSelfCorrecting"))
    for self_test in (True, False):
        for drifts in (True, False):
            found = list(
                electronics.correct_flights(
                    fmus, flights, 60.0 * minutes, self_test=self_test, drifts=drifts
                )
            )
            row = "".join(f"{value:8.2f}" for value in electronics.list_figures(found))
            followed = sum(each.is_followed for each in found)
            print(
                f"self-test {self_test!s:6s} drift {drifts!s:6s}{row}  followed {followed}",
                flush=True,
            )
            if drifts:
                low, high = electronics.bootstrap_ratio(found)
                print(f"    left over change, 95 % interval: {low:.2f} to {high:.2f}", flush=True)


def print_outside() -> None:
    print("rms error of the bias map, mdeg/h: with the log, without it, by the electronics")
    print("ratios with the log, logs that are followed; estimates of the electronics that are")
    ratios = []
    fmus = load_fmu("HRG"), load_fmu("HRGSlow"), GyroFmu(build_fmu("HRGSelfCorrecting"))
    for each in outside.compare_changes(*fmus):
        estimated, believed, corrected = (
            1e3 * np.sqrt(np.mean(errors**2)) / DEG_PER_H
            for errors in (each.estimated, each.believed, each.corrected)
        )
        listed = " ".join(f"{ratio:.2f}" for ratio in sorted(each.ratio))
        count = f"{each.followed.sum()} of {len(each.followed)}"
        row = f"{estimated:8.2f}{believed:8.2f}{corrected:8.2f}  {listed}  {count}"
        print(f"{each.field:24s}{row}, {each.electronics_followed.sum()}", flush=True)
        ratios.append(each.ratio)
    print(f"90th percentile of all ratios: {np.quantile(ratios, 0.9):.2f}")


if __name__ == "__main__":
    command, *rest = sys.argv[1:]
    numbers = [int(each) for each in rest if each.isdigit()]
    words = [each for each in rest if not each.isdigit()]
    calibration = words[0] if words else "map"
    if command == "bounds":
        print_bounds(*(numbers or [GYROS]))
    elif command == "mechanisms":
        print_mechanisms(*(numbers or [GYROS]))
    elif command == "confounded":
        print_confounded()
    elif command == "flown":
        fly(words, *(numbers + [FLOWN, flown.FIRST][len(numbers) :]))
    elif command == "tables":
        print(tables.write_tables())
    elif command == "benched":
        print_benched(*(numbers or [BENCHED]))
    elif command == "electronics":
        print_electronics(*(numbers or [ELECTRONICS, 20]))
    elif command == "outside":
        print_outside()
    else:
        print_study(calibration, *(numbers or [TRAINING, JUDGED]))
