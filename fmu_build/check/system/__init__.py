"""Checks of a system of FMUs (SSP) of any maker; the checks of a single FMU are in the folder
above."""
