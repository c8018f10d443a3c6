"""Errors of a user's class file that the Modelica compiler doesn't report."""

import re
from pathlib import Path

from fmu_build.equations.modelica import STRING
from pyhrg.common.errors import HrgError
from pyhrg.common.reading.files import decode, read_bytes
from pyhrg.common.reading.limits import DOCUMENT_BYTES

COMMENT = r"//[^\n]*|/\*.*?\*/"
CLASS = re.compile(r"^\s*(?:(?:partial|final|encapsulated)\s+)*(?:model|class|block)\s+(\w+)", re.M)
DOTTED_MODIFIER = re.compile(r"[(,]\s*(?:(?:each|final)\s+)*(\w+)\.(\w+(?:\.\w+)*)\s*=(?!=)")
REDECLARED_CLASS = re.compile(
    r"\bredeclare\s+(?:(?:final|replaceable)\s+)*(model|block|class|record|type|package|function)"
    r"\s+(\w+)\s*=\s*([\w.]+)\s*\("
)


def check_class_file(file: Path) -> None:
    """Refuse a file that does not hold the class of its name, and modifiers by a dotted name or of
    a class that is redeclared: they are legal, and the compiler drops them.

    Raises:
        HrgError: names the file, the row, what was found and what was expected.
    """
    text = decode(file, read_bytes(file, DOCUMENT_BYTES), "utf-8")
    code = re.sub(f"{STRING}|{COMMENT}", _blank, text, flags=re.DOTALL)
    classes = CLASS.findall(code)
    if classes and file.stem not in classes:
        raise HrgError(
            f"{file}: found the class {classes[0]}, expected {file.stem}: a file has the name of "
            f"its class, {classes[0]}.mo"
        )
    if dotted := DOTTED_MODIFIER.search(code):
        first, rest = dotted.groups()
        nested = f"{first}({rest.replace('.', '(')} = ...{')' * rest.count('.')})"
        row = code.count("\n", 0, dotted.start(1)) + 1
        raise HrgError(
            f"{file}, row {row}: found a modifier by the dotted name {first}.{rest}, which the "
            f"compiler would drop; expected {nested}"
        )
    if redeclared := REDECLARED_CLASS.search(code):
        kind, name, other = redeclared.groups()
        row = code.count("\n", 0, redeclared.start()) + 1
        raise HrgError(
            f"{file}, row {row}: found modifiers in a redeclaration of the class {name}, which the "
            f"compiler would drop; expected a class of its own, {kind} MyClass = {other}(...), and "
            f"redeclare {kind} {name} = MyClass"
        )


def _blank(match: re.Match[str]) -> str:
    """Rows stay where they were."""
    return " " + "\n" * match[0].count("\n")
