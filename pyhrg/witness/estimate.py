"""The present bias map of a gyro, from a log of its own channels (docs/methods/witness.md)."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from fmu_build.bundle import build_fmu
from pyhrg.common.arrays import Array
from pyhrg.common.errors import describe_briefly
from pyhrg.common.units import DEG_PER_H
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.records.log import Log
from pyhrg.witness.design import HARMONICS
from pyhrg.witness.fit import MOST_BURSTS, SIGNIFICANCE, Flown, fit_changes
from pyhrg.witness.information import compute_maps_response
from pyhrg.witness.mechanisms import NAMES, change_device
from pyhrg.witness.prior import Prior
from pyhrg.witness.replay import read_witnesses
from pyhrg.witness.responses import measure_output, measure_responses

DELAY_SIGMA = 0.02
"""Standard deviation of the prior of the amplitude force's delay beside the other channels, s.
Chosen: two periods of a recorder at 100 Hz."""
SIGMAS = f"{'sigma':>12s}{'without log':>12s}"
"""Heading of two columns of standard deviations."""


@dataclass(frozen=True)
class MapEstimate:
    """The bias map of a gyro at the end of a log, with its uncertainty.

    Attributes:
        changes: (COUNT,) estimated changes of `mechanisms.MECHANISMS` since the calibration, SI.
        covariance: (COUNT, COUNT) covariance of the changes.
        prior: distribution of the changes before the log was read.
        maps: (2 TERMS,) present maps over the pattern angle: bias of the output, rad/s, then
            scale-factor error.
        calibrated: (2 TERMS,) the device's maps at its reference temperature, in the same order.
        maps_covariance: (2 TERMS, 2 TERMS) covariance of the present maps, given the log.
        maps_prior: (2 TERMS, 2 TERMS) covariance of the present maps without the log.
        temperature: temperature of the resonator above its reference at the log's end, K.
        angle: pattern angle at the log's end, rad.
        delay, delay_sigma: time by which the amplitude force was recorded late, with its standard
            deviation, s.
        burst_share: share of the log's rows that were down-weighted as bursts.
        p_value: probability of innovations as far from white as these, if the model holds.
        is_explained: whether drifting mechanisms explain the channels and the estimate has settled.
            If not, changes and covariance are those of the prior.
    """

    changes: Array
    covariance: Array
    prior: Prior
    maps: Array
    calibrated: Array
    maps_covariance: Array
    maps_prior: Array
    temperature: float
    angle: float
    delay: float
    delay_sigma: float
    burst_share: float
    p_value: float
    is_explained: bool

    __repr__ = describe_briefly

    @property
    def summary(self) -> str:
        """The present bias map, and changes since the calibration, with their sigmas, as text."""
        lines = [
            f"{'bias map, deg/h':28s}{'calibrated':>12s}{'now':>12s}{SIGMAS}",
            *(
                f"{name:28s}{row['calibrated']:12.5f}{self._show(row['now'], '.5f')}"
                f"{row['sigma']:12.5f}{row['sigma_without_log']:12.5f}"
                for name, row in self._tabulate_map().items()
            ),
            "",
            f"{'change since calibration, SI':34s}{'now':>12s}{SIGMAS}",
            *(
                f"{name:34s}{self._show(row['now'], '.3g')}"
                f"{row['sigma']:12.2g}{row['sigma_without_log']:12.2g}"
                for name, row in self._tabulate_changes().items()
            ),
            "",
            f"temperature {self.temperature:+.2f} K; {self.burst_share:.1%} of the rows are bursts",
            f"amplitude force {self.delay:.4f} +- {self.delay_sigma:.4f} s late",
        ]
        if fixed := [
            n for n, v in zip(NAMES, self.prior.covariance.diagonal(), strict=True) if not v
        ]:
            lines.append(
                f"taken as unchanged: {', '.join(fixed)} (the device states 0, and a drift is a "
                "share of the stated value)"
            )
        if not self.is_explained:
            lines.append(f"{self._find_reason()}: the log is not followed")
        return "\n".join(lines)

    def _find_reason(self) -> str:
        """Why the log is not followed."""
        if self.burst_share > MOST_BURSTS:
            return "bursts are fewer: forces and pattern angle do not go together"
        if self.p_value <= SIGNIFICANCE:
            return f"the forces hold what no drifting mechanism makes (p = {self.p_value:.1g})"
        return "the estimate has not settled"

    def _show(self, now: float, digits: str) -> str:
        """A dash where the log is not followed: nothing was estimated."""
        return f"{now:12{digits}}" if self.is_explained else f"{'-':>12s}"

    @property
    def document(self) -> dict[str, Any]:
        """The summary's figures as JSON values; changes in SI."""
        return {
            "bias_map_deg_h": self._tabulate_map(),
            "changes": self._tabulate_changes(),
            "temperature_k": float(self.temperature),
            "delay_s": self.delay,
            "delay_sigma_s": self.delay_sigma,
            "burst_share": float(self.burst_share),
            "p_value": float(self.p_value),
            "is_explained": self.is_explained,
        }

    def _tabulate_map(self) -> dict[str, dict[str, float]]:
        names = ["mean", *(f"{wave} {h} th" for h in HARMONICS for wave in ("cos", "sin"))]
        known, before = (np.sqrt(np.diag(each)) for each in (self.maps_covariance, self.maps_prior))
        columns = {
            "calibrated": self.calibrated,
            "now": self.maps,
            "sigma": known,
            "sigma_without_log": before,
        }
        return {
            name: {key: float(values[i] / DEG_PER_H) for key, values in columns.items()}
            for i, name in enumerate(names)
        }

    def _tabulate_changes(self) -> dict[str, dict[str, float]]:
        known, before = (
            np.sqrt(np.diag(each)) for each in (self.covariance, self.prior.covariance)
        )
        return {
            name: {
                "now": float(change),
                "sigma": float(sigma),
                "sigma_without_log": float(prior),
            }
            for name, change, sigma, prior in zip(NAMES, self.changes, known, before, strict=True)
            if prior > 0
        }


def estimate_map(
    log: Log, device: Device, prior: Prior, delay_sigma: float = DELAY_SIGMA
) -> MapEstimate:
    """Estimate the bias map of a gyro at the end of a log from the gyro's own channels.

    The FMU is run with the log's motion. Changes of the mechanisms are fitted to the differences of
    recorded and simulated forces.

    Args:
        log: with the columns of `replay.REQUIRED`; rows of 0.01 to 1 s.
        device: the gyro as it was calibrated.
        prior: distribution of the changes (`make_drift_prior`).
        delay_sigma: standard deviation, s, of the time by which the amplitude force was recorded
            later than the other channels, before the log is read; 0 where one clock records all.

    Raises:
        HrgError: the log lacks a column, is too short, or has commands but virtual rotation.
    """
    witnesses = read_witnesses(log, device)
    slow, fast = GyroFmu(build_fmu("HRGSlow")), GyroFmu(build_fmu("HRG"))
    gyro = Flown(device, witnesses, prior, measure_responses(slow, device), delay_sigma)
    (fitted,) = fit_changes(fast, slow, [gyro])
    changes, covariance = fitted.changes, fitted.covariance
    if not fitted.is_explained:
        changes, covariance = prior.mean, prior.covariance
    response = compute_maps_response(fitted.responses, fitted.temperature)
    return MapEstimate(
        changes=changes,
        covariance=covariance,
        prior=prior,
        maps=measure_output(slow, change_device(device, changes), fitted.temperature),
        calibrated=measure_output(slow, device, 0.0),
        maps_covariance=response @ covariance @ response.T,
        maps_prior=response @ prior.covariance @ response.T,
        temperature=fitted.temperature,
        angle=fitted.angle,
        delay=fitted.delay,
        delay_sigma=fitted.delay_sigma,
        burst_share=fitted.burst_share,
        p_value=fitted.p_value,
        is_explained=fitted.is_explained,
    )
