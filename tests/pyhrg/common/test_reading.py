"""The boundary of reading: every failure is one line that names the file."""

import gzip
import io
import json
import os
import zipfile
from collections.abc import Callable
from pathlib import Path

import pandas as pd
import pytest

from pyhrg.common.errors import LONGEST_MESSAGE, HrgError, fold_line, quote
from pyhrg.common.reading import archives, documents, files, limits, parquet


def read_csv(path: Path) -> object:
    return list(documents.parse_csv(path, files.decode(path, path.read_bytes())))


def read_xml(path: Path) -> object:
    return documents.parse_xml(path, path.read_bytes())


def read_archive(path: Path) -> object:
    with archives.open_archive(path) as archive:
        return [archive.read(entry) for entry in archive.entries]


def zipped(data: bytes, method: int = zipfile.ZIP_DEFLATED) -> bytes:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", method) as archive:
        archive.writestr("entry", data)
    return packed.getvalue()


def lying(place: int, value: bytes) -> bytes:
    """An archive whose directory says something else at a place of its entry."""
    data = zipped(b"x" * 100)
    begin = data.index(b"PK\x01\x02") + place
    return data[:begin] + value + data[begin + len(value) :]


CUT = gzip.compress(b"x" * 100, mtime=0)[:-9]
ENDLESS = gzip.compress(bytes(10**8), mtime=0)
CASES = [
    (documents.read_json, b"[" * 100_000, "found what is no JSON: .*recursion"),
    (documents.read_json, b'{"a": ' + b"9" * 5000 + b"}", "no JSON: Exceeds the limit"),
    (documents.read_json, b"[1]", "found list, expected a JSON object"),
    (documents.read_json, b"", "found what is no JSON"),
    (documents.read_toml, b"a = " + b"[" * 100_000, "found what is no TOML: .*recursion"),
    (documents.read_toml, b"a = " + b"9" * 5000, "no TOML: Exceeds the limit"),
    (documents.read_toml, b"a = '\xff'", "found what is no text in utf-8"),
    (read_csv, b"a,b\n1," + b"9" * 200_000, "row 2: found what is no CSV: field larger"),
    (read_csv, b"a,b\n1,2\r3\n", "row 2: found what is no CSV: new-line"),
    (read_csv, b"a,b\n1," + b"9" * 400_000, "lines of 200003 bytes on average, expected at most"),
    (read_xml, b'<?xml version="1.0" encoding="shift_jis"?><a/>', "multi-byte"),
    (read_xml, b'<?xml version="1.0" encoding="bz2"?><a/>', "found what is no XML"),
    (read_xml, b"<a>", "found what is no XML: no element found"),
    (read_archive, b"PK", "found what is no intact ZIP file"),
    (read_archive, lying(8, b"\1"), "found what is no intact entry: .*encrypted"),
    (read_archive, lying(10, b"\x63"), "found compression method 99, expected stored or deflated"),
    (read_archive, lying(24, b"\0\0\0\x7f"), "found 2032.0 MiB or more, expected at most"),
    (read_archive, lying(24, b"\xc8"), "found 100 bytes of 200"),
    (parquet.read_parquet, b"PAR1" + bytes(100) + b"PAR1", "found what is no Parquet"),
    (files.read_unpacked, CUT, "found what is no whole gzipped data"),
    (files.read_unpacked, ENDLESS, "64.0 MiB or more, expected at most"),
]


@pytest.mark.parametrize(("read", "data", "message"), CASES)
def test_what_cannot_be_read_is_refused(
    read: Callable[..., object], data: bytes, message: str, tmp_path: Path
) -> None:
    path = tmp_path / "file"
    path.write_bytes(data)
    with pytest.raises(HrgError, match=message) as caught:
        read(path)
    assert "file: " in str(caught.value) or f"in {path}" in str(caught.value)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) <= LONGEST_MESSAGE


@pytest.mark.parametrize("encoding", ["bz2", "rot13", "undefined", "a\0b", "nonsense"])
def test_an_encoding_that_is_none_is_refused(encoding: str) -> None:
    with pytest.raises(HrgError, match="found what is no text in"):
        files.decode("file", b"a", encoding)


@pytest.mark.parametrize("name", ["n" * 5000, "a\0b", "nowhere", "/dev/zero", "/dev/full", "."])
def test_a_path_that_is_no_file_is_refused(name: str, tmp_path: Path) -> None:
    with pytest.raises(HrgError) as caught:
        files.read_bytes(tmp_path / name, 1000)
    assert len(str(caught.value)) <= LONGEST_MESSAGE


def test_a_pipe_is_read_to_its_end_or_limit(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    assert files.read_bytes(pipe, 10) == b""  # nobody writes
    out, into = os.pipe()
    os.write(into, b"12345")
    os.close(into)
    assert files.read_bytes(Path(f"/dev/fd/{out}"), 10) == b"12345"
    os.close(out)
    out, into = os.pipe()
    os.write(into, b"12345678901")
    with pytest.raises(HrgError, match="expected at most"):
        files.read_bytes(Path(f"/dev/fd/{out}"), 10)
    os.close(out)
    os.close(into)


def test_a_large_file_is_refused_unread(tmp_path: Path) -> None:
    path = tmp_path / "file"
    with path.open("wb") as file:
        file.truncate(2**40)
    with pytest.raises(HrgError, match=r"found 1048576\.0 MiB or more, expected at most 512 MiB"):
        files.read_unpacked(path)
    with pytest.raises(HrgError, match="expected at most 16 MiB"):
        documents.read_json(path)


def test_a_parquet_file_of_many_repeated_rows_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "table.parquet"
    pd.DataFrame({"a": [0.0] * 10_000_000}).to_parquet(path)
    with pytest.raises(HrgError, match="expected at most 64 MiB"):
        parquet.read_parquet(path)


def test_right_content_is_read(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_text(json.dumps({"a": 1}))
    assert documents.read_json(path) == {"a": 1}
    assert list(documents.parse_csv("file", 'a,"b\nc"\n\n1,2\n')) == [
        (2, ["a", "b\nc"]),
        (4, ["1", "2"]),
    ]
    path.write_bytes(gzip.compress(b"text"))
    assert files.read_unpacked(path) == b"text"
    path.write_bytes(zipped(b"data"))
    assert read_archive(path) == [b"data"]


def test_a_message_is_one_line() -> None:
    assert str(HrgError("a\nb\0\udc80")) == "a b\\x00\\udc80"
    assert len(fold_line("x" * 10**6)) <= LONGEST_MESSAGE
    assert len(fold_line("x\0" * 10**6)) <= LONGEST_MESSAGE


def test_a_value_is_shown_however_large() -> None:
    assert quote("text") == "'text'"
    assert quote(int("f" * 9000, 16)) == "a value of type int that is too large to show"
    assert len(quote([0] * 10**5)) <= 100


def test_archives_have_a_limited_number_of_entries(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "file.zip"
    with zipfile.ZipFile(path, "w") as archive:
        for name in "abc":
            archive.writestr(name, "")
    monkeypatch.setattr(archives, "ARCHIVE_ENTRIES", 2)
    with pytest.raises(HrgError, match="found 3 files, expected at most 2"):
        read_archive(path)


def test_limits_are_in_order() -> None:
    assert limits.compute_expanded_limit(0) == limits.FREE_EXPANSION
    assert limits.compute_expanded_limit(2**30) == limits.EXPANSION * 2**30
