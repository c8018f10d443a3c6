"""What is said of a prediction."""

import numpy as np
import pandas as pd

from pyhrg.gap.closing.prediction import describe_prediction


def test_the_outputs_zero_is_no_residual() -> None:
    frame = pd.DataFrame({"residual_arcsec": 124.35 + 0.15 * np.tile([1.0, -1.0], 50)})
    frame.loc[100] = np.nan
    said = describe_prediction(frame)
    assert "0.15 arcsec rms about the mean, 0.15 arcsec at most (100 rows)" in said
    assert "the mean of 124.35 arcsec is the output's zero" in said
