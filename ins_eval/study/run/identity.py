"""All that determines a study's results to the last bit: the study, the code, its libraries."""

import hashlib
import json
from dataclasses import asdict, dataclass
from typing import Any

from ins_eval.study.specification import Study
from pyhrg.common.made_by import list_versions


@dataclass(frozen=True)
class Identity:
    """What determines a study's results.

    study: all its fields, as JSON values; made_by: versions of libraries, and the digest of our own
    code.
    """

    study: dict[str, Any]
    made_by: dict[str, str]

    @property
    def digest(self) -> str:
        return hashlib.sha256(self.text.encode()).hexdigest()[:32]

    @property
    def text(self) -> str:
        return json.dumps({"study": self.study, "made_by": self.made_by}, indent=1) + "\n"


def identify_study(study: Study) -> Identity:
    """The identity of a study that this machine's code runs."""
    return Identity(_describe_study(study), list_versions())


def _describe_study(study: Study) -> dict[str, Any]:
    """Fields of a study as JSON values; a mission's file is replaced by its digest."""
    values = asdict(study)
    for mission in values["missions"]:
        mission["content"] = f"sha256 {hashlib.sha256(mission['content']).hexdigest()}"
    return dict(json.loads(json.dumps(values)))
