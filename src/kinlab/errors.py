"""What can go wrong because of something a user did, each with the exit code it leads to."""


class KinlabError(Exception):
    """The job failed: the request was understood and could not be fulfilled (exit code 1)."""

    exit_code = 1


class UsageError(KinlabError, ValueError):
    """The request itself is wrong: a name, a number, a file (exit code 2)."""

    exit_code = 2


class FileError(UsageError):
    """A file that a user named is missing, unreadable or wrong; the message starts with its name and line."""
