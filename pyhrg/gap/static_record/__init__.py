"""A static record of any gyro or accelerometer against what is believed of its noise."""

from pyhrg.gap.static_record.belief import Belief, BeliefError
from pyhrg.gap.static_record.record import RecordError, StaticRecord
from pyhrg.gap.static_record.result import RecordDiagnosis
from pyhrg.gap.static_record.run import diagnose, judge

__all__ = [
    "Belief",
    "BeliefError",
    "RecordDiagnosis",
    "RecordError",
    "StaticRecord",
    "diagnose",
    "judge",
]
