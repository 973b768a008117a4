"""Models and losses in Python are those of the library, and their derivatives are derivatives. `cargo test` runs it (package.rs)."""

import importlib.util
import json
import os
import sys
import threading
import unittest
from pathlib import Path
from unittest import mock

import numpy as np
import tomolith

HERE = Path(__file__).parent
GEAR = json.loads((HERE / "gear.json").read_text())
EXAMPLES = Path(__file__).parents[3] / "examples"


def needs(module):
    return unittest.skipUnless(importlib.util.find_spec(module), f"{module} is not installed")


def two_colors():
    coarse = ["grid.pitch_mm=0.2", "stop.iterations=1", "evaluate.refine=1"]
    for light in ("light[0]", "light[1]"):
        coarse += [f"{light}.angles=20", f"{light}.pixels=[32, 6]"]
        coarse += [f"{light}.projector.collimated.pixel_pitch_mm=0.2"]
    return tomolith.Job(EXAMPLES / "20-two-colors.toml", set=coarse).resolve()


class Tasks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.job = tomolith.Job(GEAR).resolve()
        cls.task = cls.job.task()
        random = np.random.default_rng(1)
        cls.patterns = random.random(cls.task.start.shape)
        cls.cotangent = random.random(cls.task.shape)

    def test_patterns_are_images_and_doses_volumes(self):
        start, dose = self.task.start, self.task.dose(self.task.start)
        self.assertEqual((start.shape, start.dtype), ((36, 16, 24), np.float32))
        self.assertEqual((dose.shape, dose.dtype), (self.task.shape, np.float32))
        self.assertEqual((self.task.quantity, self.task.is_linear, self.task.outputs), ("energy", True, ["dose"]))
        part, void = (dose[self.task.labels == label].mean() for label in (2, 1))
        self.assertGreater(part, 1.5 * void)
        # The gear is flat: rows above and below it light nothing
        lit, (lower, upper) = self.task.lit, self.task.bounds
        self.assertTrue(lit.any() and not lit.all())
        self.assertFalse(start[~lit].any() or upper[~lit].any() or lower.any())
        self.assertTrue((upper[lit] > 0).all())
        only_dark = np.where(lit, 0.0, 5.0)
        self.assertFalse(self.task.dose(only_dark).any())
        self.assertFalse(self.task.value_and_gradient(start)[1][~lit].any())

    def test_layouts_of_any_array_are_the_same(self):
        dose = self.task.dose(self.task.start)
        wide = np.zeros((36, 32, 24), np.float32)
        wide[:, ::2] = self.task.start
        for same in (
            [self.task.start],
            wide[:, ::2],
            np.asfortranarray(self.task.start),
            self.task.start.astype(">f4"),
            self.task.start.tolist(),
        ):
            np.testing.assert_array_equal(self.task.dose(same), dose)

    def test_the_pullback_is_the_transpose_of_the_dose(self):
        left = np.vdot(self.task.dose(self.patterns).astype(float), self.cotangent)
        right = np.vdot(self.patterns, self.task.pullback(self.patterns, self.cotangent).astype(float))
        self.assertLess(abs(left / right - 1), 1e-5)

    def test_the_pullback_of_cut_voxels_and_of_several_species_is_the_transpose(self):
        cut = tomolith.Job({**GEAR, "objective": {"bclp": {"surface": "cells"}}}).resolve()
        for task in (two_colors().task(), cut.task()):
            random = np.random.default_rng(3)
            lights = task.start if isinstance(task.start, list) else [task.start]
            patterns = [random.random(light.shape) for light in lights]
            cotangent = [random.random(task.shape) for _ in task.outputs]
            if len(lights) == 1:
                patterns, cotangent = patterns[0], cotangent[0]
            inner = lambda a, b: sum(np.vdot(x.astype(float), y.astype(float)) for x, y in zip(a, b))
            left = inner(task.dose(patterns), cotangent)
            right = inner(patterns, task.pullback(patterns, cotangent))
            self.assertLess(abs(left / right - 1), 1e-5)

    def test_the_gradient_is_that_of_the_value(self):
        start = self.task.start.astype(float)
        step = np.random.default_rng(2).uniform(-1, 1, start.shape) * 1e-3 * start.max()
        ahead, behind = (self.task.value_and_gradient(start + s * step)[0] for s in (1, -1))
        slope = np.vdot(self.task.value_and_gradient(start)[1].astype(float), step)
        self.assertLess(abs((ahead - behind) / 2 - slope), 0.01 * abs(slope))

    def test_a_loop_prints_better_than_the_start(self):
        x = self.task.start
        lower, upper = self.task.bounds
        losses = []
        for _ in range(10):
            loss, gradient = self.task.value_and_gradient(x)
            losses.append(loss)
            x = np.clip(x - 0.1 * x.max() / abs(gradient).max() * gradient, lower, upper)
        self.assertLess(losses[-1], losses[0])
        begin, end = self.task.evaluate(self.task.start), self.task.evaluate(x)
        self.assertGreater(end["iou"], begin["iou"])
        self.assertEqual(begin, self.job.evaluate(self.task.start))

    @needs("scipy")
    def test_scipy_gets_the_model(self):
        operator = self.task.operator()
        self.assertEqual(operator.shape, (self.cotangent.size, self.patterns.size))
        np.testing.assert_array_equal(operator @ self.patterns.ravel(), self.task.dose(self.patterns).ravel())
        np.testing.assert_array_equal(
            operator.T @ self.cotangent.ravel(), self.task.pullback(self.patterns, self.cotangent).ravel()
        )
        colors = two_colors().task()
        x = np.concatenate([light.ravel() for light in colors.start])
        doses = np.concatenate([dose.ravel() for dose in colors.dose(colors.start)])
        np.testing.assert_array_equal(colors.operator() @ x, doses)

    @needs("jax")
    def test_jax_differentiates_the_dose(self):
        import jax
        import tomolith.jax

        dose = tomolith.jax.dose(self.task)
        loss = lambda patterns: (jax.numpy.asarray(self.cotangent, "float32") * dose(patterns) ** 2).sum()
        value, gradient = jax.jit(jax.value_and_grad(loss))(self.patterns)
        doses = self.task.dose(self.patterns)
        expected = self.task.pullback(self.patterns, 2 * self.cotangent * doses)
        self.assertLess(abs(value / (self.cotangent * doses.astype(float) ** 2).sum() - 1), 1e-4)
        np.testing.assert_allclose(gradient, expected, rtol=1e-4, atol=1e-4 * expected.max())
        colors = two_colors().task()
        gradient = jax.grad(lambda lights: sum(d.sum() for d in tomolith.jax.dose(colors)(lights)))(colors.start)
        expected = colors.pullback(colors.start, [np.ones(colors.shape)] * 2)
        for found, known in zip(gradient, expected):
            np.testing.assert_allclose(found, known, rtol=1e-4)

    @needs("torch")
    def test_torch_differentiates_the_dose(self):
        import tomolith.torch
        import torch

        patterns = torch.tensor(self.patterns, requires_grad=True)
        tomolith.torch.Dose(self.task)(patterns).square().sum().backward()
        expected = self.task.pullback(self.patterns, 2 * self.task.dose(self.patterns))
        np.testing.assert_allclose(patterns.grad, expected, rtol=1e-4, atol=1e-4 * expected.max())
        colors = two_colors().task()
        lights = [torch.tensor(light, requires_grad=True) for light in colors.start]
        sum(dose.sum() for dose in tomolith.torch.dose(colors, lights)).backward()
        expected = colors.pullback(colors.start, [np.ones(colors.shape)] * 2)
        for found, known in zip(lights, expected):
            np.testing.assert_allclose(found.grad, known, rtol=1e-4)
        # The second derivative of Σ (F x)² along v is 2·Fᵀ F v
        v = np.random.default_rng(1).normal(size=self.patterns.shape).astype("float32")
        square = lambda x: tomolith.torch.dose(self.task, x).square().sum()
        _, found = torch.autograd.functional.hvp(square, torch.tensor(self.patterns), torch.tensor(v))
        expected = self.task.pullback(self.patterns, 2 * self.task.dose(v))
        np.testing.assert_allclose(found, expected, rtol=1e-4, atol=1e-4 * abs(expected).max())

    def test_a_missing_library_is_named(self):
        with mock.patch.dict(sys.modules, {"scipy.sparse.linalg": None}):
            with self.assertRaisesRegex(tomolith.TomolithError, "pip install scipy"):
                self.task.operator()

    def test_arrays_that_do_not_fit_are_refused(self):
        image, cotangent = self.task.start, self.cotangent
        huge = np.full(image.shape, 3e38)
        masked = np.ma.masked_array(image, image > 0)
        wrong = image.copy()
        wrong[3, 2, 1] = np.nan
        for call, words in [
            (lambda: self.task.dose(np.zeros(3)), "patterns: found shape [3]; accepted: [36, 16, 24] [frame, row, column]"),
            (lambda: self.task.dose(image.ravel()), "accepted: [36, 16, 24] [frame, row, column]"),
            (lambda: self.task.pullback(image, image), "cotangent: found shape [36, 16, 24]; accepted: "),
            (lambda: self.job.evaluate(image[:2]), "accepted: [36, 16, 24] [frame, row, column]"),
            (lambda: self.job.evaluate([image, image]), "patterns: "),
            (lambda: two_colors().task().dose(image), "found 1 array(s); accepted: a list of 2"),
            (lambda: self.task.dose(wrong), "patterns: found NaN at [3, 2, 1] [frame, row, column]"),
            (lambda: self.job.evaluate(wrong), "found NaN at [3, 2, 1]"),
            (lambda: self.task.pullback(image, cotangent * np.inf), "cotangent: found inf at [0, 0, 0] [z, y, x]"),
            (lambda: self.task.dose(huge * 100), "patterns: found inf at [0, 0, 0]"),
            (lambda: self.task.dose("abc"), "accepted: numbers"),
            (lambda: self.task.dose(None), "found object"),
            (lambda: self.task.dose([[1, 2], [3]]), "accepted: numbers"),
            (lambda: self.task.dose(masked), "a masked array"),
            (lambda: self.task.dose(image.astype("M8[s]")), "found datetime64[s]"),
            (lambda: self.task.dose(image.astype(complex)), "found complex"),
            (lambda: self.task.dose(huge), "dose: found inf"),
            (lambda: self.task.value_and_gradient(huge), "loss: found "),
            (lambda: self.job.evaluate(huge), "a voxel became inf"),
            (lambda: self.task.evaluate(huge), "a voxel became inf"),
            (lambda: self.job.evaluate(image - 1), "patterns: found -1 at [0, 0, 0] [frame, row, column]"),
            (lambda: self.task.evaluate(image - 1), "accepted: finite values ≥ 0"),
        ]:
            with self.subTest(words):
                with self.assertRaises(tomolith.TomolithError) as raised, np.errstate(over="ignore"):
                    call()
                self.assertIn(words, str(raised.exception))

    def test_voxels_lie_where_the_job_has_them(self):
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

    def test_the_angles_of_a_frame_are_known(self):
        self.assertEqual(two_colors().task().sub_angles, [4, 4])
        of_angles = lambda count: tomolith.Job(GEAR, set=[f"light.sub_angles={count}", "grid.refine=1"]).resolve()
        turning, standing = of_angles(3).task(), of_angles(1).task()
        self.assertEqual((turning.sub_angles, standing.sub_angles), ([3], [1]))
        across, along = standing.voxel_mm
        self.assertAlmostEqual(across, GEAR["grid"]["pitch_mm"])
        self.assertAlmostEqual(along, GEAR["grid"]["pitch_mm"])
        self.assertFalse(np.array_equal(turning.dose(turning.start), standing.dose(turning.start)))

    def test_a_copy_cannot_be_taken_for_the_task(self):
        for array in (self.task.start, self.task.lit, *self.task.bounds, self.task.target, self.task.labels, *two_colors().task().start):
            with self.assertRaisesRegex(ValueError, "read-only"):
                array[0, 0, 0] = 1
        self.task.start.copy()[0, 0, 0] = 1

    def test_every_species_is_evaluated(self):
        task = two_colors().task()
        print = task.evaluate(task.start)
        self.assertEqual(list(print["species"]), ["acrylate", "epoxy"])
        self.assertEqual(print["species"]["acrylate"]["iou"], print["iou"])
        self.assertEqual(print["one_exposure"]["species"], ["acrylate", "epoxy"])

    def test_threads_may_share_a_task(self):
        alone, together = self.task.dose(self.patterns), [None] * 4

        def compute(i):
            together[i] = self.task.dose(self.patterns)

        threads = [threading.Thread(target=compute, args=(i,)) for i in range(4)]
        [thread.start() for thread in threads]
        [thread.join() for thread in threads]
        for dose in together:
            np.testing.assert_array_equal(dose, alone)

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
