"""What an archive holds beside its description, sources and binaries."""

from collections.abc import Mapping
from importlib.metadata import version

from fmu_build.archive.bill_of_materials import list_materials
from fmu_build.archive.documentation.document import write_documentation
from fmu_build.archive.icon import draw_icon
from fmu_build.archive.licences import list_licence_files
from fmu_build.archive.reference import simulate_reference
from fmu_build.archive.terminals import describe_terminals
from fmu_build.equations.dae import Dae
from fmu_build.roots import Root


def make_enclosures(
    dae: Dae, root: Root, fmi: int, content: Mapping[str, bytes]
) -> dict[str, bytes]:
    """Documentation, icon, terminals, licences, reference results and bill of materials, by path.

    Args:
        dae: the model.
        root: what is exported.
        fmi: version of the standard, 2 or 3.
        content: description, sources and binaries, by path.
    """
    run = simulate_reference(root.identifier, content)
    page = write_documentation(dae, root, version("hrg"), run)
    found = {
        "documentation/index.html": page.encode(),
        "terminalsAndIcons/terminalsAndIcons.xml": describe_terminals(dae).encode(),
        "terminalsAndIcons/icon.png": draw_icon(),
        "extra/org.cyclonedx/bom.json": list_materials(root.identifier, content).encode(),
    }
    found |= run.files(root.identifier)
    found |= {f"documentation/licenses/{n}": text for n, text in list_licence_files(fmi).items()}
    if fmi == 2:
        found["model.png"] = draw_icon()
    return found
