"""Noise-free outputs of a device in observed tests, from the two fidelities that a replay needs."""

import math
from collections import OrderedDict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from fmu_build.bundle import build_fmu
from pyhrg.common.arrays import Array, Mask
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.gap.replay.angle_derivatives import (
    ANGLE_SHIFT,
    AngleDerivatives,
    FreePattern,
    compute_derivatives,
)
from pyhrg.gap.replay.inputs.inputs import ReplayInputs
from pyhrg.gap.replay.loop_response import FORCES, apply_loop_response
from pyhrg.gap.replay.observations import (
    CHANNELS,
    COARSE_STEP,
    FINE_ROW,
    ObservedTest,
    compute_settling_time,
)
from pyhrg.gap.replay.recorder import (
    ANGLES,
    list_read_out_fields,
    list_scale_steps,
    read_change,
    scale_channels,
    take_out_scales,
)
from pyhrg.gap.replay.replay import replay_inputs, replay_together
from pyhrg.gap.replay.sampled import choose_sampled_step, is_short, replay_sampled

ChannelValues = Mapping[str, Array]
"""(n,) values in SI by field of a log."""

LOOP_FIELDS = ("amplitude_loop", "quadrature_loop", "phase_loop")
"""Parameters that quasi-steady loops do not have: their response is a transfer function's."""
QUASI_STEADY_STEP = 0.1
"""Shortest communication step of the gyro with quasi-steady loops, s. Chosen: a tenth of the usual
row."""
QUASI_STEADY_STEPS = 20
"""Largest number of its communication steps in a row. Chosen: of a row of 10 s, whose inputs change
slowly."""
STEPS_PER_FINE_ROW = 5
"""Communication steps in a row shorter than `FINE_ROW`: quasi-steady loops lag by three. Chosen."""
MIN_PHASE_LAG = 1e-9
"""Phase lag behind a drifting frequency that is neglected, rad. Chosen."""
MAX_TRANSIENT_SHARE = 0.5
"""Share of transient rows above which the whole test runs with sampled loops. Chosen."""
MAX_CACHED_ROWS = 1_000_000
"""Rows of simulations kept for repeated requests. Chosen: memory."""


@dataclass(frozen=True)
class Simulation:
    """Both fidelities of the gyro.

    sampled: `HRG`, whose loops run at 1 kHz.
    quasi_steady: `HRGSlow`, whose loops are always settled.
    """

    sampled: GyroFmu
    quasi_steady: GyroFmu
    _cache: OrderedDict[tuple[int, int], tuple[object, object, Sequence[dict[str, Array]]]] = field(
        default_factory=OrderedDict, init=False, repr=False, compare=False
    )

    def model(self, rows: int, interval: float) -> GyroFmu:
        """The simplest model that shows a small difference of two devices in full, for a test of so
        many rows of an interval, s."""
        return self.sampled if is_short(rows, interval) else self.quasi_steady

    def simulate(self, device: Device, test: ObservedTest) -> dict[str, Array]:
        """(n,) by field of a log, SI: the replay of a test.

        Sampled loops run throughout if most rows are transient. Else quasi-steady loops run, with
        the loops' linear response, and sampled loops add what they change in the angles in
        transient rows (docs/methods/replay.md, "Fidelity"). A `GyroError` where the FMU refuses
        parameters or inputs; so do the methods below.
        """
        exact = take_out_scales(device)
        (values,) = self._keep(exact, test, lambda: [self._simulate_exact(exact, test)])
        return scale_channels(values, device)

    def _simulate_exact(self, device: Device, test: ObservedTest) -> dict[str, Array]:
        """`simulate` of a device whose recorder scales no channel."""
        if np.mean(test.transient) > MAX_TRANSIENT_SHARE:
            return replay_sampled(self.sampled, device, test.inputs)
        settled = self._run_with_phase_lag(device, test.inputs)
        corrected = self._correct_angles(settled, device, test)
        turned = corrected["wave_angle"] - settled["wave_angle"]
        slopes = self.differentiate_by_angle(device, test).slopes
        shifted = {name: slopes[name] * turned for name in CHANNELS if name not in ANGLES}
        forced = apply_loop_response(corrected, device, test.log, test.log.amplitude_setpoint)
        return add_channels(forced, shifted)

    def _run_with_phase_lag(self, device: Device, inputs: ReplayInputs) -> dict[str, Array]:
        """With quasi-steady loops, and the phase loop's lag behind a frequency that drifts."""
        log = inputs.log
        coarse = replay_inputs(self.quasi_steady, device, inputs, COARSE_STEP)
        lag = np.gradient(coarse["frequency_offset"], log.interval) / device.phase_loop**2
        if np.abs(lag).max() >= MIN_PHASE_LAG:
            inputs = replace(inputs, log=replace(log, phase_offset=log.phase_offset - lag))
        step = max(QUASI_STEADY_STEP, log.interval / QUASI_STEADY_STEPS)
        return replay_inputs(self.quasi_steady, device, inputs, step)

    def _correct_angles(
        self, settled: dict[str, Array], device: Device, test: ObservedTest
    ) -> dict[str, Array]:
        """A quasi-steady replay with the angles that sampled loops give in transient rows."""
        corrections = {name: np.zeros(len(test.log.time)) for name in ANGLES}
        lead = math.ceil(compute_settling_time(device) / test.log.interval)
        for rows in _find_sections(test.transient, lead):
            begin = max(rows.start - lead, 0)
            angle = test.inputs.start_angle
            if begin:
                turned = settled["wave_angle"][begin - 1] + corrections["wave_angle"][begin - 1]
                angle = math.remainder(turned, math.pi)
            inputs = test.inputs.section(slice(begin, rows.stop), angle)
            sampled = replay_sampled(self.sampled, device, inputs)
            quasi_steady = self._run_with_phase_lag(device, inputs)
            for name in ANGLES:
                apart = sampled[name] - quasi_steady[name]
                if rows.start:
                    apart -= apart[rows.start - begin - 1]
                corrections[name][rows] += apart[rows.start - begin :]
                corrections[name][rows.stop :] += apart[-1]
        return add_channels(settled, corrections)

    def compute_difference(self, low: Device, high: Device, test: ObservedTest) -> dict[str, Array]:
        """(n,) by channel, SI: output of `high` less that of `low`, for devices that differ
        little."""
        return self.compute_differences(low, [high], test)[0]

    def compute_differences(
        self, device: Device, others: Sequence[Device], test: ObservedTest
    ) -> list[dict[str, Array]]:
        """`compute_difference` of each of the others from one device, simulated together."""
        first = self._run_cached(device, test.inputs)[1]
        read_out = [self._is_read_out(device, other, test) for other in others]
        pairs = list(zip(others, read_out, strict=True))
        runs = iter(
            self._run_coarse([(o, test.inputs) for o, is_read_out in pairs if not is_read_out])
        )
        differences = []
        for other, is_read_out in pairs:
            if is_read_out:
                last = add_channels(first, read_change(first, device, other, test.log))
            else:
                last = next(runs)
            differences.append(_subtract(first, last, device, other, test))
        steps = [list_scale_steps(device, other) for other in others]
        if not any(steps):
            return differences
        read = self.simulate(take_out_scales(device), test)
        for change, own in zip(differences, steps, strict=True):
            change |= {name: change[name] + step * read[name] for name, step in own.items()}
        return differences

    def _is_read_out(self, device: Device, other: Device, test: ObservedTest) -> bool:
        """Whether one run gives the outputs of both devices."""
        is_quasi_steady = not is_short(len(test.log.time), test.log.interval)
        read_out = list_read_out_fields(test.log)
        unseen = (*read_out, *(LOOP_FIELDS if is_quasi_steady else ()))
        kept: dict[str, Any] = {name: getattr(device, name) for name in unseen}
        return replace(other, **kept) == device

    def differentiate_by_angle(self, device: Device, test: ObservedTest) -> AngleDerivatives:
        """Derivatives of a replay by the pattern angle, by central differences of the start angle
        (docs/methods/replay.md, Eq. 7); where the drive is off, by a constant rate (Eq. 7a)."""
        low, middle, high, *turned = self._run_cached(device, test.inputs)
        pairs = ((low, middle), (middle, high), *((middle, own) for own in turned))
        below, above, *changes = (_subtract(*pair, device, device, test) for pair in pairs)
        log = test.log
        turns = ANGLE_SHIFT * (np.arange(len(log.time)) + 1) / len(log.time)
        free = FreePattern(log.is_free, turns, changes[0]) if changes else None
        return compute_derivatives(device.bryan_factor, below, above, free)

    def _run_cached(self, device: Device, inputs: ReplayInputs) -> Sequence[ChannelValues]:
        """`_run_coarse` with the start angle shifted by `-ANGLE_SHIFT`, nothing and `ANGLE_SHIFT`,
        and where the drive is off at a rate that makes the same turn, together; recent results are
        kept."""
        device = take_out_scales(device)
        angles = (inputs.start_angle + shift for shift in (-ANGLE_SHIFT, 0.0, ANGLE_SHIFT))
        shifted = [replace(inputs, start_angle=angle) for angle in angles]
        if inputs.log.is_free.any():
            rate = ANGLE_SHIFT / (len(inputs.log.time) * inputs.log.interval)
            table = replace(inputs.table, rates=inputs.table.rates + rate)
            shifted.append(replace(inputs, table=table))
        runs = [(device, own) for own in shifted]
        return self._keep(device, inputs, lambda: self._run_coarse(runs))

    def _keep(
        self, device: Device, given: object, compute: Callable[[], Sequence[dict[str, Array]]]
    ) -> Sequence[dict[str, Array]]:
        """What is computed of a device and of what is given, which are compared by identity;
        recent results are kept."""
        key = id(device), id(given)
        if key in self._cache:
            return self._cache[key][-1]
        answers = compute()
        self._cache[key] = device, given, answers
        rows = sum(_count_rows(kept) for *_, kept in self._cache.values())
        while rows > MAX_CACHED_ROWS:
            *_, oldest = self._cache.popitem(last=False)[1]
            rows -= _count_rows(oldest)
        return answers

    def _run_coarse(
        self, runs: Sequence[tuple[Device, ReplayInputs]]
    ) -> Sequence[dict[str, Array]]:
        """Runs of one log with quasi-steady loops unless the test is short, in steps that suffice
        for small differences."""
        if not runs:
            return []
        log = runs[0][1].log
        if is_short(len(log.time), log.interval):
            step = choose_sampled_step(log.interval, STEPS_PER_FINE_ROW)
            return replay_together(self.sampled, runs, step)
        if log.is_free.any():  # a free pattern turns fast
            step = QUASI_STEADY_STEP
        else:
            step = log.interval / STEPS_PER_FINE_ROW if log.interval < FINE_ROW else COARSE_STEP
        return replay_together(self.quasi_steady, runs, step)


def _count_rows(answers: Sequence[ChannelValues]) -> int:
    return sum(len(values["amplitude"]) for values in answers)


def _find_sections(transient: Mask, apart: int) -> list[slice]:
    """Sections of transient rows, merged where fewer than `apart` rows lie between."""
    rows = np.flatnonzero(transient)
    parts = np.split(rows, np.flatnonzero(np.diff(rows) > apart) + 1)
    return [slice(int(part[0]), int(part[-1]) + 1) for part in parts]


def _subtract(
    first: ChannelValues, last: ChannelValues, low: Device, high: Device, test: ObservedTest
) -> dict[str, Array]:
    """Change by channel from the first answers, of `low`, to the last, of `high`, with the loops'
    response where loops did not run, as the recorder of `high` scales it."""
    change = {name: last[name] - first[name] for name in CHANNELS}
    if is_short(len(test.log.time), test.log.interval):
        return scale_channels(change, high)
    change["quadrature"] = last["quadrature"] - first["quadrature"]
    change = apply_loop_response(change, high, test.log, 0.0)
    if any(getattr(low, name) != getattr(high, name) for name in LOOP_FIELDS):
        before, after = (apply_loop_response(dict(first), d, test.log, 0.0) for d in (low, high))
        for name in ("amplitude", *FORCES):
            change[name] = change[name] + after[name] - before[name]
    return scale_channels(change, high)


def add_channels(values: ChannelValues, difference: ChannelValues) -> dict[str, Array]:
    """Sum by channel; a channel that has no difference is unchanged."""
    return {name: own + difference.get(name, 0.0) for name, own in values.items()}


def load_model(name: str, progress: Callable[[str], None] = lambda text: None) -> GyroFmu:
    """The FMU "HRG", "HRGSlow" or "HRGCarrier", ready to be run; it is built first if there is no
    current build. `progress` is called with a sentence on each step of a build."""
    fmu = GyroFmu(build_fmu(name, progress=progress))
    fmu.prepare()
    return fmu


def load_simulation(progress: Callable[[str], None] = lambda text: None) -> Simulation:
    """Both fidelities that a replay needs."""
    return Simulation(load_model("HRG", progress), load_model("HRGSlow", progress))
