"""What results hold: every name, its unit and meaning, once."""

from dataclasses import dataclass

SUFFIXES = {"s": "_s", "m": "_m", "m2": "_m2", "m/s": "_m_s", "deg": "_deg", "1": ""}
"""What a unit adds to a column's name."""


@dataclass(frozen=True)
class Quantity:
    """A number that leaves: `name` in labelled arrays, `column` in tables."""

    name: str
    unit: str
    meaning: str

    @property
    def column(self) -> str:
        return self.name + SUFFIXES[self.unit]

    @property
    def attributes(self) -> dict[str, str]:
        """Unit and meaning, as labelled arrays and Parquet store them."""
        return {"units": self.unit, "long_name": self.meaning}


AXES = ("north", "east", "down")


def _state(prefix: str, whose: str) -> tuple[Quantity, ...]:
    velocities = (
        Quantity(f"{prefix}velocity_{axis}", "m/s", f"{whose} velocity over ground, {axis}")
        for axis in AXES
    )
    return (
        Quantity(f"{prefix}latitude", "deg", f"{whose} geodetic latitude"),
        Quantity(f"{prefix}longitude", "deg", f"{whose} longitude, -180 to 180"),
        Quantity(f"{prefix}height", "m", f"{whose} height above the ellipsoid"),
        *velocities,
        Quantity(f"{prefix}heading", "deg", f"{whose} heading, clockwise from north, 0 to 360"),
        Quantity(f"{prefix}pitch", "deg", f"{whose} pitch, nose up"),
        Quantity(f"{prefix}roll", "deg", f"{whose} roll, right side down"),
    )


def _errors(kind: str, what: str) -> tuple[Quantity, ...]:
    return (
        *(Quantity(f"{a}_{kind}", "m", f"{what} of position, {a}") for a in AXES),
        *(Quantity(f"velocity_{a}_{kind}", "m/s", f"{what} of velocity, {a}") for a in AXES),
        *(Quantity(f"tilt_{a}_{kind}", "deg", f"{what} of attitude, about {a}") for a in AXES[:2]),
        Quantity(f"heading_{kind}", "deg", f"{what} of attitude, about down"),
    )


TIME = Quantity("time", "s", "since the end of alignment")
RUN = Quantity("run", "1", "number of the flight")
NAVIGATED = _state("", "navigated")
TRUE = _state("true_", "true")
ERROR = _errors("error", "navigated less true")
RADIAL_ERROR = Quantity("radial_error", "m", "root of the sum of squared north and east errors")
SIGMA = _errors("sigma", "1-sigma by the linear model")
COVARIANCE = Quantity(
    "north_east_covariance", "m2", "of the position's north and east error, by the linear model"
)
OWN = (
    Quantity("own_north_error", "m", "navigator's own error: ideal increments, true start; north"),
    Quantity("own_east_error", "m", "navigator's own error, east"),
    Quantity("own_down_error", "m", "navigator's own error, down"),
)

ALL = (TIME, RUN, *NAVIGATED, *TRUE, *ERROR, RADIAL_ERROR, *SIGMA, COVARIANCE, *OWN)
BY_NAME = {quantity.name: quantity for quantity in ALL}
BY_COLUMN = {quantity.column: quantity for quantity in ALL}
