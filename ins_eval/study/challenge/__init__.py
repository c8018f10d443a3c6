"""The study's challenge: bench records of sealed gyros are handed out, predictions are scored."""
