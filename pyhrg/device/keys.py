"""Keys of a device file: each with its unit, its range, and the field that it sets."""

from dataclasses import fields

from pyhrg.common.toml_table import Key
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H
from pyhrg.device.declarations import read_declarations
from pyhrg.device.device import AngleMap, Device

KEYS = tuple(
    Key(name, field, declaration.unit, *declaration.limits, declaration.zero)
    for field, declaration in read_declarations(Device).items()
    for name in declaration.keys
)
"""Keys at the top of a device file. Where two keys set a field, the first is written."""

SITE_KEYS = (
    Key("latitude_deg", "latitude", DEG, -90, 90),
    Key("gravity_m_s2", "gravity", 1, 9.7, 9.9),
)

MAPS = {
    "bias_map": tuple(Key(f.name, f.name, DEG_PER_H, -1e4, 1e4) for f in fields(AngleMap)),
    "scale_factor_map": tuple(
        Key(f.name, f.name, ARCSEC, -2e4, 2e4) for f in fields(AngleMap) if f.name != "mean"
    ),
}
"""Keys of the tables of Fourier coefficients over the pattern angle, by the device's field."""
