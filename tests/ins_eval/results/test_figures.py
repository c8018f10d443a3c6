"""Figures of flights: what is drawn, where."""

from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from ins_eval.results import flights, map_figure
from ins_eval.results.growth_figure import draw_growth
from ins_eval.results.map_figure import draw_map
from ins_eval.results.png import save_png
from tests.ins_eval.results.cases import dataset, track


def labels(figure: Figure, axis: str) -> list[str]:
    figure.canvas.draw()
    ticks = getattr(figure.axes[0], f"get_{axis}ticklabels")()
    return [tick.get_text() for tick in ticks]


def test_no_line_jumps_across_the_dateline() -> None:
    figure = draw_map(dataset(longitude_deg=177.0))
    for line in figure.axes[0].get_lines():
        assert np.max(np.abs(np.diff(np.asarray(line.get_xdata(), dtype=float))), initial=0) < 1.1
    texts = labels(figure, "x")
    assert any(text.endswith("E") for text in texts)
    assert any(text.endswith("W") for text in texts)
    assert "180°" in texts


@pytest.mark.parametrize("near", [-179.0, 179.0, 0.0])
def test_unwrapped_longitudes_are_continuous_and_near(near: float) -> None:
    around = (np.arange(-4.0, 5.0) + near + 180) % 360 - 180
    expected = near + np.arange(-4.0, 5.0)
    np.testing.assert_allclose(map_figure.unwrap_deg(around, near), expected)


def test_map_is_true_to_length_at_its_middle() -> None:
    figure = draw_map(dataset())
    assert figure.axes[0].get_aspect() == pytest.approx(1 / np.cos(np.deg2rad(45)), rel=5e-3)


def test_scale_bar_is_as_long_as_it_says() -> None:
    figure = draw_map(dataset())
    axes = figure.axes[0]
    (bar,) = (patch for patch in axes.patches if patch.get_height() == pytest.approx(0.012))
    (text,) = (t.get_text() for t in axes.texts)
    _, east = map_figure.find_metres_per_degree(45.0)
    assert text.endswith(" km")
    assert bar.get_width() * east == pytest.approx(1000 * float(text.removesuffix(" km")), rel=1e-3)


@pytest.mark.parametrize(
    ("limit", "length"), [(1.0, 1.0), (1.99, 1.0), (4999.0, 2000.0), (5000.0, 5000.0), (0.3, 0.2)]
)
def test_round_lengths(limit: float, length: float) -> None:
    assert map_figure.find_round_length(limit) == pytest.approx(length)


def test_without_truth_only_the_path() -> None:
    assert len(draw_map(flights.tabulate_navigated([track(3.0, 0.0)])).axes) == 1


def test_vehicle_that_stays_can_be_drawn() -> None:
    still = track(0.0, 0.0)
    still.position[:] = still.position[0]
    still.velocity[:] = 0.0
    figure = draw_map(flights.compare_with_truth([still], still))
    assert np.ptp(figure.axes[0].get_ylim()) * 111_000 == pytest.approx(
        map_figure.SMALLEST, rel=0.01
    )


def test_growth_is_drawn_with_the_sigma_around_zero() -> None:
    data = dataset(runs=3)
    figure = draw_growth(data)
    north = figure.axes[0]
    assert len(north.get_lines()) == 3
    (band,) = north.collections
    top = np.max(band.get_paths()[0].vertices[:, 1])
    bottom = np.min(band.get_paths()[0].vertices[:, 1])
    assert top == pytest.approx(float(data["north_sigma"].max()))
    assert bottom == pytest.approx(-top)


def test_growth_without_a_linear_model_has_no_band() -> None:
    assert not draw_growth(dataset(sigma=False)).axes[0].collections


@pytest.mark.parametrize("draw", [draw_map, draw_growth])
def test_same_flights_same_png(draw, tmp_path: Path) -> None:
    for name in ("a.png", "b.png"):
        save_png(draw(dataset()), tmp_path / name)
    first = (tmp_path / "a.png").read_bytes()
    assert first.startswith(b"\x89PNG")
    assert first == (tmp_path / "b.png").read_bytes()
