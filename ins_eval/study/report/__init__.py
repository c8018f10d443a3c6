"""report.html: the verdict, figures and scores of a study on one page."""
