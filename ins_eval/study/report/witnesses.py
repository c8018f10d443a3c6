"""The section of the report on what the gyros' own channels tell."""

from ins_eval.study.study_data import WITNESS_KEY, StudyData
from ins_eval.study.witness.judge import WitnessScore, list_figures
from pyhrg.common.pages.markup import PageSection, Table, make_paragraph, make_wide_table


def make_witness_section(data: StudyData) -> list[PageSection]:
    """One section where a study has read channels, else none."""
    scores = [WitnessScore(**each) for each in data.about.get(WITNESS_KEY, [])]
    if not scores:
        return []
    lead = (
        "Forces, frequency and pattern angle of each gyro were recorded in flight. They tell how "
        "far its map has drifted since the bench. R2 is that of the horizontal error; a corrected "
        "flight is the same record, navigated after the told maps were taken out. The control has "
        "the channels of another triad."
    )
    header = ("calibration", "class", "self-test", "score", "value (95 %)", "triads")
    table = make_wide_table(Table("Self-witness", header, list_figures(scores)))
    title = "What the gyros tell of themselves"
    return [PageSection("witness", title, make_paragraph(lead) + table)]
