"""The navigator's own error on error-free increments, height clamped."""

import numpy as np
import pytest
from numpy.random import default_rng

from benchmarks.navigation.motions import Flight, coning, static, weaving
from benchmarks.navigation.weave import Weave
from ins_eval.common.state import Track
from ins_eval.navigation.coefficients import SAMPLES_PER_STEP
from pyhrg.common.units import DEG_PER_H

HOUR = 3600
TWO_MINUTES = 120
PRO_RATA = 3e-3 * TWO_MINUTES / HOUR
"""3 mm in an hour, scaled to two minutes, m."""


def horizontal(flight: Flight, track: Track) -> float:
    """Largest, m."""
    return float(np.max(np.linalg.norm(flight.error(track).position[:, :2], axis=1)))


@pytest.fixture(scope="module", params=[(100, 3e-3), (200, 1e-3)], ids=["100 Hz", "200 Hz"])
def hour_of_weaving(request: pytest.FixtureRequest) -> tuple[Flight, float]:
    rate, limit = request.param
    return weaving(Weave(), HOUR, rate), limit


@pytest.mark.parametrize("samples", SAMPLES_PER_STEP)
def test_weaving_aircraft(hour_of_weaving: tuple[Flight, float], samples: int) -> None:
    """250 m/s, heading 20 deg sin(2 pi t/60 s), 45 N: 3 mm at 100 Hz, 1 mm at 200 Hz in 1 h."""
    flight, limit = hour_of_weaving
    assert horizontal(flight, flight.flown(samples)) <= limit


@pytest.mark.parametrize("samples", SAMPLES_PER_STEP)
@pytest.mark.parametrize(("hours", "rate"), [(1, 100), (24, 20)])
def test_static(hours: int, rate: int, samples: int) -> None:
    """0.1 mm, tilted: rounding does not add up either."""
    flight = static(hours * HOUR, rate)
    assert horizontal(flight, flight.flown(samples)) <= 1e-4


@pytest.mark.parametrize("samples", SAMPLES_PER_STEP)
def test_error_falls_as_the_square_of_the_step_or_better(samples: int) -> None:
    errors = []
    for rate in (10, 20, 40):
        flight = weaving(Weave(), 1200, rate)
        errors.append(horizontal(flight, flight.flown(samples)))
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert np.all(orders > 2.0), orders


def test_coning_through_the_whole_navigator() -> None:
    """1 deg at 2 Hz, four samples at 100 Hz: <= 1e-5 deg/h in attitude; two samples would not."""
    flight = coning(np.deg2rad(1.0), 2.0, 600, 100)

    def drift(samples: int) -> float:
        error = flight.error(flight.flown(samples))
        return float(np.linalg.norm(error.attitude[-1]) / error.time[-1] / DEG_PER_H)

    assert drift(4) <= 1e-5
    assert drift(2) > 1e-5


def anywhere(seed: int) -> Weave:
    """A flight from a random place in a random direction."""
    random = default_rng(seed)
    return Weave(
        latitude=np.deg2rad(random.uniform(-80, 89)),
        longitude=random.uniform(-np.pi, np.pi),
        height=random.uniform(-1e3, 2e4),
        heading=random.uniform(-np.pi, np.pi),
    )


@pytest.mark.parametrize("seed", range(12))
def test_as_accurate_anywhere_in_any_direction(seed: int) -> None:
    flight = weaving(anywhere(seed), TWO_MINUTES, 100)
    assert horizontal(flight, flight.flown(2)) < PRO_RATA


@pytest.mark.parametrize(
    ("longitude_deg", "heading_deg"), [(179.99, 90.0), (-179.99, -90.0), (180.0, 0.0)]
)
@pytest.mark.parametrize("latitude_deg", [-45.0, 0.0, 45.0, 89.0])
def test_as_accurate_across_the_dateline(
    latitude_deg: float, longitude_deg: float, heading_deg: float
) -> None:
    start = np.deg2rad([latitude_deg, longitude_deg, heading_deg])
    flight = weaving(Weave(start[0], start[1], heading=start[2]), TWO_MINUTES, 100)
    track = flight.flown(2)
    assert horizontal(flight, track) < PRO_RATA
    along = np.append(flight.start().longitude, track.position[:, 1])
    assert np.all(np.abs(np.diff(along)) < np.pi)


@pytest.mark.parametrize(("speed", "height"), [(3000.0, 1e5), (3000.0, 0.0), (0.1, -1e3)])
def test_fast_high_and_low(speed: float, height: float) -> None:
    """3 km/s that weaves little enough for a missile (8 g)."""
    weave = Weave(speed=speed, height=height, swing=np.deg2rad(10.0))
    flight = weaving(weave, 300, 100)
    assert horizontal(flight, flight.flown(2)) < 1e-3


def test_the_dateline_changes_nothing() -> None:
    """One flight at longitude 0 and across the dateline ends at the same error."""
    errors = []
    for longitude in (0.0, np.pi - 1e-4):
        flight = weaving(Weave(longitude=longitude, heading=np.pi / 2), 120, 50)
        errors.append(flight.error(flight.flown(2)).position[-1])
    assert errors[0] == pytest.approx(errors[1], abs=1e-8)
