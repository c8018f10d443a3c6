"""A block of triads: what flies, and what the bench knows of it, as arrays."""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Triads:
    """r triads of three gyros, along forward, right, down; SI.

    What the bench knows of each gyro, after calibration (`Knowledge`):
    fixed_stability, circumference_stability, instability: (r, 3) rad/s; walk: (r, 3) rad/sqrt(s);
    known: (r, 2 TERMS, 3) coefficients of its map, over the pattern angle itself;
    gain: (r, 2 TERMS, 3) what they gain per K;
    variance: (r, 2 TERMS, 3) of their errors in another power-on.

    true: (r, COUNT, 3) what the bench looked for: what flies of it as it was on the bench, noise,
    age and power-ons' scatter apart, over the pattern angle itself.

    What flies:
    start_angle: (r, 3) pattern angle at power-on, rad; rise: (r, 3) of temperature in the end, K;
    in_flight: (r, COUNT, 3) coefficients of `signals` over the pattern's turn from that angle;
    turning: (r, TURNING, 3) bias that turns the pattern (`pattern_drift`), from that angle, rad/s;
    noise: (r, KINDS, 3) strengths of the noises (`noise_weights.KINDS`);
    accelerometers: (r, 3) biases, m/s^2;
    seeds: (r, 2) entropy of each triad's noise in flight.
    """

    fixed_stability: Array
    circumference_stability: Array
    instability: Array
    walk: Array
    known: Array
    gain: Array
    variance: Array
    true: Array
    start_angle: Array
    rise: Array
    in_flight: Array
    turning: Array
    noise: Array
    accelerometers: Array
    seeds: NDArray[np.uint64]

    def __len__(self) -> int:
        return len(self.start_angle)

    def chosen(self, rows: Sequence[int]) -> "Triads":
        """Some of them."""
        return Triads(**{f.name: getattr(self, f.name)[rows] for f in fields(Triads)})

    def save(self, path: Path) -> None:
        """Into one npz, uncompressed: the same bytes from the same triads."""
        with path.open("wb") as file:
            np.savez(file, **{f.name: getattr(self, f.name) for f in fields(self)})

    @staticmethod
    def load(path: Path) -> "Triads":
        """What `save` wrote.

        Raises:
            KeyError, ValueError, OSError: it is none of it.
        """
        with np.load(path) as stored:
            return Triads(**{f.name: stored[f.name] for f in fields(Triads)})

    @staticmethod
    def joined(blocks: Sequence["Triads"]) -> "Triads":
        """All triads of some blocks, in order."""
        return Triads(
            **{
                f.name: np.concatenate([getattr(block, f.name) for block in blocks])
                for f in fields(Triads)
            }
        )
