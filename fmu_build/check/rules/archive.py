"""Rules on the ZIP archive and its folders."""

import re
from collections import Counter

from fmu_build.check.archive import Fmu
from fmu_build.check.rules.rule import Findings, rule
from pyhrg.common.errors import HrgError
from pyhrg.common.reading.archives import ENCRYPTED, METHODS, open_archive

SUFFIXES = {"darwin": ".dylib", "linux": ".so", "win": ".dll"}
"""By part of a platform's name; darwin before win, which it holds."""

ENTRY_POINTS = {"license.txt", "license.html", "license.spdx"}

INTACT = "every entry of the archive can be read"


@rule(INTACT)
def intact(fmu: Fmu) -> Findings:
    """ZIP, 4.4.7 (CRC-32); encrypted entries and other methods are another rule's matter."""
    with open_archive(fmu.path) as archive:
        for entry in archive.entries:
            if entry.flag_bits & ENCRYPTED or entry.compress_type not in METHODS:
                continue
            try:
                archive.read(entry)
            except HrgError as error:
                yield str(error)


@rule("no path occurs twice, leads outside or has a backslash")
def safe_paths(fmu: Fmu) -> Findings:
    """ZIP, 4.4.17; a path that an importer would write over another file."""
    for name in sorted(name for name, count in Counter(fmu.names).items() if count > 1):
        yield f"{name} occurs more than once"
    for name in fmu.names:
        if name.startswith("/") or ".." in name.split("/"):
            yield f"{name} leads outside the archive's folder"
        if "\\" in name:
            yield f"{name} has a backslash, which is no separator of folders"


@rule("files are stored or deflated, and not encrypted")
def plain_compression(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.5."""
    for entry in fmu.entries:
        if entry.compress_type not in METHODS:
            yield f"{entry.filename} is compressed by method {entry.compress_type}"
        if entry.flag_bits & ENCRYPTED:
            yield f"{entry.filename} is encrypted"


@rule("there are sources or binaries")
def sources_or_binaries(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.5."""
    if not any(n.startswith(("sources/", "binaries/")) for n in fmu.names):
        yield "the archive holds neither"


@rule("every platform's folder holds the library of every interface")
def binaries_complete(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 2.3; FMI 3.0.2, 2.5.1.4."""
    files = [n for n in fmu.names if not n.endswith("/")]
    for platform in sorted({n.split("/")[1] for n in files if re.match("binaries/.+/", n)}):
        suffix = next((s for part, s in SUFFIXES.items() if part in platform), None)
        if suffix is None:
            continue
        for identifier in sorted(fmu.identifiers):
            library = f"binaries/{platform}/{identifier}{suffix}"
            static = (f"binaries/{platform}/{identifier}{s}" for s in (".a", ".lib"))
            if library not in files and not any(name in files for name in static):
                yield f"{library} is missing"


@rule("a documentation folder has its index.html")
def documentation_entry_point(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 2.3; FMI 3.0.2, 2.5.1."""
    inside = any(n.startswith("documentation/") for n in fmu.names)
    if inside and "documentation/index.html" not in fmu.names:
        yield "documentation/index.html is missing"


@rule("a licenses folder has its license.txt, license.html or license.spdx")
def licences_entry_point(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.5.1.1.1."""
    folder = "documentation/licenses/"
    inside = {n.removeprefix(folder) for n in fmu.names if n.startswith(folder)}
    if inside and not inside & ENTRY_POINTS:
        yield f"{folder} has none of {', '.join(sorted(ENTRY_POINTS))}"


@rule("folders in extra are named by a reverse domain")
def extra_names(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.5.1.6."""
    folders = {n.split("/")[1] for n in fmu.names if re.match("extra/.+", n)}
    for name in sorted(folders):
        if not re.fullmatch(r"[A-Za-z0-9-]+(\.[A-Za-z0-9_-]+)+", name):
            yield f"extra/{name} is not of the form org.example"
