"""The noise of a static record of any gyro or accelerometer, compared with a belief: the noise that
the sensor should have, with a tolerance. The method is in docs/methods/noise.md."""

from pyhrg.gap.static_record.run import compute_allan, diagnose_record

__all__ = ["compute_allan", "diagnose_record"]
