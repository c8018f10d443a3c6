"""The validation: a preset of the study with one test mission, and files of its result."""
