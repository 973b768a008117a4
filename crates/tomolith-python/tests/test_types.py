"""The stubs say what the compiled part has, and the manuals of Python are whole. `cargo test` runs it (package.rs)."""

import importlib.util
import inspect
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import tomolith
from test_task import needs

# A use that is right, and one that is not
PROGRAM = """
from threading import Event

import numpy as np
import tomolith
import tomolith._operator

run = tomolith.Job({"grid": {"pitch_mm": 0.1}}, set=["stop.iterations=3"]).run(progress=print, cancel=Event())
print(run.patterns.shape, run.metrics["iou"], tomolith.Run.open(run.folder).history["loss"])
task = tomolith.Job("gear.toml").resolve().task()
value, gradient = task.value_and_gradient(np.zeros(3))
print(value + 1.0, task.operator() @ gradient.ravel(), task.target.sum())
value.shape  # type: ignore[attr-defined]
"""


class Types(unittest.TestCase):
    def must_pass(self, *arguments):
        package = Path(tomolith.__file__).parents[1]
        done = subprocess.run([sys.executable, "-m", *arguments], cwd=package, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    @needs("mypy")
    def test_stubs_and_annotations_hold(self):
        program = PROGRAM + ("import tomolith.jax\n" if importlib.util.find_spec("jax") else "")
        with tempfile.TemporaryDirectory() as folder:
            options = ["--strict", "--ignore-missing-imports", f"--cache-dir={folder}"]
            self.must_pass("mypy", *options, "-c", program)
        self.must_pass("mypy.stubtest", "--ignore-disjoint-bases", "tomolith._native")

    def test_everything_public_has_a_docstring(self):
        for name in tomolith.__all__:
            thing = getattr(tomolith, name)
            self.assertTrue(thing.__doc__, name)
            if inspect.isclass(thing):
                for part, value in vars(thing).items():
                    if not part.startswith("_"):
                        self.assertTrue(value.__doc__, f"{name}.{part}")
