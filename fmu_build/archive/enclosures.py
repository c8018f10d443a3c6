"""What an archive holds beside its description, sources and binaries."""

from collections.abc import Mapping
from importlib.metadata import version

from fmu_build.archive.bill_of_materials import bill_of_materials
from fmu_build.archive.documentation.document import documentation
from fmu_build.archive.icon import icon_png
from fmu_build.archive.licences import licence_files
from fmu_build.archive.reference import reference
from fmu_build.archive.terminals import terminals_and_icons
from fmu_build.equations.dae import Dae
from fmu_build.roots import Root


def enclosures(dae: Dae, root: Root, fmi: int, content: Mapping[str, bytes]) -> dict[str, bytes]:
    """Documentation, icon, terminals, licences, reference results and bill of materials, by path.

    Args:
        dae: the model.
        root: what is exported.
        fmi: version of the standard, 2 or 3.
        content: description, sources and binaries, by path.
    """
    run = reference(root.identifier, content)
    page = documentation(dae, root, version("hrg"), run)
    found = {
        "documentation/index.html": page.encode(),
        "terminalsAndIcons/terminalsAndIcons.xml": terminals_and_icons(dae).encode(),
        "terminalsAndIcons/icon.png": icon_png(),
        "extra/org.cyclonedx/bom.json": bill_of_materials(root.identifier, content).encode(),
    }
    found |= run.files(root.identifier)
    found |= {f"documentation/licenses/{n}": text for n, text in licence_files(fmi).items()}
    if fmi == 2:
        found["model.png"] = icon_png()
    return found
