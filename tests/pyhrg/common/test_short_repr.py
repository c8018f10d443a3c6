"""Objects that users hold show themselves in one line; digests rest on all that they hold."""

import inspect
import typing
from collections.abc import Iterator
from dataclasses import dataclass, field, is_dataclass, replace

import numpy as np
import pytest

import fmu_build
import ins_eval
import pyhrg
from pyhrg.common.errors import describe_briefly
from pyhrg.common.made_by import digest_value
from pyhrg.device.device import AngleMap, Device


@dataclass(frozen=True)
class Example:
    """Has a field of each kind."""

    __repr__ = describe_briefly

    values: np.ndarray = field(default_factory=lambda: np.zeros(3))
    number: float = 1.0
    text: str = ""
    device: Device = field(default_factory=Device)
    table: dict[str, int] = field(default_factory=dict)
    items: tuple[int, ...] = ()
    name: str = ""
    other: int = 0


def parts(hint: object) -> Iterator[type]:
    """Classes of a type hint."""
    for part in typing.get_args(hint) or (hint,):
        if inspect.isclass(part):
            yield part
        elif part is not hint:
            yield from parts(part)


def public_classes() -> set[type]:
    """Our dataclasses that front doors name or return."""
    doors = [getattr(door, n) for door in (pyhrg, ins_eval, fmu_build) for n in door.__all__]
    hints = [o if inspect.isclass(o) else typing.get_type_hints(o)["return"] for o in doors
             if inspect.isclass(o) or inspect.isfunction(o)]  # fmt: skip
    return {each for hint in hints for each in parts(hint) if is_dataclass(each)}


@pytest.mark.parametrize("kind", sorted(public_classes(), key=lambda kind: kind.__name__))
def test_no_public_object_prints_all_that_it_holds(kind: type) -> None:
    """A dataclass's own `__repr__` is wrapped."""
    assert not hasattr(kind.__repr__, "__wrapped__")


def test_a_device_is_one_line_that_begins_with_its_name() -> None:
    text = repr(pyhrg.load_device("typical"))
    assert text.startswith("Device(name='typical', ")
    assert text.endswith(", ...)")
    assert len(text) < 200
    assert "\n" not in text


def test_what_is_at_its_default_is_left_out_and_what_is_large_has_its_size() -> None:
    assert repr(Example()) == "Example()"
    example = Example(np.ones((3, 4)), 1 / 3, "a" * 100, Device(name="g"), {"a": 1}, (1, 2))
    assert repr(example) == (
        "Example(values=<3 x 4 ndarray>, number=0.333333, "
        "text='aaaaaaaaaaaaaaaa ... aaaaaaaaaaaaaaaa', device=<Device g>, table=<1 key>, "
        "items=<2 items>)"
    )
    assert repr(replace(example, name="x", other=2)).startswith("Example(name='x', values=<3 x 4")
    assert repr(replace(example, name="x", other=2)).endswith("table=<1 key>, ...)")


def test_digests_see_what_the_line_leaves_out() -> None:
    device = pyhrg.load_device("typical")
    other = replace(device, scale_factor_map=AngleMap(sin8=1e-9))
    assert repr(device) == repr(other)
    assert digest_value(device) != digest_value(other)
    assert digest_value((1, {"device": device})) != digest_value((1, {"device": other}))
    assert digest_value(device) == digest_value(replace(device))
