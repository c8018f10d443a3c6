"""Modelica to flat equations, sorted."""
