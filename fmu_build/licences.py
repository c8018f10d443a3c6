"""documentation/licenses: what is granted, and the notices of others' work inside."""

import re
from importlib.metadata import distribution
from pathlib import Path

import fmpy

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


def licence_expression() -> str:
    """SPDX expression that this distribution declares; empty where it declares none."""
    return str(distribution("hrg").metadata.json.get("license_expression", ""))


def licence_files(fmi: int) -> dict[str, bytes]:
    """Content of the folder, by file name; `license.txt` is the entry point."""
    notices = {
        "cephes.txt": CEPHES,
        "fdlibm.txt": FDLIBM,
        "fmi_headers.txt": _fmi_headers(fmi),
    }
    own = {
        Path(str(f)).name: f.read_text()
        for f in distribution("hrg").files or []
        if ".dist-info/licenses/" in str(f)
    }
    files = {"license.txt": _entry_point(sorted(own), sorted(notices)), **own, **notices}
    return {name: text.encode() for name, text in files.items()}


def _entry_point(own: list[str], notices: list[str]) -> str:
    granted = licence_expression()
    first = (
        f"SPDX-License-Identifier: {granted}"
        if granted
        else "SPDX-License-Identifier: NOASSERTION\n\n"
        "Its authors have granted no licence for this FMU; all rights are theirs."
    )
    lines = [
        first,
        *(f"  {name}" for name in own),
        "",
        "Parts that others wrote, by their notices:",
    ]
    return "\n".join([*lines, *(f"  {name}" for name in notices), ""])


def _fmi_headers(fmi: int) -> str:
    """The comment of the header that the binaries are compiled with."""
    header = Path(fmpy.__file__).parent / "c-code" / f"fmi{fmi}Functions.h"
    text = header.read_text(encoding="utf-8", errors="replace")
    found = re.search(r"Copyright.*?(?=\*/)", text, re.DOTALL)
    if found is None:
        raise ValueError(f"{header.name} holds no copyright notice")
    return f"FMI headers, used in compiling the binaries\n\n{found.group(0).rstrip()}\n"
