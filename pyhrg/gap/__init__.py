"""Where simulation and a real gyro part, which effect does it, how far it closes the gap."""
