"""The README, the stubs and the version."""

import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import vcgpdm
from conftest import ROOT

HERE = Path(__file__).parents[1]
EXAMPLES = re.findall(r"^```python\n(.*?)^```", (HERE / "README.md").read_text("utf-8"), re.M | re.S)


@pytest.mark.parametrize("example", EXAMPLES)
def test_the_examples_of_the_readme_run(example, tmp_path):
    done = subprocess.run([sys.executable, "-c", example], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout
    assert not done.stderr


def test_the_first_example_has_twelve_lines_at_most():
    assert len(EXAMPLES[0].splitlines()) <= 12


def test_the_stubs_describe_the_module(tmp_path):
    pytest.importorskip("mypy")
    allowed = tmp_path / "allowed.txt"
    # The widget is written in Python and has no stubs.
    allowed.write_text(r"vcgpdm\.widget\..*")
    command = [sys.executable, "-m", "mypy.stubtest", "vcgpdm", "--allowlist", allowed]
    command += ["--ignore-unused-allowlist"]
    # mypy writes its cache into the folder where it runs.
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_everything_public_has_a_docstring():
    for name in vcgpdm.__all__:
        item = getattr(vcgpdm, name)
        if not isinstance(item, type):
            continue
        assert item.__doc__, name
        for member, value in vars(item).items():
            assert member.startswith("_") or value.__doc__, f"{name}.{member}"


def test_the_version_is_that_of_the_library():
    workspace = tomllib.loads((ROOT / "Cargo.toml").read_text("utf-8"))
    assert vcgpdm.__version__ == workspace["workspace"]["package"]["version"]
