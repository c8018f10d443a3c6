"""What the panels, bars and figures show against the diagnosis."""

import re

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC, DEG_PER_H
from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.findings.diagnosis import GapFigure
from pyhrg.gap.report.closing import compute_reduction_interval
from pyhrg.gap.report.figures.panels import ALL, compute_panels
from pyhrg.gap.report.figures.views import VIEWS, compute_axis_values, find_moving_axes
from pyhrg.gap.report.places import build_places, build_scales
from pyhrg.gap.report.residuals import build_held_out


def test_a_gap_is_outside_the_band_before_and_inside_after(with_gap: CampaignDiagnosis) -> None:
    pooled = {
        (p.view.key, p.axis.key): p.means for p in compute_panels(with_gap).panels if p.test == ALL
    }
    force = pooled["amplitude_force", "wave_angle"]
    assert force.count_outside(force.before) > 0.8 * len(force.centres)
    counts = [(m.count_outside(m.after), len(m.centres)) for m in pooled.values()]
    outside, bins = np.sum(counts, axis=0)
    assert outside < 0.15 * bins


def test_single_tests_are_drawn_along_what_they_move_along(with_gap: CampaignDiagnosis) -> None:
    drawn = compute_panels(with_gap)
    assert not drawn.left_out
    still = {p.axis.key for p in drawn.panels if p.test == "still"}
    assert still == {"time"}
    warm = {p.axis.key for p in drawn.panels if p.test == "warm"}
    assert warm == {"temperature", "temperature_rate", "time"}
    slow = next(t for t in with_gap.tests if t.test.id == "slow")
    assert "rate" in {a.key for a in find_moving_axes(compute_axis_values(slow, with_gap.nominal))}


def test_the_rate_is_the_change_of_the_angle() -> None:
    angle, rate = VIEWS[:2]
    residual = np.array([0.0, 2.0, np.nan, 8.0]) * ARCSEC
    assert angle.convert(residual, 2.0) == pytest.approx([0, 2, np.nan, 8], nan_ok=True)
    expected = 1.0 * ARCSEC / DEG_PER_H
    assert rate.convert(residual, 2.0) == pytest.approx(
        [np.nan, expected, np.nan, np.nan], nan_ok=True
    )


def test_shares_add_up(with_gap: CampaignDiagnosis) -> None:
    assert sum(w.share for w in with_gap.diagnosis.where) == pytest.approx(1)
    assert "100\u00a0%" in build_places(with_gap)


def test_a_figure_for_each_held_out_test(with_gap: CampaignDiagnosis) -> None:
    held = [t for t in with_gap.tests if t.test.is_holdout]
    assert len(re.findall("<figure>", build_held_out(with_gap))) == len(held) == 1


def test_shrink_lies_between_its_ends() -> None:
    figure = GapFigure(before=10.0, after=1.5, floor=1.0, floor_95=(0.5, 2.0))
    low, high = compute_reduction_interval(figure)
    assert low == pytest.approx(100 * 8.5 / 9.5)
    assert high == pytest.approx(100 * 8.5 / 8)
    assert low < 100 * 8.5 / 9 < high


def test_what_was_found_leaves_next_to_nothing_beyond_the_noise(
    with_gap: CampaignDiagnosis,
) -> None:
    sizes = with_gap.diagnosis.sizes
    assert max(s.before for s in sizes) > 50
    assert max(s.after for s in sizes) < 15
    assert "<details open>" in build_scales(with_gap)
    assert len(re.findall("<details", build_scales(with_gap))) == len({s.scale_s for s in sizes})
