"""Effects and known parameters that explain about as much in each other's place."""

import numpy as np
import pytest

from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import EFFECTS, Effect
from pyhrg.gap.effects.known_parameters import KnownParameters
from pyhrg.gap.evidence.equivalence.known_equivalents import find_known_equivalents
from pyhrg.gap.evidence.evidence import fit
from tests.pyhrg.gap.made_up import design_of

ROTATION, DELAY = EFFECTS["drive_frame_rotation"], EFFECTS["loop_delay"]
LATITUDE, OFFSET = EFFECTS["site_latitude"], EFFECTS["thermometer_offset"]
SCALES = {ROTATION: 1e7, LATITUDE: 1e4, OFFSET: 5.0}
"""Sigma per unit."""


@pytest.mark.parametrize(
    ("cause", "other", "size", "tolerance"),
    [
        (ROTATION, LATITUDE, 12.0, 1.0),
        (ROTATION, LATITUDE, 40.0, 10.0),
        (LATITUDE, ROTATION, 12.0, 1.0),
        (LATITUDE, ROTATION, 40.0, 10.0),
        (LATITUDE, OFFSET, 12.0, 1.0),
    ],
)
@pytest.mark.parametrize(("correlation", "are_equivalent"), [(1.0, True), (0.9, False)])
def test_each_names_the_other(
    cause: Effect,
    other: Effect,
    size: float,
    tolerance: float,
    correlation: float,
    are_equivalent: bool,
) -> None:
    """Size and tolerance are in sigma of these rows: a known parameter is beyond its own. With a
    correlation of 0.9 the other leaves a chi-square of 27. A size of four tolerances is not
    very improbable, but an effect that leaves it so is none in its place."""
    draws = np.random.default_rng(1).normal(size=(400, 3))
    unit, across, third = np.linalg.qr(draws)[0].T
    same = correlation * unit + np.sqrt(1 - correlation**2) * across
    columns = {cause: SCALES[cause] * unit, other: -SCALES[other] * same, DELAY: 1e5 * third}
    design = design_of({e: column[:, None] for e, column in columns.items()}, size * unit)
    tolerances = {e: tolerance / SCALES[e] for e in (cause, other) if e.family != "gyro"}
    known = KnownParameters(design, tolerances)
    best = fit(known.marginal, [cause] if cause.family == "gyro" else [])
    assert best is not None
    found = find_known_equivalents(known, best, Device(), cause, [other, DELAY])
    assert found == ((other.name,) if are_equivalent else ())


@pytest.mark.parametrize("size", [13.0, 16.0, 25.0])
def test_what_explains_nothing_is_no_equivalent(size: float) -> None:
    """Of a latitude that is hardly beyond its tolerance of 10 sigma."""
    unit, third = np.linalg.qr(np.random.default_rng(1).normal(size=(400, 2)))[0].T
    residual = size * unit + 0.5 * third
    design = design_of({LATITUDE: 1e4 * unit[:, None], DELAY: 1e5 * third[:, None]}, residual)
    known = KnownParameters(design, {LATITUDE: 1e-3})
    best = fit(known.marginal, [])
    assert best is not None
    assert find_known_equivalents(known, best, Device(), LATITUDE, [DELAY]) == ()
