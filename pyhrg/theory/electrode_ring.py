"""What an uneven gap makes of a ring of electrodes that read and drive alike, in closed form."""

import math


def combine_gap_harmonics(
    first: complex, second: complex, third: complex, fourth: complex
) -> complex:
    """Fourth harmonic that acts, of a gap d (1 + Re sum E_n exp(-i n phi)) with these E_n.

    A pick-off's gain goes with 1/gap^2, whose second order is 3 E^2: E_4 - (3/2) E_1 E_3 -
    (3/4) E_2^2.
    """
    return fourth - 1.5 * first * third - 0.75 * second**2


def lump_gap_harmonic(fourth: complex, electrodes: int, coverage: float) -> tuple[float, float]:
    """Gain mismatch g and non-orthogonality d of pick-offs and drives alike, to first order.

    Eight electrodes of half width b stand where the harmonic's cosine is at its peaks: with
    j = sin 6b/(6 sin 2b), g = -(2 + 4j) Re E_4 and d = -(2 - 4j) Im E_4. Sixteen sample it evenly,
    j = 0. The drives' frame is turned by -d against the pick-offs, so that no mean bias is left.
    """
    half_width = math.pi / electrodes * coverage
    share = math.sin(6 * half_width) / (6 * math.sin(2 * half_width)) if electrodes == 8 else 0.0
    return -(2 + 4 * share) * fourth.real, -(2 - 4 * share) * fourth.imag
