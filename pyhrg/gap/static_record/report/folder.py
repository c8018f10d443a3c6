"""The folder of a diagnosis of a static record: its files appear together or not at all."""

import json
from pathlib import Path

import tomli_w

from pyhrg.common.files import stage_files
from pyhrg.gap.static_record.belief import PERIODS, TOLERANCE_PERCENT
from pyhrg.gap.static_record.document import build_document, round_digits
from pyhrg.gap.static_record.fit.diagnosis import ChannelDiagnosis
from pyhrg.gap.static_record.report.page import build_page
from pyhrg.gap.static_record.result import RecordDiagnosis

RESULT, PAGE, CLOSED = "diagnosis.json", "report.html", "closed.toml"


def write_record_report(result: RecordDiagnosis, out: Path) -> None:
    """Write `diagnosis.json`, `report.html` and `closed.toml`: a belief with the noise that was
    found, by channel."""
    closed = {d.channel.name: _state_closed_noise(d) for d in result.channel_diagnoses}
    texts = {
        PAGE: build_page(result),
        CLOSED: tomli_w.dumps(closed),
        RESULT: json.dumps(build_document(result), indent=1, allow_nan=False) + "\n",
    }
    with stage_files(out, tuple(texts)) as aside:
        for name, text in texts.items():
            (aside / name).write_text(text, encoding="utf-8")


def _state_closed_noise(d: ChannelDiagnosis) -> dict[str, object]:
    """The closed noise model under the keys of a belief."""
    terms = zip(d.channel.kind.terms, d.closed.tolist(), strict=True)
    levels = {t.parameter: round_digits(x / t.factor) for t, x in terms if x}
    ramp = d.channel.kind.ramp
    ramps = [c.value for c in d.causes if c.term is ramp] or [d.belief.ramp / ramp.factor]
    if ramps[0]:
        levels[ramp.parameter] = round_digits(ramps[0])
    tolerance = round_digits(100 * d.belief.tolerance)
    return {**levels, PERIODS: list(d.belief.periods), TOLERANCE_PERCENT: tolerance}
