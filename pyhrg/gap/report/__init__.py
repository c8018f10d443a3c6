"""report.html: a diagnosis as people look at it first."""
