"""How well drives with fixes tell the maps of whole-angle gyros (docs/methods/aided.md)."""
