"""Budgets: alignment and navigation of a car with known errors of its sensors."""

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.colors import to_hex

from ins_eval.alignment.analytic import level_and_gyrocompass
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.common.state import position_error
from ins_eval.error_model.budget_figure import (
    INITIAL_COLOUR,
    MAX_SHOWN_EFFECTS,
    plot_budget,
)
from ins_eval.error_model.dynamics import COUNT
from ins_eval.error_model.effects import BIASES, Effect
from ins_eval.error_model.error_budget import (
    Weights,
    compute_budget,
    compute_weights,
    sum_contributions,
)
from ins_eval.error_model.linear_model import join_models, linearize, model_alignment
from ins_eval.error_model.motion import sample_motion
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.trajectories.catalogue import load_trajectory
from pyhrg.common.units import DEG_PER_H, DEG_PER_SQRT_H, MICRO_G
from pyhrg.records.imu.log import Increments

STILL, FLIGHT, INTERVAL = 200.0, 1800.0, 0.05
ALIGNED = round(STILL / INTERVAL)
TRAJECTORY = load_trajectory("car", FLIGHT + 10, STILL + 20)
NOISE = SensorErrors(
    gyro_bias=0.01 * DEG_PER_H,
    angle_random_walk=1e-3 * DEG_PER_SQRT_H,
    gyro_bias_instability=0.003 * DEG_PER_H,
    accelerometer_bias=20 * MICRO_G,
    velocity_random_walk=1e-4,
)


def model_weights(step: float, effects: tuple[Effect, ...] = BIASES) -> Weights:
    still = sample_motion(TRAJECTORY, -STILL, step, round(STILL / step))
    moving = sample_motion(TRAJECTORY, 0.0, step, round(FLIGHT / step))
    aligning = model_alignment(still, effects, NOISE)
    return compute_weights(
        join_models(aligning, linearize(moving, Clamped(np.zeros(1)), effects, NOISE))
    )


@pytest.fixture(scope="module")
def truth() -> Increments:
    return TRAJECTORY.increments(-STILL, INTERVAL, round((STILL + FLIGHT) / INTERVAL))


@pytest.fixture(scope="module")
def signals(truth: Increments) -> dict[str, Increments]:
    """A tenth of what a gyro of the paper's class does, for the linear remainder to be small."""
    generator = np.random.default_rng(3)
    angle = np.array([0.1, 0.7, 1.3]) - 0.277 * np.cumsum(truth.rotation, axis=0)
    none = np.zeros_like(truth.rotation)
    walk = 1e-4 * DEG_PER_SQRT_H * np.sqrt(INTERVAL)
    rotations = {
        "mean bias": none + np.array([1.0, -2, 1.5]) * 1e-3 * DEG_PER_H * INTERVAL,
        "map": 2e-3 * DEG_PER_H * INTERVAL * np.cos(4 * angle),
        "scale factor": 1e-6 * truth.rotation,
        "noise": walk * generator.standard_normal(none.shape),
    }
    result = {name: replace(truth, rotation=r, velocity=none) for name, r in rotations.items()}
    force = none + 5 * MICRO_G * INTERVAL * np.array([1, -1, 0.5])
    return result | {"accelerometers": replace(truth, rotation=none, velocity=force)}


def flown(record: Increments) -> np.ndarray:
    """Final position error north and east, alignment included."""
    start = TRAJECTORY.state(0.0)
    mat_nb = level_and_gyrocompass(record.between(0, ALIGNED), start.latitude)
    flight = record.between(ALIGNED, len(record))
    height = Clamped(TRAJECTORY.position(flight.bounds)[:, 2])
    track = navigate(replace(start, mat_nb=mat_nb), flight, height, len(flight))
    return position_error(track.position, TRAJECTORY.track(track.time).position)[0, :2]


def erring(truth: Increments, signals: dict[str, Increments], sign: float) -> Increments:
    return replace(
        truth,
        rotation=truth.rotation + sign * sum(s.rotation for s in signals.values()),
        velocity=truth.velocity + sign * sum(s.velocity for s in signals.values()),
    )


def test_each_effect_is_the_navigators(truth: Increments, signals: dict[str, Increments]) -> None:
    """Flown one by one, forth and back: 1e-3 of each effect's part, at steps of 0.1 s."""
    result = compute_budget(model_weights(0.1), signals, np.zeros(COUNT))
    for name, signal in signals.items():
        single = {name: signal}
        ends = [flown(erring(truth, single, sign)) for sign in (1.0, -1.0)]
        expected = (ends[0] - ends[1]) / 2
        part = result.contribution.sel(effect=name).sum(("axis", "time")).values
        assert np.linalg.norm(part - expected) < 1e-3 * np.linalg.norm(expected), name


def test_parts_sum_to_the_whole(truth: Increments, signals: dict[str, Increments]) -> None:
    """Exactly to the linear error; to the navigator's but for the remainder, here 0.2 %."""
    own = model_weights(0.25)
    whole = erring(truth, signals, 1.0)
    sensor_errors = replace(
        whole, rotation=whole.rotation - truth.rotation, velocity=whole.velocity - truth.velocity
    )
    initial = np.array([1.0, 2, 0, 0.01, 0.02, 0, 1e-6, 2e-6, 3e-6, 0])
    parts = sum_contributions(compute_budget(own, signals, initial))
    together = sum_contributions(compute_budget(own, {"all": sensor_errors}, initial))
    assert parts == pytest.approx(together, rel=1e-9)
    expected = flown(whole) - flown(truth)
    without = sum_contributions(compute_budget(own, signals, np.zeros(COUNT)))
    assert np.linalg.norm(without - expected) < 2e-3 * np.linalg.norm(expected)
    assert together - without == pytest.approx(own.states[0] @ initial, rel=1e-9)


def test_signals_must_span_the_model(signals: dict[str, Increments]) -> None:
    short = {"noise": signals["noise"].between(ALIGNED, ALIGNED + 100)}
    with pytest.raises(ValueError, match=r"increments span 0\.0 to 5\.0 s: expected -200\.0"):
        compute_budget(model_weights(1.0), short, np.zeros(COUNT))


def test_labels(signals: dict[str, Increments]) -> None:
    result = compute_budget(model_weights(1.0), signals, np.zeros(COUNT))
    assert result.contribution.attrs["units"] == "m"
    assert result.contribution.dims == ("effect", "axis", "time", "component")
    accelerometers = result.contribution.sel(effect="mean bias", axis="accelerometer right")
    assert float(abs(accelerometers).max()) == 0.0


def test_figure(signals: dict[str, Increments]) -> None:
    """Two effects are all shown; of twice as many the smallest are summed."""
    own = model_weights(1.0)
    many = {f"{name} {k}": signal for k in range(4) for name, signal in signals.items()}
    for shown, title in ((signals, "Few"), (many, "Many")):
        figure = plot_budget(own, compute_budget(own, shown, np.zeros(COUNT)), title)
        handles, labels = figure.axes[2].get_legend_handles_labels()
        colours = {to_hex(each.get_color()) for each in handles}
        assert len(colours | {to_hex(INITIAL_COLOUR)}) == len(handles) + 1
        assert len(labels) == min(len(shown), MAX_SHOWN_EFFECTS) + 1
        assert figure.get_suptitle().startswith(title)
