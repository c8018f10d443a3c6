"""Which channels and rows of a campaign's logs are compared with the simulation."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from pyhrg.common.arrays import Array, Mask
from pyhrg.device.device import Device
from pyhrg.gap.replay.inputs.inputs import ReplayInputs, prepare_inputs
from pyhrg.gap.replay.inputs.table_steps import ERROR_PER_STEP, find_turning_rows
from pyhrg.gap.replay.loop_response import FORCES
from pyhrg.gap.replay.reading_noise import ReadingNoise
from pyhrg.gap.replay.replay import HELD_COLUMNS
from pyhrg.records import Log
from pyhrg.records.campaign import Test

CHANNEL_WORDS = {
    "gyro_angle": "output angle",
    "amplitude": "amplitude",
    "amplitude_force": "amplitude force",
    "quadrature_force": "quadrature force",
    "frequency_offset": "loop frequency",
}
CHANNELS = tuple(CHANNEL_WORDS)
"""Fields of a log that are compared. The wave angle is not: the output angle follows from it."""
MEAN_CHANNELS = (*FORCES, "frequency_offset")
"""Channels of which a log has means over its rows; the others are taken at the rows' ends."""
LOOP_COMMANDS = ("drive_on", "virtual_rotation", "amplitude_setpoint", "phase_offset")
"""Commands whose change puts the loops, and through them the pattern, into a transient."""
AMPLITUDE_COMMANDS = ("drive_on", "amplitude_setpoint")
"""Commands after whose change the drive pushes: the amplitude of the row before is not compared, as
a late reading of it shows the push."""
COMMAND_COLUMNS = (
    "axis_up",
    *(name for name in HELD_COLUMNS if not name.startswith("acceleration")),
)
"""Commands and attitude. After one of them changes, every channel but the output angle is left out
until the loops settle."""
MIN_SETTLING_TIME = 4.0
"""Shortest time after which a change counts as settled, s. Chosen."""
SETTLING_TIME_CONSTANTS = 24
"""Settling time in time constants of the slowest loop. Chosen: exp(-24) is 4e-11."""
ACCELERATION_LIMIT = 1e-3
"""Angular acceleration of the table above which loops are in a transient, rad/s^2. Chosen."""
SPECIFIC_FORCE_STEP = 1.0
"""Change of specific force from row to row above which loops settle anew, m/s^2: it steps the
g-sensitive gain. Chosen."""
FORCE_RATE_LIMIT = 0.02
"""Table rate below which quasi-steady loops with a linear response give the forces, rad/s.
Chosen."""
ANGLE_RATE_LIMIT = 1e-3
"""Table rate below which lagging loops change no angle, rad/s. Chosen."""
PHASE_OFFSET_LIMIT = 0.01
"""Largest phase offset that quasi-steady loops represent, rad. Chosen."""
COARSE_STEP = 1.0
"""Longest communication step for a small difference of two devices with quasi-steady loops, s.
Chosen."""
COARSE_SETTLING_STEPS = 20
"""Steps after which quadrature in such a simulation is settled to 0.2 %."""
FINE_ROW = 0.2
"""Rows shorter than this resolve how loops follow, s; such tests run with sampled loops. Chosen."""


@dataclass(frozen=True)
class ObservedTest:
    """A test with its replayable inputs and the rows of each channel that are compared.

    rows: (n,) by channel. The angle must be present too, since it gives the pattern's position.
    transient: (n,) rows in which loops are not settled, so that their replay needs sampled loops.
    reading_noise: (n,) by channel, SI: standard deviation of the white noise that readings of the
        bench's angles add to a comparison; a channel without any is missing.
    encoder_step: difference of neighbouring readings of the encoder, rad; 0 where none is seen.
    noise_growth: (n,) by channel: standard deviation of its noise over that at nominal amplitude;
        a channel whose noise does not grow is missing.
    line_period: of a line that the residuals of the campaign show, s.
    unexplained: by channel: chi-square for each component of what no set of effects and terms
        explains; a channel of which little more than noise is left is missing.
    """

    test: Test
    inputs: ReplayInputs
    rows: Mapping[str, Mask]
    transient: Mask
    reading_noise: Mapping[str, Array] = field(default_factory=dict)
    encoder_step: float = 0.0
    noise_growth: Mapping[str, Array] = field(default_factory=dict)
    line_period: float | None = None
    unexplained: Mapping[str, float] = field(default_factory=dict)

    @property
    def log(self) -> Log:
        """Log of the test, with the inputs that are replayed."""
        return self.inputs.log


def compute_settling_time(device: Device) -> float:
    """Time that loops need to settle after a command or a change of the table's rate, s."""
    slowest = min(device.amplitude_loop, device.quadrature_loop, device.phase_loop)
    return max(MIN_SETTLING_TIME, SETTLING_TIME_CONSTANTS / slowest)


def observe_test(test: Test, nominal: Device, encoder_noise: float = 0.0) -> ObservedTest:
    """Select what a test has to compare (docs/methods/replay.md, "Rows that are compared"). Its log
    has complete inputs; the nominal device gives the start angle, and the loops' settling time.
    `encoder_noise`, rad: see `prepare_inputs`."""
    log = test.log
    inputs = prepare_inputs(log, nominal, encoder_noise)
    transient = _find_transient_rows(log, inputs, compute_settling_time(nominal))
    coarse = COARSE_SETTLING_STEPS * min(COARSE_STEP, log.interval)
    changed = find_command_changes(log)
    if log.interval >= FINE_ROW:
        changed |= find_table_acceleration(inputs) | _find_rotation(inputs, FORCE_RATE_LIMIT)
    duration = max(compute_settling_time(nominal), coarse)
    settled = find_undisturbed_rows(log, changed, duration)
    held = find_undisturbed_rows(log, _find_amplitude_changes(log, nominal), duration)
    pushed_next = np.append(_find_changes(log, AMPLITUDE_COMMANDS)[1:], False)
    rows = {}
    for name in CHANNELS:
        compared = np.isfinite(getattr(log, name)) & np.isfinite(log.gyro_angle)
        compared &= held if name == "gyro_angle" else settled
        if name in FORCES:
            compared &= log.is_driven
        if name == "amplitude":
            compared &= ~pushed_next
        rows[name] = compared
    rows["temperature"] = np.isfinite(log.temperature)
    return ObservedTest(test, inputs, rows, transient)


def add_reading_noise(
    test: ObservedTest, noise: ReadingNoise, slopes: Mapping[str, Array]
) -> ObservedTest:
    """The test with a bench's reading noise; `slopes` are the (n,) derivatives of each channel by
    the output angle, since all others are compared at the measured pattern angle
    (docs/methods/replay.md, Eq. 10)."""
    table = test.inputs.log.table_angle
    rates = np.abs(np.gradient(table, test.log.interval))
    rounding = ERROR_PER_STEP * noise.encoder_step * find_turning_rows(table)
    encoder = np.hypot(noise.encoder.value, rounding) if np.ptp(table) else 0.0
    angle = np.hypot(encoder, noise.jitter * rates)
    pattern = np.hypot(angle, noise.row_jitter.value * rates)
    by_channel = {name: np.abs(slope) * pattern for name, slope in slopes.items()}
    by_channel["gyro_angle"] = angle
    levels = {n: v for n, v in by_channel.items() if v.any()}
    return replace(test, reading_noise=levels, encoder_step=noise.encoder_step)


def see_angles(channel: str, angles: Array) -> Array:
    """(n, ...) angles at the ends of the rows, as a channel sees them: a mean over a row is taken
    at the mean angle of its ends (docs/methods/effects.md, Eq. 3)."""
    if channel not in MEAN_CHANNELS:
        return angles
    begins = np.concatenate((angles[:1], angles[:-1]))
    return np.where(np.isfinite(begins), (begins + angles) / 2, angles)


def _find_transient_rows(log: Log, inputs: ReplayInputs, settling_time: float) -> Mask:
    """(n,) rows whose angle needs sampled loops; all rows where quasi-steady loops don't hold even
    between changes."""
    is_special = (
        (log.virtual_rotation != 0) | log.is_free | (np.abs(log.phase_offset) > PHASE_OFFSET_LIMIT)
    )
    if log.interval < FINE_ROW or is_special.any():
        return np.ones(len(log.time), dtype=bool)
    changed = find_table_acceleration(inputs) | _find_rotation(inputs, ANGLE_RATE_LIMIT)
    changed |= _find_changes(log, LOOP_COMMANDS)
    return ~find_undisturbed_rows(log, changed, settling_time + log.interval)


def _find_rotation(inputs: ReplayInputs, limit: float) -> Mask:
    """(n,) rows in which the table turns faster than a limit, rad/s."""
    rates = np.abs(inputs.table.rates)
    return np.asarray(np.maximum(rates[1:], rates[:-1]) > limit)


def _find_changes(log: Log, names: Sequence[str]) -> Mask:
    """(n,) rows in which one of these columns changes, and the first row."""
    changed = np.zeros(len(log.time), dtype=bool)
    changed[0] = True
    for name in names:
        changed |= np.diff(getattr(log, name), prepend=getattr(log, name)[0]) != 0
    return changed


def _find_amplitude_changes(log: Log, nominal: Device) -> Mask:
    """(n,) rows in which the drive is to change the amplitude. It pushes hard then, and small
    differences of quasi-steady gyros are late by three communication steps."""
    if log.interval < FINE_ROW:
        return np.zeros(len(log.time), dtype=bool)
    set_points = np.diff(log.amplitude_setpoint, prepend=nominal.amplitude) != 0
    return np.asarray(set_points | (np.diff(log.drive_on, prepend=log.drive_on[0]) > 0))


def find_command_changes(log: Log) -> Mask:
    """(n,) rows in which a command or the attitude changes, and the first row."""
    changed = _find_changes(log, COMMAND_COLUMNS)
    for axis in "xyz":
        force = getattr(log, f"acceleration_{axis}")
        changed |= np.abs(np.diff(force, prepend=force[0])) > SPECIFIC_FORCE_STEP
    return changed


def find_table_acceleration(inputs: ReplayInputs) -> Mask:
    """(n,) rows in which the table's rate changes by more than `ACCELERATION_LIMIT`."""
    changes = np.maximum(np.abs(np.diff(inputs.table.rates)), np.abs(inputs.table.parabola_means))
    return np.asarray(changes / inputs.log.interval > ACCELERATION_LIMIT)


def find_undisturbed_rows(log: Log, changed: Mask, duration: float) -> Mask:
    """(n,) rows with no changed row in the duration, s, before them."""
    last = np.maximum.accumulate(np.where(changed, log.time, -np.inf))
    return np.asarray(log.time - last >= duration)
