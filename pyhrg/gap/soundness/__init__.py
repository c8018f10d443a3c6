"""Step 2: records that contradict the campaign or themselves are named and left out."""

from pyhrg.gap.soundness.screening import nominal_device, screen_campaign

__all__ = ["nominal_device", "screen_campaign"]
