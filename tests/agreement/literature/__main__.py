"""`python -m tests.agreement.literature > docs/literature.md` computes every figure of the page."""

import sys

from tests.agreement.literature.document import compute_figures, fill_document

sys.stdout.write(fill_document(compute_figures()))
