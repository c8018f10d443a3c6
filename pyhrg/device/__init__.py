"""The gyro as its maker would list it: parameters, files, ready devices."""
