"""The car of `hrg validate`."""

from ins_eval.trajectories import catalogue
from ins_eval.trajectories.trajectory import Trajectory


def car(still: float, duration: float) -> Trajectory:
    """The ready mission `car`: stands for `still`, s, then drives for `duration`, s.

    It turns by 45 to 180 degrees at junctions four minutes apart, so that heading goes through the
    full circle; hills pitch it by 2 degrees, and it leans out of its turns by up to 4 degrees.
    """
    return catalogue.trajectory("car", still, duration)
