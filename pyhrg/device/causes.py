"""Errors that a device states, each with the changes that remove it."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from pyhrg.device.declarations import format_effect, read_declarations
from pyhrg.device.device import Device

IDEAL = Device()
TABLES = {
    "bias_map": "bias map of the electronics",
    "scale_factor_map": "scale-factor map of the electronics",
    "turn_on_scatter": "turn-on to turn-on repeatability",
}
"""Names of what the tables of a device file state, by the device's field."""


@dataclass(frozen=True)
class Cause:
    """One error of a gyro.

    Attributes:
        name: the field's term for the error.
        keys: keys of a device file that state the error.
        fields: fields of `Device` that are ideal without the error.
        model: parameters of the FMU that `Device.model` has not without it.
    """

    name: str
    keys: tuple[str, ...]
    fields: tuple[str, ...] = ()
    model: frozenset[str] = frozenset()

    def __str__(self) -> str:
        return f"{self.name} ({', '.join(self.keys)})"

    def remove(self, device: Device) -> Device:
        """The device without this error."""
        kept = {name: value for name, value in device.model.items() if name not in self.model}
        ideal = {name: getattr(IDEAL, name) for name in self.fields}
        return replace(device, model=kept, **ideal)


def list_causes(devices: Sequence[Device]) -> list[Cause]:
    """All errors that any of the devices states, but noise; declared parameters of one group are
    one."""
    stated = {
        name for d in devices for name, value in vars(d).items() if value != getattr(IDEAL, name)
    }
    fields_by_key: dict[str, dict[str, str]] = {}
    for name, declaration in read_declarations(Device).items():
        if declaration.cause and name in stated:
            fields_by_key.setdefault(declaration.cause, {})[declaration.keys[0]] = name
    declared = [
        Cause(format_effect(name), tuple(fields), tuple(fields.values()))
        for name, fields in fields_by_key.items()
    ]
    tables = [Cause(name, (f"[{f}]",), (f,)) for f, name in TABLES.items() if f in stated]
    return [*declared, *tables, *_list_model_causes(devices)]


def _list_model_causes(devices: Sequence[Device]) -> list[Cause]:
    """One a parameter of the FMU, with all elements of an array."""
    arrays: dict[str, set[str]] = {}
    for name in (name for device in devices for name in device.without_noise().model):
        arrays.setdefault(name.partition("[")[0], set()).add(name)
    return [Cause(array, ("[model]",), model=frozenset(names)) for array, names in arrays.items()]
