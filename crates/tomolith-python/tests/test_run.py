"""Runs from Python are those of the library: their files, events, copies, ends. `cargo test` runs it (package.rs)."""

import json
import os
import pickle
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import unittest
from pathlib import Path
from unittest import mock

import numpy as np
import tomolith
from test_task import EXAMPLES, GEAR, needs


class Jobs(unittest.TestCase):
    def test_jobs_that_cannot_be_used_are_refused(self):
        for call, words in [
            (lambda: tomolith.Job(GEAR, set=["stop.iteratons=3"]), "did you mean `iterations`?"),
            (lambda: tomolith.Job("nowhere.toml"), "nowhere.toml: "),
            (lambda: tomolith.Job({**GEAR, "grid": {"pitch_mm": float("nan")}}), "grid.pitch_mm: found NaN; accepted: a finite number"),
            (lambda: tomolith.Job(GEAR, set={"grid.pitch_mm": float("inf")}), "grid.pitch_mm=inf: found inf; accepted: a finite number"),
            (lambda: tomolith.Job({**GEAR, "grid": {"pitch_mm": object()}}), "found a value of"),
            (lambda: tomolith.sweep("nowhere.toml", threads=0), "1 to 256"),
            (lambda: tomolith.sweep("nowhere.toml"), "nowhere.toml: "),
            (lambda: tomolith.Run.open("nowhere"), "the folder is missing"),
        ]:
            with self.subTest(words):
                with self.assertRaises(tomolith.TomolithError) as raised:
                    call()
                self.assertIn(words, str(raised.exception))
        with self.assertRaisesRegex(TypeError, "cancel: found <class 'int'>; accepted: a threading.Event"):
            tomolith.Job(GEAR).run(cancel=3)

    def test_errors_give_their_parts(self):
        def error_of(call):
            with self.assertRaises(tomolith.TomolithError) as raised:
                call()
            error = raised.exception
            return error, (error.key, error.found, error.accepted, error.file, error.line)

        resin = {**GEAR["resin"], "refractive_index": -1}
        error, (key, found, accepted, *place) = error_of(lambda: tomolith.Job({**GEAR, "resin": resin}))
        self.assertEqual((key, found, place, error.errors), ("resin.refractive_index", "-1", [None, None], []))
        # No file holds a dict, so no line is named
        self.assertEqual(str(error), f"resin.refractive_index: found -1; accepted: {accepted}")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "gear.json"
            file.write_text(json.dumps({**GEAR, "resin": resin}, indent=1))
            error, (*_, named, line) = error_of(lambda: tomolith.Job(file))
            self.assertEqual(named, file)
            self.assertIn('"refractive_index": -1', file.read_text().splitlines()[line - 1])
            self.assertIn(f"({file}, line {line})", str(error))
            # A copy in another process has no lines of its own
            job = pickle.loads(pickle.dumps(tomolith.Job(file, set=["resin.refractive_index=1.5", "vial.index_matched.radius_mm=0.1"])))
            self.assertIsNone(error_of(job.check)[0].line)
        error, parts = error_of(lambda: tomolith.Job({**GEAR, "resin": {**resin, "absorbtion": 1.0}}))
        self.assertEqual({e.key for e in error.errors}, {"resin.refractive_index", "resin.absorbtion"})
        first = error.errors[0]
        self.assertEqual(parts, (first.key, first.found, first.accepted, None, None))
        self.assertEqual(str(error), "\n".join(map(str, error.errors)))
        copy = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(copy), copy.key, len(copy.errors)), (str(error), first.key, 2))
        error, (key, *_, named, line) = error_of(lambda: tomolith.Job("nowhere.toml"))
        self.assertEqual((key, named, line), (None, Path("nowhere.toml"), None))
        error, parts = error_of(lambda: tomolith.sweep("nowhere.toml", threads=0))
        self.assertEqual(parts, ("threads", "0", "1 to 256", None, None))

    def test_a_target_may_be_an_array(self):
        inside = np.zeros((8, 10, 12), bool)
        inside[2:, 3:, 4:] = True
        lengths = {"size_mm": 2.4, "height_mm": 1.6}
        of_array = tomolith.Job({**GEAR, "target": {"stack": inside, **lengths}})
        with tempfile.TemporaryDirectory() as folder:
            np.save(Path(folder) / "inside.npy", inside)
            of_file = tomolith.Job({**GEAR, "target": {"stack": Path(folder) / "inside.npy", **lengths}})
            task = of_file.resolve().task()
        target, (across, along) = task.target, task.voxel_mm
        np.testing.assert_array_equal(of_array.resolve().task().target, target)
        self.assertAlmostEqual(target.sum() * across**2 * along / (inside.sum() * 0.2**3), 1, delta=0.05)
        low, high = target[:, :, : target.shape[2] // 3].sum(), target[:, :, -target.shape[2] // 3 :].sum()
        self.assertLess(low, 0.5 * high)
        pickled, file = pickle.dumps(of_array), Path(of_array.tables["target"]["stack"])
        self.assertTrue(file.is_file())
        same = pickle.loads(pickled)
        del of_array
        # Another job holds it
        self.assertTrue(file.is_file())
        np.testing.assert_array_equal(same.resolve().task().target, target)
        del same
        self.assertFalse(file.exists() or file.parent.exists())
        np.testing.assert_array_equal(pickle.loads(pickled).resolve().task().target, target)
        # The same array is the same job, another one is not
        with tempfile.TemporaryDirectory() as folder:
            job = lambda stack: tomolith.Job({**GEAR, "target": {"stack": stack, **lengths}}, folder=folder)
            self.assertGreater(job(inside).run().metrics["iou"], 0.5)
            job(inside.copy()).run(resume=True)
            job(inside).run()
            with self.assertRaisesRegex(tomolith.TomolithError, "finished run of another job: target.stack"):
                job(~inside).run()
        for stack, words in [
            (np.ma.masked_array(inside, inside), "target.stack: found a masked array"),
            (inside[0], "target.stack: found an array of shape [10, 12] and type bool; accepted: an array [z, y, x]"),
            (inside.astype(complex), "type complex128"),
            (2.0 * inside, "a value of 2"),
        ]:
            with self.subTest(words), self.assertRaises(tomolith.TomolithError) as raised:
                tomolith.Job({**GEAR, "target": {"stack": stack, **lengths}}).resolve()
            self.assertIn(words, str(raised.exception))
        with self.assertRaises(tomolith.TomolithError) as raised:
            tomolith.Job({**GEAR, "target": {"stack": inside}}).resolve()
        self.assertEqual([error.key for error in raised.exception.errors], ["target.size_mm", "target.height_mm"])

    def test_tables_may_hold_numbers_of_numpy_and_paths(self):
        light = {**GEAR["light"][0], "pixels": np.array([24, 16]), "angles": np.int64(36)}
        same = tomolith.Job({**GEAR, "light": [light], "output": {"folder": Path("out/x")}})
        self.assertEqual(same.tables["light"], tomolith.Job(GEAR).tables["light"])

    def test_changes_are_a_dict_or_a_list(self):
        changes = {"light[0].angles": np.int64(40), "grid.pitch_mm": 0.2, "target": {"phantom": {"sphere": {"size_mm": 2.0}}}, "output.volumes": ["nrrd", "tiff"]}
        listed = ["light[0].angles=40", "grid.pitch_mm=0.2", "target={phantom={sphere={size_mm=2.0}}}", 'output.volumes=["nrrd", "tiff"]']
        self.assertEqual(tomolith.Job(GEAR, set=changes).tables, tomolith.Job(GEAR, set=listed).tables)
        for refused, words in [({"stop.iteratons": 3}, "did you mean `iterations`?"), ({"stop.iterations": None}, "stop.iterations=null")]:
            with self.subTest(refused), self.assertRaises(tomolith.TomolithError) as raised:
                tomolith.Job(GEAR, set=refused)
            self.assertIn(words, str(raised.exception))
        with self.assertRaisesRegex(TypeError, "a list of texts"):
            tomolith.Job(GEAR, set="stop.iterations=3")

    def test_a_pickled_job_is_the_same_from_any_folder(self):
        job = tomolith.Job(EXAMPLES / "01-gear.toml", set=["stop.iterations=7"])
        of_tables = tomolith.Job(GEAR, folder="somewhere")
        pickles, before = [pickle.dumps(j) for j in (job, of_tables)], os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            try:
                os.chdir(folder)
                copies = [pickle.loads(p) for p in pickles]
                tables = [copy.tables for copy in copies]
            finally:
                os.chdir(before)
        self.assertEqual(tables, [job.tables, of_tables.tables])
        self.assertEqual([copy.name for copy in copies], [job.name, of_tables.name])


class Runs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def long(self):
        return tomolith.Job(GEAR, set=["stop.iterations=1000000", "stop.change=0"], folder=self.folder / "long")

    def test_a_run_is_that_of_the_library(self):
        job = tomolith.Job(GEAR, folder=self.folder / "run")
        self.assertEqual(job.tables["stop"]["iterations"], 10)
        self.assertGreater(job.check()["memory_mb"], 0)
        events = []
        run = job.run(progress=events.append)
        iterations = [event["iteration"] for event in events if event["event"] == "iteration"]
        self.assertEqual(iterations[-1], run.summary["iterations"])
        self.assertEqual(run.metrics["iou"], run.summary["evaluation"]["iou"])
        simulated = tomolith.Job(GEAR, folder=self.folder / "simulated").simulate(run)
        self.assertEqual(simulated.metrics, run.metrics)
        evaluated = job.resolve().evaluate(run.patterns)
        for name in ("iou", "ver", "pw", "surface_mean_mm"):
            self.assertEqual(evaluated[name], run.metrics[name])
        library = tomolith.Run.open(os.environ["TOMOLITH_LIBRARY_RUN"])
        self.assertEqual(library.metrics, run.metrics)
        self.assertIsNone(library.summary)
        for name in ("patterns", "patterns_raw", "dose", "target", "labels"):
            np.testing.assert_array_equal(getattr(run, name), getattr(library, name))
        with self.assertRaisesRegex(tomolith.TomolithError, "another folder .folder=DIR., or overwrite=True to replace that run"):
            tomolith.Job(GEAR, set=["stop.iterations=2"], folder=self.folder / "run").run()
        job.run()
        self.assertEqual(run.patterns_raw.shape, run.patterns.shape)  # the same job, the same numbers
        tomolith.Job(GEAR, set=["stop.iterations=2"], folder=self.folder / "run").run(overwrite=True)
        self.assertIn("run", repr(run))
        with self.assertRaisesRegex(tomolith.TomolithError, "another run"):
            run.history

    def test_a_folder_reads_as_arrays(self):
        run = tomolith.Run.open(os.environ["TOMOLITH_LIBRARY_RUN"])
        resolved = tomolith.Job(GEAR).resolve()
        task = resolved.task()
        self.assertEqual((run.patterns.shape, run.dose.shape), (task.start.shape, resolved.shape))
        z, y, x = run.coordinates_mm
        self.assertAlmostEqual(x[1] - x[0], 0.2)
        self.assertAlmostEqual(x[0], -x[-1])
        # The task leaves out slices above and below the part, and has finer voxels
        inside = run.target.max(axis=(1, 2)) > 0
        (nz, ny, nx), (_, fine, _) = run.target[inside].shape, task.shape
        means = task.target.reshape(nz, ny, fine // ny, nx, fine // nx).mean(axis=(2, 4))
        np.testing.assert_allclose(run.target[inside], means, atol=0.06)
        np.testing.assert_array_equal(run.labels == 2, run.target >= 0.5)
        np.testing.assert_allclose(z[inside][0] - 0.1, task.box_mm[0][2], atol=1e-9)
        # The numbers are of voxels twice as fine, which see more of the edges
        union, common = (run.print | (run.target >= 0.5)).sum(), (run.print & (run.target >= 0.5)).sum()
        self.assertGreater(common / union, 0.94)
        self.assertAlmostEqual(common / union, run.metrics["iou"], delta=0.11)
        self.assertTrue((np.diff(run.history["iteration"]) > 0).all())
        self.assertLess(run.history["loss"][-1], run.history["loss"][0])
        html = run._repr_html_()
        self.assertIn(f"iou {run.metrics['iou']:.4g}", html)
        self.assertIn("data:image/png;base64,iVBORw0KGgo", html)
        # The page itself, in a frame
        page = run.page(height=500)
        self.assertEqual(page.html, (run.folder / "report.html").read_text("utf-8"))
        frame = page._repr_html_()
        self.assertTrue(frame.startswith('<iframe sandbox="allow-scripts" style="width: 100%; height: 500px'))
        self.assertEqual(frame.count("<"), 2)  # what it holds is text of an attribute
        with mock.patch.dict(sys.modules, {"xarray": None}):
            with self.assertRaisesRegex(tomolith.TomolithError, "pip install xarray"):
                run.to_xarray()

    def test_what_is_solid_is_so_at_the_threshold_of_the_job_and_nothing_is_of_gray_targets(self):
        run = tomolith.Job(GEAR, set={"evaluate.threshold": 0.6}, folder=self.folder / "early").run()
        self.assertGreater(run.report["exposure"]["reported_percent"], 110)
        off = run.print != (run.dose >= 0.6)
        self.assertLess(np.abs(run.dose[off] - 0.6).max(initial=0), 1e-5)
        image = {"image": EXAMPLES / "images/rings.png", "size_mm": 2.0, "height_mm": 0.6}
        gray = tomolith.Job({**GEAR, "target": image}, folder=self.folder / "gray").run()
        with self.assertRaisesRegex(tomolith.TomolithError, "no threshold in the report"):
            gray.print

    @needs("xarray")
    def test_a_folder_reads_as_xarray(self):
        run = tomolith.Run.open(os.environ["TOMOLITH_LIBRARY_RUN"])
        data = run.to_xarray()
        self.assertEqual(data.dose.dims, ("z", "y", "x"))
        self.assertEqual(data.z.attrs, {"units": "mm"})
        middle = data.dose.sel(x=0, y=0, z=0, method="nearest")
        self.assertEqual(middle, run.dose[tuple(np.abs(c).argmin() for c in run.coordinates_mm)])
        self.assertEqual(data["print"].dtype, bool)

    def test_a_damaged_folder_is_refused(self):
        damaged = self.folder / "damaged"
        shutil.copytree(os.environ["TOMOLITH_LIBRARY_RUN"], damaged)
        for name, content in [("dose.npy", b""), ("dose.vti", b"<VTK"), ("patterns.npz", b"PK"), ("history.csv", b"a\nb\n")]:
            (damaged / name).write_bytes(content)
        run = tomolith.Run.open(damaged)
        for name, file in [("dose", "dose.npy"), ("target", "dose.vti"), ("patterns", "patterns.npz"), ("history", "history.csv")]:
            with self.subTest(name), self.assertRaisesRegex(tomolith.TomolithError, f"{file}: .*; accepted: "):
                getattr(run, name)
        self.assertIn("iou", run._repr_html_())
        shutil.rmtree(damaged)
        with self.assertRaisesRegex(tomolith.TomolithError, "dose.npy: the folder is missing"):
            run.dose
        damaged.mkdir()
        (damaged / "report.json").write_text("[1, 2")
        with self.assertRaisesRegex(tomolith.TomolithError, "report.json: "):
            tomolith.Run.open(damaged)

    def test_a_card_computes_where_the_job_names_one(self):
        listed = subprocess.run([sys.executable, "-m", "tomolith", "devices", "--json"], capture_output=True, check=True)
        cards = [card["name"] for card in json.loads(listed.stdout)["devices"]]
        if not cards and "TOMOLITH_NEEDS_GPU" not in os.environ:
            self.skipTest("no graphics card")
        runs = [
            tomolith.Job(GEAR, set=["stop.iterations=2", f"resources.device={json.dumps(device)}"], folder=self.folder / device[:3]).run()
            for device in ("cpu", f"gpu:{cards[0]}")
        ]
        self.assertIn(f"on {cards[0]}", (runs[1].folder / "job.toml").read_text("utf-8"))
        np.testing.assert_allclose(runs[1].dose, runs[0].dose, atol=0.01)

    def test_the_print_in_time_is_that_of_the_same_material(self):
        job = tomolith.Job(
            EXAMPLES / "19-print-in-time.toml",
            set=["grid.pitch_mm=0.2", "stop.iterations=3"],
            folder=self.folder / "time",
        )
        run = job.run()
        evaluated = job.resolve().evaluate(run.patterns)
        self.assertGreater(run.summary["in_time"][0]["best_jaccard"], 0.5)
        self.assertEqual(evaluated["in_time"], run.summary["in_time"])

    def test_a_sweep_runs_its_jobs(self):
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

    def test_an_observer_gets_the_copies_that_it_wants(self):
        class Watcher:
            wants = ["patterns", "dose"]
            iterations, copies = [], []

            def event(self, event):
                if event["event"] == "iteration":
                    self.iterations.append(event["iteration"])
                    self.wants = ["print"] if event["iteration"] > 4 else ["patterns", "dose"]

            def snapshot(self, snapshot):
                self.copies.append(snapshot)

        watcher = Watcher()
        run = tomolith.Job(GEAR, folder=self.folder / "watched").run(progress=watcher)
        self.assertEqual([copy["iteration"] for copy in watcher.copies], [*watcher.iterations, None])
        task = tomolith.Job(GEAR).resolve().task()
        early, late = watcher.copies[2], watcher.copies[6]
        self.assertEqual((set(early), set(late)), ({"iteration", "patterns", "dose"}, {"iteration", "print"}))
        np.testing.assert_allclose(early["dose"], task.dose(early["patterns"]), rtol=1e-4, atol=1e-4)
        self.assertEqual(late["print"].shape, task.shape)
        # Who watches changes nothing
        plain = tomolith.Run.open(os.environ["TOMOLITH_LIBRARY_RUN"])
        np.testing.assert_array_equal(run.patterns, plain.patterns)

    def test_what_an_observer_raises_ends_the_run(self):
        def stop(event):
            raise ZeroDivisionError

        class Greedy:
            wants = ["everything"]

            def event(self, event):
                pass

        with self.assertRaises(ZeroDivisionError):
            tomolith.Job(GEAR, folder=self.folder / "raised").run(progress=stop)
        with self.assertRaises(TypeError):
            tomolith.Job(GEAR, folder=self.folder / "no-callable").run(progress=3)
        with self.assertRaisesRegex(tomolith.TomolithError, "wants: found `everything`"):
            tomolith.Job(GEAR, folder=self.folder / "greedy").run(progress=Greedy())

    def test_a_canceled_run_is_resumed(self):
        cancel = threading.Event()

        def stop_at_three(event):
            if event.get("iteration") == 3:
                cancel.set()

        with self.assertRaisesRegex(tomolith.Canceled, "resume=True"):
            self.long().run(progress=stop_at_three, cancel=cancel)
        cancel.clear()
        iterations = []

        def stop_at_once(event):
            if event["event"] == "iteration":
                iterations.append(event["iteration"])
                cancel.set()

        with self.assertRaises(tomolith.Canceled):
            self.long().run(resume=True, progress=stop_at_once, cancel=cancel)
        # On from the last whole checkpoint: that of the iteration at hand where there was time to write it, else the one before
        self.assertGreaterEqual(iterations[0], 3)

    def test_what_has_no_checkpoint_is_not_to_be_resumed(self):
        cancel = threading.Event()
        cancel.set()
        with self.assertRaises(tomolith.Canceled) as raised:
            self.long().run(cancel=cancel)
        self.assertEqual(str(raised.exception), "canceled")

    def test_an_interrupt_ends_a_run(self):
        # Programs that were started in the background ignore interrupts
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            self.long().run()

    def test_a_daemon_thread_ends_with_python(self):
        job = f"tomolith.Job({GEAR!r}, set=['stop.iterations=1000000', 'stop.change=0'], folder={str(self.folder / 'daemon')!r})"
        script = f"import threading, time, tomolith\nthreading.Thread(target={job}.run, daemon=True).start()\ntime.sleep(0.5)"
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_a_second_run_of_one_folder_is_refused(self):
        cancel, refused = threading.Event(), []

        def second(event):
            if event.get("iteration") == 1:
                try:
                    self.long().run()
                except tomolith.TomolithError as error:
                    refused.append(str(error))
                cancel.set()

        with self.assertRaises(tomolith.Canceled):
            self.long().run(progress=second, cancel=cancel)
        self.assertEqual(len(refused), 1)
        self.assertIn("long", refused[0])
