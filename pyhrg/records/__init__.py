"""Logs of bench tests: one record format for what was simulated and what was recorded."""

from pyhrg.records.columns import COLUMNS, Column, LogError
from pyhrg.records.log import Log, read, write

__all__ = ["COLUMNS", "Column", "Log", "LogError", "read", "write"]
