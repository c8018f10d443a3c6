"""What the user can mend; each message is one clear line."""

from fmu_build.binaries.platforms import BuildError
from fmu_build.equations.translate import TranslationError
from ins_eval.alignment.result import AlignmentError
from ins_eval.imu.gyros import GyroError
from ins_eval.imu.imu import StartUpError
from ins_eval.imu.specification import SpecificationError
from ins_eval.navigation.strapdown import NavigationError
from ins_eval.trajectories.errors import TrajectoryError
from pyhrg.records.imu.log import LogError

REFUSALS = (
    AlignmentError,
    BuildError,
    GyroError,
    LogError,
    NavigationError,
    SpecificationError,
    StartUpError,
    TrajectoryError,
    TranslationError,
)
