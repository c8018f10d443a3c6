"""Scales and paths against what they say they draw."""

import re

import numpy as np
import pytest

from pyhrg.common.pages import svg


def test_a_log_scale_puts_decades_at_equal_distances() -> None:
    scale = svg.Scale(1.0, 1000.0, 0.0, 300.0)
    np.testing.assert_allclose(scale([1, 10, 100, 1000]), [0, 100, 200, 300], atol=1e-12)
    assert scale.ticks == [1, 10, 100, 1000]


def test_a_linear_scale_has_round_ticks_within() -> None:
    scale = svg.Scale(0.0, 2.0, 0.0, 100.0, log=False)
    assert float(scale(0.5)) == 25
    assert scale.ticks == [0, 0.5, 1, 1.5, 2]


@pytest.mark.parametrize(
    ("values", "limits"),
    [([3, 40], (1, 100)), ([0.02, np.nan, -5], (0.01, 0.1)), ([10, 10], (10, 100)), ([], (1, 10))],
)
def test_decades_hold_every_positive_value(
    values: list[float], limits: tuple[float, float]
) -> None:
    assert svg.find_decades(values) == pytest.approx(limits)


def test_points_lie_where_they_were_put_each_once() -> None:
    generator = np.random.default_rng(3)
    x, y = generator.uniform(70, 410, (2, 500))
    twice = svg.format_points(np.tile(x, 2), np.tile(y, 2))
    steps = re.findall(r"m(-?\d+)( |(?=-))(-?\d+)h0", twice)
    assert "".join(f"m{a}{gap}{b}h0" for a, gap, b in steps) == twice
    drawn = np.cumsum([(int(a), int(b)) for a, _, b in steps], axis=0)
    wanted = np.unique(np.rint(svg.GRID_DIVISIONS * np.stack([x, y], axis=1)), axis=0)
    np.testing.assert_array_equal(drawn, wanted)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0123456, "0.0123"),
        (3.4, "3.4"),
        (12345.0, "12,300"),
        (-0.5, "−0.5"),
        (0, "0"),
        (0.9996, "1"),
        (2.5e7, "2.5e+07"),
        (np.nan, "–"),
        (-np.inf, "−∞"),
    ],
)
def test_numbers_are_told_in_three_digits(value: float, text: str) -> None:
    assert svg.format_number(value) == text


@pytest.mark.parametrize(
    ("given", "texts"),
    [
        ((0.00656, -0.189, 0.188), ("0.01", "−0.19", "0.19")),
        ((0.9653, 0.9181, 0.9832), ("0.965", "0.918", "0.983")),
        ((-52.5, -131.2, -21.1), ("−52", "−131", "−21")),
        ((-0.001, -0.2, 0.2), ("0.00", "−0.20", "0.20")),
        ((0.001, 0.00098, 0.00103), ("0.001000", "0.000980", "0.001030")),
        ((2.68888e-6, 2.68798e-6, 2.68978e-6), ("2.68888e−06", "2.68798e−06", "2.68978e−06")),
        ((0.5, 0.5, 0.5), ("0.5", "0.5", "0.5")),
        ((0.5, np.nan, np.nan), ("0.5", "–", "–")),
        ((0.18 / 7, 0.18 / 7 - 1e-17, 0.18 / 7 + 1e-17), ("0.0257", "0.0257", "0.0257")),
    ],
)
def test_estimates_have_two_digits_of_their_interval(
    given: tuple[float, float, float], texts: tuple[str, str, str]
) -> None:
    assert svg.format_estimate(*given) == texts


def test_log_axes_are_named() -> None:
    x, y = svg.make_horizontal_scale(0.0, 1.0, log=False), svg.make_vertical_scale(1.0, 10.0)
    labels = re.findall(r'text-anchor="middle">(\D[^<]*)<', svg.draw_frame(x, y, "time", "error"))
    assert labels == ["time", "error, log axis"]


def test_ticks_are_short() -> None:
    ticks = [svg._format_short(value) for value in (0.1, 999.0, -1e5, 1e6, 2.5e6)]
    assert ticks == ["0.1", "999", "−100k", "1M", "2.5M"]
