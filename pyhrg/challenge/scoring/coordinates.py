"""The coordinates in which an effect shows, also for effects that a catalogue lacks."""

from pyhrg.device.declarations import read_declarations
from pyhrg.device.device import Device

COORDINATES = {
    effect.name: frozenset(effect.coordinates)
    for declaration in read_declarations(Device).values()
    for effect in (declaration.effect, declaration.noise)
    if effect
}
"""Coordinates in which the greatest share of an effect's gap may lie, by the effect's name; both
as the record format calls them."""
