"""The judged flights of a study with one judged mission: in words, and as a figure."""
