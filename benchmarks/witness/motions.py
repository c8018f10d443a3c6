"""What gyros of a mission go through, with and without a self-test by virtual rotation."""

from dataclasses import dataclass

import numpy as np

from ins_eval.error_model.effects import ANGULAR_GAIN
from ins_eval.imu.gyros import resolve_force_in_case
from ins_eval.mission_model.missions import STILL, plan_mission
from ins_eval.mission_model.signals import compute_case_warming_rate, compute_resonator_warmth
from ins_eval.study.witness.self_test import rotate_virtually
from pyhrg.common.arrays import Array
from pyhrg.witness.responses import Motion, stack_signals

ROW = 0.5
"""Length of a row, s."""
CLASSES = {
    "car": "car",
    "aircraft": "aircraft with rolls",
    "airliner": "aircraft without rolls",
    "long-haul": "great circle",
    "ship": "ship",
    "missile": "missile",
    "city": "city",
    "static-table": "turntable",
}
"""Mission classes of the study by the mission that stands for them."""


@dataclass(frozen=True)
class Ride:
    """A mission's motion from power-on. rate: (n, 3) about the body axes in each row, rad/s;
    forces: (3, n, 3) specific force along the axes of each gyro's case, m/s^2; row: length of a
    row, s."""

    rate: Array
    forces: Array
    row: float

    def follow(self, axis: int, start: float, rise: float, test: float = 0.0) -> Motion:
        """The motion of the gyro along a body axis.

        start: pattern angle at power-on, rad; rise: final rise of temperature, K; test: duration of
        a self-test at power-on, s.
        """
        since = self.row * (np.arange(len(self.rate)) + 0.5)
        rotation = rotate_virtually(since, test)
        rate = self.rate[:, axis]
        angle = start + self.row * ANGULAR_GAIN * np.cumsum(rotation - rate)
        temperature = rise * compute_resonator_warmth(since - STILL)
        heating = rise * compute_case_warming_rate(since - STILL)
        signals = stack_signals(heating, self.forces[axis])
        return Motion(self.row, angle, rate, rotation, temperature, signals)


def load_ride(mission: str, hours: float, row: float = ROW) -> Ride:
    planned = plan_mission(mission, hours)
    rows = round((STILL + planned.hours * 3600) / row)
    increments = planned.trajectory().increments(-STILL, row, rows)
    forces = np.stack([resolve_force_in_case(increments, axis) for axis in np.eye(3)])
    return Ride(increments.rotation / row, forces, row)
