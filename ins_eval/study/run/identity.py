"""What determines a study's results, to the last bit: the study itself and all that computes it."""

import hashlib
import json
from dataclasses import asdict, dataclass
from typing import Any

from ins_eval.study.specification import Study
from pyhrg.common.made_by import made_by


@dataclass(frozen=True)
class Identity:
    """study: every key of it, plain; made_by: versions, and the digest of our own code."""

    study: dict[str, Any]
    made_by: dict[str, str]

    @property
    def digest(self) -> str:
        """Of both."""
        return hashlib.sha256(self.text.encode()).hexdigest()[:32]

    @property
    def text(self) -> str:
        """As JSON."""
        return json.dumps({"study": self.study, "made_by": self.made_by}, indent=1) + "\n"


def identity(study: Study) -> Identity:
    """Of a study, if this machine's code runs it."""
    return Identity(_plain(study), made_by())


def _plain(study: Study) -> dict[str, Any]:
    """As JSON gives it back; of a mission's file, the digest."""
    values = asdict(study)
    for mission in values["missions"]:
        mission["content"] = f"sha256 {hashlib.sha256(mission['content']).hexdigest()}"
    return dict(json.loads(json.dumps(values)))
