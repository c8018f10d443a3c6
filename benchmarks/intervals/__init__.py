"""How often 95 % intervals hold the truth, procedure by procedure; run as a module."""

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
