"""Names and numbers as people read them."""

import pytest

from pyhrg.device.declarations import format_effect
from pyhrg.gap.effects.catalogue import DETERMINISTIC, NOISES
from pyhrg.gap.report.words import (
    format_percent,
    join_words,
    parse_parameter,
)


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("damping_anisotropy_per_s", ("damping anisotropy", "1/s", 1.0)),
        ("bias_deg_h_per_g", ("bias", "deg/h/g", 1.0)),
        ("angle_random_walk_deg_sqrt_h", ("angle random walk", "deg/√h", 1.0)),
        ("rate_random_walk_deg_h_sqrt_h", ("rate random walk", "deg/h/√h", 1.0)),
        ("phase_rad_per_K", ("phase", "rad/K", 1.0)),
        ("pickoff_gain_mismatch", ("pickoff gain mismatch", "ppm", 1e6)),
        ("lost_rows_percent", ("lost rows", "%", 1.0)),
        ("axis_up_sign", ("axis up sign", "", 1.0)),
    ],
)
def test_a_parameter_has_words_and_a_unit(name: str, expected: tuple[str, str, float]) -> None:
    assert parse_parameter(name) == expected


def test_no_unit_is_left_in_the_words_of_the_catalogue() -> None:
    keys = [key for e in DETERMINISTIC for key in e.keys] + [e.key for e in NOISES]
    for key in keys:
        words = parse_parameter(key.name)[0].split()
        assert not {"deg", "h", "per", "K", "g", "s", "rad", "Hz", "ppm", "arcsec"} & set(words)


def test_nothing_is_certain() -> None:
    assert format_percent(1.0) == ">\u00a099.9\u00a0%"
    assert format_percent(0.999) == "99.9\u00a0%"
    assert format_percent(1e-9) == "<\u00a00.1\u00a0%"
    assert format_percent(0.0) == "0.0\u00a0%"


def test_lists() -> None:
    assert join_words(["a"]) == "a"
    assert join_words(["a", "b", "c"]) == "a, b and c"
    assert join_words([]) == ""


def test_names_keep_their_letters() -> None:
    assert format_effect("g_sensitive_bias") == "g-sensitive bias"
    assert format_effect("coriolis_factor_error") == "Coriolis factor error"
