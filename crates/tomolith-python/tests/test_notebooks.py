"""The notebooks run from top to bottom, and are kept without what they print. `cargo test` runs it (package.rs)."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("*.ipynb"))


class Notebooks(unittest.TestCase):
    def test_each_runs(self):
        self.assertEqual(len(NOTEBOOKS), 4)
        for notebook in NOTEBOOKS:
            cells = json.loads(notebook.read_text("utf-8"))["cells"]
            code = [cell for cell in cells if cell["cell_type"] == "code"]
            self.assertFalse(any(cell["outputs"] or cell["execution_count"] for cell in code), notebook.name)
            program = "\n\n".join("".join(cell["source"]) for cell in code)
            with self.subTest(notebook.name), tempfile.TemporaryDirectory() as folder:
                done = subprocess.run([sys.executable, "-c", program], cwd=folder, capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertTrue(done.stdout)
