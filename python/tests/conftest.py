"""What the tests share."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

ASSETS = Path(os.environ.get("FLOCKPROOF_ASSETS", Path(__file__).resolve().parents[2] / "assets"))


def command_line(*arguments: str) -> subprocess.CompletedProcess[str]:
    """The program as a user runs it."""
    command = [sys.executable, "-m", "flockproof", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def answer(*arguments: str) -> Any:
    """The JSON document of a command that succeeds."""
    done = command_line(*arguments, "--json")
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@pytest.fixture(scope="session")
def assets() -> Path:
    return ASSETS
