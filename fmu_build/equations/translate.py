"""Modelica to flat equations: with `class_compiler.py` the only caller of the Modelica compiler."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from fmu_build.equations.case_angle import add_case_angle
from fmu_build.equations.class_compiler import compile_class
from fmu_build.equations.compiler_document import read_document
from fmu_build.equations.dae import Dae
from pyhrg.common.errors import HrgError
from pyhrg.common.extras import import_extra

COMPILER_VERSION = "0.10.2"
SCHEMA_VERSION = 43


def open_session(uses: Iterable[Path] = ()) -> Any:
    """A session of the Modelica compiler, for one thread. It keeps the library's parsed files, and
    parses again those that changed."""
    return import_extra("rumoca").Session([str(used) for used in uses])


def translate(
    library: Path,
    model: str,
    source: str = "",
    class_file: Path | None = None,
    uses: Iterable[Path] = (),
    session: Any = None,
) -> Dae:
    """Flat equations of a model of a library (the folder of `package.mo`) by its full name, e.g.
    `HRG.Gyroscopes.HRGEnvelope`. A model that is not the library's own but uses it is given as its
    Modelica text, `source`, or as the user's file that holds it. The library may use others. A
    session (`open_session`) that translated another model of the library needs less time."""
    rumoca = import_extra("rumoca")
    if rumoca.version() != COMPILER_VERSION:
        raise HrgError(
            f"rumoca {rumoca.version()} is installed; expected {COMPILER_VERSION}, "
            "for which the generator is written"
        )
    try:
        if class_file is not None:
            document = compile_class(library, model, class_file)
        elif source:
            document = rumoca.Session([str(library)]).loads(source, model=model).to_dict("dae")
        else:
            package = str(library / "package.mo")
            session = session or open_session(uses)
            document = session.load(package, model=model).to_dict("dae")
    except rumoca.RumocaError as error:
        raise HrgError(f"{model}: {error}") from error
    if document["schema_version"] != SCHEMA_VERSION:
        raise HrgError(
            f"rumoca wrote schema {document['schema_version']}; expected {SCHEMA_VERSION}"
        )
    try:
        return add_case_angle(read_document(model, document["storage"], document["source_map"]))
    except ValueError as error:
        raise HrgError(f"{model}: {error}") from error
