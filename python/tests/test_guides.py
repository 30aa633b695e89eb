"""The examples of the guides run."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from shared import ROOT


@pytest.mark.parametrize("language", ["en", "cs"])
def test_guide(language: str, folder: Path) -> None:
    pytest.importorskip("duckdb")
    for path in (ROOT / "docs/guide/examples/contour").iterdir():
        shutil.copy(path, folder)
    text = (ROOT / f"docs/guide/python.{language}.md").read_text("utf-8")
    examples = re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
    assert len(examples) > 5
    names: dict[str, object] = {}
    for example in examples:
        exec(compile(example, f"python.{language}.md", "exec"), names)
