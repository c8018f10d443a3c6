"""FMUs that something was done to."""

import re
import zipfile
from collections.abc import Callable
from pathlib import Path

Content = dict[str, bytes]

LOCAL_HEADER = 30
"""Bytes before an entry's name (ZIP, 4.3.7)."""


def tampered(original: Path, folder: Path, change: Callable[[Content], None]) -> Path:
    """A copy of an FMU whose content was changed in place."""
    with zipfile.ZipFile(original) as archive:
        content = {name: archive.read(name) for name in archive.namelist()}
    change(content)
    copy = folder / original.name
    with zipfile.ZipFile(copy, "w") as archive:
        for name, data in content.items():
            entry = zipfile.ZipInfo(name)
            entry.filename = name  # ZipInfo would mend a bad one
            archive.writestr(entry, data, zipfile.ZIP_DEFLATED)
    return copy


def damaged(original: Path, folder: Path, name: str) -> Path:
    """A copy of an FMU with one bit flipped in the packed bytes of an entry."""
    data = bytearray(original.read_bytes())
    with zipfile.ZipFile(original) as archive:
        entry = archive.getinfo(name)
    begin = entry.header_offset + LOCAL_HEADER + len(entry.filename)
    data[begin + entry.compress_size // 2] ^= 1
    copy = folder / original.name
    copy.write_bytes(data)
    return copy


def text(name: str, pattern: str, replacement: str) -> Callable[[Content], None]:
    """Replace the first match of a pattern in a file; there must be one."""

    def change(content: Content) -> None:
        changed, count = re.subn(
            pattern, replacement, content[name].decode(), count=1, flags=re.DOTALL
        )
        assert count == 1, pattern
        content[name] = changed.encode()

    return change


def description(pattern: str, replacement: str) -> Callable[[Content], None]:
    """The same in modelDescription.xml."""
    return text("modelDescription.xml", pattern, replacement)


def renamed(old: str, new: str) -> Callable[[Content], None]:
    """Rename files by a pattern of their path."""

    def change(content: Content) -> None:
        for name in list(content):
            if re.search(old, name):
                content[re.sub(old, new, name)] = content.pop(name)

    return change


def removed(pattern: str) -> Callable[[Content], None]:
    """Remove files by a pattern of their path."""

    def change(content: Content) -> None:
        names = [name for name in content if re.search(pattern, name)]
        assert names, pattern
        for name in names:
            del content[name]

    return change


def added(name: str, data: bytes = b"") -> Callable[[Content], None]:
    """Add a file."""
    return lambda content: content.update({name: data})
