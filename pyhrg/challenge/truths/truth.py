"""The truth of a case, drawn by its seed."""

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache, partial

import numpy as np
from scipy.optimize import brentq

from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.challenge.truths.form import load_forms
from pyhrg.challenge.truths.meter import Meter
from pyhrg.challenge.truths.noise_strength import set_noise
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.fmu import GyroError
from pyhrg.gap.effects.catalogue import EFFECT_NAMES, EFFECTS, NOISE_EFFECTS, Effect

KINDS = ("none", "single", "pair", "outside", "weak", "left_out", "several")
"""Kinds of truths. `weak` is a single effect below the detection strength; `left_out` one that is
removed from the diagnosis' catalogue."""
COUNTS = {
    "none": (0, 0),
    "single": (1, 1),
    "weak": (1, 1),
    "left_out": (1, 1),
    "pair": (2, 2),
    "several": (3, 8),
}
"""Fewest and most effects of the catalogue in each kind."""
MAX_ATTEMPTS = 100
"""Largest number of attempts to draw a truth that the tests show."""
NO_STRENGTH = 1e-12
"""Smallest strength, sigmas: that of an effect that no test shows, so that it has a logarithm."""
DETECTION_SIGMAS = 6.0
"""Strength from which a diagnosis must find a gap, sigmas."""
SMALLEST_SIZE, LARGEST_SIZE = 1e-9, 30.0
"""Range of sizes, in units of an effect's scale, in which the size of a strength is searched."""
LOG_SIZE_STEP = math.log(2)
"""Step by which the logarithm of a size is reduced where the FMU can't simulate the size."""


@dataclass(frozen=True)
class Truth:
    """The answer to a case.

    Attributes:
        kind: one of `KINDS`.
        effects: names of the true effects; empty where a form outside the catalogue is true.
        parameters: total values of the effects' parameters, by the campaign format's names and
            units.
        strengths: strength of each effect alone, or of the form beyond the catalogue, sigmas.
        form: name of the form outside the catalogue.
        coordinate: coordinate in which the form shows.
        place: place where the form acts.
        size: size of the form, in typical sizes.
        stand_ins: effects that these tests can't separate from the effect that was left out.
        holdout_noise_arcsec: rms of the true noise in the output angle of the held-out tests.
        beyond: known parameters that are off by more than their tolerance.
    """

    kind: str
    effects: tuple[str, ...] = ()
    parameters: Mapping[str, float] = field(default_factory=dict)
    strengths: tuple[float, ...] = ()
    form: str | None = None
    coordinate: str | None = None
    place: str | None = None
    size: float | None = None
    stand_ins: tuple[str, ...] = ()
    holdout_noise_arcsec: float | None = None
    beyond: tuple[str, ...] = ()


@dataclass(frozen=True)
class TrueState:
    """A truth with the device and the disturbance that realise it."""

    truth: Truth
    device: Device
    disturbance: Disturbance = field(default_factory=Disturbance)


@dataclass(frozen=True)
class Drawing:
    """Draws truths of one gyro.

    Attributes:
        strengths: range of the effects' strengths, sigmas; their logarithm is drawn uniformly.
        effects: names of the effects that may be drawn.
    """

    meter: Meter
    generator: np.random.Generator
    strengths: tuple[float, float]
    effects: Sequence[str]

    def draw_state(self, kind: str) -> TrueState:
        """A truth of this kind.

        Raises:
            ValueError: no such kind, or nothing that the tests show at these strengths.
        """
        if kind not in KINDS:
            raise ValueError(f"{kind}: expected one of {', '.join(KINDS)}")
        for _ in range(MAX_ATTEMPTS):
            state = self._draw_form() if kind == "outside" else self._draw_effects(kind)
            if state:
                return state
        raise ValueError(f"{kind}: the tests show nothing at {self.strengths} sigmas")

    def _draw_strength(self) -> float:
        return math.exp(self.generator.uniform(*np.log(self.strengths)))

    def _draw_effects(self, kind: str) -> TrueState | None:
        """A truth of effects of the catalogue; None where the tests can't show them at the drawn
        strengths."""
        least, most = COUNTS[kind][0], min(COUNTS[kind][1], len(self.effects))
        count = least if least == most else int(self.generator.integers(least, most + 1))
        names = self.generator.choice(self.effects, size=count, replace=False).tolist()
        device = self.meter.nominal
        parameters: dict[str, float] = {}
        strengths = tuple(self._draw_strength() for _ in names)
        for name, sigmas in zip(names, strengths, strict=True):
            change = self._draw_change(name)
            size = solve_size(partial(self._measure, name, change), sigmas)
            if size is None:
                return None
            put, values = change(size)
            device, parameters = put(device), {**parameters, **values}
        others = [(a, b) for a in names for b in names if a != b]
        if any(self._measure_beside(a, b, device) < DETECTION_SIGMAS for a, b in others):
            return None
        stand_ins = self._find_stand_ins(names[0], device) if kind == "left_out" else ()
        truth = Truth(kind, tuple(names), parameters, strengths, stand_ins=stand_ins)
        return TrueState(truth, device)

    def _draw_change(self, name: str) -> "Change":
        """An effect as a function of its size, in a direction that is drawn now."""
        nominal = self.meter.nominal
        if name in NOISE_EFFECTS:
            noise = NOISE_EFFECTS[name]

            def raise_noise(size: float) -> tuple[Put, dict[str, float]]:
                total = math.hypot(getattr(nominal, noise.field), size * noise.scale)
                values = {noise.key.name: noise.key.from_si(total)}
                return partial(set_noise, noise=noise, value=total), values

            return raise_noise
        effect = EFFECTS[name]
        direction = _draw_direction(effect, self.generator)

        def add_vector(size: float) -> tuple[Put, dict[str, float]]:
            vector = effect.vector(nominal) + size * effect.scale * direction
            return partial(effect.put, vector=vector), effect.parameters(vector)

        return add_vector

    def _measure(self, name: str, change: "Change", size: float) -> float:
        return self.meter.sigmas_of(name, change(size)[1])

    def _measure_beside(self, name: str, other: str, device: Device) -> float:
        """Strength of one effect of a device when another effect, at its best size, imitates it,
        sigmas. A deterministic effect can't imitate noise; noise makes a deterministic effect
        weaker."""
        meter, nominal = self.meter, self.meter.nominal
        if name in NOISE_EFFECTS:
            noise = NOISE_EFFECTS[name]
            alone = set_noise(nominal, noise, getattr(device, noise.field))
            rival = NOISE_EFFECTS.get(other)
            return meter.sigmas_of_noise_beyond(rival, alone) if rival else math.inf
        effect = EFFECTS[name]
        if other in NOISE_EFFECTS:
            noise = NOISE_EFFECTS[other]
            noisy = set_noise(nominal, noise, getattr(device, noise.field))
            return meter.sigmas(effect.put(noisy, effect.vector(device)))
        gap = meter.residual(effect.put(nominal, effect.vector(device)))
        return meter.sigmas_beyond(EFFECTS[other], gap)

    def _find_stand_ins(self, name: str, device: Device) -> tuple[str, ...]:
        """Effects that imitate this one so well that less than `DETECTION_SIGMAS` of it is left."""
        return tuple(
            other
            for other in EFFECT_NAMES
            if other != name and self._measure_beside(name, other, device) < DETECTION_SIGMAS
        )

    def _draw_form(self) -> TrueState | None:
        meter, forms = self.meter, load_forms()
        form = forms[self.generator.integers(len(forms))]
        seed = int(self.generator.integers(2**31))

        def disturb(size: float) -> Disturbance:
            return form.disturbance(meter.nominal, size, np.random.default_rng(seed))

        def measure(size: float) -> float:
            if form.coordinate == "noise":
                return meter.sigmas_of_unsteady(disturb(size))
            return meter.sigmas_beyond_catalogue(meter.residual(meter.nominal, disturb(size)))

        sigmas = self._draw_strength()
        size = solve_size(measure, sigmas)
        if size is None:
            return None
        truth = Truth("outside", (), {}, (sigmas,), form.name, form.coordinate, form.place, size)
        return TrueState(truth, meter.nominal, disturb(size))


Put = Callable[[Device], Device]
"""Puts an effect into a device."""
Change = Callable[[float], tuple[Put, dict[str, float]]]
"""A function of an effect's size in units of its scale, which returns what puts the effect into a
device, and the values of its parameters."""


def solve_size(strength: Callable[[float], float], sigmas: float) -> float | None:
    """The size of an effect that has a given strength, to 1 %; None where the FMU can simulate no
    such size. It is rounded to three digits, so that rounding errors of the strengths do not show.
    """

    @cache
    def excess(logarithm: float) -> float:
        return math.log(max(strength(math.exp(logarithm)), NO_STRENGTH) / sigmas)

    def is_simulated(logarithm: float) -> bool:
        with suppress(GyroError):
            return math.isfinite(excess(logarithm))
        return False

    low, high = math.log(SMALLEST_SIZE), math.log(LARGEST_SIZE)
    while not is_simulated(high):
        high -= LOG_SIZE_STEP
        if high < low:
            return None
    if excess(high) < 0:
        return None
    return float(f"{math.exp(float(brentq(excess, low, high, xtol=0.01))):.3g}")


def _draw_direction(effect: Effect, generator: np.random.Generator) -> Array:
    """(size,) unit vector: of the only sign that the effect may have, else of a drawn direction."""
    if effect.size == 1 and effect.bounds[0] == 0:
        return np.ones(effect.size)
    if effect.size == 1:
        return np.array([generator.choice((-1.0, 1.0))])
    angle = generator.uniform(0, 2 * math.pi)
    return np.array([math.cos(angle), math.sin(angle)])
