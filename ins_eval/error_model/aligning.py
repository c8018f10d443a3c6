"""Static alignment as steps of the linear error model (docs/methods/error_model.md, Eq. 10).

Alignment takes pitch and roll from the mean specific force and heading from the mean rate
(`alignment.analytic`), so that the sensors' errors at each time contribute to the attitude error.
This model is joined before that of the navigation. The final error then includes the sensors'
errors during alignment, and a bias that alignment compensates has no effect until the vehicle
turns.
"""

from collections.abc import Sequence

import numpy as np

from ins_eval.alignment.analytic import bias_sensitivity
from ins_eval.common import earth
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.effects import BIASES, Effect
from ins_eval.error_model.linear_model import LinearModel, assemble_model
from ins_eval.error_model.motion import Motion
from ins_eval.error_model.states import ATTITUDE, COUNT


def model_alignment(
    still: Motion, effects: Sequence[Effect] = BIASES, noise: SensorErrors | None = None
) -> LinearModel:
    """Model the alignment over a motion at rest.

    The attitude error is 0 at the beginning and that of the alignment at the end. Position and
    velocity errors stay as they are.
    """
    duration = still.step * len(still)
    g = np.zeros((len(still.mat_nb), COUNT, 6))
    gravity = earth.gravity(still.latitude, still.height)
    sensitivity = bias_sensitivity(still.latitude, gravity)
    g[:, ATTITUDE, :3] = sensitivity[..., :3] @ still.mat_nb / duration
    g[:, ATTITUDE, 3:] = sensitivity[..., 3:] @ still.mat_nb / duration
    return assemble_model(still, np.zeros((len(still), COUNT, COUNT)), g, effects, noise)
