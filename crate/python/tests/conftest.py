"""What several tests use."""

import json
import os
import subprocess
from pathlib import Path

import pytest
from vcgpdm import Clip, Vcgpdm

ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="session")
def walk():
    return Clip.sample("walk-1")


@pytest.fixture(scope="session")
def model(walk):
    return Vcgpdm.fit(walk, parts="lower,upper", max_iterations=15, seed=3)


@pytest.fixture(scope="session")
def terminal():
    """The terminal program: a function of its arguments that returns the JSON it prints."""
    program = Path(os.environ.get("VCGPDM_PROGRAM", ROOT / "target/debug/vcgpdm"))
    if not program.exists():
        pytest.skip(f"the terminal program is not at {program}: cargo build -p vcgpdm-cli")

    def run(*arguments):
        done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout) if done.stdout else None

    return run
