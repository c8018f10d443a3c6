"""Step 7: an equation for what has no name: terms proposed, and written as a Modelica class."""
