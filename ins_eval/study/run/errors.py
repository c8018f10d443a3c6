"""What keeps a study from running."""

from pyhrg.common.errors import HrgError


class StudyRunError(HrgError):
    """The message names folder or block, what was found and what was expected."""
