"""Figures of docs/methods/aided.md: `python -m benchmarks.aided COMMAND [NUMBER]`.

command          what it prints
mean [TRIADS]    flights on the FMU of triads whose maps' means are calibrated (seed 1, numbers from
                 100), in turn on four missions: fixes of 2 m at 1 Hz for two hours, then an hour
                 without
bound [CALIBRATION TRIADS]
                 what the filter's covariance leaves of the free hour, by what is known before the
                 drive: population, bench, the gyros' own channels
map [TRIADS]     the same of triads whose whole maps are calibrated
drawn [SEEDS]    NEES of drives whose sensors' errors are drawn from the filter's own prior
"""

import sys

import numpy as np
from scipy.stats import chi2

from benchmarks.aided.bound import bound_triads
from benchmarks.aided.drawn import filter_drawn
from benchmarks.aided.flown import STUDY_SEED, AidedTriad, Told, fly_triads
from ins_eval.aided.bench_maps import SEEN
from ins_eval.study.experiment import load_fmu
from ins_eval.study.gyros.drawn_triad import AXES, TriadDistribution
from ins_eval.study.gyros.population import RAW, TRIMMED
from ins_eval.study.scores.resampling import bootstrap
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG_PER_H

LEARNING, TRIADS, DRAWS = 12, 16, 1000
DRAWN_MISSIONS, DRAWN_HOURS = ("city", "aircraft"), 0.5


def compute_nees(told: Told, true: Array) -> tuple[float, int, float, int]:
    """Normalised square of the harmonics' errors and its degrees: in the directions that the drive
    has seen, and in all."""
    terms = true.shape[1]
    harmonics = np.flatnonzero(np.arange(true.size) % terms)
    error = (told.maps.coefficients - true).ravel()[harmonics]
    left, before = (m.joint[np.ix_(harmonics, harmonics)] for m in (told.maps, told.prior))
    scale = 1 / np.sqrt(np.diag(before))
    values, vectors = np.linalg.eigh(left * np.outer(scale, scale))
    squares = (vectors.T @ (scale * error)) ** 2 / values
    seen = values < SEEN
    return float(squares[seen].sum()), int(seen.sum()), float(squares.sum()), len(squares)


def size_harmonics(errors: Array) -> float:
    """Rms over gyros of the map's size without its mean, 1e-3 deg/h."""
    return float(np.sqrt(np.mean(np.sum(errors[:, 1:] ** 2, axis=1) / 2)) / DEG_PER_H * 1e3)


def print_row(triad: AidedTriad) -> None:
    square, degrees, every, count = compute_nees(triad.own, triad.true)
    *_, benched, _ = compute_nees(triad.benched, triad.true)
    sizes = [
        size_harmonics(errors)
        for errors in (
            triad.true,
            *(each.maps.coefficients - triad.true for each in (triad.own, triad.benched)),
            triad.bench - triad.true,
        )
    ]
    print(
        f"{triad.mission:9s} NIS {triad.innovation:.3f}  NEES seen {square / max(degrees, 1):5.2f} "
        f"of {degrees:2d}, all {every / count:5.2f}, with the bench {benched / count:5.2f}  map "
        f"{sizes[0]:5.1f}, error {sizes[1]:5.1f}, with the bench {sizes[2]:5.1f}, bench alone "
        f"{sizes[3]:5.1f} mdeg/h  hour: {triad.own.free:6.0f} m, with the bench "
        f"{triad.benched.free:6.0f} ({triad.benched.used} maps used), with another's "
        f"{triad.misled.free:6.0f} ({triad.misled.used} used), uncorrected {triad.uncorrected:6.0f}"
        f", another's errors {triad.shuffled:6.0f}, alone {triad.alone:6.0f}",
        flush=True,
    )


def make_distribution(method: str) -> TriadDistribution:
    if method == "mean":
        return TriadDistribution(population=TRIMMED, method="mean")
    return TriadDistribution(population=RAW, method="map")


def print_bound(method: str, count: int) -> None:
    print("medians of the horizontal error after the free hour, m, by the filter's covariance")
    for each in bound_triads(load_fmu("HRGSlow"), make_distribution(method), count):
        print(
            f"{each.mission:9s} {each.prior:13s} {each.free:6.0f}, uncorrected "
            f"{each.uncorrected:6.0f}, ratio {each.free / each.uncorrected:.3f}; noise alone "
            f"{each.noise:5.0f}, ratio {each.noise / each.uncorrected:.3f}",
            flush=True,
        )


def print_flown(method: str, count: int) -> None:
    distribution = make_distribution(method)
    fmus = load_fmu("HRG"), load_fmu("HRGSlow")
    triads = []
    for triad in fly_triads(fmus, distribution, LEARNING, count):
        print_row(triad)
        triads.append(triad)
    for name in ("own", "benched"):
        nees = [compute_nees(getattr(each, name), each.true) for each in triads]
        square, degrees, every, count = np.sum(nees, axis=0)
        print(f"{name}: NEES of the directions seen {describe_nees(square, degrees)}")
        print(f"{name}: NEES of all harmonics {describe_nees(every, count)}")
    own = np.array([t.own.free for t in triads])
    benched = np.array([t.benched.free for t in triads])
    for name in ("uncorrected", "alone"):
        base = [getattr(t, name) for t in triads]
        print_ratio(f"median error over that {name}", own, base)
        print_ratio(f"with the bench's maps, over that {name}", benched, base)
    print_ratio("with the bench's maps over without", benched, own.tolist())
    base = [t.uncorrected for t in triads[1:]]
    print_ratio("control, another triad's errors", np.array([t.shuffled for t in triads[1:]]), base)
    misled = np.array([t.misled.free for t in triads[1:]])
    print_ratio("control, another triad's bench, over without", misled, own[1:].tolist())
    used, misled_by = (sum(getattr(t, name).used for t in triads) for name in ("benched", "misled"))
    print(f"bench's maps used: {used} of {AXES * len(triads)}")
    print(f"another triad's bench's maps used: {misled_by} of {AXES * (len(triads) - 1)}")
    print(
        f"noise after the last fix alone: median {find_noise_median(triads):.0f} m of "
        f"{np.median(own):.0f} m"
    )
    for name, errors in (("without the bench", own), ("with it", benched)):
        worse = np.mean([e > t.uncorrected for e, t in zip(errors, triads, strict=True)])
        print(f"flights made worse {name}: {worse:.0%} of {len(triads)}")


def describe_nees(square: float, degrees: float) -> str:
    low, high = chi2.ppf((0.005, 0.995), degrees) / degrees
    return f"{square / degrees:.2f} of {degrees:.0f} degrees, 99 % band {low:.2f} to {high:.2f}"


def find_noise_median(triads: list[AidedTriad]) -> float:
    """Median horizontal error, m, over triads and draws of the noise after the last fix."""
    generator = np.random.default_rng(STUDY_SEED)
    drawn = [generator.multivariate_normal(np.zeros(2), t.by_noise, DRAWS) for t in triads]
    return float(np.median(np.linalg.norm(np.concatenate(drawn), axis=1)))


def print_ratio(title: str, corrected: Array, base: list[float]) -> None:
    found = bootstrap(_compare_medians, [corrected, np.array(base)], STUDY_SEED)
    print(f"{title}: {found.value:.3f} ({found.low:.3f} to {found.high:.3f})")


def _compare_medians(corrected: Array, uncorrected: Array) -> Array:
    return np.asarray(np.median(corrected, axis=-1) / np.median(uncorrected, axis=-1))


def print_drawn(count: int) -> None:
    for mission in DRAWN_MISSIONS:
        found = np.array(list(filter_drawn(mission, DRAWN_HOURS, count)))
        square, degrees = found.sum(axis=0)
        low, high = chi2.ppf((0.005, 0.995), degrees) / degrees
        print(
            f"{mission}: NEES {square / degrees:.3f} of {degrees:.0f} degrees in {count} drives, "
            f"99 % band {low:.3f} to {high:.3f}",
            flush=True,
        )


if __name__ == "__main__":
    command, *rest = sys.argv[1:]
    number = next((int(each) for each in rest if each.isdigit()), TRIADS)
    if command == "drawn":
        print_drawn(number)
    elif command == "bound":
        print_bound(next((each for each in rest if not each.isdigit()), "mean"), number)
    else:
        print_flown(command, number)
