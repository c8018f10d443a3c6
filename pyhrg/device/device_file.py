"""Devices as TOML files: keys and units of the campaigns' catalogue and of their `nominal`."""

import difflib
import sys
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import tomli_w

from pyhrg.common.errors import HrgError
from pyhrg.common.files import toml_of, write_whole
from pyhrg.common.site import Site
from pyhrg.device.device import FMU_NAMES, AngleMap, Device
from pyhrg.device.keys import KEYS, MAPS, SITE_KEYS, Key

SCATTERED = FMU_NAMES - {"seed", "startAngle"}
"""Parameters of the FMU that may differ from power-on to power-on, beside those of `[model]`."""
FEW = 4
"""Keys that a message proposes where none is close."""


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
"""Design values of a gyro; its errors are for the tests to find."""


class DeviceError(HrgError):
    """The file is no device; the message names file, key, what was found and what expected."""


def read(path: Path, fmu_names: Collection[str] | None = None) -> Device:
    """Read a device; an empty file is an ideal gyro.

    Args:
        path: TOML. At the top `name` and the keys of `device_keys.KEYS`; tables `[bias_map]`
            (deg/h), `[scale_factor_map]` (arcsec of pattern angle), `[site]`, `[specification]`
            (limits by finding), `[model]` (anything else of the FMU, by its names, SI) and
            `[turn_on_scatter]` (standard deviations of parameters of the FMU from power-on to
            power-on, by its names, SI).
        fmu_names: names that `[model]` may use (`GyroFmu.references`); None leaves them to the FMU.

    Raises:
        DeviceError: an unreadable file; a key that is unknown or said twice; a value that is no
            finite number or out of range.
    """
    return from_table(toml_of(path, DeviceError), str(path), fmu_names)


def from_table(
    document: Mapping[str, Any], source: str, fmu_names: Collection[str] | None = None
) -> Device:
    """A device from keys and values of such a file, as of a campaign's `nominal`.

    Args:
        document: values and tables by key.
        source: where they come from, for messages.
        fmu_names: see `read`.

    Raises:
        DeviceError: see `read`.
    """
    return _Reader(source).device(document, fmu_names)


def write(device: Device, path: Path) -> None:
    """Write a device, whole or not at all: what differs from an ideal gyro.

    It reads back to the same bits wherever a number in the file's unit gives them, as for every
    device that was read, and otherwise to the nearest.

    Raises:
        OSError: the folder can't be written.
    """
    ideal = Device()
    document: dict[str, Any] = {"name": device.name} if device.name else {}
    document |= _written(KEYS, device, ideal)
    for table, coefficients in MAPS.items():
        document[table] = _written(coefficients, getattr(device, table), AngleMap())
    document["site"] = _written(SITE_KEYS, device.site, ideal.site)
    document["specification"] = dict(device.specification)
    document["turn_on_scatter"] = dict(device.turn_on_scatter)
    document["model"] = dict(device.model)
    kept = {key: value for key, value in document.items() if value != {}}
    write_whole(path, tomli_w.dumps(kept).encode())


def nominal(device: Device) -> dict[str, float]:
    """What a test engineer believes of the gyro before any test, by the keys of a campaign."""
    by_name = {key.name: key for key in KEYS}
    return {name: by_name[name].from_si(getattr(device, by_name[name].field)) for name in NOMINAL}


@dataclass(frozen=True)
class _Reader:
    """Takes a document apart; knows where it is from, for messages."""

    source: str

    def device(self, document: Mapping[str, Any], fmu_names: Collection[str] | None) -> Device:
        tables = ("name", *MAPS, "site", "specification", "model", "turn_on_scatter")
        self._known(document, [key.name for key in KEYS] + list(tables))
        top = {key: value for key, value in document.items() if key not in tables}
        model = self._table(document, "model")
        self._check_model(model, fmu_names)
        scatter = self._table(document, "turn_on_scatter")
        self._known(scatter, sorted({*SCATTERED, *model}), "turn_on_scatter.")
        device = Device(
            name=self._name(document.get("name", "")),
            **self._values(top, KEYS),
            **self._maps(document),
            site=Site(**self._values(self._table(document, "site"), SITE_KEYS, "site.")),
            specification=self._positive("specification", self._table(document, "specification")),
            model={key: self._number(f"model.{key}", value) for key, value in model.items()},
            turn_on_scatter=self._positive("turn_on_scatter", scatter),
        )
        self._check_damping(device)
        return device

    def error(self, key: str, found: object, expected: str) -> DeviceError:
        return DeviceError(f"{self.source}: {key}: found {found!r}, expected {expected}")

    def _known(self, table: Iterable[str], names: Collection[str], prefix: str = "") -> None:
        for key in table:
            if key not in names:
                close = difflib.get_close_matches(key, names, n=1) or sorted(names)[:FEW]
                raise DeviceError(
                    f"{self.source}: {prefix}{key}: found an unknown key, expected "
                    + " or ".join(f"{prefix}{name}" for name in close)
                    + (" or another" if len(close) == FEW else "")
                )

    def _table(self, document: Mapping[str, Any], name: str) -> dict[str, Any]:
        table = document.get(name, {})
        if not isinstance(table, dict):
            raise self.error(name, table, "a table")
        return table

    def _name(self, value: object) -> str:
        if not isinstance(value, str):
            raise self.error("name", value, "text")
        return value

    def _number(self, key: str, value: object) -> float:
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self.error(key, value, "a number")
        if not abs(value) <= sys.float_info.max:
            raise self.error(key, value, "a finite number")
        return float(value)

    def _values(
        self, table: Mapping[str, Any], keys: Collection[Key], prefix: str = ""
    ) -> dict[str, Any]:
        """SI values by field."""
        self._known(table, [key.name for key in keys], prefix)
        values: dict[str, Any] = {}
        for key in (key for key in keys if key.name in table):
            value = self._number(prefix + key.name, table[key.name])
            if not key.low <= value <= key.high:
                raise self.error(prefix + key.name, value, key.expected)
            if key.field in values:
                twin = next(k.name for k in keys if k.field == key.field and k.name in table)
                raise self.error(prefix + key.name, value, f"it or {twin}, which says the same")
            values[key.field] = key.to_si(value)
        return values

    def _maps(self, document: Mapping[str, Any]) -> dict[str, Any]:
        return {
            name: AngleMap(**self._values(self._table(document, name), keys, f"{name}."))
            for name, keys in MAPS.items()
        }

    def _positive(self, name: str, table: Mapping[str, Any]) -> dict[str, float]:
        """Numbers of a table that must be above 0."""
        values = {key: self._number(f"{name}.{key}", value) for key, value in table.items()}
        for key, value in values.items():
            if value <= 0:
                raise self.error(f"{name}.{key}", value, "a number above 0")
        return values

    def _check_model(self, model: Iterable[str], fmu_names: Collection[str] | None) -> None:
        for key in model:
            if key in FMU_NAMES:
                raise self.error("model", key, "names that have no key or power-on of their own")
        if fmu_names is not None:
            self._known(model, fmu_names, "model.")

    def _check_damping(self, device: Device) -> None:
        """An axis can't gain energy by itself: D/2 <= 1/tau."""
        highest = 2 / device.decay_time
        if device.damping_anisotropy > highest:
            raise self.error(
                "damping_anisotropy_per_s",
                device.damping_anisotropy,
                f"at most 2/decay_time_s, {highest:g}",
            )


def _written(keys: Collection[Key], values: Any, defaults: Any) -> dict[str, float]:
    """What differs from the defaults, in the file's units, under each field's first key."""
    first = {key.field: key for key in reversed(list(keys))}
    changed = (f.name for f in fields(values) if f.name in first)
    return {
        first[name].name: first[name].from_si(getattr(values, name))
        for name in changed
        if getattr(values, name) != getattr(defaults, name)
    }
