"""`python -m tests.agreement.paper > docs/paper.md` computes every figure; `--figures`: a list."""

import sys

from tests.agreement.paper.document import compute_figures, fill_document

values = compute_figures()
if "--figures" in sys.argv[1:]:
    print("\n".join(f"{name} = {value:.6g}" for name, value in values.items()))
else:
    sys.stdout.write(fill_document(values))
