"""Logs of inertial measurement units (IMUs) in several formats, read and checked."""
