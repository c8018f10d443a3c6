"""Residuals: the records without effects and candidate terms of given sizes."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pyhrg.common.arrays import Array, Mask
from pyhrg.device.device import Device
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Sizes, TestChannel
from pyhrg.gap.effects.form import Form, build_form_columns, build_reading_columns
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.effects.linear_test import Group, LinearTest
from pyhrg.gap.effects.term_columns import select_term_columns
from pyhrg.gap.replay.observations import CHANNELS
from pyhrg.gap.whitening.campaign_noise import CampaignNoise
from pyhrg.gap.whitening.whitening import NoiseModel, whiten
from pyhrg.records import Log

AMPLITUDE_TOLERANCE = 0.05
"""An amplitude set point counts as nominal when it differs by less than this share. Chosen."""


@dataclass(frozen=True)
class Residual:
    """Residual of one channel in one test.

    values: (n,) record less simulation, SI.
    steps: (n,) time since the reading before, s.
    interval: length of a row, s.
    noise: noise model of the channel.
    unmodelled: (n,) shape that may be there (`whiten`'s last argument).
    model_error: chi-square that the removed responses may get wrong (docs/methods/evidence.md, Eq.
        10). It counts as noise when noises are compared.
    """

    test: str
    channel: str
    values: Array
    steps: Array
    interval: float
    noise: NoiseModel
    unmodelled: Array | None = None
    model_error: float = 0.0

    @cached_property
    def white(self) -> Array:
        """(n,) whitened, in sigma."""
        return whiten(self.values[:, None], self.steps, self.noise, self.unmodelled).series[:, 0]

    @property
    def times(self) -> Array:
        """(n,) time of each reading, s."""
        return np.cumsum(self.steps)


def compute_residuals(
    parts: Sequence[LinearTest],
    removed: Sizes,
    noise: CampaignNoise,
    channels: Sequence[str] = CHANNELS,
    model_error: Mapping[TestChannel, float] | None = None,
) -> list[Residual]:
    """Residuals of some channels, fields of a log, in all tests, without the groups of these sizes.

    The output angle is used only while the amplitude is nominal: at a smaller amplitude its noise
    is larger. Other channels are compared where the pattern is as measured.
    """
    of_output: Sizes = {
        g: v
        for g, v in removed.items()
        if isinstance(g, Effect) or (isinstance(g, Jump) and g.kind == "output")
    }  # what moves the output; not what moves the pattern that other channels see
    misread = [g for g in removed if isinstance(g, CandidateTerm) and g.is_reading_error]
    residuals = []
    for index, part in enumerate(parts):
        angle = _subtract(part, of_output, "gyro_angle", index)[:, None]
        for group, values in build_reading_columns(part.where, misread):
            angle -= (values @ removed[group])[:, None]
        for channel in channels:
            series = _subtract(part, removed, channel, index)[:, None]
            values = part.at_measured_angle(series, angle, channel)[:, 0]
            rows = part.test.rows[channel]
            if channel == "gyro_angle":
                rows = rows & is_nominal(part.test.log, part.nominal)
            residuals.append(
                Residual(
                    part.test.test.id,
                    channel,
                    values[rows],
                    np.diff(part.test.log.time[rows], prepend=0.0),
                    part.test.log.interval,
                    noise.get_model(channel, part.test, rows),
                    part.unmodelled[channel][rows],
                    (model_error or {}).get((part.test.test.id, channel), 0.0),
                )
            )
    return residuals


def select_distinct(*choices: Sizes | Mapping[Effect, Array]) -> list[Sizes]:
    """The choices whose groups differ; of those with the same groups the last one."""
    by_groups: dict[tuple[Group, ...], Sizes] = {}
    for removed in choices:
        by_groups[tuple(removed)] = dict[Group, Array](removed.items())
    return list(by_groups.values())


def _subtract(part: LinearTest, removed: Sizes, channel: str, index: int) -> Array:
    """(n,) residual of a channel in the test of this index, less the groups' responses."""
    residual = part.residual[channel].copy()
    terms = {g for g in removed if not isinstance(g, Effect)}
    columns: dict[Group, Array] = {}
    if terms:
        forms = [g for g in terms if isinstance(g, Form)]
        columns.update(select_term_columns(part.where, channel, terms).items())
        columns.update(build_form_columns(part.where, channel, forms))
    for group, size in removed.items():
        if isinstance(group, Effect):
            residual -= part.sensitivities[group][channel] @ size
        elif group in columns:
            residual -= columns[group] @ (size[[index]] if group.is_of_each_power_on else size)
    return residual


def is_nominal(log: Log, nominal: Device) -> Mask:
    """(n,) rows in which the drive holds the nominal amplitude."""
    difference = np.abs(log.amplitude_setpoint - nominal.amplitude)
    is_near = difference < AMPLITUDE_TOLERANCE * nominal.amplitude
    return np.asarray(is_near & log.is_driven)
