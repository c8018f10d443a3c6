"""Namespaces of the documents of an SSP (System Structure and Parameterization)."""

SPACES = {
    prefix: f"http://ssp-standard.org/SSP1/SystemStructure{name}"
    for prefix, name in (("ssd", "Description"), ("ssc", "Common"), ("ssv", "ParameterValues"))
}
"""By the usual prefix; alike in SSP 1.0 and 2.0."""
