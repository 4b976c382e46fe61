"""The command line of flockproof, as in ``python -m flockproof verify``."""

from __future__ import annotations

import sys

from . import _native


def main() -> int:
    """Runs the command line with the arguments of the process; the exit status."""
    sys.stdout.flush()
    return _native.command_line(["flockproof", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
