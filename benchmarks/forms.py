"""Further errors outside the catalogue, to see which candidate terms are missing.

    python benchmarks/forms.py FOLDER SEED COUNT

Makes campaigns of a good laboratory, each with one of these forms, drawn at random, diagnoses and
scores them. The forms of `hrg gap challenge` were written without knowledge of the candidate terms.
These were written with it, so that their score is no evidence of how often the diagnosis is right.
One process does all the work, because others would load the challenge's own forms.
"""

import sys

import numpy as np

from pyhrg import run_challenge
from pyhrg.challenge.truths import form
from pyhrg.challenge.truths.conditions import Conditions
from pyhrg.challenge.truths.entry import command, damp, damp_along_axis, misread, show, turn, vary
from pyhrg.challenge.truths.form import Form, follow
from pyhrg.challenge.truths.outside import FAST, KELVINS, SLOW, fade, jump, warm, wave
from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG_PER_H, HZ, MINUTE, PPM, STANDARD_GRAVITY

SPLIT = "resonator.material.splitPerAcceleration"
GAIN = "pickOff.gainPerAcceleration"
FRAME = "drive.rotationPerAcceleration"


def weigh(now: Conditions, axis: int) -> Array:
    """Specific force along an axis, over gravity."""
    return now.acceleration[axis] / STANDARD_GRAVITY


def lag_twice(now: Conditions, draw: np.random.Generator) -> Array:
    """The temperature behind a second lag, of 1500 to 4000 s."""
    step = now.interval / now.warmth.shape[1]
    late = follow(now.warmth.ravel(), step, draw.uniform(1500, 4000))
    return late.reshape(now.warmth.shape) / KELVINS


def warm_harmonic(now: Conditions, draw: np.random.Generator) -> Array:
    """A second harmonic of the pattern angle in proportion to the temperature."""
    return wave(2)(now, draw) * now.warmth / KELVINS


FORMS = (
    Form("split_settles", "stiffness", "time", vary(SPLIT, 1e-5 * HZ, fade(300, 1500)),
         "A trimmed shell relaxes after power-on."),
    Form("split_jump", "stiffness", "time", vary(SPLIT, 1e-5 * HZ, jump),
         "A particle leaves the rim."),
    Form("split_gradient", "stiffness", "temperature_rate",
         vary(SPLIT, 1e-5 * HZ, lambda now, draw: now.warming * MINUTE),
         "A gradient across the rim stresses one axis."),
    Form("split_temperature_squared", "stiffness", "temperature",
         vary(SPLIT, 1e-5 * HZ, warm(2)), "Two moduli differ to second order."),
    Form("frequency_settles", "stiffness", "time",
         show("frequency_offset", 1e-4 * HZ, fade(200, 1500)), "A glue joint relaxes."),
    Form("frequency_acceleration_squared", "stiffness", "acceleration",
         show("frequency_offset", 1e-4 * HZ, lambda now, draw: weigh(now, 2) ** 2),
         "Weight along the stem stresses the shell the same way up and down."),
    Form("warm_second_harmonic", "bias", "temperature", turn(0.01 * DEG_PER_H, warm_harmonic),
         "The gap of a shell off centre grows as it warms."),
    Form("temperature_cubed", "bias", "temperature", turn(0.01 * DEG_PER_H, warm(3)),
         "A compensation to second order leaves the third."),
    Form("acceleration_across", "bias", "acceleration",
         turn(0.05 * DEG_PER_H, lambda now, draw: weigh(now, 0)), "Weight bends the stem."),
    Form("acceleration_product", "bias", "acceleration",
         turn(0.05 * DEG_PER_H, lambda now, draw: weigh(now, 0) * weigh(now, 2)),
         "A bent stem bends further under a load along it."),
    Form("second_thermal_lag", "bias", "temperature", turn(0.01 * DEG_PER_H, lag_twice),
         "A heavy part of the mount follows slowly."),
    Form("warming_magnitude", "bias", "temperature_rate",
         turn(0.01 * DEG_PER_H, lambda now, draw: np.abs(now.warming) * MINUTE),
         "The mount rubs while it expands or shrinks."),
    Form("bias_harmonic_8", "bias", "wave_angle", turn(0.1 * DEG_PER_H, wave(8)),
         "Eight electrodes repeat round the shell."),
    Form("readout_harmonic_6", "readout", "wave_angle", misread(0.1 * ARCSEC, wave(6)),
         "A converter has a cubic error."),
    Form("readout_harmonic_2", "readout", "wave_angle", misread(0.1 * ARCSEC, wave(2)),
         "A sum has an offset that the loops do not see."),
    Form("scale_temperature", "readout", "temperature",
         turn(10 * PPM, lambda now, draw: now.rate * now.warmth / KELVINS),
         "The angular gain follows the wall."),
    Form("damping_harmonic_2", "damping", "wave_angle", damp(1e-8, wave(2)),
         "A coating is thicker on one side."),
    Form("damping_acceleration", "damping", "acceleration",
         damp(1e-8, lambda now, draw: weigh(now, 2)), "The support's loss follows its load."),
    Form("damping_rate_squared", "damping", "rate",
         damp(1e-8, lambda now, draw: (now.rate / FAST) ** 2), "Rest gas is thrown outwards."),
    Form("damping_temperature_squared", "damping", "temperature", damp(1e-8, warm(2)),
         "Internal friction curves."),
    Form("anisotropy_settles", "damping", "time", damp_along_axis(1e-7, fade(300, 1500)),
         "Water leaves one side of the shell."),
    Form("anisotropy_acceleration", "damping", "acceleration",
         damp_along_axis(1e-7, lambda now, draw: weigh(now, 2)), "A joint slips under load."),
    Form("phase_drift", "electronics", "time",
         command("phase_offset", 1e-5, lambda now, draw: now.time / 3600), "An oscillator ages."),
    Form("phase_temperature_squared", "electronics", "temperature",
         command("phase_offset", 1e-5, warm(2)), "A filter has a second temperature coefficient."),
    Form("set_point_drift", "electronics", "time",
         command("amplitude_setpoint", 1e-6, lambda now, draw: now.time / 3600),
         "A voltage reference ages."),
    Form("encoder_temperature", "bench", "temperature",
         show("table_angle", ARCSEC, lambda now, draw: (now.case - now.case.ravel()[0]) / KELVINS),
         "A chamber twists the table's column."),
    Form("commanded_rotation_squared", "drive", "rate",
         turn(0.05 * DEG_PER_H, lambda now, draw: np.sign(now.virtual_rotation)
              * (now.virtual_rotation / SLOW) ** 2), "A drive amplifier saturates."),
    Form("frame_settles", "drive", "time", vary(FRAME, 1e-5, fade(300, 1500)),
         "A cable relaxes."),
    Form("frame_temperature", "drive", "temperature", vary(FRAME, 1e-5, warm(1)),
         "The electrodes' block turns as it warms."),
    Form("gain_settles", "pickoff", "time", vary(GAIN, 1e-6, fade(300, 1500)),
         "A preamplifier warms up."),
    Form("gain_temperature_squared", "pickoff", "temperature", vary(GAIN, 1e-6, warm(2)),
         "A preamplifier has a second temperature coefficient."),
)  # fmt: skip


def main(folder: str, seed: str, count: str) -> None:
    form.FORMS_MODULE = __name__
    kinds = {"none": 0, "single": 0, "pairs": 0, "outside": int(count)}
    level = "good-lab"
    score = run_challenge(folder, **kinds, level=level, seed=int(seed), workers=1, progress=True)
    print(score.summary)


if __name__ == "__main__":
    main(*sys.argv[1:])
