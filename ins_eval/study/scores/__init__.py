"""How well predictions were kept: figures with intervals over triads."""
