"""The free vibration of the linear shell in closed form: a ring-down.

The averaged envelope obeys Z' = A Z with a constant A while the rate is constant: decay 1/tau,
damping anisotropy D e^{4i th_tau}, split dw e^{4i th_w} and the Coriolis coupling 2 k Omega (Lynch
1995, averaged equations). For a 2 x 2 matrix the exponential is elementary.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array

Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class FreeShell:
    """Coefficients of the shell's free motion.

    Attributes:
        decay: 1/tau, 1/s.
        damping: D exp(4i th_tau), 1/s.
        split: dw exp(4i th_w), rad/s.
    """

    decay: float
    damping: complex
    split: complex

    def orbit(
        self, time: Array, angle: float, pattern_rate: float, pickoff: complex = 0j
    ) -> tuple[Array, Array]:
        """Pattern angle, rad, continuous, and logarithm of the antinode amplitude, (n,) each, as
        pick-offs see them.

        Args:
            time: (n,) since the drive was switched off, s, ascending.
            angle: pattern angle as the drive is switched off, rad; the amplitude is 1 then, the
                quadrature zero.
            pattern_rate: rate of the pattern by rotation of the case alone, -k Omega, rad/s.
            pickoff: gain mismatch g and non-orthogonality d of the pick-offs, g + i d.
        """
        x, y = self._envelope(time, angle, pattern_rate)
        x, y = (1 + pickoff.real / 2) * x, (1 - pickoff.real / 2) * (y + pickoff.imag * x)
        energy = np.abs(x) ** 2 + np.abs(y) ** 2
        stokes = np.abs(x) ** 2 - np.abs(y) ** 2 + 2j * (x * y.conj()).real
        turns = np.unwrap(np.concatenate(([4 * angle], np.angle(stokes))))[1:] / 4
        # the decay is common to both: added here, so that the exponential never underflows
        antinode = np.log((energy + np.abs(stokes)) / 2) / 2
        return np.asarray(turns), np.asarray(antinode - self.decay * time)

    def _envelope(self, time: Array, angle: float, pattern_rate: float) -> tuple[Complex, Complex]:
        """(n,) envelopes X = cx - i sx and Y, the common decay taken out: exp(B t) = cosh(m t) +
        B sinh(m t)/m with m^2 = -det B, for a matrix B without trace."""
        diagonal = -(self.damping.real + 1j * self.split.real) / 2
        symmetric = -(self.damping.imag + 1j * self.split.imag) / 2
        turn = 2 * pattern_rate
        m = np.sqrt(diagonal**2 + symmetric**2 - turn**2 + 0j)
        even = np.cosh(m * time)
        odd = np.sinh(m * time) / m if abs(m) > 0 else time + 0j
        c, s = np.cos(2 * angle), np.sin(2 * angle)
        x = even * c + odd * (diagonal * c + (symmetric - turn) * s)
        y = even * s + odd * ((symmetric + turn) * c - diagonal * s)
        return np.asarray(x), np.asarray(y)
