"""Content of result.json."""

import json
import math
from collections.abc import Mapping
from importlib.metadata import version
from typing import Any

import numpy as np

from pyhrg.bench.outcome import Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.reporting.judgement import judge_findings

SCHEMA = "hrg-bench/1"


def format_document(
    procedure: Procedure, outcome: Outcome, seed: int | None, limits: Mapping[str, float]
) -> str:
    """JSON text of a test's result; each finding is in the unit that its key names.

    The limits are the specification's, by the findings' keys.
    """
    content = {
        "schema": SCHEMA,
        "hrg": version("hrg"),
        "procedure": procedure.name,
        "source": procedure.source,
        "seed": seed,
        "findings": {
            finding.key: {
                "value": _convert(finding.value),
                "interval_95": _convert(finding.interval),
                "n": finding.n,
                "note": finding.note,
            }
            for finding in outcome.findings
        },
        "verdict": outcome.verdict,
        "specification": {
            judgement.finding.key: {
                "at_least" if judgement.finding.at_least else "at_most": judgement.limit,
                "verdict": judgement.word,
            }
            for judgement in judge_findings(outcome, limits)
        },
        "warnings": list(outcome.warnings),
        "exclusions": list(outcome.exclusions),
        "values_si": _convert(outcome.values),
    }
    return json.dumps(content, indent=2, allow_nan=False) + "\n"


def _convert(value: Any) -> Any:
    """The value in types that JSON has: arrays as lists, and null for NaN and infinity."""
    if isinstance(value, Mapping):
        return {str(key): _convert(item) for key, item in value.items()}
    if isinstance(value, np.ndarray | np.generic):
        return _convert(value.tolist())
    if isinstance(value, list | tuple):
        return [_convert(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
