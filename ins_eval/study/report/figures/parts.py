"""Parts that the report's figures and tables share: panels, drawings, legends, tables of markup;
attributes by which the page's script filters, and colours by mission class.
"""

import html
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from ins_eval.study.study_data import StudyData
from ins_eval.study.tables.score import ALL
from pyhrg.common.pages import svg


@dataclass(frozen=True)
class Panel:
    """A figure beside others.

    Attributes:
        title: text.
        body: markup below the caption.
        notes: markup of further lines of the caption.
        attributes: attributes of the element, each with a blank before it.
    """

    title: str
    body: str
    notes: Sequence[str] = ()
    attributes: str = ""

    @property
    def markup(self) -> str:
        caption = "<br>".join([f"<b>{html.escape(self.title)}</b>", *self.notes])
        return f"<figure{self.attributes}><figcaption>{caption}</figcaption>{self.body}</figure>"


def join_panels(panels: Iterable[Panel], attributes: str = "") -> str:
    """Panels side by side."""
    return f'<div class="panels"{attributes}>{"".join(panel.markup for panel in panels)}</div>'


def draw_axes(
    x: svg.Scale, y: svg.Scale, labels: tuple[str, str], content: str, label: str, extra: str = ""
) -> str:
    """A drawing with axes.

    Args:
        x, y: scales of the axes.
        labels: labels of the axes, text.
        content: markup of the drawing within the axes.
        label: text that says what the drawing shows.
        extra: further attributes, each with a blank before it.
    """
    return (
        f'<svg viewBox="0 0 {svg.WIDTH} {svg.HEIGHT}" role="img" '
        f'aria-label="{html.escape(label)}"{extra}>{svg.draw_frame(x, y, *labels)}{content}</svg>'
    )


def draw_equality(x: svg.Scale, y: svg.Scale) -> str:
    """The line on which both axes have the same value."""
    ends = np.array([x.low, x.high])
    return f'<path class="equal" d="{svg.draw_line(x(ends), y(ends))}"/>'


def make_legend(entries: Iterable[tuple[str, str, str]], label: str) -> str:
    """A legend.

    Args:
        entries: for each, attributes of the item, CSS class of its colour, and text.
        label: text that says what the colours mean.
    """
    listed = "".join(
        f'<li{attributes}><svg class="{colour}" width="14" height="14" aria-hidden="true">'
        f'<circle cx="7" cy="7" r="6"/></svg> {html.escape(text)}</li>'
        for attributes, colour, text in entries
    )
    return f'<ul class="legend" aria-label="{html.escape(label)}">{listed}</ul>'


@dataclass(frozen=True)
class Row:
    """A row of a table. title: text of its first cell; cells: markup of the others; attributes:
    attributes of the row, each with a blank before it."""

    title: str
    cells: Sequence[str]
    attributes: str = ""


def make_table(
    caption: str, header: Sequence[str], rows: Iterable[Row], attributes: str = ""
) -> str:
    """A table whose cells are markup; caption and header are text."""
    head = "".join(f'<th scope="col">{html.escape(text)}</th>' for text in header)
    body = "".join(
        f'<tr{row.attributes}><th scope="row">{html.escape(row.title)}</th>'
        f"{''.join(f'<td>{cell}</td>' for cell in row.cells)}</tr>"
        for row in rows
    )
    return (
        f'<div class="wide"{attributes}><table class="matrix"><caption>{html.escape(caption)}'
        f"</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>"
    )


def format_interval(value: float, low: float, high: float) -> str:
    middle, *ends = svg.format_estimate(value, low, high)
    return f"<b>{middle}</b><br><small>{' to '.join(ends)}</small>"


def make_fold(title: str, content: str) -> str:
    """Markup that a click opens; the title is text."""
    return f"<details><summary>{html.escape(title)}</summary>{content}</details>"


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
