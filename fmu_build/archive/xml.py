"""XML as it is written into the archive."""

import xml.etree.ElementTree as ET


def format_xml(root: ET.Element) -> str:
    """Indented text of a document, with its declaration."""
    ET.indent(root)
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{ET.tostring(root, encoding="unicode")}\n'
