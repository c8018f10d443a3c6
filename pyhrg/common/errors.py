"""The one exception that users of this project catch."""


class HrgError(Exception):
    """An error that the user can correct. Its message is one line that names the file, the field,
    what was found and what was expected.

    Every package derives its own from it. The command `hrg` prints the message and ends with
    status 2.
    """
