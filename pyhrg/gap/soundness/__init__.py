"""Step 2: records that contradict the campaign or themselves are named and left out."""

from pyhrg.gap.soundness.screening import build_nominal_device, screen_campaign

__all__ = ["build_nominal_device", "screen_campaign"]
