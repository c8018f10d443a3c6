"""What keeps a study from running."""


class StudyRunError(Exception):
    """The message names folder or block, what was found and what was expected."""
