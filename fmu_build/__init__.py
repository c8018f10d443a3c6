"""Modelica to FMU: translate, generate C, compile, describe, bundle and check."""
