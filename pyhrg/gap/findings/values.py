"""Values that several parts of `diagnosis.json` have."""

import math
from typing import Any

from pyhrg.common.toml_table import TomlTable


def parse_numbers(table: TomlTable) -> dict[str, float]:
    """Finite numbers by key."""
    return {name: table.finite_number(name) for name in table.values}


def parse_interval(table: TomlTable, key: str) -> tuple[float, float]:
    """Two numbers in order; an error of the table where they are not."""
    low, high = table.numbers(key, 2, -math.inf, math.inf)
    if low > high:
        raise table.error(key, table.values[key], "[low, high]")
    return low, high


STAGES = ("before", "after", "floor", "floor_95")
ROLES = ("fit", "holdout")
FIGURE_UNITS = ("angle_arcsec", "rate_deg_h", "area_arcsec")


def make_gap_table(gap: dict[str, Any]) -> dict[str, Any]:
    """Tables of stages, in them tables of roles, in them figures by their units."""
    document: dict[str, Any] = {
        stage: {
            role: {
                unit: gap[f"{role}_{unit}"][stage]
                for unit in FIGURE_UNITS
                if gap.get(f"{role}_{unit}") is not None
            }
            for role in ROLES
        }
        for stage in STAGES
    }
    return {**document, "shrink_percent": gap["shrink_percent"], "whiteness": gap["whiteness"]}
