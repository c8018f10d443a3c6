"""documentation/licenses: the licence of the FMU, and the notices of others' work inside."""

import re
from dataclasses import dataclass
from importlib.metadata import distribution
from pathlib import Path

import fmpy

from fmu_build.binaries.platforms import BuildError

NOTICES = Path(__file__).with_name("notices")
"""Notices of the work of others that the sources hold, by file."""


@dataclass(frozen=True)
class Licence:
    """The licence of this distribution, and so of every FMU that it builds.

    `expression` is an SPDX licence expression, `copyright` the copyright line of `text`.
    """

    expression: str
    author: str
    copyright: str
    text: str


def read_licence() -> Licence:
    """The licence, from the metadata of the installed distribution."""
    installed = distribution("hrg")
    text = installed.read_text("licenses/LICENSE") or ""
    line = re.search(r"^Copyright .*$", text, re.MULTILINE)
    metadata = installed.metadata.json
    if line is None or "license_expression" not in metadata:
        raise BuildError(
            "the installed hrg holds no licence: install it again (python3 -m pip install -e .)"
        )
    return Licence(
        str(metadata["license_expression"]), str(metadata["author"]), line.group(0), text
    )


def list_licence_files(fmi: int, *, is_generated: bool = True) -> dict[str, bytes]:
    """Content of the folder, by file name; `license.txt` is the entry point. Sources that are
    generated from equations hold the work of others beside the FMI headers."""
    held = NOTICES.glob("*.txt") if is_generated else ()
    notices = {file.name: file.read_text(encoding="utf-8") for file in held}
    notices["fmi_headers.txt"] = _fmi_headers(fmi)
    licence = read_licence()
    lines = [
        f"SPDX-License-Identifier: {licence.expression}",
        "",
        licence.text.rstrip(),
        "",
        "Parts that others wrote, by their notices:",
        *(f"  {name}" for name in sorted(notices)),
        "",
    ]
    files = {"license.txt": "\n".join(lines), **notices}
    return {name: text.encode() for name, text in files.items()}


def _fmi_headers(fmi: int) -> str:
    """The comment of the header that the binaries are compiled with."""
    header = Path(fmpy.__file__).parent / "c-code" / f"fmi{fmi}Functions.h"
    text = header.read_text(encoding="utf-8", errors="replace")
    notice = re.search(r"Copyright.*?(?=\*/)", text, re.DOTALL)
    if notice is None:
        raise ValueError(f"{header.name} holds no copyright notice")
    return f"FMI headers, used in compiling the binaries\n\n{notice.group(0).rstrip()}\n"
