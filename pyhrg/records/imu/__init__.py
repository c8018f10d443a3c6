"""Logs of IMUs, in the formats that are known: what their sensors handed over, checked."""
