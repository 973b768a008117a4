"""What Python gives is what the library gives, and its derivatives are derivatives. `cargo test` runs it (package.rs)."""

import json
import os
import signal
import tempfile
import threading
import unittest
from pathlib import Path

import numpy as np
import tomolith

HERE = Path(__file__).parent
GEAR = json.loads((HERE / "gear.json").read_text())
EXAMPLES = Path(__file__).parents[3] / "examples"


class Tasks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.job = tomolith.Job(GEAR).resolve()
        cls.task = cls.job.task()

    def test_the_pullback_is_the_transpose_of_the_dose(self):
        random = np.random.default_rng(1)
        x = random.random(self.task.start.size)
        dose = self.task.dose(x)
        cotangent = random.random(dose.size)
        left = np.dot(dose.astype(float), cotangent)
        right = np.dot(x, self.task.pullback(x, cotangent).astype(float))
        self.assertLess(abs(left / right - 1), 1e-5)

    def test_the_gradient_is_that_of_the_value(self):
        start = self.task.start.astype(float)
        step = np.random.default_rng(2).uniform(-1, 1, start.size) * 1e-3 * start.max()
        ahead, behind = (self.task.value_and_gradient(start + s * step)[0] for s in (1, -1))
        slope = np.dot(self.task.value_and_gradient(start)[1].astype(float), step)
        self.assertLess(abs((ahead - behind) / 2 - slope), 0.01 * abs(slope))

    def test_images_and_pixels_are_one(self):
        (image,) = self.task.patterns(self.task.start)
        self.assertEqual(image.shape, (36, 16, 24))
        np.testing.assert_array_equal(self.task.pixels(image), self.task.start)
        np.testing.assert_array_equal(self.task.pixels([image.astype(float)]), self.task.start)
        (volume,) = self.task.volumes(self.task.dose(self.task.start))
        self.assertEqual(volume.shape, self.task.target.shape)
        # The part is brighter than the void
        part, void = (volume[self.task.labels == label].mean() for label in (2, 1))
        self.assertGreater(part, 1.5 * void)

    def test_a_loop_of_ones_own_prints_better_than_the_start(self):
        x = self.task.start.copy()
        lower, upper = self.task.bounds
        losses = []
        for _ in range(10):
            loss, gradient = self.task.value_and_gradient(x)
            losses.append(loss)
            x = np.clip(x - 0.1 * x.max() / abs(gradient).max() * gradient, lower, upper)
        self.assertLess(losses[-1], losses[0])
        begin, end = self.task.evaluate(self.task.start), self.task.evaluate(x)
        self.assertGreater(end["iou"], begin["iou"])
        self.assertEqual(begin, self.job.evaluate(self.task.patterns(self.task.start)))

    def test_what_does_not_fit_is_said(self):
        image = self.task.patterns(self.task.start)[0]
        for call, words in [
            (lambda: self.task.dose(np.zeros(3)), "x: found 3 elements; accepted: "),
            (lambda: self.task.dose(np.zeros((2, 2))), "x: found an array of several axes"),
            (lambda: self.job.evaluate(image[:2]), "accepted: [36, 16, 24] [frame, row, column]"),
            (lambda: self.job.evaluate([image, image]), "found 2 arrays; accepted: 1"),
            (lambda: tomolith.Job(GEAR, set=["stop.iteratons=3"]), "did you mean `iterations`?"),
            (lambda: tomolith.Job("nowhere.toml"), "nowhere.toml: "),
            (lambda: tomolith.Job({**GEAR, "grid": {"pitch_mm": float("nan")}}), "job: "),
            (lambda: tomolith.Job({**GEAR, "grid": {"pitch_mm": object()}}), "found a value of"),
            (lambda: self.task.dose(np.full(self.task.start.size, np.inf)), "at element"),
            (lambda: self.task.dose("abc"), "accepted: numbers"),
            (lambda: self.task.dose(np.ma.masked_array(self.task.start, self.task.start > 0)), "a masked array"),
            (lambda: self.task.dose(np.zeros(self.task.start.size, "M8[s]")), "found datetime64[s]"),
            (lambda: self.task.dose(np.zeros(self.task.start.size, complex)), "found complex128"),
            (lambda: self.task.value_and_gradient(np.full(self.task.start.size, 3e38)), "loss: found "),
            (lambda: self.task.dose(np.full(self.task.start.size, 3e38)), "dose: found inf"),
            (lambda: self.job.evaluate(image - 1), "at [0, 0, 0] [frame, row, column]"),
            (lambda: tomolith.sweep("nowhere.toml", threads=0), "1 to 256"),
            (lambda: tomolith.sweep("nowhere.toml"), "nowhere.toml: "),
        ]:
            with self.assertRaises(tomolith.TomolithError) as raised:
                call()
            self.assertIn(words, str(raised.exception))


    def test_tables_may_hold_numbers_of_numpy_and_paths(self):
        light = {**GEAR["light"][0], "pixels": np.array([24, 16]), "angles": np.int64(36)}
        same = tomolith.Job({**GEAR, "light": [light], "output": {"folder": Path("out/x")}})
        self.assertEqual(same.tables["light"], tomolith.Job(GEAR).tables["light"])

    def test_voxels_are_told(self):
        self.assertEqual(self.task.shape, self.task.target.shape)
        (across, along), pitch = self.task.voxel_mm, self.job.pitch_mm
        self.assertAlmostEqual(self.task.shape[2] * across, self.job.shape[2] * pitch)
        low, high = self.task.box_mm
        for axis, edge, count in zip(range(3), [across, across, along], reversed(self.task.shape)):
            self.assertAlmostEqual(high[axis] - low[axis], count * edge)
        # Slices beside the part are left out
        self.assertGreater(self.task.target[0].max(), 0)
        self.assertGreater(self.task.target[-1].max(), 0)
        self.assertLess(self.task.shape[0] * along, self.job.shape[0] * pitch)

    @unittest.skipUnless(hasattr(os, "fork"), "no forks here")
    def test_a_fork_is_refused(self):
        child = os.fork()
        if child == 0:
            try:
                self.task.dose(self.task.start)
            except tomolith.TomolithError as error:
                os._exit(0 if "spawn" in str(error) else 1)
            os._exit(2)
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 0)


class Runs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_a_run_tells_what_the_same_patterns_print_anywhere(self):
        job = tomolith.Job(GEAR, folder=self.folder / "run")
        self.assertEqual(job.tables["stop"]["iterations"], 10)
        self.assertGreater(job.check()["memory_mb"], 0)
        events = []
        run = job.run(progress=events.append)
        iterations = [event["iteration"] for event in events if event["event"] == "iteration"]
        self.assertEqual(iterations[-1], run["iterations"])
        patterns = self.folder / "run" / "patterns.npz"
        simulated = tomolith.Job(GEAR, folder=self.folder / "simulated").simulate(patterns)
        self.assertEqual(simulated["evaluation"], run["evaluation"])
        evaluated = job.resolve().evaluate(np.load(patterns)["patterns"])
        for name in ("iou", "ver", "pw"):
            self.assertEqual(evaluated[name], run["evaluation"][name])
        # The library itself has run the same job
        library = Path(os.environ["TOMOLITH_LIBRARY_RUN"])
        report = json.loads((library / "report.json").read_text())
        self.assertEqual(evaluated["surface_mean_mm"], report["evaluation"]["surface_mean_mm"])
        np.testing.assert_array_equal(
            np.load(patterns)["patterns"], np.load(library / "patterns.npz")["patterns"]
        )
        with self.assertRaisesRegex(tomolith.TomolithError, "overwrite"):
            tomolith.Job(GEAR, set=["stop.iterations=2"], folder=self.folder / "run").run()

    def test_the_print_in_time_is_that_of_the_same_material(self):
        job = tomolith.Job(
            EXAMPLES / "19-print-in-time.toml",
            set=["grid.pitch_mm=0.2", "stop.iterations=3"],
            folder=self.folder / "time",
        )
        run = job.run()
        patterns = np.load(self.folder / "time" / "patterns.npz")["patterns"]
        evaluated = job.resolve().evaluate(patterns)
        self.assertGreater(run["in_time"][0]["best_jaccard"], 0.5)
        self.assertEqual(evaluated["in_time"], run["in_time"])

    def test_every_species_is_told(self):
        coarse = ["grid.pitch_mm=0.2", "stop.iterations=1", "evaluate.refine=1"]
        for light in ("light[0]", "light[1]"):
            coarse += [f"{light}.angles=20", f"{light}.pixels=[32, 6]"]
            coarse += [f"{light}.projector.collimated.pixel_pitch_mm=0.2"]
        job = tomolith.Job(EXAMPLES / "20-two-colors.toml", set=coarse).resolve()
        task = job.task()
        print = task.evaluate(task.start)
        self.assertEqual(list(print["species"]), ["acrylate", "epoxy"])
        self.assertEqual(print["species"]["acrylate"]["iou"], print["iou"])
        self.assertEqual(print["one_exposure"]["species"], ["acrylate", "epoxy"])

    def test_a_sweep_tells_what_it_came_to(self):
        (self.folder / "sweep.toml").write_text(
            'job = "gear.toml"\nmetrics = ["evaluation.iou"]\n[[axes]]\nkey = "stop.iterations"\nvalues = [0, 3]\n'
        )
        (self.folder / "gear.toml").write_text(
            "grid.pitch_mm = 0.3\ntarget = { phantom = 'gear', size_mm = 3.0 }\n"
            "resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }\n"
            "vial = { index_matched = { radius_mm = 3.0 } }\n"
            "[[light]]\npixels = [16, 12]\nangles = 16\nprojector.collimated = { pixel_pitch_mm = 0.3 }\n"
        )
        outcome = tomolith.sweep(self.folder / "sweep.toml", folder=self.folder / "swept")
        self.assertEqual((outcome["runs"], outcome["done"], outcome["failed"]), (2, 2, 0))

    def test_what_a_callable_raises_and_an_interrupt_end_the_run(self):
        def stop(event):
            raise ZeroDivisionError

        with self.assertRaises(ZeroDivisionError):
            tomolith.Job(GEAR, folder=self.folder / "raised").run(progress=stop)
        # Programs that were started in the background ignore interrupts
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        long = tomolith.Job(GEAR, set=["stop.iterations=1000000"], folder=self.folder / "long")
        threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            long.run()


if __name__ == "__main__":
    unittest.main()
