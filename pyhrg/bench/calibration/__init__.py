"""Maps fitted, applied, and what they leave."""
