"""Climbs, launches, hills and the sea, against closed forms."""

import numpy as np
import pytest

from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.manoeuvres.overlays import Hills, Sway
from ins_eval.trajectories.manoeuvres.straights import Accelerate, Rest, Straight
from ins_eval.trajectories.manoeuvres.vertical import Boost, Climb, Pitch
from tests.ins_eval.trajectories.flights import GRAVITY, HEIGHT, displacement, euler, fly_manoeuvres


@pytest.mark.parametrize("change", [1500.0, -800.0, 20.0])
def test_climb_changes_height_by_what_it_says(change: float) -> None:
    """At its angle, or less if the change is small."""
    path, end = fly_manoeuvres(Climb(height_change=change, climb_angle=np.deg2rad(8)))
    assert path.position(np.array(end))[2] - HEIGHT == pytest.approx(change, abs=1e-4)
    pitch = euler(path, np.linspace(0, end, 400))[:, 1]
    steepest = np.max(np.abs(pitch))
    if abs(change) > 100:
        assert steepest == pytest.approx(np.deg2rad(8), abs=1e-3)
        assert path.velocity(np.array(end / 2))[2] == pytest.approx(
            -np.sign(change) * 200 * np.sin(np.deg2rad(8)), rel=1e-6
        )
    else:
        assert steepest < np.deg2rad(2)
    assert pitch[-1] == pytest.approx(0.0, abs=1e-4)


def test_climb_begins_level() -> None:
    with pytest.raises(TrajectoryError, match=r"course 2: found a climb angle of 5 deg"):
        fly_manoeuvres(Pitch(climb_angle=np.deg2rad(5), duration=5.0), Climb(height_change=100.0))


def test_boost_goes_up_then_over() -> None:
    """Straight up while vertical; height at the end by quadrature of the profile."""
    boost = Boost(speed=2000.0, duration=60.0, vertical=10.0, climb_angle=np.deg2rad(30))
    launch = (Rest(duration=5.0), boost, Straight(duration=5.0))
    path, _ = fly_manoeuvres(*launch, speed=0.0, heading=1.0, climb_angle=np.pi / 2)
    velocity = path.velocity(np.array([14.0, 65.0]))
    assert np.linalg.norm(velocity[0, :2]) < 1e-3 * abs(velocity[0, 2])
    assert np.linalg.norm(velocity[1]) == pytest.approx(2000.0, rel=1e-4)
    assert -velocity[1, 2] == pytest.approx(1000.0, rel=1e-3)
    t = np.linspace(0, 60, 20_001)
    s, over = t / 60, np.clip((t - 10) / 50, 0, 1)
    speed = 2000 * s**3 * (10 - 15 * s + 6 * s**2)
    climb = np.pi / 2 - np.deg2rad(60) * over**3 * (10 - 15 * over + 6 * over**2)
    rise = np.trapezoid(speed * np.sin(climb), t)
    assert -displacement(path, 65.0)[2] == pytest.approx(rise, rel=1e-4)
    force = path.rate_and_force(np.array([0.0, 35.0]))[1]
    assert force[0] == pytest.approx([GRAVITY, 0.0, 0.0], abs=1e-3)
    assert force[1, 0] > 60.0


def test_boost_begins_upright() -> None:
    with pytest.raises(
        TrajectoryError, match=r"climb angle of 0 deg, expected 90.*climb_angle_deg"
    ):
        fly_manoeuvres(Boost(speed=100.0, duration=10.0, vertical=2.0, climb_angle=1.0), speed=0.0)


def test_boost_needs_time_to_pitch_over() -> None:
    with pytest.raises(TrajectoryError, match=r"vertical_s: found 10, expected .* duration_s, 10"):
        fly_manoeuvres(
            Boost(speed=100.0, duration=10.0, vertical=10.0, climb_angle=1.0),
            speed=0.0,
            climb_angle=np.pi / 2,
        )


def test_given_sway_is_a_sine_of_its_amplitude_and_period() -> None:
    sway = Sway(roll=0.1, roll_period=12.0, heave=1.5, heave_period=8.0, ramp=10.0)
    path, _ = fly_manoeuvres(Straight(duration=120.0), speed=8.0, overlays=(sway,))
    time = np.linspace(20, 115, 700)
    roll, pitch, _ = euler(path, time).T
    assert roll == pytest.approx(0.1 * np.sin(2 * np.pi * time / 12), abs=1e-5)
    assert pitch == pytest.approx(np.zeros(700), abs=1e-9)
    heights = path.position(time)[:, 2]
    assert heights - HEIGHT == pytest.approx(1.5 * np.sin(2 * np.pi * time / 8), abs=2e-4)


def test_seeded_sway_has_the_rms_of_a_sine() -> None:
    """Over 3 h: 7 waves of one rms each; the same seed is the same sea, another is not."""
    seas = [Sway(roll=0.1, pitch=0.03, seed=seed) for seed in (3, 3, 4)]
    leg = Straight(duration=10_800.0)
    time = np.arange(100.0, 10_700.0, 0.5)
    angles = [euler(fly_manoeuvres(leg, speed=8.0, overlays=(sea,))[0], time) for sea in seas]
    assert np.std(angles[0][:, 0]) == pytest.approx(0.1 / np.sqrt(2), rel=0.05)
    assert np.std(angles[0][:, 1]) == pytest.approx(0.03 / np.sqrt(2), rel=0.05)
    assert np.array_equal(angles[0], angles[1])
    assert not np.allclose(angles[0], angles[2], atol=0.01)


def test_sway_lasts_as_long_as_it_says() -> None:
    sway = Sway(roll=0.1, start=30.0, duration=60.0, ramp=10.0)
    path, _ = fly_manoeuvres(Straight(duration=150.0), speed=8.0, overlays=(sway,))
    outside = np.concatenate([np.linspace(0, 29, 60), np.linspace(91.5, 145, 60)])
    assert euler(path, outside)[:, 0] == pytest.approx(np.zeros(120), abs=2e-5)
    assert np.max(euler(path, np.linspace(45, 75, 100))[:, 0]) == pytest.approx(0.1, rel=0.01)


def test_hills_pitch_and_lift() -> None:
    """Height: speed times the integral of the sine of the path's angle."""
    hills = Hills(climb_angle=np.deg2rad(2), period=310.0, ramp=1.0)
    path, end = fly_manoeuvres(
        Straight(duration=310.0),
        Accelerate(speed=20.0, duration=9.0),
        speed=20.0,
        overlays=(hills,),
    )
    time = np.linspace(5, 300, 200)
    angle = np.deg2rad(2) * np.sin(2 * np.pi * time / 310)
    assert euler(path, time)[:, 1] == pytest.approx(angle, abs=1e-6)
    assert path.position(np.array(155.0))[2] - HEIGHT == pytest.approx(
        20 * np.deg2rad(2) * 310 / np.pi, rel=1e-3
    )
    assert end == pytest.approx(319.0)
