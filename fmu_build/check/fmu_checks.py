"""All checks of an FMU, one after the other."""

from collections.abc import Iterator
from functools import partial

import fmpy
from fmpy.model_description import ValidationError

from fmu_build.check.archive import Fmu
from fmu_build.check.check import Check, collect_findings
from fmu_build.check.experiment import find_missing_binary, plan_experiment
from fmu_build.check.importers import IMPORTERS
from fmu_build.check.rules import (  # noqa: F401 (modules of rules register themselves)
    archive,
    capabilities,
    sources,
    structure,
    terminals,
    units,
    variables,
)
from fmu_build.check.rules.archive import INTACT
from fmu_build.check.rules.rule import RULES
from fmu_build.check.runs import run_importers
from pyhrg.common.errors import HrgError
from pyhrg.common.reading.limits import refuse_unreadable


def run_checks(fmu: Fmu) -> Iterator[Check]:
    """Our own rules, FMPy's validation, and a short run in every importer with equal numbers.

    A damaged archive is one finding an entry, and nothing else is asked of it.
    """
    damaged = collect_findings(partial(RULES[INTACT], fmu))
    if damaged:
        yield Check(INTACT, damaged, "nothing else was checked")
        return
    for name, rule in RULES.items():
        yield Check(name, collect_findings(partial(rule, fmu)))
    yield Check("FMPy validates it", _fmpy_findings(fmu))
    yield from _runs(fmu)


def _runs(fmu: Fmu) -> Iterator[Check]:
    """In importers, where one of them can load it."""
    try:
        with refuse_unreadable(fmu.path, "experiment that can be planned"):
            planned = plan_experiment(fmu)
    except HrgError as error:
        yield Check("importers run it", [str(error)])
        return
    if planned is None:
        yield Check("importers run it", remark="it offers no co-simulation", asked=False)
        return
    missing = list(find_missing_binary(fmu, planned))
    if missing:
        yield Check("importers run it", missing)
        return
    yield from run_importers(IMPORTERS, planned)


def _fmpy_findings(fmu: Fmu) -> list[str]:
    """All of FMPy's validation but names, which are a rule."""
    try:
        fmpy.read_model_description(str(fmu.path), validate_model_structure=True)
    except ValidationError as error:
        return [str(problem) for problem in error.problems]
    except Exception as error:  # FMPy raises what its readers raise
        return [f"{type(error).__name__}: {error}"]
    return []
