"""Results as labelled arrays, tables with units, and figures."""
