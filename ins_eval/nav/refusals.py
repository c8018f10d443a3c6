"""What the user can mend; each message is one clear line."""

from ins_eval.alignment.result import AlignmentError
from ins_eval.imu.log import LogError
from ins_eval.imu.specification import SpecificationError
from ins_eval.navigation.strapdown import NavigationError
from ins_eval.trajectories.errors import TrajectoryError

REFUSALS = (AlignmentError, LogError, NavigationError, SpecificationError, TrajectoryError)
