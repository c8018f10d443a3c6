"""Errors that a device states, and the device without each."""

import pytest

from pyhrg.common.units import DEG
from pyhrg.device.causes import TABLES, list_causes
from pyhrg.device.declarations import read_declarations
from pyhrg.device.device import AngleMap, Device
from pyhrg.device.keys import KEYS
from pyhrg.device.ready_devices import TYPICAL

CAUSES = {name: d.cause for name, d in read_declarations(Device).items() if d.cause}


@pytest.mark.parametrize("field", CAUSES)
def test_each_declared_error_can_be_removed(field: str) -> None:
    device = Device(**{field: 1e-3})
    (cause,) = list_causes([Device(), device])
    assert cause.keys == (next(key.name for key in KEYS if key.field == field),)
    assert cause.remove(device) == Device()


def test_every_effect_is_an_error_and_no_noise_is() -> None:
    for field, declaration in read_declarations(Device).items():
        if declaration.effect or declaration.noise:
            assert (field in CAUSES) == bool(declaration.effect)


def test_typical_gyro() -> None:
    assert [str(cause) for cause in list_causes([TYPICAL])] == [
        "damping anisotropy (damping_anisotropy_per_s)",
        "frequency split and phase errors (frequency_split_Hz, phase_error_rad)",
        "pick-off gain mismatch (pickoff_gain_mismatch)",
        "pick-off non-orthogonality (pickoff_nonorthogonality)",
        "drive gain mismatch (drive_gain_mismatch)",
        "drive non-orthogonality (drive_nonorthogonality)",
    ]
    alone = TYPICAL.without_anisotropy()
    assert len(list_causes([alone])) == 1
    assert list_causes([Device(decay_time=400.0, damping_axis=30 * DEG)]) == []


def test_tables_and_parameters_of_the_fmu() -> None:
    """An array is one error; noise is none."""
    device = Device(
        bias_map=AngleMap(cos4=1e-8),
        scale_factor_map=AngleMap(cos4=1e-5),
        turn_on_scatter={"pickOff.gainMismatch": 1e-5},
        model={"a[1]": 1.0, "a[2]": 2.0, "b": 3.0, "noise.virtualRotation": 1e-5},
    )
    causes = list_causes([device])
    assert [cause.name for cause in causes] == [*TABLES.values(), "a", "b"]
    assert causes[3].remove(device).model == {"b": 3.0, "noise.virtualRotation": 1e-5}
    for cause in causes:
        device = cause.remove(device)
    assert device == Device(model={"noise.virtualRotation": 1e-5})
