"""The page of a record's noise: a table and the Allan deviation of each channel."""

import html
import json
from pathlib import Path

from pyhrg.common.files import stage_files
from pyhrg.common.pages.markup import Table, make_document, make_paragraph, make_wide_table
from pyhrg.gap.static_record.allan import FILES, PAGE, RESULT, TABLE, ChannelNoise, RecordNoise
from pyhrg.gap.static_record.report.figures import draw_fitted_noise

STYLE = "td,th{text-align:left}svg text{fill:#000}.panels{grid-template-columns:minmax(0,40rem)}"
READING = (
    "The points are the overlapping Allan deviation, the band its 95 % intervals. The line is the "
    "noise that was fitted to the record by maximum likelihood (IEEE Std 952), with the rate ramp. "
    "Earth's rate and gravity are in the mean. A noise that the record does not show has an upper "
    "bound. Where the line misses the points, the record holds something else, such as motion."
)


def write_noise_report(noise: RecordNoise, out: Path) -> None:
    """Write `allan.json`, `allan.csv` and `report.html`, all or none."""
    with stage_files(out, FILES) as aside:
        text = json.dumps(noise.document, indent=1, allow_nan=False) + "\n"
        (aside / RESULT).write_text(text, encoding="utf-8")
        noise.deviations.to_csv(aside / TABLE, index=False)
        (aside / PAGE).write_text(build_allan_page(noise), encoding="utf-8")


def build_allan_page(noise: RecordNoise) -> str:
    """The page as HTML."""
    title = f"Noise of {noise.source}"
    body = [
        f"<h1>{html.escape(title)}</h1>",
        make_paragraph(READING),
        *map(_build_section, noise.channels),
        *(make_paragraph(f"Record: {note}", "weak") for note in noise.notes),
    ]
    return make_document(title, STYLE, "".join(body), "")


def _build_section(each: ChannelNoise) -> str:
    name = html.escape(each.channel.name)
    figure = draw_fitted_noise(each)
    caption = f"{each.deviation.n} readings every {each.channel.interval:g} s"
    table = Table(caption, ("", "Value, 95 % interval", "Unit", "Key"), tuple(each.rows))
    return (
        f"<h2>{name}</h2>{make_wide_table(table)}"
        f'<div class="panels"><figure role="img" aria-label="Allan deviation of {name}">'
        f"{figure}</figure></div>"
    )
