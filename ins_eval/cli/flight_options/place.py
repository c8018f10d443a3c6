"""Where a log was recorded, as options say it."""

import argparse
from collections.abc import Sequence
from dataclasses import dataclass

from pyhrg.common.errors import HrgError
from pyhrg.common.option_numbers import number

FLAGS = ("--latitude-deg", "--longitude-deg", "--height-m")
HIGHEST_LATITUDE_DEG = 89.0


@dataclass(frozen=True)
class Place:
    """latitude_deg: None if the log is to say it."""

    latitude_deg: float | None = None
    longitude_deg: float = 0.0
    height_m: float = 0.0


def add_place_options(parser: argparse.ArgumentParser) -> None:
    """`--latitude-deg`, `--longitude-deg`, `--height-m`."""
    group = parser.add_argument_group("where a log was recorded, if not where it says itself")
    group.add_argument("--latitude-deg", metavar="DEG", help="geodetic latitude")
    group.add_argument("--longitude-deg", metavar="DEG", help="longitude (default 0)")
    group.add_argument("--height-m", metavar="M", help="height above the ellipsoid (default 0)")


def place(options: argparse.Namespace) -> Place:
    """Checked.

    Raises:
        HrgError: an option out of range, or a longitude or height without latitude.
    """
    latitude, longitude, height = options.latitude_deg, options.longitude_deg, options.height_m
    if latitude is None:
        for option, value in (("--longitude-deg", longitude), ("--height-m", height)):
            if value is not None:
                raise HrgError(f"{option} {value}: expected --latitude-deg as well")
        return Place()
    limit = HIGHEST_LATITUDE_DEG
    return Place(
        latitude_deg=number("--latitude-deg", latitude, -limit, limit),
        longitude_deg=number("--longitude-deg", longitude or "0", -360, 360),
        height_m=number("--height-m", height or "0", -1000, 100_000),
    )


def refuse_options_of_logs(options: argparse.Namespace, flags: Sequence[str]) -> None:
    """Where there is no log.

    Raises:
        HrgError: one of them is given.
    """
    for flag in flags:
        if getattr(options, flag[2:].replace("-", "_")) is not None:
            raise HrgError(f"{flag}: is for recorded logs, and the IMU is simulated")
