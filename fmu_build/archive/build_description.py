"""sources/buildDescription.xml of FMI 3.0: how the sources are compiled."""

import xml.etree.ElementTree as ET
from collections.abc import Sequence

from fmu_build.archive.xml import format_xml


def describe_build(identifier: str, sources: Sequence[str], options: Sequence[str]) -> str:
    """The document for sources of C99 beside their headers.

    Args:
        identifier: the library's name.
        sources: names of the files to compile.
        options: of a compiler of the GCC family, with which the numbers are the same everywhere.
    """
    root = ET.Element("fmiBuildDescription", fmiVersion="3.0")
    configuration = ET.SubElement(root, "BuildConfiguration", modelIdentifier=identifier)
    files = ET.SubElement(
        configuration,
        "SourceFileSet",
        language="C99",
        compiler="clang",
        compilerOptions=" ".join(options),
    )
    for name in sources:
        ET.SubElement(files, "SourceFile", name=name)
    return format_xml(root)
