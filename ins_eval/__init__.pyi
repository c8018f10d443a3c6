from .aided.aid import aid
from .aided.report import AidedDrive
from .flights.align_record import align
from .flights.align_report import AlignedRecord
from .flights.fly import fly, fly_log
from .flights.report import Flight
from .flights.sources import read_record, write_record
from .imu.specification import list_imus, load_imu
from .navigation.strapdown import navigate
from .parking.parking import ParkingComparison, compare_parking
from .position.front import PositionGap, compute_position_gap
from .schedules.schedules import (
    ChosenSchedules,
    ScheduleComparison,
    choose_schedules,
    compare_schedules,
)
from .study.challenge.challenge import hand_out_challenge, score_challenge
from .study.run_study import StudyResult, run_study
from .study.study_file import load_study
from .study.summary.predict_error import predict_error
from .study.validation.validate import validate
from .system.system import write_system
from .trajectories.catalogue import list_trajectories, load_trajectory

__all__ = [
    "AidedDrive",
    "AlignedRecord",
    "ChosenSchedules",
    "Flight",
    "ParkingComparison",
    "PositionGap",
    "ScheduleComparison",
    "StudyResult",
    "aid",
    "align",
    "choose_schedules",
    "compare_parking",
    "compare_schedules",
    "compute_position_gap",
    "fly",
    "fly_log",
    "hand_out_challenge",
    "list_imus",
    "list_trajectories",
    "load_imu",
    "load_study",
    "load_trajectory",
    "navigate",
    "predict_error",
    "read_record",
    "run_study",
    "score_challenge",
    "validate",
    "write_record",
    "write_system",
]
