"""Turns against closed forms of level flight."""

import numpy as np
import pytest

from ins_eval.common import earth
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.manoeuvres.manoeuvre import Entry
from ins_eval.trajectories.manoeuvres.straights import Straight
from ins_eval.trajectories.manoeuvres.turns import (
    CoordinatedTurn,
    FigureEight,
    STurn,
    Turn,
    UTurn,
    Weave,
)
from tests.ins_eval.trajectories.flights import (
    GRAVITY,
    HEIGHT,
    LATITUDE,
    displacement,
    euler,
    fly_manoeuvres,
)

BANK = np.deg2rad(30.0)
RADIUS = 200.0**2 / (GRAVITY * np.tan(BANK))


def circumradius(points: np.ndarray) -> float:
    a, b = points[1] - points[0], points[2] - points[0]
    c = b - a
    area = 0.5 * abs(a[0] * b[1] - a[1] * b[0])
    return float(np.linalg.norm(a) * np.linalg.norm(b) * np.linalg.norm(c) / (4 * area))


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_coordinated_turn_has_the_radius_of_its_bank(side: float) -> None:
    """v^2 / (g tan(bank)); it ends at its angle, level; the force stays in the symmetry plane."""
    path, end = fly_manoeuvres(CoordinatedTurn(turn=side * np.deg2rad(200), bank=BANK))
    points = np.array([displacement(path, t)[:2] for t in (20.0, 30.0, 40.0)])
    assert circumradius(points) == pytest.approx(RADIUS, rel=3e-4)
    assert euler(path, np.array(30.0))[0] == pytest.approx(side * BANK, abs=1e-6)
    assert euler(path, np.array(end))[[0, 2]] == pytest.approx(
        [0.0, side * (np.deg2rad(200) - 2 * np.pi)], abs=1e-4
    )
    force = path.rate_and_force(np.array(30.0))[1]
    assert abs(force[1]) < 0.03 < 0.1 * abs(force[2])


def test_turn_lasts_its_angle_over_its_rate() -> None:
    leg = CoordinatedTurn(turn=1.0, bank=BANK, ramp=4.0).leg(Entry(200.0, 0.0, 0.0, GRAVITY))
    assert leg.duration == pytest.approx(200.0 / (GRAVITY * np.tan(BANK)) + 4.0)


def test_small_turn_is_flown_at_less_bank() -> None:
    path, end = fly_manoeuvres(CoordinatedTurn(turn=np.deg2rad(2), bank=BANK, ramp=4.0))
    banks = euler(path, np.linspace(0, end, 200))[:, 0]
    assert np.max(banks) < 0.8 * BANK
    assert euler(path, np.array(end))[2] == pytest.approx(np.deg2rad(2), abs=1e-5)


def test_u_turn_comes_back_abeam_by_its_diameter() -> None:
    """The ramp is short, since ramps widen the turn a little."""
    path, end = fly_manoeuvres(UTurn(side="left", bank=BANK, ramp=0.5))
    assert displacement(path, end)[1] == pytest.approx(-2 * RADIUS, rel=1e-3)
    assert np.cos(euler(path, np.array(end))[2]) == pytest.approx(-1.0, abs=1e-8)


def test_s_turn_ends_abeam() -> None:
    """R (1 - cos) twice to the right, R sin twice on, and one ramp's way between the arcs, along
    the turned heading; at the ends, half a ramp's way each."""
    turn, ramp, speed = np.deg2rad(70), 0.5, 60.0
    path, end = fly_manoeuvres(STurn(turn=turn, bank=BANK, ramp=ramp), speed=speed)
    radius = speed**2 / (GRAVITY * np.tan(BANK))
    arcs = 2 * radius * np.array([np.sin(turn), 1 - np.cos(turn)])
    ramps = speed * ramp * np.array([1 + np.cos(turn), np.sin(turn)])
    assert displacement(path, end)[:2] == pytest.approx(arcs + ramps, rel=3e-4)
    assert euler(path, np.array(end)) == pytest.approx(np.zeros(3), abs=1e-4)


@pytest.mark.parametrize("ramp", [0.5, 4.0, 30.0])
def test_figure_eight_closes(ramp: float) -> None:
    """To 10 cm of 88 km. Half way it is off by what heading turns against a straight line on the
    Earth, the loop's area times tan(latitude) / radius; the second loop takes that back."""
    path, end = fly_manoeuvres(FigureEight(bank=BANK, ramp=ramp), heading=0.5)
    assert end > 440
    assert np.linalg.norm(displacement(path, end)) < 0.1
    east = np.pi * RADIUS**2 * np.tan(LATITUDE) / (earth.transverse_radius(LATITUDE) + HEIGHT)
    assert displacement(path, end / 2) == pytest.approx([0.0, east, 0.0], rel=0.02, abs=1e-3)
    assert np.linalg.norm(displacement(path, end / 4)[:2]) > RADIUS
    assert euler(path, np.array(end))[2] == pytest.approx(0.5, abs=1e-6)


def test_flat_and_outward_leaning_turns() -> None:
    """`lean` is the share of the coordinated bank."""
    middle = np.array(10.0)
    right = {"turn": np.deg2rad(90), "duration": 20.0}
    banks = [
        euler(fly_manoeuvres(Turn(**right, lean=x), speed=15.0)[0], middle)[0]
        for x in (0, 1, -0.15)
    ]
    rate = np.deg2rad(90) * 1.5 / 20
    assert banks[0] == pytest.approx(0.0, abs=1e-9)
    assert banks[1] == pytest.approx(np.arctan(15 * rate / GRAVITY), rel=1e-3)
    assert banks[2] == pytest.approx(-0.15 * banks[1], rel=1e-9)


def test_weave_swings_its_heading() -> None:
    amplitude = np.deg2rad(20)
    path, _ = fly_manoeuvres(Weave(heading=amplitude, period=60.0, duration=240.0), speed=250.0)
    time = np.linspace(0, 235, 500)
    roll, _, yaw = euler(path, time).T
    assert yaw == pytest.approx(amplitude * np.sin(2 * np.pi * time / 60), abs=1e-6)
    rate = amplitude * 2 * np.pi / 60 * np.cos(2 * np.pi * time / 60)
    assert roll == pytest.approx(np.arctan(250 * rate / GRAVITY), abs=1e-4)


def test_swelling_weave_begins_and_ends_level() -> None:
    path, end = fly_manoeuvres(Weave(heading=0.2, period=30.0, duration=180.0, ramp=30.0))
    ends = euler(path, np.array([0.0, end]))
    assert ends == pytest.approx(np.zeros((2, 3)), abs=2e-3)


def test_weave_without_a_ramp_fits_its_own_kind_alone() -> None:
    """Otherwise its bank would jump."""
    weave = Weave(heading=0.2, period=30.0, duration=60.0)
    assert fly_manoeuvres(weave, weave)[1] == pytest.approx(120.0)
    for others in ((weave, Straight(duration=10.0)), (Straight(duration=10.0), weave)):
        with pytest.raises(TrajectoryError, match=r"course 2: turns at .* give a weave a ramp_s"):
            fly_manoeuvres(*others)


def test_standing_vehicle_does_not_turn() -> None:
    with pytest.raises(TrajectoryError, match=r"course 1: speed: found 0 m/s .* at least 0\.1"):
        fly_manoeuvres(UTurn(side="right"), speed=0.0)


def test_heights_hold_through_turns() -> None:
    path, end = fly_manoeuvres(CoordinatedTurn(turn=6.0, bank=BANK), UTurn(side="left"))
    heights = path.position(np.linspace(0, end, 300))[:, 2]
    assert heights == pytest.approx(np.full(300, HEIGHT), abs=1e-6)
