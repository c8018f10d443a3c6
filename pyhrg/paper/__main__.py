"""`python -m pyhrg.paper > docs/paper.md` computes every figure anew; with `--figures`, a list."""

import sys

from pyhrg.paper.document import figures, filled

values = figures()
if "--figures" in sys.argv[1:]:
    print("\n".join(f"{name} = {value:.6g}" for name, value in values.items()))
else:
    sys.stdout.write(filled(values))
