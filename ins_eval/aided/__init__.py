"""Navigation aided by fixes: errors of the sensors, maps of gyros among them, from a drive
(docs/methods/aided.md)."""
