"""Rules on sources: the files to compile are there, under the right names."""

from fmu_build.check.archive import Fmu
from fmu_build.check.rules.rule import Findings, rule

BUILD_DESCRIPTION = "sources/buildDescription.xml"


@rule("listed source files exist")
def sources_exist(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 3.3.1 (SourceFiles); FMI 3.0.2, 2.5.2.1."""
    for element in fmu.description.iterfind(".//SourceFiles/File"):
        if f"sources/{element.get('name')}" not in fmu.names:
            yield f"SourceFiles lists {element.get('name')}, which sources doesn't hold"
    for element in fmu.xml(BUILD_DESCRIPTION).iter("SourceFile"):
        if f"sources/{element.get('name')}" not in fmu.names:
            yield f"the build description lists {element.get('name')}, which sources doesn't hold"


@rule("folders that the build description includes exist")
def include_folders_exist(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.5.2.1."""
    for element in fmu.xml(BUILD_DESCRIPTION).iter("IncludeDirectory"):
        name = element.get("name", "").strip("/")
        if name != "." and not any(n.startswith(f"sources/{name}/") for n in fmu.names):
            yield f"the build description includes the folder {name}, which sources doesn't hold"


@rule("the build description builds the interfaces' identifiers")
def build_identifier(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.5.2.1."""
    has_sources = any(n.startswith("sources/") for n in fmu.names)
    if fmu.major == 3 and has_sources and BUILD_DESCRIPTION not in fmu.names:
        yield f"{BUILD_DESCRIPTION} is missing"
    built = {
        e.get("modelIdentifier", "") for e in fmu.xml(BUILD_DESCRIPTION).iter("BuildConfiguration")
    }
    for name in sorted(built - fmu.identifiers):
        yield f"the build description builds {name}, expected {', '.join(sorted(fmu.identifiers))}"


@rule("the build description is of the FMU's version of the standard")
def build_version(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.5.2.1."""
    version = fmu.xml(BUILD_DESCRIPTION).get("fmiVersion")
    if BUILD_DESCRIPTION in fmu.names and not (version or "").startswith("3."):
        yield f"fmiVersion of the build description is {version}, expected 3.0"
