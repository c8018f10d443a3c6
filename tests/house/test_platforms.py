"""macOS and Windows: nothing that only some systems have is needed to import or to read."""

import ast
import os
from pathlib import Path

import pytest

from pyhrg.common.arguments import count_cores
from pyhrg.common.caches import files as cache_files
from pyhrg.common.reading import files
from tests.house.test_shape import modules

POSIX = {"fcntl", "grp", "pwd", "resource", "termios"}
"""Modules of the standard library that Windows lacks."""


def test_no_module_imports_what_windows_lacks_at_its_top() -> None:
    found = []
    for path in modules().values():
        for node in ast.parse(path.read_text()).body:
            names = [alias.name for alias in getattr(node, "names", [])]
            names.append(getattr(node, "module", None) or "")
            if isinstance(node, ast.Import | ast.ImportFrom) and POSIX & set(names):
                found.append(path.name)
    assert found == []


def test_cores_are_counted_where_the_system_does_not_say_which_may_be_used(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.delattr(os, "sched_getaffinity", raising=False)
    assert count_cores() == os.cpu_count()


def test_a_file_is_read_where_there_is_no_opening_without_waiting(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delattr(os, "O_NONBLOCK", raising=False)
    monkeypatch.setattr(files, "WITHOUT_WAITING", 0)
    (tmp_path / "log").write_bytes(b"1\r\n")
    assert files.read_bytes(tmp_path / "log", 10) == b"1\r\n"


def test_a_cache_is_found_where_files_have_no_owner(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delattr(os, "geteuid", raising=False)
    monkeypatch.setattr("platformdirs.user_cache_path", lambda name: tmp_path / name)
    assert cache_files.find_cache_folder() == tmp_path / "hrg"
