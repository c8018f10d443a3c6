"""What the page can be filtered by, as attributes that its style and script know."""

import html

from ins_eval.study.report.result import StudyResult
from ins_eval.study.tables.score import ALL

CALIBRATIONS = {"map": "whole map calibrated", "mean": "mean calibrated"}


def marked(mission_class: str = ALL, calibration: str = ALL, half: str = ALL) -> str:
    """Attributes of an element that shows only these."""
    given = {"class": mission_class, "calibration": calibration, "half": half}
    return "".join(
        f' data-{key}="{html.escape(value)}"' for key, value in given.items() if value != ALL
    )


def colour(result: StudyResult, mission_class: str) -> str:
    """CSS class that colours a mission class."""
    classes = result.values("mission_class")
    return f"c{classes.index(mission_class) % 8}"


def calibration_title(key: str) -> str:
    """As read."""
    return CALIBRATIONS.get(key, key)


def legend(result: StudyResult) -> str:
    """Colours of the mission classes."""
    entries = "".join(
        f'<li{marked(name)}><svg class="{colour(result, name)}" width="14" height="14" '
        f'aria-hidden="true"><circle cx="7" cy="7" r="5"/></svg> {html.escape(name)}</li>'
        for name in result.values("mission_class")
    )
    return f'<ul class="legend" aria-label="Colours of mission classes">{entries}</ul>'
