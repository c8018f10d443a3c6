"""The gyro as its maker would describe it: parameters, files, ready devices."""
