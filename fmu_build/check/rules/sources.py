"""Rules on sources: what is to be compiled is there, under the right name."""

import xml.etree.ElementTree as ET

from fmu_build.check.archive import Fmu
from fmu_build.check.rules.rule import Findings, rule

BUILD_DESCRIPTION = "sources/buildDescription.xml"


@rule("listed source files exist")
def sources_exist(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 3.3.1 (SourceFiles); FMI 3.0.2, 2.5.2.1."""
    for element in fmu.description.iterfind(".//SourceFiles/File"):
        if f"sources/{element.get('name')}" not in fmu.names:
            yield f"SourceFiles lists {element.get('name')}, which sources doesn't hold"
    build = fmu.xml(BUILD_DESCRIPTION)
    for element in () if build is None else build.iter("SourceFile"):
        if f"sources/{element.get('name')}" not in fmu.names:
            yield f"the build description lists {element.get('name')}, which sources doesn't hold"


@rule("folders that the build description includes exist")
def include_folders_exist(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.5.2.1."""
    build = fmu.xml(BUILD_DESCRIPTION)
    for element in () if build is None else build.iter("IncludeDirectory"):
        name = element.get("name", "").strip("/")
        if name != "." and not any(n.startswith(f"sources/{name}/") for n in fmu.names):
            yield f"the build description includes the folder {name}, which sources doesn't hold"


@rule("the build description builds the interfaces' identifiers")
def build_identifier(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.5.2.1."""
    build = fmu.xml(BUILD_DESCRIPTION)
    if build is None:
        if fmu.major == 3 and any(n.startswith("sources/") for n in fmu.names):
            yield f"{BUILD_DESCRIPTION} is missing"
        return
    built = _identifiers(build)
    for name in sorted(built - fmu.identifiers):
        yield f"the build description builds {name}, expected {', '.join(sorted(fmu.identifiers))}"


@rule("the build description is of the FMU's version of the standard")
def build_version(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.5.2.1."""
    build = fmu.xml(BUILD_DESCRIPTION)
    if build is not None and not build.get("fmiVersion", "").startswith("3."):
        yield f"fmiVersion of the build description is {build.get('fmiVersion')}, expected 3.0"


def _identifiers(build: ET.Element) -> set[str]:
    return {e.get("modelIdentifier", "") for e in build.iter("BuildConfiguration")}
