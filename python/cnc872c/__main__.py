"""The command ``cnc872c``."""

import signal
import sys

from . import _native


def main() -> int:
    """Runs the command line; the exit status."""
    # The command ends at once, as the program without Python does.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _native.main(["cnc872c", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
