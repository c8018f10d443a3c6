"""The input `caseAngle` beside the input `angularRate`: the same motion as an angle."""

from dataclasses import replace

from fmu_build.equations.dae import Dae, Node

RATE, ANGLE = "angularRate", "caseAngle"
LARGEST_ANGLE = 1e6
"""rad; chosen: 28 h at 10 rad/s, and a double still tells 1e-10 rad apart there."""


def add_case_angle(dae: Dae) -> Dae:
    """The model with the input `caseAngle` as its last variable, where it has `angularRate`.

    No equation reads it: the FMU adds the rate at which it changes within a step to `angularRate`
    (`c/inputs.c`)."""
    rate = next((v for v in dae.variables if v.name == RATE and v.role == "input"), None)
    if rate is None:
        return dae
    values = (0.0, -LARGEST_ANGLE, LARGEST_ANGLE, 1.0)
    start, minimum, maximum, nominal = range(len(dae.nodes), len(dae.nodes) + len(values))
    angle = replace(
        rate,
        name=ANGLE,
        type_name="Units.Angle",
        unit="rad",
        description="Angle of the case about the input axis at the end of the coming step, in "
        "which it turns evenly; its rate adds to angularRate",
        start=start,
        minimum=minimum,
        maximum=maximum,
        nominal=nominal,
        offset=dae.scalar_count,
    )
    literals = tuple(Node("literal", value, ()) for value in values)
    return replace(dae, variables=(*dae.variables, angle), nodes=dae.nodes + literals)
