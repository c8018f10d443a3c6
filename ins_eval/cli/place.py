"""Options that say where a log was recorded, for `hrg nav` and `hrg align`."""

import argparse

PLACE = ("latitude_deg", "longitude_deg", "height_m")


def add_place_options(parser: argparse.ArgumentParser) -> None:
    """Declare `--latitude-deg`, `--longitude-deg`, `--height-m`."""
    group = parser.add_argument_group("where a log was recorded, if not where it says itself")
    add = group.add_argument
    add("--latitude-deg", type=float, metavar="DEG", help="geodetic latitude")
    add("--longitude-deg", type=float, metavar="DEG", help="longitude (default 0)")
    add("--height-m", type=float, metavar="M", help="height above the ellipsoid (default 0)")
