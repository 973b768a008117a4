"""The command `tomolith`, also as `python -m tomolith`."""

import signal
import sys

from ._native import _command


def main() -> int:
    """Runs the command with the words of this process; its exit code."""
    # The command answers Ctrl-C itself; where it does not listen, Ctrl-C ends the process as it ends any program
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _command(["tomolith", *sys.argv[1:]], [sys.executable, "-m", "tomolith"])


if __name__ == "__main__":
    sys.exit(main())
