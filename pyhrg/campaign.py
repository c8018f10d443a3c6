"""Stub, replaced."""
from dataclasses import dataclass
from collections.abc import Mapping
from pyhrg.records import Log
@dataclass(frozen=True)
class Site:
    latitude: float
    gravity: float
@dataclass(frozen=True)
class Test:
    id: str
    kind: str
    role: str
    log: Log
@dataclass(frozen=True)
class Campaign:
    device: str
    site: Site
    nominal: Mapping[str, float]
    tests: tuple[Test, ...]
