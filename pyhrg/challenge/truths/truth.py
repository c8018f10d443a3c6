"""The truth of a case, drawn by its seed."""

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cache, partial

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.challenge.truths.form import Form, load_forms
from pyhrg.challenge.truths.meter import Meter, set_noise
from pyhrg.device.device import Device
from pyhrg.fmu import GyroError
from pyhrg.gap.effects.catalogue import EFFECT_NAMES, EFFECTS, NOISE_EFFECTS, Effect

Array = NDArray[np.float64]
KINDS = ("none", "single", "pair", "outside", "weak", "left_out", "several")
"""Kinds of truths. `weak` is a single effect below the detection strength; `left_out` one that is
removed from the diagnosis' catalogue."""
COUNTS = {
    "none": (0, 0),
    "single": (1, 1),
    "weak": (1, 1),
    "left_out": (1, 1),
    "pair": (2, 2),
    "several": (3, 7),
}
"""Fewest and most effects of the catalogue in each kind."""
MAX_ATTEMPTS = 100
"""Most attempts to draw a truth that the tests show."""
NO_STRENGTH = 1e-12
"""Strength given to an effect that the tests don't see, sigmas, so that it has a logarithm."""
DETECTION_SIGMAS = 6.0
"""Strength from which a diagnosis must find a gap, sigmas."""
SMALLEST, LARGEST = 1e-9, 30.0
"""Range of sizes over an effect's scale that is searched."""
LOG_SIZE_STEP = math.log(2)
"""Step of the logarithm by which a size is reduced where the FMU can't simulate it."""


@dataclass(frozen=True)
class Truth:
    """The answer to a case.

    kind: one of `KINDS`.
    effects: of the catalogue.
    parameters: of the effects, by the campaign format's names and units; totals.
    strengths: of each effect alone, or of the form beyond all effects of the catalogue, sigmas.
    form: outside the catalogue.
    coordinate: in which the form shows.
    stand_ins: effects that are confounded with an effect left out, in these tests.
    holdout_noise_arcsec: rms of the true noise in the output angle of the held-out tests.
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
    """A truth with the device and the disturbance that realise it."""

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
    strengths: tuple[float, float] = (DETECTION_SIGMAS, 10 * DETECTION_SIGMAS)
    effects: Sequence[str] = EFFECT_NAMES

    def state(self, kind: str) -> TrueState:
        """A truth of this kind.

        Raises:
            ValueError: no such kind, or nothing that the tests show at these strengths.
        """
        if kind not in KINDS:
            raise ValueError(f"{kind}: expected one of {', '.join(KINDS)}")
        for _ in range(MAX_ATTEMPTS):
            state = self._outside() if kind == "outside" else self._inside(kind)
            if state:
                return state
        raise ValueError(f"{kind}: the tests show nothing at {self.strengths} sigmas")

    def _inside(self, kind: str) -> TrueState | None:
        """A truth of effects of the catalogue; None where the tests can't show them at the drawn
        strengths."""
        least, most = COUNTS[kind]
        count = least if least == most else int(self.generator.integers(least, most + 1))
        names = self.generator.choice(self.effects, size=count, replace=False).tolist()
        state = self._with(kind, names)
        if state is None or kind != "left_out":
            return state
        return replace(state, truth=replace(state.truth, stand_ins=self._stand_ins(state)))

    def _with(self, kind: str, names: Sequence[str]) -> TrueState | None:
        """A truth of these effects, each with a drawn strength."""
        device = self.meter.believed
        parameters: dict[str, float] = {}
        wanted = [math.exp(self.generator.uniform(*np.log(self.strengths))) for _ in names]
        for name, sigmas in zip(names, wanted, strict=True):
            sized = self._sized(name)
            size = solve_size(self._strength_by_size(name, sized), sigmas)
            if size is None:
                return None
            change, found = sized(size)
            device, parameters = change(device), {**parameters, **found}
        if self._is_confounded(names, device):
            return None
        return TrueState(Truth(kind, tuple(names), parameters, tuple(wanted)), device)

    def _sized(self, name: str) -> "Sized":
        """An effect by its size, in a direction that is drawn now."""
        believed = self.meter.believed
        if name in NOISE_EFFECTS:
            noise = NOISE_EFFECTS[name]
            was = getattr(believed, noise.field)

            def louder(size: float) -> tuple[Change, dict[str, float]]:
                total = math.hypot(was, size * noise.scale)
                key = noise.key
                return (
                    lambda device: set_noise(device, noise, total),
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
        """Strength of one effect of a device where another imitates it as far as possible, sigmas.
        A deterministic effect can't imitate noise; noise makes a deterministic effect weaker."""
        meter, believed = self.meter, self.meter.believed
        if name in NOISE_EFFECTS:
            noise = NOISE_EFFECTS[name]
            alone = set_noise(believed, noise, getattr(device, noise.field))
            rival = NOISE_EFFECTS.get(other)
            return meter.sigmas_of_noise_beyond(rival, alone) if rival else math.inf
        effect = EFFECTS[name]
        if other in NOISE_EFFECTS:
            noise = NOISE_EFFECTS[other]
            noisy = set_noise(believed, noise, getattr(device, noise.field))
            return meter.sigmas(effect.put(noisy, effect.vector(device)))
        gap = meter.residual(effect.put(believed, effect.vector(device)))
        return meter.sigmas_beyond(EFFECTS[other], gap)

    def _is_confounded(self, names: Sequence[str], device: Device) -> bool:
        """Whether one of the effects imitates another to less than `DETECTION_SIGMAS`."""
        return any(
            self._left(a, b, device) < DETECTION_SIGMAS for a in names for b in names if a != b
        )

    def _stand_ins(self, state: TrueState) -> tuple[str, ...]:
        """Effects that imitate the only one to less than `DETECTION_SIGMAS`."""
        (name,) = state.truth.effects
        others = [other for other in EFFECT_NAMES if other != name]
        return tuple(
            other for other in others if self._left(name, other, state.device) < DETECTION_SIGMAS
        )

    def _outside(self) -> TrueState | None:
        believed, every = self.meter.believed, load_forms()
        form = every[self.generator.integers(len(every))]
        freedom = int(self.generator.integers(2**31))
        sigmas = math.exp(self.generator.uniform(*np.log(self.strengths)))
        size = solve_size(partial(self._beyond, form, freedom), sigmas)
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
"""A function of an effect's size over its scale; it returns the change of a device and the
parameters."""


def solve_size(strength: Callable[[float], float], sigmas: float) -> float | None:
    """The size of an effect that has a given strength, to 1 %; None where the FMU can simulate no
    such size.

    It is rounded to three digits, so that rounding errors of the strengths do not show.
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
        high -= LOG_SIZE_STEP
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
