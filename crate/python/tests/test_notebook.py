"""The notebook of docs/examples runs."""

from pathlib import Path

import pytest
import vcgpdm
from conftest import ROOT


def test_the_notebook_runs(tmp_path):
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    for needed in ("ipykernel", "matplotlib", "anywidget"):
        pytest.importorskip(needed)
    notebook = nbformat.read(ROOT / "docs/examples/walk.ipynb", as_version=4)
    assert all(cell.outputs == [] for cell in notebook.cells if cell.cell_type == "code")
    if not (Path(vcgpdm.__file__).parent / "widget.js").exists():
        # A build without Node has no script for the widget.
        notebook.cells[-1].metadata["tags"] = ["raises-exception"]
    client = nbclient.NotebookClient(
        notebook, timeout=600, kernel_name="python3", resources={"metadata": {"path": tmp_path}}
    )
    client.execute()
    assert (tmp_path / "model.json").stat().st_size > 10_000
    assert (tmp_path / "other-arms.bvh").read_text().startswith("HIERARCHY")
