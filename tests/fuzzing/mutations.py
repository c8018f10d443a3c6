"""Ways to spoil a file: each takes its bytes and a source of chance, and gives other bytes."""

import gzip
import io
import random
import re
import zipfile
from collections.abc import Callable

ZEROS = gzip.compress(bytes(100_000_000), 1, mtime=0)
"""A member of gzipped data that unpacks to 230 times its size."""
Mutation = Callable[[bytes, random.Random], bytes]

DIGITS = "9" * 5000
DEEP = 20_000
"""Levels of nesting, beyond Python's recursion."""
CELLS = (
    *("", "nan", "inf", "-inf", "1e308", "-1e308", "1e-320", "1e999", "-1", "0", "1e12", "1_0"),
    *(DIGITS, "9" * 200_000, "text", "Ω" * 50, "１２", "0x10", '"', '"a\nb"', "\r", "\0", "\x1f"),
    *("1;2", "1,2", "2024-02-30", "1" * 300 + ".5", "true", "\u2028", "'", "=1+1"),
)
"""Texts of a cell."""
VALUES = (
    *("nan", "inf", "-inf", "1e308", "-1e308", "1e-320", "-1", "0", "9223372036854775807"),
    *(DIGITS[:400], DIGITS, "0x" + "f" * 9000, "true", "[]", "{}", '""', '"\\u0000"', '"\\n"'),
    *('"../../../etc"', f'"{"n" * 5000}"', '"/dev/zero"', '"utf-7"', '"bz2"', '"rot13"'),
    *('"undefined"', '"idna"', '"utf-16"', '"%Y%Y"', '"%d %d"', '"%"', "[" * DEEP, "1979-05-27"),
    *('{"a":' * DEEP, "null", "[[[]]]", "[1, nan, 1e308]", '[{"x": 1}]', "1.5", "1e12", "1e-12"),
)
"""Values of a TOML or JSON key: some belong to one of them alone."""
ATTRIBUTES = (
    *("", "nan", "1e308", "-1", "0", DIGITS, "2.0.0.0", "\u2028", "&#0;", "n" * 5000, "../..", "3"),
)
DECLARATIONS = tuple(
    f'<?xml version="1.0" encoding="{name}"?>'.encode()
    for name in ("bz2", "utf-7", "utf-32", "shift_jis", "undefined", "rot13", "\0", "cp037", "none")
)
KEY = rb'(?<!\w)[A-Za-z_]\w*(?="?\s*[=:])'
"""A key of a TOML or JSON document; tried once a word, however long it is."""
BOMB = b'<!DOCTYPE b [<!ENTITY a "aaaaaaaaaa">' + b"".join(
    b'<!ENTITY %c "%b">' % (98 + i, b"&%c;" % (97 + i) * 10) for i in range(9)
)


def flip(data: bytes, chance: random.Random) -> bytes:
    """Some bytes are others."""
    changed = bytearray(data or b"x")
    for _ in range(chance.choice((1, 1, 3, 30))):
        changed[chance.randrange(len(changed))] = chance.randrange(256)
    return bytes(changed)


def cut(data: bytes, chance: random.Random) -> bytes:
    """The end is missing, or the beginning, or a piece."""
    first, last = sorted(chance.randrange(len(data) + 1) for _ in range(2))
    return chance.choice((data[:first], data[first:], data[:first] + data[last:], b""))


def insert(data: bytes, chance: random.Random) -> bytes:
    """Something is put in."""
    place = chance.randrange(len(data) + 1)
    pieces = (
        b"\0",
        b"\r",
        b"\xef\xbb\xbf",
        b"\xff\xfe",
        b"[" * DEEP,
        b'"',
        b"\n\n",
        b"x" * 200_000,
    )
    return data[:place] + chance.choice(pieces) + data[place:]


def recode(data: bytes, chance: random.Random) -> bytes:
    """The same text in another encoding, or packed."""
    text = data.decode("latin-1")
    return chance.choice(
        (
            *(text.encode(name) for name in ("utf-16", "utf-32", "utf-8-sig", "utf-7")),
            gzip.compress(data, mtime=0)[:-9],
            gzip.compress(flip(data, chance), mtime=0),
            gzip.compress(data, mtime=0) + ZEROS,
            gzip.compress(gzip.compress(data, mtime=0), mtime=0),
        )
    )


BYTES: tuple[Mutation, ...] = (flip, cut, insert, recode)


def set_value(data: bytes, chance: random.Random) -> bytes:
    """A value of a TOML or JSON document is another."""
    return _replace(rb'(?<=[=:\[,])\s*("[^"\n]*"|[-+\w.]+)', VALUES, data, chance)


def rename_key(data: bytes, chance: random.Random) -> bytes:
    """A key has another name, or that of another key."""
    names = re.findall(KEY, data) or [b"x"]
    name = chance.choice((chance.choice(names).decode(), "n" * 5000, "\u00e9", "a.b", ""))
    return _replace(KEY, (name,), data, chance)


def drop_line(data: bytes, chance: random.Random) -> bytes:
    """A line is missing, or there twice."""
    lines = data.splitlines(keepends=True) or [b""]
    i = chance.randrange(len(lines))
    return b"".join(lines[:i] + chance.choice(([], [lines[i]] * 2)) + lines[i + 1 :])


DOCUMENT: tuple[Mutation, ...] = (*BYTES, *[set_value] * 8, *[rename_key] * 2, drop_line)


def set_cell(data: bytes, chance: random.Random) -> bytes:
    """A cell of a table, or all of a column, is another; the header may be among them."""
    rows, mark = _split_rows(data)
    place = chance.randrange(max(len(rows[0]), 1))
    cell = chance.choice(CELLS)
    begin = chance.randrange(2)
    chosen = range(begin, len(rows)) if chance.random() < 0.5 else [chance.randrange(len(rows))]
    for i in chosen:
        if place < len(rows[i]):
            rows[i][place] = cell
    return _join_rows(rows, mark)


def scale_column(data: bytes, chance: random.Random) -> bytes:
    """All numbers of a column, often the times, are many times larger or smaller."""
    rows, mark = _split_rows(data)
    place = chance.choice((0, 0, chance.randrange(max(len(rows[0]), 1))))
    factor = chance.choice((1e-300, 1e-12, 1e-6, -1.0, 0.0, 1e6, 1e9, 1e12, 1e300))
    for row in rows[1:]:
        if place < len(row):
            try:
                row[place] = repr(float(row[place]) * factor)
            except ValueError:
                continue
    return _join_rows(rows, mark)


def move_columns(data: bytes, chance: random.Random) -> bytes:
    """Columns change places, or one is missing or there twice."""
    rows, mark = _split_rows(data)
    order = list(range(len(rows[0])))
    chance.choice((chance.shuffle, list.pop, lambda o: o.append(0)))(order)
    return _join_rows([[row[i] for i in order if i < len(row)] for row in rows], mark)


def move_rows(data: bytes, chance: random.Random) -> bytes:
    """Rows are missing, there twice, out of order, or far later than the one before."""
    rows, mark = _split_rows(data)
    i = chance.randrange(len(rows))
    kind = chance.randrange(4)
    if kind == 0:
        rows[i:] = rows[:i]
    elif kind == 1:
        rows[1:] = chance.sample(rows[1:], len(rows) - 1)
    elif kind == 2:
        del rows[chance.randrange(3) :]
    else:
        for row in rows[max(i, 1) :]:
            row[0] = f"{chance.choice((1e6, 1e9, 1e11))}{len(row)}"
    return _join_rows(rows or [[""]], mark)


TABLE: tuple[Mutation, ...] = (
    *BYTES,
    *[set_cell] * 8,
    *[scale_column] * 2,
    move_columns,
    *[move_rows] * 2,
    drop_line,
)


def spoil_entry(data: bytes, chance: random.Random) -> bytes:
    """A file in an archive is spoilt, most often a document."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        content = {name: archive.read(name) for name in archive.namelist()}
    documents = [name for name in content if name.endswith(".xml")]
    name = chance.choice(documents if chance.random() < 0.9 else list(content))
    content[name] = chance.choice(XML)(content[name], chance)
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as archive:
        for entry, text in content.items():
            archive.writestr(entry, text, zipfile.ZIP_DEFLATED)
    return packed.getvalue()


def spoil_directory(data: bytes, chance: random.Random) -> bytes:
    """Headers of an archive lie: encrypted, oddly compressed, of another size or name."""
    changed = bytearray(data)
    marks = [m.start() for m in re.finditer(rb"PK\x01\x02", data)]
    begin = chance.choice(marks)
    offset, size = chance.choice(((8, 2), (10, 2), (16, 4), (20, 4), (24, 4), (28, 2), (42, 4)))
    for place in marks if chance.random() < 0.2 else [begin]:
        value = chance.choice((1, 12, 14, 99, 2 ** (8 * size) - 1, 0)).to_bytes(size, "little")
        changed[place + offset : place + offset + size] = value
    return bytes(changed)


def set_attribute(data: bytes, chance: random.Random) -> bytes:
    """An attribute of an XML document is another."""
    return _replace(rb'(?<==")[^"]*(?=")', ATTRIBUTES, data, chance)


def spoil_xml(data: bytes, chance: random.Random) -> bytes:
    """Another declaration, a bomb of entities, deep nesting, a million elements."""
    body = data.partition(b"?>")[2]
    return chance.choice(
        (
            chance.choice(DECLARATIONS) + body,
            BOMB + b"]><fmiModelDescription>&j;</fmiModelDescription>",
            b"<a>" * 10 * DEEP,
            b"<a>" * DEEP + b"</a>" * DEEP,
            b"<a>" + b"<b/>" * 1_000_000 + b"</a>",
            body.replace(b"<", b"<x>", 1),
        )
    )


def drop_element(data: bytes, chance: random.Random) -> bytes:
    """An element without content is missing, or there twice."""
    found = list(re.finditer(rb"<\w[^<>]*/>", data))
    if not found:
        return data
    match = chance.choice(found)
    return data[: match.start()] + match.group() * chance.choice((0, 2)) + data[match.end() :]


XML: tuple[Mutation, ...] = (*BYTES, *[set_attribute] * 6, *[spoil_xml] * 3, drop_element)
ARCHIVE: tuple[Mutation, ...] = (flip, cut, *[spoil_entry] * 4, *[spoil_directory] * 2)


def _replace(pattern: bytes, texts: tuple[str, ...], data: bytes, chance: random.Random) -> bytes:
    found = list(re.finditer(pattern, data))
    if not found:
        return data + b"?"
    match = chance.choice(found)
    return data[: match.start()] + chance.choice(texts).encode() + data[match.end() :]


def _split_rows(data: bytes) -> tuple[list[list[str]], str]:
    text = data.decode("latin-1")
    mark = ";" if text.count(";") > text.count(",") else ","
    return [line.split(mark) for line in text.splitlines()] or [[""]], mark


def _join_rows(rows: list[list[str]], mark: str) -> bytes:
    return "".join(mark.join(row) + "\n" for row in rows).encode("utf-8", "replace")
