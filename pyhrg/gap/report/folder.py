"""The folder of a diagnosis: its files appear together or not at all."""

from collections.abc import Sequence
from pathlib import Path

from pyhrg.common.files import stage_files
from pyhrg.gap.diagnose import FILES, CampaignDiagnosis
from pyhrg.gap.report.page import PAGE, build_page
from pyhrg.gap.report.sections import Section


def write_report(
    diagnosis: CampaignDiagnosis, out: Path | str, sections: Sequence[Section] = ()
) -> None:
    """Write a diagnosis with its page: `diagnosis.json`, `before.toml`, `after.toml`,
    `report.html`, and the document of each added section.

    Args:
        diagnosis: of a campaign.
        out: folder; made if it is missing.
        sections: added to the page before the next test.

    Raises:
        OSError: the folder can't be written.
        ValueError: a section's document has a number that is not finite.
    """
    documents = {section.file: section.to_json() for section in sections}
    with stage_files(Path(out), (*FILES, *documents, PAGE)) as aside:
        diagnosis.write_files(aside)
        for file, content in documents.items():
            (aside / file).write_bytes(content)
        (aside / PAGE).write_text(build_page(diagnosis, sections), encoding="utf-8")
