"""Attributes by which the page's script filters, and colours by mission class."""

import html

from ins_eval.study.report.figures.parts import make_legend
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables.score import ALL

CALIBRATIONS = {"map": "whole map calibrated", "mean": "mean calibrated"}
COLOURS = 12
"""Number of colours in the style of all pages (`base.css`); a study of more classes of manoeuvre
repeats them."""


def make_filter_attributes(mission_class: str = ALL, calibration: str = ALL) -> str:
    """Attributes of an element that shows only these."""
    given = {"class": mission_class, "calibration": calibration}
    return "".join(
        f' data-{key}="{html.escape(value)}"' for key, value in given.items() if value != ALL
    )


def choose_colour(data: StudyData, mission_class: str) -> str:
    return f"c{data.classes.index(mission_class) % COLOURS}"


def name_calibration(key: str) -> str:
    return CALIBRATIONS.get(key, key)


def make_class_legend(data: StudyData) -> str:
    """Colours of the mission classes."""
    names = data.classes
    entries = ((make_filter_attributes(name), choose_colour(data, name), name) for name in names)
    return make_legend(entries, "Colours of mission classes")
