"""Variables of the trajectory's FMU, in the order of their value references in `trajectory.c`."""

from typing import NamedTuple

GYROS = ("gyro1", "gyro2", "gyro3")
"""Places at which the gyros are mounted."""
CASE_MOTION = ("angularRate", "accelerationX", "accelerationY", "accelerationZ")
"""Inputs of a gyro that the trajectory gives."""
LEAD_IN = "leadIn"
ROW = "row"
SPECIFIC_FORCE = tuple(f"specificForce[{axis}]" for axis in (1, 2, 3))
HEIGHT, CLIMB = "referenceHeight", "referenceClimbRate"

_AXES = ("x, from which the pattern angle counts", "y", "z, the input axis")
_BODY = ("forward", "right", "down")


class Variable(NamedTuple):
    """A real variable; `largest` is that of its size."""

    name: str
    unit: str
    description: str
    is_parameter: bool = False
    start: float = 0.0
    largest: float = 0.0


def name_case_axis(gyro: int, axis: int, body: int) -> str:
    """Name of the parameter that is one component of a gyro's case axis; numbers from 0."""
    return f"{GYROS[gyro]}.caseAxes[{axis + 1},{body + 1}]"


def list_variables() -> list[Variable]:
    """All variables."""
    parameters = [
        Variable(
            name_case_axis(gyro, axis, body),
            "1",
            f"Component {_BODY[body]} of the axis {_AXES[axis]} of the case",
            is_parameter=True,
            start=float(body == (gyro + 1 + axis) % 3),
            largest=1.0,
        )
        for gyro in range(3)
        for axis in range(3)
        for body in range(3)
    ]
    text = "Number of communication steps at rest, before the motion begins"
    parameters.append(Variable(LEAD_IN, "1", text, is_parameter=True, largest=1e6))
    return [*parameters, *_list_outputs()]


def _list_outputs() -> list[Variable]:
    outputs = []
    for gyro in GYROS:
        text = "Mean rotation rate of the case about the input axis over the coming interval"
        outputs.append(Variable(f"{gyro}.angularRate", "rad/s", text))
        for axis in "XYZ":
            text = f"Mean specific force along the case's {axis.lower()} over the coming interval"
            outputs.append(Variable(f"{gyro}.acceleration{axis}", "m/s2", text))
    for name, axis in zip(SPECIFIC_FORCE, _BODY, strict=True):
        text = f"Mean specific force {axis} over the coming interval"
        outputs.append(Variable(name, "m/s2", text))
    text = "Number of the coming interval, from 1; 0: the motion has not begun yet"
    outputs.append(Variable(ROW, "1", text))
    outputs.append(Variable(HEIGHT, "m", "Height above the ellipsoid"))
    outputs.append(Variable(CLIMB, "m/s", "Climb rate"))
    return outputs
