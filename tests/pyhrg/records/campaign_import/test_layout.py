"""Text files of many kinds give the same numbers."""

import gzip
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.errors import HrgError
from pyhrg.records.campaign_import.layout import Cells, Layout, read_cells


def cells_of(folder: Path, data: bytes, layout: Layout) -> Cells:
    (folder / "log.txt").write_bytes(data)
    return read_cells(folder / "log.txt", layout)


@pytest.mark.parametrize(
    ("data", "layout"),
    [
        (b"a,b\n1.5,2\n-3,nan\n", Layout()),
        (b"\xef\xbb\xbfa,b\r\n1.5,2\r\n-3,\r\n", Layout()),
        (b"a;b\n1,5;2\n-3;\n", Layout(separator=";", decimal=",")),
        (b"# x\n a \t b\n\n1.5\t2\n#\n-3\tNaN\n", Layout(separator="\t", comment="#")),
        (b"  a   b\n 1.5  2\n  -3   void\n", Layout(None, missing=frozenset({"void"}))),
        (b"x\ny\na|b\ns|m\n1.5|2\n-3|\n", Layout("|", ".", "", "ascii", True, 2, 1)),
        (b'"a","b"\n"1.5","2"\n"-3",""\n', Layout()),
        ("a,b\n1.5,2\n-3,\n".encode("utf-16"), Layout(encoding="utf-16")),
        (gzip.compress(b"a,b\n15e-1,2\n-3,\n", mtime=0), Layout()),
    ],
)
def test_a_file_is_taken_apart(tmp_path: Path, data: bytes, layout: Layout) -> None:
    cells = cells_of(tmp_path, data, layout)
    np.testing.assert_array_equal(cells.numbers("a"), [1.5, -3.0])
    np.testing.assert_array_equal(cells.numbers(2), [2.0, np.nan])


def test_rows_are_lines_of_the_file(tmp_path: Path) -> None:
    cells = cells_of(tmp_path, b"#\n\na\n1\n#\n\n2\n", Layout(comment="#"))
    assert cells.rows.tolist() == [4, 7]


def test_a_name_that_is_there_twice_is_not_guessed(tmp_path: Path) -> None:
    cells = cells_of(tmp_path, b"a,a\n1,2\n", Layout())
    with pytest.raises(HrgError, match=r"log\.txt: column a: found 2 columns of that name"):
        cells.numbers("a")
    assert cells.numbers(2) == [2.0]


def test_another_encoding_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match=r"log\.txt: found what is no text in utf-8"):
        cells_of(tmp_path, "°\n1\n".encode("latin-1"), Layout())
