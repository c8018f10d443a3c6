"""A software bill of materials, CycloneDX 1.5: tools with versions, sources with digests."""

import hashlib
import json
from collections.abc import Mapping
from importlib.metadata import version
from typing import Any

from fmu_build.archive.licences import read_licence

TOOLS = {
    "rumoca": "Modelica compiler",
    "ziglang": "C compiler and cross-compiler",
    "fmpy": "FMI headers",
    "hrg": "generator of the C sources and of the archive",
}

LIBRARIES = (
    ("Cephes Mathematical Library", "polynomials of sin, cos and atan", "cephes.txt"),
    ("fdlibm", "polynomial of log", "fdlibm.txt"),
)


def list_materials(name: str, content: Mapping[str, bytes]) -> str:
    """The bill of an FMU's sources and binaries (by path) as JSON, without times or random
    numbers."""
    licence = read_licence()
    component = {
        "type": "library",
        "author": licence.author,
        "name": name,
        "version": version("hrg"),
        "licenses": [{"expression": licence.expression}],
        "copyright": licence.copyright,
    }
    tools = [
        {"type": "application", "name": name, "version": version(name), "description": purpose}
        for name, purpose in TOOLS.items()
    ]
    libraries = [
        {
            "type": "library",
            "name": name,
            "description": f"{part}, in sources/arithmetic.h",
            "licenses": [{"license": {"name": f"documentation/licenses/{notice}"}}],
        }
        for name, part, notice in LIBRARIES
    ]
    document = {
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {"component": component, "tools": {"components": tools}},
        "components": [*libraries, *(_file(path, content[path]) for path in sorted(content))],
    }
    return json.dumps(document, indent=1) + "\n"


def _file(path: str, data: bytes) -> dict[str, Any]:
    digest = hashlib.sha256(data).hexdigest()
    return {"type": "file", "name": path, "hashes": [{"alg": "SHA-256", "content": digest}]}
