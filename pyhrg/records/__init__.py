"""Logs of bench tests: one record format for what was simulated and what was recorded."""

from pyhrg.records.columns import COLUMNS, LogError
from pyhrg.records.log import Log, read_log, write_log

__all__ = ["COLUMNS", "Log", "LogError", "read_log", "write_log"]
