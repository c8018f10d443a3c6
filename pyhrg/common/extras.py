"""Libraries that come with an extra of this distribution, such as `hrg[build]`."""

from importlib import import_module
from typing import Any

from pyhrg.common.errors import HrgError

EXTRA_OF = {"rumoca": "build", "ziglang": "build", "dask": "cluster", "distributed": "cluster"}
"""The extra that installs each library."""
PURPOSE = {"build": "build an FMU", "cluster": "run a study"}


def require_extra(extra: str) -> None:
    """Refuse to begin where a library of an extra is missing.

    Raises:
        HrgError: one is not installed.
    """
    for library, its_extra in EXTRA_OF.items():
        if its_extra == extra:
            import_extra(library)


def import_extra(library: str) -> Any:
    """A library that an extra installs.

    Raises:
        HrgError: it is not installed; the message names the extra.
    """
    try:
        return import_module(library)
    except ModuleNotFoundError as error:
        if error.name != library:
            raise
        extra = EXTRA_OF[library]
        raise HrgError(
            f"{library} is not installed, expected to {PURPOSE[extra]}: "
            f"python3 -m pip install 'hrg[{extra}]'"
        ) from None
