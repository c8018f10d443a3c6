"""What of a campaign can be used: contradictions within it are named, and left out."""

from pyhrg.gap.soundness.sound import sound

__all__ = ["sound"]
