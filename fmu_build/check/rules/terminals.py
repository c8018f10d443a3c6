"""Rules on terminals and icons."""

import re

from fmu_build.check.archive import Fmu
from fmu_build.check.rules.rule import Findings, rule

DOCUMENT = "terminalsAndIcons/terminalsAndIcons.xml"

MATCHING_RULES = ("plug", "bus", "sequence")

VARIABLE_KINDS = ("signal", "inflow", "outflow")


@rule("terminals name variables of the model")
def members_exist(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.4.9."""
    names = {v.name for v in fmu.variables}
    for terminal in fmu.xml(DOCUMENT).iter("Terminal"):
        for member in terminal:
            for attribute in ("variableName", "inStreamVariableName", "outStreamVariableName"):
                name = member.get(attribute)
                if name is not None and name not in names:
                    yield f"terminal {terminal.get('name')} names {name}, which is no variable"


@rule("terminals are of known matching rules and kinds, or of a maker's own")
def kinds_known(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.4.9.2: others are named by a reverse domain."""
    for terminal in fmu.xml(DOCUMENT).iter("Terminal"):
        where = f"terminal {terminal.get('name')}"
        matching = terminal.get("matchingRule", "")
        if matching not in MATCHING_RULES and not re.fullmatch(r"\w+(\.[\w-]+)+", matching):
            yield f"{where} has the matching rule {matching}"
        for member in terminal.findall("TerminalMemberVariable"):
            kind = member.get("variableKind", "")
            if kind not in VARIABLE_KINDS and not re.fullmatch(r"\w+(\.[\w-]+)+", kind):
                yield f"{where} has a member of kind {kind}"
            if matching in ("plug", "bus") and not member.get("memberName"):
                yield f"{where} has a member {member.get('variableName')} without a memberName"


@rule("names of terminals and of their members are given once")
def terminal_names(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.4.9.2."""
    root = fmu.xml(DOCUMENT)
    for parent in (*root.findall("Terminals"), *root.iter("Terminal")):
        for tag, attribute in (("Terminal", "name"), ("TerminalMemberVariable", "memberName")):
            names = [e.get(attribute, "") for e in parent.findall(tag)]
            for name in sorted({n for n in names if n and names.count(n) > 1}):
                yield f"{name} is there more than once"


@rule("icons that are described exist")
def icons_exist(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.4.9.1."""
    root = fmu.xml(DOCUMENT)
    icon = "terminalsAndIcons/icon.png"
    if root.find("GraphicalRepresentation/Icon") is not None and icon not in fmu.names:
        yield f"{icon} is missing"
    for graphic in root.iter("TerminalGraphicalRepresentation"):
        name = f"terminalsAndIcons/{graphic.get('iconBaseName')}.png"
        if name not in fmu.names:
            yield f"{name} is missing"


@rule("an SVG picture has a PNG picture beside it")
def png_beside_svg(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.5.1."""
    for name in fmu.names:
        drawn = re.fullmatch(r"(terminalsAndIcons/[^/]+|documentation/diagram)\.svg", name)
        if drawn and f"{drawn.group(1)}.png" not in fmu.names:
            yield f"{name} has no PNG picture beside it"


@rule("the terminals' version is the description's")
def terminals_version(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.4.9; FMI 2.0 names the version that defines the document."""
    version = fmu.xml(DOCUMENT).get("fmiVersion")
    own = fmu.description.get("fmiVersion") if fmu.major == 3 else "3.0"
    if DOCUMENT in fmu.names and version != own:
        yield f"fmiVersion is {version}, expected {own}"
