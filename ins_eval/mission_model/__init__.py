"""The linear model of a mission: position error per unit of each gyro error."""
