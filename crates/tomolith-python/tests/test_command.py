"""The command that the package brings along is the command: its words, output and exit codes. `cargo test` runs it (package.rs)."""

import json
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import tomolith
from test_task import GEAR

TOMOLITH = [sys.executable, "-m", "tomolith"]

# A sweep of two runs, and a command, which says 1000/50 µm
STUDY = """
title = "A gear"
paper = "Nobody, never"
[runs.few]
sweep = "sweep.toml"
[runs.voxel]
command = ["analyze", "voxel", "--pixels", "100", "--fps", "1000", "--penetration-mm", "10", "--dose-time-s", "50", "--radius-mm", "1"]
[[rows]]
quantity = "IoU"
where = "Table 1"
of = "few"
at = { iterations = 3 }
metric = "evaluation.iou"
published = 1
within = 0.5
[[rows]]
quantity = "pixel, mm"
where = "S1"
of = "voxel"
metric = "at_radius.pixel_mm"
published = 0.02
within = 1e-9
"""
SWEEP = """
job = "gear.json"
[[axes]]
key = "stop.iterations"
values = [0, 3]
"""


class Commands(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def command(self, *words):
        return subprocess.run([*TOMOLITH, *map(str, words)], capture_output=True, text=True, cwd=self.folder)

    def test_words_output_and_exit_codes_are_those_of_the_command(self):
        version = self.command("--version")
        self.assertEqual((version.returncode, version.stdout), (0, f"tomolith {tomolith.__version__}\n"))
        self.assertIn("Usage: tomolith", self.command("--help").stdout)
        # All of it arrives
        self.assertTrue(self.command("completions", "bash").stdout.endswith("fi\n"))
        slip = self.command("runn")
        self.assertEqual((slip.returncode, slip.stdout), (2, ""))
        self.assertIn("run", slip.stderr)
        (self.folder / "gear.json").write_text(json.dumps(GEAR))
        done = self.command("run", "gear.json", "--toy", "--set", "evaluate.require_iou=1.0", "--json", "--output", "gear")
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertEqual(json.loads(done.stdout.splitlines()[-1])["event"], "done")
        self.assertTrue((self.folder / "gear" / "report.html").is_file())

    def test_an_interrupt_ends_it_with_130(self):
        (self.folder / "gear.json").write_text(json.dumps(GEAR))
        words = ["run", "gear.json", "--set", "stop.iterations=1000000", "--set", "stop.change=0", "--json"]
        # Programs that were started in the background ignore interrupts
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        with subprocess.Popen([*TOMOLITH, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.folder) as child:
            self.addCleanup(child.kill)
            next(line for line in child.stdout if json.loads(line)["event"] == "iteration")
            child.send_signal(signal.SIGINT)
            asked = time.monotonic()
            lines, errors = child.communicate(timeout=60)
        self.assertEqual(child.returncode, 130, errors)
        self.assertLess(time.monotonic() - asked, 10)
        self.assertNotIn("Traceback", errors)
        self.assertEqual(json.loads(lines.splitlines()[-1])["event"], "error")

    def test_a_study_is_reproduced(self):
        (self.folder / "study").mkdir()
        (self.folder / "study" / "study.toml").write_text(STUDY)
        (self.folder / "study" / "sweep.toml").write_text(SWEEP)
        (self.folder / "study" / "gear.json").write_text(json.dumps(GEAR))
        events = []
        found = tomolith.reproduce(self.folder / "study", folder=self.folder / "found", progress=events.append)
        self.assertEqual([row["verdict"] for row in found["rows"]], ["reproduced", "reproduced"])
        self.assertTrue((self.folder / "found" / "table.md").is_file())
        self.assertEqual(events[0]["event"], "study")
        self.assertEqual({event["of"] for event in events[1:]}, {"few"})
        with self.assertRaisesRegex(tomolith.TomolithError, "study.toml"):
            tomolith.reproduce(self.folder)
