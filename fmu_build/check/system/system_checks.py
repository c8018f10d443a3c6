"""All checks of a system, one after the other."""

from collections.abc import Iterator
from functools import partial

from fmu_build.check.check import Check, collect_findings
from fmu_build.check.fmu_checks import run_checks
from fmu_build.check.runs import run_importers
from fmu_build.check.system.archive import System
from fmu_build.check.system.importers import IMPORTERS, plan_run
from fmu_build.check.system.rules import RULES
from pyhrg.common.errors import HrgError
from pyhrg.common.reading.limits import refuse_unreadable


def check_system(system: System) -> Iterator[Check]:
    """Every FMU by all that is asked of one, rules on the system, a run in two importers."""
    for source, fmu in sorted(system.fmus.items()):
        checks = list(run_checks(fmu))
        findings = [f"{check.name}: {finding}" for check in checks for finding in check.findings]
        skipped = [f"{check.name}: {check.skipped}" for check in checks if check.skipped]
        remark = "; ".join([f"{len(checks)} checks", *skipped])
        yield Check(f"{source} passes the checks of an FMU", findings, remark)
    broken = False
    for name, rule in RULES.items():
        findings = collect_findings(partial(rule, system))
        broken |= bool(findings)
        yield Check(name, findings)
    if broken:
        yield Check("importers run it", remark="the system is not sound", asked=False)
        return
    try:
        with refuse_unreadable(system.path, "experiment that can be planned"):
            planned = plan_run(system)
    except HrgError as error:
        yield Check("importers run it", [str(error)])
        return
    yield from run_importers(IMPORTERS, planned)
