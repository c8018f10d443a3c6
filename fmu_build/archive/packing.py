"""Archives whose bytes follow from their content alone."""

import io
import zipfile
from collections.abc import Mapping


def pack_archive(content: Mapping[str, bytes]) -> bytes:
    """A ZIP archive of files by path: sorted names and fixed times, so that the same content gives
    the same bytes."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(content):
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content[name])
    return buffer.getvalue()
