"""The FMU archive: generated sources, compiled for each platform, packed; cached by digest."""

import hashlib
import tempfile
from collections.abc import Callable, Mapping, Sequence
from importlib.metadata import version
from pathlib import Path

from fmu_build.archive.bill_of_materials import list_materials
from fmu_build.archive.description import describe_build, describe_fmi2, describe_fmi3
from fmu_build.archive.documentation.document import write_documentation
from fmu_build.archive.licences import list_licence_files, read_licence
from fmu_build.archive.packing import pack_archive
from fmu_build.archive.parameter_sets import join_arrays
from fmu_build.archive.reference import simulate_reference
from fmu_build.archive.terminals import describe_terminals
from fmu_build.binaries.libraries import fetch_library
from fmu_build.binaries.platforms import (
    FLAGS,
    PLATFORMS,
    PORTABLE_FLAGS,
    BuildError,
    choose_platforms,
    find_compiler_version,
    list_platforms,
    place_binaries,
)
from fmu_build.code.generate import generate_header, generate_source
from fmu_build.code.limits import generate_limits
from fmu_build.equations.dae import Dae
from fmu_build.equations.modelica import read_page
from fmu_build.equations.scalars import Scalar, list_variables
from fmu_build.equations.translate import COMPILER_VERSION, translate
from fmu_build.roots import PARTS, ROOTS, Root
from pyhrg.common.caches.files import find_cache_folder, is_intact, write_digest
from pyhrg.common.files import check_output_file, write_whole
from pyhrg.common.made_by import find_modelica
from pyhrg.common.reading.limits import refuse_unreadable

SOURCES = (
    "model.c",
    "core.c",
    "limits.c",
    "number.c",
    "instance.c",
    "log.c",
    "inputs.c",
    "snapshot.c",
    "derivative.c",
)
SHELLS = {2: "fmi2.c", 3: "fmi3.c"}
ICON = Path(__file__).parent / "archive" / "icon.png"
"""A shell seen from above, at rest and vibrating, among its eight electrodes."""

PREBUILT = Path(__file__).parent / "prebuilt"
"""Holds FMUs where a wheel is installed, in a folder named by the digest of their sources."""
PREBUILT_FMI = 2
"""The version of the standard that `pyhrg.fmu` imports."""
DEVICES = Path(__file__).parent / "archive" / "devices"
"""Parameter sets of the ready devices (SSP), one a file; `tests/agreement` holds them to these."""

Progress = Callable[[str], None]


def find_modelica_library() -> Path:
    """Folder of the Modelica library that this distribution holds."""
    return find_modelica() / "HRG"


def build_fmu(
    model: str = "HRG",
    *,
    fmi: int = 2,
    platforms: Sequence[str] = (),
    out: Path | str | None = None,
    class_file: Path | str | None = None,
    progress: Progress = lambda text: None,
) -> Path:
    """Build an FMU of the present sources, or take it from the user's cache, and return its path.

    A wheel holds those of FMI 2.0, for all platforms: no compiler is needed where it is installed.

    Args:
        model: a key of `fmu_build.roots.ROOTS` (the gyro: HRG, HRGCarrier or HRGSlow) or `PARTS`.
        class_file: a Modelica file with one class, named as the file, in place of `model`. The
            class is a gyro with sampled loops and uses the library HRG.
        fmi: version of the standard, 2 or 3.
        platforms: keys of `PLATFORMS`, or "all" for those that the standard knows; by default at
            least this machine's.
        out: file to write; by default the file in the cache.
        progress: function that is called with the name of each step.

    Raises:
        HrgError: the message says what is wrong.
        OSError: the cache or `out` can't be written.
    """
    root = _find_root(model) if class_file is None else _make_root(Path(class_file))
    if out is not None:
        check_output_file(Path(out))
    if "all" in platforms:
        for name in sorted(PLATFORMS.keys() - list_platforms(fmi)):
            progress(f"{name} is left out: FMI {fmi}.0 has no folder for it")
        platforms = list_platforms(fmi)
    path = _fetch_fmu(root, fmi, platforms, progress)
    if out is None:
        return path
    write_whole(Path(out), path.read_bytes())
    return Path(out)


def _fetch_fmu(root: Root, fmi: int, platforms: Sequence[str], progress: Progress) -> Path:
    """Path of an FMU in the user's cache, taken from the wheel or built if it isn't there."""
    prebuilt = None if platforms else _find_prebuilt(root, fmi)
    platforms = choose_platforms(platforms, fmi)
    if prebuilt:
        folder = f"{prebuilt.parent.name}-prebuilt"
    else:
        folder = f"{_digest_build(root)[:16]}-fmi{fmi}-{'+'.join(platforms)}"
    path = find_cache_folder() / folder / f"{root.identifier}.fmu"
    if is_intact(path):
        progress(f"{path.name}: unchanged, from cache")
        return path
    if prebuilt:
        path.parent.mkdir(parents=True, exist_ok=True)
        write_whole(path, prebuilt.read_bytes())
    else:
        write_fmu(path, root, fmi, platforms, progress)
    write_digest(path)
    return path


def list_arrays(model: str = "HRG") -> list[Scalar]:
    """Arrays that an FMU has in FMI 3.

    Args:
        model: as of `build_fmu`.

    Raises:
        HrgError: there is no such model, or it can't be translated.
    """
    return _select_arrays(_translate(_find_root(model)), 3)


def _select_arrays(dae: Dae, fmi: int) -> list[Scalar]:
    return [variable for variable in list_variables(dae, fmi) if variable.count > 1]


def _find_root(model: str) -> Root:
    known = ROOTS | PARTS
    if model not in known:
        raise BuildError(f"model: found {model!r}, expected {', '.join(known)}")
    return known[model]


def _make_root(file: Path) -> Root:
    """The root of a file's class: it runs as `HRG` does."""
    if not file.is_file() or not file.stem.isidentifier() or file.suffix != ".mo":
        raise BuildError(f"class file: found {str(file)!r}, expected a file named CLASS.mo")
    if file.stem in ROOTS | PARTS:
        raise BuildError(f"class file: {file.stem}: the library has this name; expected another")
    description = read_page(file).description or f"Gyro of the class {file.stem}"
    usual = ROOTS["HRG"]
    return Root(file.stem, file.stem, description, usual.integrator, usual.step, file.resolve())


def _find_prebuilt(root: Root, fmi: int) -> Path | None:
    """The FMU of a model that the installed wheel holds, if it is one of the present sources."""
    path = PREBUILT / digest_sources()[:16] / f"{root.identifier}.fmu"
    return path if root.class_file is None and fmi == PREBUILT_FMI and path.is_file() else None


def write_prebuilt(progress: Progress) -> None:
    """Build the FMUs of all models that a wheel holds."""
    for root in ROOTS.values():
        path = PREBUILT / digest_sources()[:16] / f"{root.identifier}.fmu"
        write_fmu(path, root, PREBUILT_FMI, list_platforms(PREBUILT_FMI), progress)


def _digest_build(root: Root) -> str:
    """Digest of the sources, of the C compiler's version, and of the file of a class that is not
    the library's."""
    digest = hashlib.sha256(f"{digest_sources()} {find_compiler_version()}".encode())
    if root.class_file is not None:
        digest.update(root.class_file.read_bytes())
    return digest.hexdigest()


def write_fmu(
    path: Path,
    root: Root = ROOTS["HRG"],
    fmi: int = 2,
    platforms: Sequence[str] = (),
    progress: Progress = lambda text: None,
) -> None:
    """Translate, compile and pack a model; `path` appears only when all is done."""
    platforms = choose_platforms(platforms, fmi)
    progress(f"translating {root.model}")
    sources = [*SOURCES, SHELLS[fmi]]
    with tempfile.TemporaryDirectory(prefix="hrg-build-") as name:
        folder = Path(name)
        with refuse_unreadable(root.model, "gyro that the generator knows"):
            dae = _translate(root)
            description = write_sources(dae, folder, fmi, root)
        content = {"modelDescription.xml": description.encode()}
        packed = [*(folder / name for name in sources), *folder.glob("*.h")]
        content |= {f"sources/{f.name}": f.read_bytes() for f in packed}
        libraries = {
            platform: fetch_library(folder, sources, root.identifier, PLATFORMS[platform], progress)
            for platform in platforms
        }
    content |= place_binaries(libraries, root.identifier, fmi)
    if fmi == 3:
        build_text = describe_build(root.identifier, sources, PORTABLE_FLAGS)
        content["sources/buildDescription.xml"] = build_text.encode()
    content |= _make_enclosures(dae, root, fmi, content)
    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, pack_archive(content))
    progress(f"built {path}")


def _translate(root: Root) -> Dae:
    gyros = find_modelica_library()
    if root.class_file is not None or root.library == gyros.name:
        return translate(gyros, root.model, class_file=root.class_file)
    return translate(gyros.with_name(root.library), root.model, uses=(gyros,))


DIGESTED_FOLDERS = ("equations", "code", "c", "binaries", "archive")
"""Folders whose files determine what the FMU is, and enter its digest."""
SUFFIXES = ("py", "css", "png", "ssv", "txt", "c", "h")


def digest_sources() -> str:
    """Digest of all that determines the FMU but the C compiler: Modelica, generator, C, licence."""
    tools = f"{COMPILER_VERSION} {version('hrg')} {FLAGS}"
    digest = hashlib.sha256(f"{tools} {read_licence()}".encode())
    package = Path(__file__).parent
    for root, pattern in (
        (find_modelica(), "**/*.mo"),
        (package, "*.py"),
        *((package / part, f"**/*.{suffix}") for part in DIGESTED_FOLDERS for suffix in SUFFIXES),
    ):
        for file in sorted(root.glob(pattern)):
            digest.update(file.relative_to(root).as_posix().encode())
            digest.update(file.read_bytes())
    return digest.hexdigest()


def write_sources(dae: Dae, folder: Path, fmi: int, root: Root = ROOTS["HRG"]) -> str:
    """Write the C sources into a folder; returns modelDescription.xml."""
    equations = generate_source(dae, root.integrator)
    digest = hashlib.sha256((equations + generate_limits(dae, "", 3)).encode())
    for source in sorted((Path(__file__).parent / "c").iterdir()):
        (folder / source.name).write_bytes(source.read_bytes())
        digest.update(source.read_bytes())
    token = digest.hexdigest()[:32]
    (folder / "model.c").write_text(equations)
    (folder / "model_constants.h").write_text(generate_header(dae))
    (folder / "limits.c").write_text(generate_limits(dae, token, fmi))
    if fmi == 3:
        return describe_fmi3(dae, root, token)
    return describe_fmi2(dae, root, token, [*SOURCES, SHELLS[fmi]])


def _make_enclosures(
    dae: Dae, root: Root, fmi: int, content: Mapping[str, bytes]
) -> dict[str, bytes]:
    """What an archive holds beside its description, sources and binaries (`content`), by path."""
    run = simulate_reference(root.identifier, content)
    page = write_documentation(dae, root, version("hrg"), run, fmi)
    icon = ICON.read_bytes()
    files = {
        "documentation/index.html": page.encode(),
        "terminalsAndIcons/terminalsAndIcons.xml": describe_terminals(dae).encode(),
        "terminalsAndIcons/icon.png": icon,
        "extra/org.cyclonedx/bom.json": list_materials(root.identifier, content).encode(),
    }
    files |= run.files(root.identifier)
    files |= {f"documentation/licenses/{n}": text for n, text in list_licence_files(fmi).items()}
    if root.identifier in ROOTS:
        arrays = _select_arrays(dae, fmi)
        for file in DEVICES.glob("*.ssv"):
            files[f"resources/{file.name}"] = join_arrays(file.read_text(), arrays).encode()
    return files | ({"model.png": icon} if fmi == 2 else {})
