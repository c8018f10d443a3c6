"""What is really wrong with the gyro of one case, drawn by its seed."""

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cache, partial

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.challenge.truths.form import Form, forms
from pyhrg.challenge.truths.meter import Meter, noise_put
from pyhrg.device.device import Device
from pyhrg.fmu import GyroError
from pyhrg.gap.effects.catalogue import EFFECTS, NAMES, NOISE_EFFECTS, Effect

Array = NDArray[np.float64]
KINDS = ("none", "single", "pair", "outside", "weak", "left_out", "several")
"""`weak` is a single effect below what a diagnosis is held to; `left_out` one that its catalogue
then lacks."""
COUNTS = {
    "none": (0, 0),
    "single": (1, 1),
    "weak": (1, 1),
    "left_out": (1, 1),
    "pair": (2, 2),
    "several": (3, 7),
}
"""Effects of the catalogue in each, at least and at most."""
TRIES = 100
"""Of drawing a truth that the tests show, at most."""
NO_STRENGTH = 1e-12
"""Sigmas of what the tests don't see, so that it has a logarithm."""
LEAST = 6.0
"""Sigmas from which a diagnosis is held to find a gap."""
SMALLEST, LARGEST = 1e-9, 30.0
"""Sizes over an effect's scale that are looked at."""
SMALLER = math.log(2)
"""By which the largest is made smaller where the FMU can't simulate it."""


@dataclass(frozen=True)
class Truth:
    """The answer to a case.

    kind: one of `KINDS`.
    effects: of the catalogue.
    parameters: of the effects, by the campaign format's names and units; totals.
    strengths: sigmas of each effect alone, or of the form beyond what the catalogue could take.
    form: outside the catalogue.
    coordinate: that the form lives in.
    stand_ins: of an effect left out, those that do nearly the same to these tests.
    holdout_noise_arcsec: rms of what noise makes of the output angle on held-out tests: what no
        simulation can do away with.
    """

    kind: str
    effects: tuple[str, ...] = ()
    parameters: Mapping[str, float] = field(default_factory=dict)
    strengths: tuple[float, ...] = ()
    form: str | None = None
    coordinate: str | None = None
    stand_ins: tuple[str, ...] = ()
    holdout_noise_arcsec: float | None = None


@dataclass(frozen=True)
class TrueState:
    """A truth, and what makes it so."""

    truth: Truth
    device: Device
    disturbance: Disturbance = field(default_factory=Disturbance)


@dataclass(frozen=True)
class Drawing:
    """Draws truths of one gyro.

    strengths: sigmas that effects are drawn from, evenly in logarithm.
    effects: of the catalogue that may be drawn.
    """

    meter: Meter
    generator: np.random.Generator
    strengths: tuple[float, float] = (LEAST, 10 * LEAST)
    effects: Sequence[str] = NAMES

    def state(self, kind: str) -> TrueState:
        """A truth of this kind.

        Raises:
            ValueError: no such kind, or nothing that the tests show at these strengths.
        """
        if kind not in KINDS:
            raise ValueError(f"{kind}: expected one of {', '.join(KINDS)}")
        for _ in range(TRIES):
            state = self._outside() if kind == "outside" else self._inside(kind)
            if state:
                return state
        raise ValueError(f"{kind}: the tests show nothing at {self.strengths} sigmas")

    def _inside(self, kind: str) -> TrueState | None:
        """A truth of the catalogue's effects; None where the tests can't show them as drawn."""
        least, most = COUNTS[kind]
        count = least if least == most else int(self.generator.integers(least, most + 1))
        names = self.generator.choice(self.effects, size=count, replace=False).tolist()
        state = self._with(kind, names)
        if state is None or kind != "left_out":
            return state
        return replace(state, truth=replace(state.truth, stand_ins=self._stand_ins(state)))

    def _with(self, kind: str, names: Sequence[str]) -> TrueState | None:
        """A truth of these effects, each at a strength that is drawn."""
        device = self.meter.believed
        parameters: dict[str, float] = {}
        wanted = [math.exp(self.generator.uniform(*np.log(self.strengths))) for _ in names]
        for name, sigmas in zip(names, wanted, strict=True):
            sized = self._sized(name)
            size = solved(self._strength_by_size(name, sized), sigmas)
            if size is None:
                return None
            change, found = sized(size)
            device, parameters = change(device), {**parameters, **found}
        if self._is_confounded(names, device):
            return None
        return TrueState(Truth(kind, tuple(names), parameters, tuple(wanted)), device)

    def _sized(self, name: str) -> "Sized":
        """An effect in a direction that is drawn now, by its size."""
        believed = self.meter.believed
        if name in NOISE_EFFECTS:
            noise = NOISE_EFFECTS[name]
            was = getattr(believed, noise.field)

            def louder(size: float) -> tuple[Change, dict[str, float]]:
                total = math.hypot(was, size * noise.scale)
                key = noise.key
                return (
                    lambda device: noise_put(device, noise, total),
                    {key.name: key.from_si(total)},
                )

            return louder
        effect = EFFECTS[name]
        direction = _direction(effect, self.generator)

        def further(size: float) -> tuple[Change, dict[str, float]]:
            vector = effect.vector(believed) + size * effect.scale * direction
            return lambda device: effect.put(device, vector), effect.parameters(vector)

        return further

    def _strength_by_size(self, name: str, sized: "Sized") -> Callable[[float], float]:
        return lambda size: self.meter.sigmas_of(name, sized(size)[1])

    def _left(self, name: str, other: str, device: Device) -> float:
        """Sigmas of one effect of a device, alone, where another takes as much as it can. What
        moves the simulation can't stand in for noise; noise hides it."""
        meter, believed = self.meter, self.meter.believed
        if name in NOISE_EFFECTS:
            noise = NOISE_EFFECTS[name]
            alone = noise_put(believed, noise, getattr(device, noise.field))
            rival = NOISE_EFFECTS.get(other)
            return meter.sigmas_of_noise_beyond(rival, alone) if rival else math.inf
        effect = EFFECTS[name]
        if other in NOISE_EFFECTS:
            noise = NOISE_EFFECTS[other]
            noisy = noise_put(believed, noise, getattr(device, noise.field))
            return meter.sigmas(effect.put(noisy, effect.vector(device)))
        gap = meter.residual(effect.put(believed, effect.vector(device)))
        return meter.sigmas_beyond(EFFECTS[other], gap)

    def _is_confounded(self, names: Sequence[str], device: Device) -> bool:
        """Whether one of the effects could stand in for another, with less than `LEAST` left."""
        return any(self._left(a, b, device) < LEAST for a in names for b in names if a != b)

    def _stand_ins(self, state: TrueState) -> tuple[str, ...]:
        """Effects that leave less than `LEAST` of the only one."""
        (name,) = state.truth.effects
        others = [other for other in NAMES if other != name]
        return tuple(other for other in others if self._left(name, other, state.device) < LEAST)

    def _outside(self) -> TrueState | None:
        believed, every = self.meter.believed, forms()
        form = every[self.generator.integers(len(every))]
        freedom = int(self.generator.integers(2**31))
        sigmas = math.exp(self.generator.uniform(*np.log(self.strengths)))
        size = solved(partial(self._beyond, form, freedom), sigmas)
        if size is None:
            return None
        truth = Truth("outside", (), {}, (sigmas,), form.name, form.coordinate)
        disturbance = form.disturbance(believed, size, np.random.default_rng(freedom))
        return TrueState(truth, believed, disturbance)

    def _beyond(self, form: Form, freedom: int, size: float) -> float:
        believed = self.meter.believed
        disturbance = form.disturbance(believed, size, np.random.default_rng(freedom))
        if form.coordinate == "noise":
            return self.meter.sigmas_of_unsteady(disturbance)
        gap = self.meter.residual(believed, disturbance)
        return self.meter.sigmas_beyond_catalogue(gap)


Change = Callable[[Device], Device]
Sized = Callable[[float], tuple[Change, dict[str, float]]]
"""An effect by its size over its scale: what it does to a device, and its parameters."""


def solved(strength: Callable[[float], float], sigmas: float) -> float | None:
    """The size of an effect that has a strength, to a percent; None where none has that the FMU can
    simulate.

    Three digits, so that no rounding of the strengths is in it.
    """

    @cache
    def excess(logarithm: float) -> float:
        return math.log(max(strength(math.exp(logarithm)), NO_STRENGTH) / sigmas)

    def is_simulated(logarithm: float) -> bool:
        with suppress(GyroError):
            return math.isfinite(excess(logarithm))
        return False

    low, high = math.log(SMALLEST), math.log(LARGEST)
    while not is_simulated(high):
        high -= SMALLER
        if high < low:
            return None
    if excess(high) < 0:
        return None
    return float(f"{math.exp(float(brentq(excess, low, high, xtol=0.01))):.3g}")


def _direction(effect: Effect, generator: np.random.Generator) -> Array:
    if effect.size == 1 and effect.bounds[0] == 0:
        return np.ones(effect.size)
    if effect.size == 1:
        return np.array([generator.choice((-1.0, 1.0))])
    angle = generator.uniform(0, 2 * math.pi)
    return np.array([math.cos(angle), math.sin(angle)])
