"""`hrg gap diagnose FILE`: a static record against a belief."""

import json
from collections.abc import Mapping
from pathlib import Path

import tomli_w

from pyhrg.common.files import staging
from pyhrg.gap.static_record import belief as beliefs
from pyhrg.gap.static_record.belief import PERIODS, TOLERANCE_PERCENT, Belief, BeliefError
from pyhrg.gap.static_record.fit.diagnosis import ChannelDiagnosis, diagnosed
from pyhrg.gap.static_record.fit.hypotheses import FALSE_ALARMS
from pyhrg.gap.static_record.reading import read
from pyhrg.gap.static_record.record import StaticRecord
from pyhrg.gap.static_record.report.page import page
from pyhrg.gap.static_record.result import RecordDiagnosis, as_json
from pyhrg.gap.static_record.shared_motion import shared_power

RESULT, REPORT, CLOSED = "diagnosis.json", "report.html", "closed.toml"


def diagnose(path: Path, belief: Path, out: Path, trusted: bool = False) -> RecordDiagnosis:
    """Diagnose a file and write `diagnosis.json`, `report.html` and, by channel, `closed.toml`.

    Args:
        path: of the record, see `reading.read`.
        belief: TOML, see `belief.read`.
        out: folder.
        trusted: see `reading.read`.

    Raises:
        BeliefError: see `belief.read`; the record has no sensor that the belief is of.
        LogError, RecordError: see `reading.read`.
        OSError: the folder can't be written.
    """
    believed = beliefs.read(belief)
    result = judge(read(path, trusted), believed)
    closed = {d.channel.name: _closed(d) for d in result.channels}
    texts = {
        REPORT: page(result),
        CLOSED: tomli_w.dumps(closed),
        RESULT: json.dumps(as_json(result), indent=1, allow_nan=False) + "\n",
    }
    with staging(out, tuple(texts)) as aside:
        for name, text in texts.items():
            (aside / name).write_text(text, encoding="utf-8")
    return result


def judge(record: StaticRecord, believed: Mapping[str, Belief], seed: int = 0) -> RecordDiagnosis:
    """Diagnose the channels that something is believed of, by their name or their sensor's.

    The rate of false alarms holds for the record: each channel has its share of it.

    Raises:
        BeliefError: none is.
    """
    belief_of = {c.name: believed.get(c.name, believed.get(c.kind.table)) for c in record.channels}
    known = {name: belief for name, belief in belief_of.items() if belief is not None}
    channels = [c for c in record.channels if c.name in known]
    if not channels:
        kinds = " and ".join(sorted({c.kind.table for c in record.channels}))
        raise BeliefError(f"{record.source}: found a record of {kinds}, expected a belief of them")
    each = FALSE_ALARMS / len(channels)
    found = tuple(diagnosed(c, known[c.name], each, seed) for c in channels)
    shared = shared_power([c.part(0, c.half) for c in record.channels])
    kept = [i for i, c in enumerate(record.channels) if c.name in known]
    left = [f"{c.name}: nothing is believed of it" for c in record.channels if c.name not in known]
    notes = (*record.notes, *left)
    return RecordDiagnosis(record.source, notes, found, shared[kept], seed)


def _closed(d: ChannelDiagnosis) -> dict[str, object]:
    """The closed noise model, in the keys of a belief."""
    terms = zip(d.channel.kind.terms, d.closed.tolist(), strict=True)
    levels = {t.parameter: float(f"{x / t.factor:.6g}") for t, x in terms if x}
    ramp = d.channel.kind.ramp
    ramps = [c.value for c in d.causes if c.term is ramp] or [d.belief.ramp / ramp.factor]
    if ramps[0]:
        levels[ramp.parameter] = float(f"{ramps[0]:.6g}")
    tolerance = float(f"{100 * d.belief.tolerance:.6g}")
    return {**levels, PERIODS: list(d.belief.periods), TOLERANCE_PERCENT: tolerance}
