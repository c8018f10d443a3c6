"""Mix-ups are named; what is ordinary raises no alarm."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from ins_eval.flights import sources
from ins_eval.imu.specification import load_imu
from ins_eval.trajectories.catalogue import list_trajectories, load_trajectory
from pyhrg.common.units import DEG, STANDARD_GRAVITY
from pyhrg.records.columns import LogError
from pyhrg.records.imu.log import ACCELEROMETERS, GYROS, ROTATION, VELOCITY, Increments, Quantity
from pyhrg.records.imu.plausibility import Readings, check_plausibility
from tests.ins_eval.imu.logs import (
    FORCE_G,
    FORCE_M_S2,
    GYRO_DEG_S,
    GYRO_RAD_S,
    frame,
    resting,
    saved,
)

Motion = Callable[[np.ndarray], tuple[object, object, object]]
Change = Callable[[pd.DataFrame], pd.DataFrame]

MOVING = ("great-circle", "weaving")
"""Ready missions that begin in motion."""
GYRO = ["gyro_x_rad_s", "gyro_y_rad_s", "gyro_z_rad_s"]
FORCE = ["accelerometer_x_m_s2", "accelerometer_y_m_s2", "accelerometer_z_m_s2"]


def scaled(columns: list[str], factor: float) -> Change:
    return lambda table: table.assign(**{name: table[name] * factor for name in columns})


def renamed(old: str, new: str) -> Change:
    return lambda table: table.rename(columns=lambda name: name.replace(old, new))


def swapped(table: pd.DataFrame) -> pd.DataFrame:
    names = dict(zip(GYRO + FORCE, FORCE + GYRO, strict=True))
    return table.rename(columns=names)


MIXED_UP = [
    (scaled(FORCE, 1 / STANDARD_GRAVITY), "accelerometer_x_m_s2 .* is g given where m/s2 is meant"),
    (scaled(FORCE, 1e3 / STANDARD_GRAVITY), "is milli-g given where m/s2 is meant"),
    (scaled(FORCE, 1e6 / STANDARD_GRAVITY), "is micro-g given where m/s2 is meant"),
    (scaled(FORCE, 0.01), "are increments given where rates are meant"),
    (renamed("m_s2", "g"), "accelerometer_x_g .* is m/s2 given where g is meant"),
    (lambda t: renamed("accelerometer", "velocity")(renamed("m_s2", "m_s")(t)), "are rates given"),
    (scaled(FORCE, 0), "found nothing but 0, expected about 9.81 m/s2: are the acc"),
    (scaled(FORCE, -1), "is z up where down is meant, or the sign reversed"),
    (scaled(GYRO, 1 / DEG), "gyro_x_rad_s .* are degrees given where radians are meant"),
    (scaled(GYRO, 3600 / DEG), "are degrees per hour given"),
    (scaled(GYRO, 0.01), "gyro_x_rad_s .* are increments given where rates are meant"),
    (renamed("rad_s", "deg_s"), "gyro_x_deg_s .* are radians given where degrees are meant"),
    (lambda t: renamed("gyro", "rotation")(renamed("rad_s", "rad")(t)), "rotation_x.* are rates"),
    (swapped, "are gyros and accelerometers swapped"),
]


@pytest.mark.parametrize(("change", "message"), MIXED_UP)
@pytest.mark.parametrize("latitude", [-1.3, 0.0, 0.8])
def test_a_mix_up_is_named(tmp_path: Path, change: Change, message: str, latitude: float) -> None:
    path = saved(change(frame(resting(latitude=latitude))), tmp_path)
    with pytest.raises(LogError, match=rf"log\.csv: column .*{message}"):
        sources.read_record(path)
    sources.read_record(path, trusted=True)


def test_at_10_hz_two_mix_ups_look_alike_and_both_are_named(tmp_path: Path) -> None:
    slow = resting(60.0)
    sums = [values.reshape(-1, 10, 3).sum(axis=1) for values in (slow.rotation, slow.velocity)]
    table = scaled(FORCE, 0.1)(frame(Increments(0.1, *sums)))
    with pytest.raises(LogError, match="are increments given where rates are meant"):
        sources.read_record(saved(table, tmp_path))


def motion(rate: Motion, force: Motion, seconds: float = 120.0) -> Increments:
    """From functions of time (n,) to (n, 3)."""
    time = 0.01 * np.arange(round(100 * seconds))
    sums = [0.01 * np.array([x + 0 * time for x in f(time)]).T for f in (rate, force)]
    return Increments(0.01, *sums)


G = STANDARD_GRAVITY
ROLLS = motion(lambda t: (2.0 * (t % 20 < np.pi), 0, 0), lambda t: (0, 0, -G))
SPIN = motion(lambda t: (30.0, 0, 0), lambda t: (60 - t / 2, 0.1 * np.sin(30 * t), 0))
BOOST = motion(lambda t: (0, 0, 1e-4), lambda t: (np.where(t < 20, G, 30 * G * (t < 60)), 0, 0))
FREE_FALL = motion(lambda t: (1e-3, 0, 0), lambda t: (1e-3, 0, -1e-3))
TURN = motion(lambda t: (0, 0, 0.24 * DEG), lambda t: (0, 0.04, -9.81), 600)
BANKED = motion(lambda t: (0, 0.24 * DEG * 0.2, 0.24 * DEG), lambda t: (0, 0, -10.0), 600)
INVERTED = motion(lambda t: (0, 0, 1e-4), lambda t: (0, 0, np.where(t % 10 < 4, G, -G)))


@pytest.mark.parametrize("kind", range(2))
@pytest.mark.parametrize(
    "flight", [ROLLS, SPIN, BOOST, FREE_FALL, TURN, BANKED, INVERTED], ids=range(7)
)
def test_what_a_vehicle_may_do_raises_no_alarm(flight: Increments, kind: int) -> None:
    gyros, forces = ((ROTATION, VELOCITY), (GYRO_DEG_S, FORCE_G))[kind]
    rate, force = flight.rotation / 0.01 / gyros.factor, flight.velocity / 0.01 / forces.factor
    check_plausibility(Readings("flight", 0.01, gyros, forces, rate, force))


@pytest.fixture(scope="module", params=list_trajectories())
def mission(request: pytest.FixtureRequest) -> tuple[str, Increments]:
    """Five minutes of each ready mission, those that can from a minute at rest; at 100 Hz."""
    moving = request.param in MOVING
    still = 0.0 if moving else 60.0
    truth = load_trajectory(request.param, 300.0 - still, still).increments(-still, 0.01, 30_000)
    return request.param, load_imu("simple").measure(truth, seed=1).increments


def readings(flown: Increments, gyros: Quantity, forces: Quantity, every: int = 1) -> Readings:
    """As a log at a lower rate has them."""
    sums = (flown.rotation, flown.velocity)
    rate, force = (x.reshape(-1, every, 3).sum(axis=1) / (0.01 * every) for x in sums)
    values = (rate / gyros.factor, force / forces.factor)
    return Readings("mission", 0.01 * every, gyros, forces, *values)


@pytest.mark.parametrize("every", [1, 2, 10])
def test_a_mission_raises_no_alarm(mission: tuple[str, Increments], every: int) -> None:
    _, flown = mission
    for gyros in GYROS:
        for forces in ACCELEROMETERS:
            check_plausibility(readings(flown, gyros, forces, every))


def test_a_mix_up_is_told_on_a_mission_that_begins_at_rest(
    mission: tuple[str, Increments],
) -> None:
    name, flown = mission
    for gyros, forces in ((GYRO_RAD_S, FORCE_G), (GYRO_DEG_S, FORCE_M_S2)):
        right = readings(flown, gyros, forces)
        other = FORCE_G if forces is FORCE_M_S2 else FORCE_M_S2
        with pytest.raises(LogError, match=r"given where .* meant"):
            check_plausibility(replace(right, accelerometers=other))
        if name not in MOVING:
            other = GYRO_DEG_S if gyros is GYRO_RAD_S else GYRO_RAD_S
            with pytest.raises(LogError, match=r"s given where .*s are meant"):
                check_plausibility(replace(right, gyros=other))


def test_tactical_gyros_raise_no_alarm() -> None:
    """500 triads whose biases are of 0 to 20 deg/h: Earth's rate is lost, no unit is doubted."""
    truth = resting()
    generator = np.random.default_rng(1)
    for _ in range(500):
        bias = generator.normal(0.0, generator.uniform(0, 20) * DEG / 3600, size=3)
        rate = truth.rotation / 0.01 + bias
        force = truth.velocity / 0.01
        check_plausibility(Readings("log", 0.01, GYROS[2], ACCELEROMETERS[1], rate, force))
