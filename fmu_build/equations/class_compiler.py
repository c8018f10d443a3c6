"""Compiles the class of a user's file in a process of its own: a text that crashes the Modelica
compiler, or gives it work without end, ends that process alone.

Called as `python -m fmu_build.equations.class_compiler LIBRARY MODEL FILE RESULT`, it writes the
compiler's document, JSON. What else stands in the file's folder, and the compiler would read, is
left out: the file is compiled in RESULT's folder.
"""

import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from fmu_build.equations.class_file import check_class_file
from pyhrg.common.errors import HrgError, fold_line
from pyhrg.common.extras import import_extra
from pyhrg.common.reading.documents import read_json

MOST_SECONDS = 10
"""Largest processor time of a compilation, s. Chosen: thirty times that of a gyro."""
MOST_BYTES = 2**30
"""Largest memory of a compilation. Chosen: fourteen times that of a gyro."""
REFUSED = 2
"""Exit status where the compiler refuses the class; the reason is on standard error."""


def compile_class(library: Path, model: str, file: Path) -> dict[str, Any]:
    """The compiler's document of a class in a file that uses the library, read by itself.

    Raises:
        HrgError: the compiler refuses the class, fails, or takes more than the limits.
    """
    check_class_file(file)
    with tempfile.TemporaryDirectory(prefix="hrg-class-") as folder:
        result = Path(folder) / "document.json"
        command = [sys.executable, "-m", __spec__.name, str(library), model, str(file), str(result)]
        run = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False)
        if run.returncode == REFUSED:
            raise HrgError(f"{model}: {run.stderr}")
        if run.returncode or not result.exists():
            raise HrgError(
                f"{file}: the Modelica compiler failed (status {run.returncode}), expected a class "
                f"that it compiles within {MOST_SECONDS} s and {MOST_BYTES / 2**30:g} GiB"
            )
        return read_json(result)


def _limit_resources() -> None:
    """Limit this process, where the system can (not on Windows)."""
    try:
        import resource
    except ModuleNotFoundError:
        return
    resource.setrlimit(resource.RLIMIT_CPU, (MOST_SECONDS, MOST_SECONDS))
    resource.setrlimit(resource.RLIMIT_DATA, (MOST_BYTES, MOST_BYTES))


def _main() -> None:
    library, model, file, result = sys.argv[1:]
    alone = str(shutil.copy(file, Path(result).parent))
    rumoca = import_extra("rumoca")
    _limit_resources()
    try:
        text = rumoca.Session([library]).load(alone, model=model).to_json("dae")
        Path(result).write_text(text.replace(json.dumps(alone), json.dumps(file)))
    except rumoca.RumocaError as error:
        print(fold_line(str(error).replace(alone, file)), file=sys.stderr)
        sys.exit(REFUSED)


if __name__ == "__main__":
    _main()
