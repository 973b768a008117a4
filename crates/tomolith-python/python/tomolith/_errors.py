"""What the package raises."""

from pathlib import Path


class TomolithError(Exception):
    """What was found, where, and what is accepted.

    The text says it in the words of the command; the attributes give its parts to programs, and are None where they are not known: `key`, the dotted path
    of the key of a job, or the argument of a call; `found` and `accepted`; `file`, and the `line` in it, counted from 1. Where several keys of a job are at
    fault, `errors` holds an error for each, and the other attributes are those of the first.
    """

    def __init__(
        self,
        *text: object,
        key: str | None = None,
        found: str | None = None,
        accepted: str | None = None,
        file: Path | None = None,
        line: int | None = None,
        errors: "list[TomolithError] | None" = None,
    ) -> None:
        super().__init__(*text)
        self.key = key
        self.found = found
        self.accepted = accepted
        self.file = file
        self.line = line
        # An error alone does not hold itself: it would live until the garbage collector finds the circle
        self.errors = errors or []


class Canceled(TomolithError):
    """Work ended because its `cancel` was set. `Job.run(resume=True)` goes on from a run's checkpoint; a sweep goes on when it is called again."""


# People import them from the package, and so do pickles
for _error in (TomolithError, Canceled):
    _error.__module__ = "tomolith"
