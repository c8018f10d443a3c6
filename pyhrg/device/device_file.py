"""Devices as TOML files, with the keys and units of the record format."""

from collections.abc import Collection, Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any

import tomli_w

from pyhrg.common.files import write_whole
from pyhrg.common.site import Site
from pyhrg.common.toml_table import Key, TomlTable, read_fields, read_table
from pyhrg.device.device import FMU_NAMES, AngleMap, Device
from pyhrg.device.keys import KEYS, MAPS, SITE_KEYS

TABLES = (*MAPS, "site", "specification", "model", "turn_on_scatter")

NOMINAL = (
    "coriolis_factor",
    "decay_time_s",
    "frequency_Hz",
    "frequency_temperature_coefficient_per_K",
    "decay_time_temperature_coefficient_per_K",
    "thermal_lag_s",
    "control_period_s",
    "amplitude",
    "amplitude_loop_rad_s",
    "quadrature_loop_rad_s",
    "phase_loop_rad_s",
    "reference_temperature_degC",
)
"""Keys of design values: known before any test, while errors are for the tests to find."""


def read(path: Path) -> Device:
    """The device in a TOML file; an empty file is an ideal gyro.

    At the top stand `name` and the keys of `pyhrg.device.keys.KEYS`; tables are `[bias_map]`
    (deg/h), `[scale_factor_map]` (arcsec of pattern angle), `[site]`, `[specification]` (limits by
    finding), `[model]` (other parameters of the FMU, by its names, SI) and `[turn_on_scatter]`
    (standard deviations of parameters of the FMU from power-on to power-on, by its names, SI).
    """
    return _read_device(read_table(path))


def from_table(document: Mapping[str, Any], source: str) -> Device:
    """The device with the keys and values of a device file, such as a campaign's `nominal`; the
    source is their file or place, for messages."""
    return _read_device(TomlTable(source, "", document))


def write(device: Device, path: Path) -> None:
    """Write the values of a device that differ from an ideal gyro's.

    The file appears whole or not at all. A device that was read from a file reads back to the same
    bits; any other to the nearest values that numbers in the file's units give.
    """
    ideal = Device()
    document: dict[str, Any] = {"name": device.name} if device.name else {}
    document |= _write_keys(KEYS, device, ideal)
    for table, coefficients in MAPS.items():
        document[table] = _write_keys(coefficients, getattr(device, table), AngleMap())
    document["site"] = _write_keys(SITE_KEYS, device.site, ideal.site)
    document["specification"] = dict(device.specification)
    document["turn_on_scatter"] = dict(device.turn_on_scatter)
    document["model"] = dict(device.model)
    kept = {key: value for key, value in document.items() if value != {}}
    write_whole(path, tomli_w.dumps(kept).encode())


def nominal(device: Device) -> dict[str, float]:
    """Design values of a device by the keys `NOMINAL`, in the keys' units."""
    by_name = {key.name: key for key in KEYS}
    return {name: by_name[name].from_si(getattr(device, by_name[name].field)) for name in NOMINAL}


def _read_device(document: TomlTable) -> Device:
    maps: dict[str, Any] = {
        name: AngleMap(**read_fields(document.table(name), keys)) for name, keys in MAPS.items()
    }
    model = document.table("model")
    for name in model.values:
        if name in FMU_NAMES:
            raise document.error("model", name, "an FMU parameter that no key of a device sets")
    scatter = document.table("turn_on_scatter")
    scatter.check_known(sorted((FMU_NAMES - {"seed", "startAngle"}) | model.values.keys()))
    device = Device(
        name=document.text("name", ""),
        **read_fields(document, KEYS, ("name", *TABLES)),
        **maps,
        site=Site(**read_fields(document.table("site"), SITE_KEYS)),
        specification=_read_positive_numbers(document.table("specification")),
        model={key: model.finite_number(key) for key in model.values},
        turn_on_scatter=_read_positive_numbers(scatter),
    )
    highest = 2 / device.decay_time  # an axis can't gain energy by itself: D/2 <= 1/tau
    if device.damping_anisotropy > highest:
        expected = f"at most 2/decay_time_s, {highest:g}"
        raise document.error("damping_anisotropy_per_s", device.damping_anisotropy, expected)
    return device


def _read_positive_numbers(table: TomlTable) -> dict[str, float]:
    values = {key: table.finite_number(key) for key in table.values}
    for key, value in values.items():
        if value <= 0:
            raise table.error(key, value, "a number above 0")
    return values


def _write_keys(keys: Collection[Key], values: Any, defaults: Any) -> dict[str, float]:
    """Values that differ from the defaults, in the file's units, by each field's first key."""
    first_keys = {key.field: key for key in reversed(list(keys))}
    return {
        key.name: key.from_si(getattr(values, key.field))
        for key in (first_keys[f.name] for f in fields(values) if f.name in first_keys)
        if getattr(values, key.field) != getattr(defaults, key.field)
    }
