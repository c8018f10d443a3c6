"""Courses on which simulated gyros go through the recorded angles and frequencies.

`HRG` at 1 kHz shows how the loops lag, and is dear. `HRGSlow` shows nearly the same at a twentieth
of the time. What `HRG` shows beyond it on the same course hardly depends on the course or on small
changes of the device. So it is taken once or twice, and all else is found on `HRGSlow` (defect
correction, Stetter 1978).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from pyhrg.device.device import Device
from pyhrg.fmu import WIDE, GyroFmu
from pyhrg.witness.replay import Course, Replay, Witnesses, guess_course, replay

FOLLOWED_ANGLE = 1e-9
"""Rms error of the simulated angles at which a course is followed, rad. Derived: a frequency split
of 1 mHz makes of it a quadrature force of 1e-11 1/s, a tenth of what an angle random walk of 1e-4
deg/sqrt(h) leaves of the force in two hours."""
CORRECTED_ANGLE = 1e-7
"""Rms error of the angles of `HRG` from which one correction leads below `FOLLOWED_ANGLE`, rad.
Derived: corrections left 4e-5 of an error of 2.4e-5 rad, with 1e5 chi-square of changes besides
(self-test and 20 min of weaving); a hundredth is asked for."""
REPLAYS = 8
"""Largest number of replays by `HRGSlow` that one course takes. Derived: each leaves of the angle's
error the bias map's slope times the flight's duration, 0.04 for 1.5 deg/h in two hours."""


@dataclass
class FollowedGyro:
    """A recorded gyro and the course on which its simulation follows it.

    Attributes:
        witnesses: recorded channels.
        course: the course that was found so far.
        target: channels that `HRGSlow` has to show where `HRG` would show the recorded ones.
        is_corrected: whether the target is known to `FOLLOWED_ANGLE`.
    """

    witnesses: Witnesses
    course: Course
    target: Witnesses
    is_corrected: bool = False


def begin(device: Device, witnesses: Witnesses) -> FollowedGyro:
    """A gyro that was not replayed yet."""
    return FollowedGyro(witnesses, guess_course(device, witnesses), witnesses)


def follow_slowly(
    slow: GyroFmu, changed: Mapping[int, Device], gyros: Sequence[FollowedGyro]
) -> dict[int, Replay]:
    """Replays of changed devices by `HRGSlow`, by their numbers, on courses that are corrected
    until their angles are those of the targets."""
    replays: dict[int, Replay] = {}
    unfollowed = list(changed)
    for _ in range(REPLAYS):
        targets = [gyros[n].target for n in unfollowed]
        replays |= _replay(slow, changed, gyros, unfollowed, targets)
        unfollowed = [n for n in unfollowed if replays[n].angle_error >= FOLLOWED_ANGLE]
        for n in unfollowed:
            gyros[n].course = replays[n].following
    return replays


def follow(
    fmus: tuple[GyroFmu, GyroFmu], changed: Mapping[int, Device], gyros: Sequence[FollowedGyro]
) -> dict[int, Replay]:
    """Replays of changed devices, by their numbers, on courses that are corrected until angles
    agree; targets that are not known well enough are corrected by `HRG` once.

    fmus: `HRG` and `HRGSlow`.
    """
    fast, slow = fmus
    replays = follow_slowly(slow, changed, gyros)
    unknown = [n for n in changed if not gyros[n].is_corrected]
    recorded = [gyros[n].witnesses for n in unknown]
    for n, each in _replay(fast, changed, gyros, unknown, recorded).items():
        gyros[n].target = _correct_target(gyros[n].target, each, replays[n])
        gyros[n].is_corrected = each.angle_error < CORRECTED_ANGLE
    return replays | follow_slowly(slow, {n: changed[n] for n in unknown}, gyros)


def _replay(
    fmu: GyroFmu,
    changed: Mapping[int, Device],
    gyros: Sequence[FollowedGyro],
    numbers: Sequence[int],
    witnesses: Sequence[Witnesses],
) -> dict[int, Replay]:
    replayed: dict[int, Replay] = {}
    for first in range(0, len(numbers), WIDE):
        part = slice(first, first + WIDE)
        devices = [changed[n] for n in numbers[part]]
        courses = [gyros[n].course for n in numbers[part]]
        replays = replay(fmu, devices, witnesses[part], courses)
        replayed |= dict(zip(numbers[part], replays, strict=True))
    return replayed


def _correct_target(target: Witnesses, fast: Replay, slow: Replay) -> Witnesses:
    """The target whose errors by `HRGSlow` are those of the recorded channels by `HRG`, on one
    course."""
    angle = target.angle.copy()
    angle[1:] += fast.angle_errors - slow.angle_errors
    return replace(
        target,
        angle=angle,
        forces=target.forces + fast.residuals - slow.residuals,
        frequency=target.frequency + fast.frequency_errors - slow.frequency_errors,
    )
