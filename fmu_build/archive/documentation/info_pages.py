"""Info pages of the Modelica library, for the documentation."""

import xml.etree.ElementTree as ET
from collections.abc import Iterable
from html import escape
from pathlib import Path

from fmu_build.equations.dae import Dae
from fmu_build.equations.modelica import find_library, read_page


def read_model_pages(dae: Dae) -> str:
    """Pages of the model, of every class that declares one of its variables, of its functions."""
    classes = dict.fromkeys(Path(variable.file) for variable in dae.variables)
    own = f"{dae.model.split('.')[-1]}.mo"
    called = {function.name.split(".")[-1] for function in dae.functions}
    functions = (file for file in sorted(_library(dae).rglob("*.mo")) if file.stem in called)
    return _articles([*sorted(classes, key=lambda file: file.name != own), *functions])


def read_guide_pages(dae: Dae) -> str:
    """Pages of the users' guide, in its order; none if the library has no guide."""
    folder = _library(dae) / "UsersGuide"
    order = folder / "package.order"
    names = order.read_text(encoding="utf-8").split() if order.exists() else []
    return _articles(folder / f"{name}.mo" for name in names)


def _library(dae: Dae) -> Path:
    return find_library(Path(dae.variables[0].file))


def _articles(files: Iterable[Path]) -> str:
    articles = []
    for page in map(read_page, files):
        if page.info:
            try:
                ET.fromstring(f"<div>{page.info}</div>")
            except ET.ParseError as error:
                raise ValueError(f"the info text of {page.name} is no HTML: {error}") from error
            articles.append(
                f"<article><h3>{escape(page.description)}</h3>\n"
                f'<p class="small"><code>{escape(page.name)}</code></p>\n{page.info}</article>'
            )
    return "\n".join(articles)
