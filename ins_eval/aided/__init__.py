"""Navigation aided by fixes: sensor errors and bias maps of gyros, from a drive
(docs/methods/aided.md)."""
