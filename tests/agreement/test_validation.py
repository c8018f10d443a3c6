"""Every model of `HRG.Validation` keeps its claim at all angles, with a signature that is seen, and
with nothing to be seen where the mechanism is absent."""

import re
from collections.abc import Callable, Iterator

import pytest

from tests.agreement import reference_results
from tests.agreement.claims import CLAIMS, SLOW_CLAIMS, Demonstration, Result, demonstrations
from tests.modelica.catalogue import read_catalogue_numbers
from tests.modelica.models import Model

Demonstrate = Callable[[Model], Demonstration]
ALL = [*CLAIMS, *SLOW_CLAIMS]
over_claims = pytest.mark.parametrize("claim", ALL, ids=lambda c: c.name)


@pytest.fixture(scope="module")
def demonstrate() -> Iterator[Demonstrate]:
    with demonstrations(ALL) as running:
        yield lambda claim: running[claim.name].result()


def misses(results: list[Result], tolerance: float) -> list[str]:
    """Results that are off by more than the tolerance, in words."""
    return [
        f"from {r.start_angle:.3f} rad: measured {r.measured:.6g}, expected {r.expected:.6g}, "
        f"off by {abs(r.measured - r.expected) / r.scale:.2g} of {r.scale:.3g}"
        for r in results
        if not abs(r.measured - r.expected) <= tolerance * r.scale
    ]


@over_claims
def test_claim_holds(claim: Model, demonstrate: Demonstrate) -> None:
    shown = demonstrate(claim)
    assert not (found := misses(list(shown.shown), shown.tolerance)), "\n".join(found)


@over_claims
def test_signature_is_large_and_its_tolerance_small(claim: Model, demonstrate: Demonstrate) -> None:
    shown = demonstrate(claim)
    assert 0 < shown.tolerance <= 0.2
    assert all(r.scale > 0 for r in shown.shown)
    assert max(abs(r.expected) / r.scale for r in shown.shown) >= 0.5


@over_claims
def test_nothing_is_measured_without_the_mechanism(claim: Model, demonstrate: Demonstrate) -> None:
    shown = demonstrate(claim)
    scale = max(r.scale for r in shown.shown)
    absent = [Result(r.start_angle, r.measured, 0.0, scale) for r in shown.control]
    assert not (found := misses(absent, shown.tolerance)), "\n".join(found)


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda c: c.name)
def test_result_has_not_drifted(claim: Model, demonstrate: Demonstrate) -> None:
    reference = reference_results.read(claim.name)
    present = demonstrate(claim).shown
    assert len(reference) == len(present)
    moved = [
        Result(now.start_angle, now.measured, before.measured, before.scale)
        for now, before in zip(present, reference, strict=True)
    ]
    assert [r.start_angle for r in reference] == pytest.approx([r.start_angle for r in present])
    assert not (found := misses(moved, reference_results.DRIFT)), "\n".join(found)


def test_every_reference_result_has_its_model() -> None:
    folder = reference_results.reference_path("").parent
    expected = {reference_results.reference_path(claim.name) for claim in CLAIMS}
    assert set(folder.iterdir()) == expected


def test_every_mechanism_of_the_catalogue_is_claimed() -> None:
    """By the number that an info page names."""
    named = {int(n) for c in CLAIMS for n in re.findall(r"[Mm]echanism (\d+)", c.info)}
    assert named == read_catalogue_numbers()
