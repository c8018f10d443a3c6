"""The small study, its verdict on the terminal and a figure: which bench test told the truth."""
