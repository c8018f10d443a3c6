"""The error of a study that cannot run."""

from pyhrg.common.errors import HrgError


class StudyRunError(HrgError):
    """A study cannot run; the message names folder or block, what was found, what was expected."""
