"""The inputs of a replay: what a log says about the turntable and the temperature."""
