"""Drawings against what they say they draw."""

import re

import numpy as np
import pytest

from pyhrg.gap.report.figures.strips import LEFT, TOP, Band, Labels, Size, Strip, draw_strips

SIZE = Size(420, 112, 5)
X = np.array([0.0, 1.0, 2.0])
BAND = Band(X, np.full(3, 0.1), 1.0)
LABELS = Labels("Rate, deg/s", "Angle, arcsec", "what it shows")


def strokes(svg: str) -> list[list[tuple[float, ...]]]:
    paths = re.findall(r'class="strokes[^>]* d="([^"]*)"', svg)
    return [
        [tuple(map(float, p)) for p in re.findall(r"[ML]([\d.]+) ([\d.]+)V([\d.]+)", path)]
        for path in paths
    ]


def strip(high: float, label: str = "before") -> Strip:
    values = np.array([0.0, high / 2, high])
    return Strip(label, "c1", X, values, values)


def test_values_lie_on_their_scale() -> None:
    (drawn,) = strokes(draw_strips([strip(10.0)], BAND, SIZE, LABELS))
    x, low, high = np.array(drawn).T
    assert low == pytest.approx(high)
    assert np.diff(x)[0] == pytest.approx(np.diff(x)[1], abs=0.11)
    assert np.diff(low)[0] == pytest.approx(np.diff(low)[1], abs=0.11)
    assert x.min() > LEFT
    assert TOP < low.min() < low.max() < TOP + SIZE.strip


def test_strips_of_like_range_have_the_same_scale() -> None:
    near = strokes(draw_strips([strip(10.0), strip(5.0)], BAND, SIZE, LABELS))
    far = strokes(draw_strips([strip(10.0), strip(0.5)], BAND, SIZE, LABELS))
    rise = [[s[0][1] - s[-1][1] for s in drawn] for drawn in (near, far)]
    assert rise[0][1] == pytest.approx(rise[0][0] / 2, abs=0.2)
    assert rise[1][1] > rise[1][0] / 2


def test_the_band_is_around_zero() -> None:
    svg = draw_strips([strip(10.0)], Band(X, np.full(3, 5.0), 1.0), SIZE, LABELS)
    corners = re.findall(r"M[\d.]+ ([\d.]+)H[\d.]+V([\d.]+)H", svg)
    (points,) = strokes(svg)
    ten = points[0][1] - points[2][1]
    assert len(corners) == 3
    for low, high in corners:
        assert abs(float(low) - float(high)) == pytest.approx(ten, abs=0.2)
        assert (float(low) + float(high)) / 2 == pytest.approx(points[0][1], abs=0.2)


def test_nothing_at_all_can_be_drawn() -> None:
    flat = Strip("before", "c1", X, np.zeros(3), np.zeros(3))
    svg = draw_strips([flat], Band(X, np.zeros(3), 0.0), SIZE, LABELS)
    assert "nan" not in svg
    assert "inf" not in svg
