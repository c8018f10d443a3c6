"""A naive predictor: each judged flight errs as the training triads did. It reads no bench record.

python docs/challenge/naive.py HAND-OUT predictions.csv
"""

import sys
from pathlib import Path

import numpy as np
import pandas as pd

folder, out = map(Path, sys.argv[1:])
training = pd.read_csv(folder / "training.csv")
training["radial_m"] = np.hypot(training["flown_north_m"], training["flown_east_m"])
quantiles = training.groupby("mission")["radial_m"].quantile([0.05, 0.5, 0.95]).unstack()
quantiles.columns = ["low_m", "median_m", "high_m"]

flights = pd.read_csv(folder / "flights.csv")
judged = flights.loc[flights["role"] == "test", ["triad"]].drop_duplicates()
judged.merge(quantiles.reset_index(), how="cross").to_csv(out, index=False)
