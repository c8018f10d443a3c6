"""What to do after a diagnosis, in sentences."""

from collections.abc import Collection

from pyhrg.device.declarations import format_effect
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.findings.diagnosis import Diagnosis
from pyhrg.gap.replay.observations import CHANNEL_WORDS
from pyhrg.gap.report.terms import find_nearest, name_term
from pyhrg.gap.report.words import format_name

NOTHING_NEXT = {
    "no_gap": "Nothing: the simulation stands for this gyro as it is.",
    "unexplained": "Look at the residuals by coordinate below: no known form explains them.",
}
"""What to do where there are no causes, no terms and no next test."""
RESCALE = "Correct the scale of the recorded {}, or state its tolerance."
REMEDIES = {
    "mounting_sign": "Turn the sign where it is recorded, or the gyro where it is mounted.",
    "drive_interruption": "Find out why the drive was lost, and repeat these tests.",
    "encoder_noise": "Check the table encoder and its wiring.",
    "table_ripple": "Calibrate the table encoder over a turn.",
    "time_jitter": "Let the recorder latch encoder and gyro at the same edge of its clock.",
    "lost_rows": "Check the recorder: it loses rows.",
    "outliers": "Check the recorder: it writes wrong readings.",
    "amplitude_scale": RESCALE.format("amplitude"),
    "amplitude_force_scale": RESCALE.format("amplitude force"),
    "quadrature_force_scale": RESCALE.format("quadrature force"),
}
"""What to do about a fault of bench or record."""
DEVICE_FILES = "after.toml and closed.fmu are this gyro"
TERM_FILES = "closed.fmu is this gyro with its equation, closed.mo its text"
USE = "{}: use them from now on."
NOT_VERIFIED = (
    "{}, as these records show it. No other test has verified it: hold one out, then use it."
)
CHECK_RECORDS = (
    "First check units and scales of the records, above all of the {}, where most of the gap is. "
    "Then diagnose again."
)
CAVEATS = "Do not use after.toml and closed.fmu: see the caveats above."
CONFOUNDED = (
    "after.toml and closed.fmu agree with these records, but have one of the confounded causes: "
    "in another test they may be wrong."
)
INCOMPLETE = "after.toml and closed.fmu have the named causes alone, not the whole gap."
NOT_CLOSER = (
    "On the held-out tests the identified gyro is further from the records than the nominal one. "
    "Do not use closed.fmu: what was found does not hold there."
)


def suggest_next_steps(diagnosis: Diagnosis, kinds: Collection[str]) -> list[str]:
    """Sentences on what to do next; kinds of tests: those that the laboratory has made."""
    test = diagnosis.next_test
    sentences = []
    if not diagnosis.settled and diagnosis.where:
        channel = CHANNEL_WORDS[diagnosis.where[0].channel]
        sentences.append(CHECK_RECORDS.format(channel))
    if test:
        why = test.why.removesuffix(".")
        sentences.append(f"Next test: {format_name(test.kind)}, {test.hours:g} h: {why}.")
    for term in diagnosis.terms:
        if nearest := find_nearest(term):
            known = f"known mechanism {nearest[0].number}, {nearest[0].name}"
            suggestion = nearest[0].suggest_test(kinds)
            sentences.append(f"{name_term(term)} is nearest to {known}.{suggestion}")
    for cause in diagnosis.causes:
        if (effect := EFFECTS.get(cause.effect)) and effect.imitators:
            others = " or ".join(map(format_effect, effect.imitators))
            name = format_effect(cause.effect)
            sentences.append(f"No test of a gyro tells {name} from {others}: look at the bench.")
    sentences += [REMEDIES[c.effect] for c in diagnosis.causes if c.effect in REMEDIES]
    if any(c.effect not in REMEDIES for c in diagnosis.causes) or diagnosis.terms:
        sentences.append(_say_whether_to_use(diagnosis))
    return sentences or [NOTHING_NEXT[diagnosis.verdict]]


def _say_whether_to_use(diagnosis: Diagnosis) -> str:
    """What the closed files are worth, by the verdict and the verification."""
    files = TERM_FILES if diagnosis.terms else DEVICE_FILES
    if (diagnosis.gap.shrink_percent or 0.0) < 0 or diagnosis.gap.is_wider_held_out:
        return NOT_CLOSER
    if diagnosis.verdict == "ambiguous":
        return CONFOUNDED
    if diagnosis.verdict == "unexplained" and not diagnosis.terms:
        return INCOMPLETE
    if diagnosis.caveats:
        return CAVEATS
    return (NOT_VERIFIED if diagnosis.gap.holdout_angle_arcsec is None else USE).format(files)
