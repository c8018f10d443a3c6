"""The numbers of a gyro, part by part: each field is declared once, with its key and its names."""
