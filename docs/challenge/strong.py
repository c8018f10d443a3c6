"""A strong predictor from outside: harmonics of the bench records, and Schuler's equations.

python docs/challenge/strong.py HAND-OUT predictions.csv

It fits each gyro's bias and scale factor over the pattern angle to the raw records, integrates the
linear error equations of a navigator along each mission, and takes its spread from the training
triads. Of this project it uses the motion of the missions alone.
"""

import json
import sys
from pathlib import Path

import numpy as np
import pandas as pd
from scipy.optimize import minimize
from scipy.stats import ncx2

import ins_eval

EARTH_RATE, RADIUS = 7.292115e-5, 6371e3
HARMONICS = (2, 4, 6, 8)
STEP = 0.5
"""Step of the integration, s."""
INSIDE = 0.9


def evaluate_terms(angle):
    """(..., 9) constant, and cosine and sine of each harmonic."""
    waves = [f(h * angle) for h in HARMONICS for f in (np.cos, np.sin)]
    return np.stack([np.ones_like(angle), *waves], axis=-1)


def read_logs(folder, kind):
    index = json.loads((folder / "campaign.json").read_text())
    up = EARTH_RATE * np.sin(np.radians(index["site"]["latitude_deg"]))
    for test in index["tests"]:
        if test["kind"] == kind:
            log = pd.read_csv(folder / test["file"])
            angles = ("table_angle_deg", "gyro_angle_deg", "wave_angle_deg")
            yield log["time_s"].to_numpy(), *(np.radians(log[a].to_numpy()) for a in angles), up


def fit_maps(folder):
    """(18,) coefficients of the bias, rad/s, and of the scale-factor error."""
    rows, rates = [], []
    for kind, every in (("positions", 20), ("rate", 10)):
        for time, table, gyro, pattern, up in read_logs(folder, kind):
            begin = np.arange(round(30 / (time[1] - time[0])), len(time) - every, every)
            end = begin + every
            span, turned = time[end] - time[begin], table[end] - table[begin]
            input_rate = turned / span + up
            # the table either rests or turns steadily during a piece of the record
            moved = np.diff(table)
            even = np.array([np.ptp(moved[a:b]) < 1e-6 for a, b in zip(begin, end, strict=True)])
            middle = (pattern[begin] + pattern[end]) / 2
            waves = evaluate_terms(middle)
            # a mean over the piece is less than the value at its middle
            swept = pattern[end] - pattern[begin]
            waves[:, 1:] *= np.sinc(np.outer(swept, np.repeat(HARMONICS, 2)) / (2 * np.pi))
            # a random walk's rate over the piece has a variance of one over its duration
            weight = np.sqrt(span[even])
            rows.append(weight[:, None] * np.hstack([waves, waves * input_rate[:, None]])[even])
            rates.append(weight * ((gyro[end] - gyro[begin]) / span - input_rate)[even])
    return np.linalg.lstsq(np.vstack(rows), np.concatenate(rates))[0]


def propagate(mission, index, file, gyros, cool, per_kelvin):
    """(r, 2) error north and east, m, at a mission's end; arguments of gyros are (r, 3, ...)."""
    still, end = index["still_s"], round(mission["hours"] * 3600 / STEP) * STEP
    motion = ins_eval.load_trajectory(file, end, still)
    time = np.arange(-still, end, STEP) + STEP / 2
    rate, force = motion.rate_and_force(time)
    mat_nb, position, velocity = motion.mat_nb(time), motion.position(time), motion.velocity(time)
    force = np.einsum("tij,tj->ti", mat_nb, force)
    case, lag = index["case_warm_up_s"], index["resonator_warm_up_s"]
    warmth = 1 - (lag * np.exp(-(time + still) / lag) - case * np.exp(-(time + still) / case)) / (
        lag - case
    )
    error = np.empty((len(cool), len(time), 3))
    for axis in range(3):
        for r in range(len(cool)):
            k, start, rise = gyros[r, axis]
            turned = STEP * (np.cumsum(rate[:, axis]) - rate[:, axis] / 2)
            terms = evaluate_terms(start - k * turned)
            maps = [each[r, axis].reshape(2, 9).T for each in (cool, per_kelvin)]
            bias, scale = (terms @ maps[0] + (rise * warmth)[:, None] * (terms @ maps[1])).T
            error[r, :, axis] = bias + scale * rate[:, axis]
    return integrate(time, mat_nb, position, velocity, force, error, index["settling_s"] - still)


def integrate(time, mat_nb, position, velocity, force, error, settled):
    """(r, 2) error, m: seven states, position, velocity and attitude (phi-angle equations)."""
    state = np.zeros((len(error), 7))
    aligning = (time > settled) & (time < 0)
    east = np.einsum("tj,rtj->r", mat_nb[aligning][:, 1], error[:, aligning]) / aligning.sum()
    state[:, 6] = east / (EARTH_RATE * np.cos(position[0, 0]))
    for n in np.flatnonzero(time > 0):
        sin, cos = np.sin(position[n, 0]), np.cos(position[n, 0])
        (north, east, _), (f_n, f_e, f_d) = velocity[n], force[n]
        earth = EARTH_RATE * np.array([cos, 0.0, -sin])
        carried = np.array([east, -north, -east * sin / cos]) / RADIUS
        matrix = np.zeros((7, 7))
        matrix[0, 2] = matrix[1, 3] = 1
        matrix[2, 5:], matrix[3, 4], matrix[3, 6] = (-f_d, f_e), f_d, -f_n
        down = 2 * earth[2] + carried[2]
        matrix[2, 3], matrix[3, 2] = down, -down
        matrix[4, 3], matrix[5, 2], matrix[6, 3] = 1 / RADIUS, -1 / RADIUS, -sin / cos / RADIUS
        matrix[4, 0], matrix[6, 0] = -EARTH_RATE * sin / RADIUS, -EARTH_RATE * cos / RADIUS
        x, y, z = earth + carried
        matrix[4:, 4:] = -np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        step = STEP * matrix
        driven = np.zeros_like(state)
        driven[:, 4:] = -STEP * error[:, n] @ mat_nb[n].T
        state = state + (state + driven / 2) @ (step + step @ step / 2).T + driven
    return state[:, :2]


def fit_spread(missed, size):
    """Standard deviation of each component, m, as a function of the maps' size: by maximum
    likelihood, the root of a constant and of a share of the size, squared."""

    def variance(logs, of):
        return np.exp(logs[0]) + np.exp(logs[1]) * of**2

    def misfit(logs):
        expected = variance(logs, size)[:, None]
        return np.sum(np.log(expected) + missed**2 / expected)

    power = np.mean(missed**2)
    start = np.log([power / 2, power / 2 / np.mean(size**2)])
    found = minimize(misfit, start, method="Nelder-Mead").x
    return lambda of: np.sqrt(variance(found, of))


def main(folder, out):
    index = json.loads((folder / "challenge.json").read_text())
    flights = pd.read_csv(folder / "flights.csv")
    training = pd.read_csv(folder / "training.csv").set_index(["mission", "triad"])
    cool = np.array([fit_maps(folder / gyro / "bench") for gyro in flights["gyro"]])
    warm = np.array([fit_maps(folder / gyro / "bench-warm") for gyro in flights["gyro"]])
    cool, warm = cool.reshape(-1, 3, 18), warm.reshape(-1, 3, 18)
    believed = [
        json.loads((folder / gyro / "bench" / "campaign.json").read_text())["nominal"]
        for gyro in flights["gyro"]
    ]
    constant = [each["coriolis_factor"] for each in believed]
    known = [constant, np.radians(flights["start_angle_deg"]), flights["rise_K"]]
    gyros = np.stack(known, axis=-1).reshape(-1, 3, 3)
    roles, triads = (flights[name].to_numpy()[::3] for name in ("role", "triad"))
    size = np.sqrt(np.mean(np.sum(cool[..., :9] ** 2, axis=-1), axis=-1))
    tables = []
    for mission in index["missions"]:
        name, file = mission["mission"], folder / mission["file"]
        per_kelvin = (warm - cool) / index["bench_warm_rise_K"]
        expected = propagate(mission, index, file, gyros, cool, per_kelvin)
        learned, judged = roles == "train", roles == "test"
        flown = training.loc[name].loc[triads[learned]].to_numpy()
        sigma = fit_spread(flown - expected[learned], size[learned])(size[judged])
        distance = np.linalg.norm(expected[judged], axis=1)
        table = {"triad": triads[judged], "mission": name}
        for column, share in (
            ("low_m", (1 - INSIDE) / 2),
            ("median_m", 0.5),
            ("high_m", (1 + INSIDE) / 2),
        ):
            table[column] = sigma * np.sqrt(ncx2.ppf(share, 2, (distance / sigma) ** 2))
        tables.append(pd.DataFrame(table))
    pd.concat(tables).to_csv(out, index=False)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
