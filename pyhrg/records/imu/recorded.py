"""Logs of IMUs in any known format; the content of the file shows which."""

from pathlib import Path

from pyhrg.common.reading.files import decode, read_unpacked
from pyhrg.common.reading.messages import is_novatel, is_vectornav
from pyhrg.records.imu import kf_gins, novatel, psins, vectornav
from pyhrg.records.imu.log import RecordedImu
from pyhrg.records.imu.table_log import PARQUET, read_csv, read_parquet


def read_imu_log(path: Path, trusted: bool = False) -> RecordedImu:
    """Read the log of an IMU: PSINS or KF-GINS text, messages of NovAtel or VectorNav, CSV or
    Parquet (docs/imus.md), gzipped or not.

    Args:
        path: the file.
        trusted: whether units and axes are taken as stated though gravity or Earth's rate
            contradict them.

    Raises:
        HrgError: the file can't be read or is cut off; a checksum is wrong; a column is missing or
            stands there twice; a row has too few or too many fields; a field is no finite number;
            time stands, runs back or steps unevenly; there are too few rows; a unit, axis or column
            is another than stated.
    """
    data = read_unpacked(path)
    if data.startswith(PARQUET):
        return read_parquet(str(path), data, trusted)
    lines = decode(path, data).rstrip().splitlines()
    if lines and is_novatel(lines[0]):
        return novatel.read_novatel(str(path), lines, trusted)
    if lines and is_vectornav(lines[0]):
        return vectornav.read_vectornav(str(path), lines, trusted)
    if lines and lines[0].startswith(psins.COMMENT):
        return psins.read_psins(str(path), lines, trusted)
    if kf_gins.is_kf_gins(lines):
        return kf_gins.read_kf_gins(str(path), lines, trusted)
    return read_csv(str(path), lines, trusted)
