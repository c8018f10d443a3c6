"""documentation/licenses: the licence of the FMU, and the notices of others' work inside."""

import re
from dataclasses import dataclass
from importlib.metadata import distribution
from pathlib import Path

import fmpy

from fmu_build.binaries.platforms import BuildError

CEPHES = """\
Cephes Mathematical Library, Stephen L. Moshier
Polynomials of sin, cos and atan in sources/arithmetic.h

Cephes Math Library Release 2.8: June, 2000
Copyright 1984, 1985, 1995, 2000 by Stephen L. Moshier

Its author's words: "Some software in this archive may be from the book _Methods and Programs for
Mathematical Functions_ (Prentice-Hall or Simon & Schuster International, 1989) or from the Cephes
Mathematical Library, a commercial product. In either event, it is copyrighted by the author. What
you see here may be used freely but it comes with no support or guarantee."
"""

FDLIBM = """\
fdlibm, Freely Distributable Math Library
Polynomial of log in sources/arithmetic.h

Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.

Developed at SunPro, a Sun Microsystems, Inc. business.
Permission to use, copy, modify, and distribute this software is freely granted, provided that
this notice is preserved.
"""


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


def list_licence_files(fmi: int) -> dict[str, bytes]:
    """Content of the folder, by file name; `license.txt` is the entry point."""
    notices = {
        "cephes.txt": CEPHES,
        "fdlibm.txt": FDLIBM,
        "fmi_headers.txt": _fmi_headers(fmi),
    }
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
    found = re.search(r"Copyright.*?(?=\*/)", text, re.DOTALL)
    if found is None:
        raise ValueError(f"{header.name} holds no copyright notice")
    return f"FMI headers, used in compiling the binaries\n\n{found.group(0).rstrip()}\n"
