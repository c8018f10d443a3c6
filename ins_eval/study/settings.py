"""Settings of gyros, bench and drift in a study file: keys, units and ranges.

Each table of the file sets fields of a dataclass (`experiment.DEFAULT_SETTINGS`). A field that the
file does not set keeps its default.
"""

from collections.abc import Mapping

from pyhrg.common.keys import Key, read_fields
from pyhrg.common.toml_table import TomlTable
from pyhrg.common.units import DEG_PER_H, HOUR

Settings = Mapping[str, float]
"""Values of a dataclass's fields, SI."""


_POPULATION = (
    Key("smallest_deg_h", "smallest", DEG_PER_H, 1e-4, 100),
    Key("largest_deg_h", "largest", DEG_PER_H, 1e-4, 100),
    Key("common_share", "common", 1, 0, 1),
)
_PLAN = (
    Key("runs", "runs", 1, 1, 100, whole=True),
    Key("fixed_runs", "fixed_runs", 1, 2, 100, whole=True),
    Key("positions", "positions", 1, 16, 720, whole=True),  # nine terms of a map
    Key("segments", "segments", 1, 1, 36, whole=True),
    Key("fixed_segments", "fixed_segments", 1, 2, 360, whole=True),
    Key("periods", "periods", 1, 1, 100, whole=True),
)
SETTING_TABLES: Mapping[str, tuple[Key, ...]] = {
    "trimmed": _POPULATION,
    "raw": _POPULATION,
    "calibration": _PLAN,
    "bench": _PLAN,
    "drift": (
        Key("age_days", "age", 24 * HOUR, 0, 7300),
        Key("coolest_K", "coolest", 1, -80, 80),
        Key("warmest_K", "warmest", 1, -80, 80),
    ),
}
"""Keys by table: gyros that are calibrated at the mean, gyros whose map is calibrated, the maker's
tests, the bench's tests, and what changes between calibration and flight."""
ORDERED_PAIRS = (
    ("trimmed", "smallest", "largest"),
    ("raw", "smallest", "largest"),
    ("drift", "coolest", "warmest"),
)
"""Table, lower and upper end of each range; a file states both ends or neither."""


def read_settings(top: TomlTable) -> dict[str, Settings]:
    """Settings of the tables that a study file has.

    Raises:
        HrgError: an unknown key, a value out of range, a range of which one end is
            missing or whose lower end is above the upper one.
    """
    read: dict[str, Settings] = {
        name: read_fields(top.table(name), SETTING_TABLES[name])
        for name in SETTING_TABLES
        if name in top.values
    }
    for name, low, high in ORDERED_PAIRS:
        if name in read:
            _check_ends(top.table(name), read[name], low, high)
    return read


def _check_ends(table: TomlTable, found: Settings, low: str, high: str) -> None:
    keys = {key.field: key.name for key in SETTING_TABLES[table.prefix.removesuffix(".")]}
    for one, other in ((low, high), (high, low)):
        if one in found and other not in found:
            raise table.missing(keys[other], f"a number beside {keys[one]}")
    if low in found and found[low] > found[high]:
        raise table.error(keys[high], table.values[keys[high]], f"{keys[low]} or more")
