"""Prior odds of all that may take part (docs/methods/evidence.md, Eqs. (6), (12), (14), (15)).

They state how often a campaign is expected to show each kind of gap. All are chosen. A factor of
two changes log odds by 0.7; an effect of 6 sigma has a log evidence of about 15.
"""

EFFECT_ODDS = 0.25
"""Some effect of the catalogue takes part, shared equally among the effects."""
NOISE_ODDS = 0.05
"""A given noise of the catalogue exceeds its stated level."""
UNNAMED_ODDS = 0.05
"""Something outside the catalogue takes part: a candidate term, shared equally among these; the
same odds for an unnamed noise, shared among its correlation times."""
HALF_UNNAMED_ODDS = UNNAMED_ODDS / 2
"""Pairs of events that no coordinate predicts have the odds of one candidate term: a jump of the
bias and a step of an angle; a line in the residual and a stretch of other noise."""
