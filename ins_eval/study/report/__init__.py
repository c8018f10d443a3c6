"""report.html: the study's result as people look at it first."""
