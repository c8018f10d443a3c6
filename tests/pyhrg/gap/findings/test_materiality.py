"""Size of what an explanation leaves."""

import pytest

from pyhrg.gap.evidence.noise.noise_hypothesis import NoiseHypothesis, UnnamedNoise
from pyhrg.gap.findings.diagnosis import GapFigure
from pyhrg.gap.findings.materiality import MIN_RATE_TIME, compute_excess, measure_unnamed_noise
from pyhrg.gap.whitening.whitening import CorrelatedNoise, NoiseModel


@pytest.mark.parametrize(
    ("lag", "of_rate", "expected"),
    [
        (1e4, True, (0.0, 1e-9)),
        (MIN_RATE_TIME / 200, True, (0.0, 1e-10)),
        (30.0, False, (1e-9, 0.0)),
    ],
)
def test_a_noise_without_a_name_has_its_own_size(
    lag: float, of_rate: bool, expected: tuple[float, float]
) -> None:
    unnamed = UnnamedNoise(CorrelatedNoise(1e-9, lag, of_rate), -5.0)
    hypothesis = NoiseHypothesis(NoiseModel(1e-7), (), 0.0, unnamed)
    assert measure_unnamed_noise(hypothesis) == pytest.approx(expected)
    assert measure_unnamed_noise(NoiseHypothesis(NoiseModel(1e-7), ())) == (0.0, 0.0)


@pytest.mark.parametrize(("after", "excess"), [(1.1, 0.0), (1.19, 0.0), (2.0, 1.6)])
def test_an_excess_is_beyond_noise_and_uncertain_parameters(after: float, excess: float) -> None:
    figure = GapFigure(5.0, after, 0.4, (0.2, 1.0))
    assert compute_excess(figure) == pytest.approx(excess)
