"""Volumes of a run open in the readers that other programs have. `cargo test` runs it (package.rs)."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import tomolith
from test_task import GEAR, needs

PITCH_MM = 0.2


class Volumes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        changes = ['output.volumes=["nrrd","tiff","ome-zarr"]', 'output.movie="none"', "stop.iterations=1"]
        cls.run_ = tomolith.Job(GEAR, set=changes, folder=cls.folder / "run").run()
        cls.arrays = {"dose": cls.run_.dose, "target": cls.run_.target, "label": cls.run_.labels}

    def each(self, ending):
        for name, array in self.arrays.items():
            with self.subTest(name):
                yield self.run_.folder / "volumes" / f"{name}.{ending}", array

    def corner(self):
        """The first voxel's center, z, y and x, mm."""
        return [axis[0] for axis in self.run_.coordinates_mm]

    @needs("nrrd")
    def test_pynrrd_reads_values_and_places(self):
        import nrrd

        for path, array in self.each("nrrd"):
            values, header = nrrd.read(str(path), index_order="C")
            np.testing.assert_array_equal(values, array)
            self.assertEqual(values.dtype, array.dtype)
            np.testing.assert_allclose(header["space origin"][::-1], self.corner())
            np.testing.assert_allclose(header["space directions"], PITCH_MM * np.eye(3))
            self.assertEqual((header["space"], list(header["space units"])), ("left-posterior-superior", ["mm"] * 3))

    @needs("nrrd")
    def test_what_pynrrd_writes_is_read(self):
        import nrrd

        rows = {}
        for encoding in ("raw", "gzip"):
            files = [self.folder / f"{name}-{encoding}.nrrd" for name in ("dose", "target")]
            for file, array in zip(files, (self.run_.dose.astype(float), self.run_.target)):
                nrrd.write(str(file), array, {"encoding": encoding}, index_order="C")
            rows[encoding] = self.command("metrics", *files, "--pitch-mm", PITCH_MM)
        folder = self.run_.folder / "volumes"
        for ending in ("nrrd", "tif"):
            files = [folder / f"{name}.{ending}" for name in ("dose", "target")]
            rows[ending] = self.command("metrics", *files, "--pitch-mm", PITCH_MM)
        self.assertEqual(len(set(rows.values())), 1, rows)

    def command(self, *words):
        call = [sys.executable, "-m", "tomolith", *map(str, words)]
        done = subprocess.run(call, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    @needs("tifffile")
    def test_tifffile_reads_pages_and_lengths(self):
        import tifffile

        z, y, x = self.corner()
        for path, array in self.each("tif"):
            with tifffile.TiffFile(path) as file:
                self.assertTrue(file.is_imagej)
                self.assertEqual(len(file.pages), len(array))
                # Rows from +y down
                np.testing.assert_array_equal(file.asarray()[:, ::-1], array)
                np.testing.assert_array_equal(file.pages[3].asarray()[::-1], array[3])
                self.assertEqual(file.asarray().dtype, array.dtype)
                lengths = file.imagej_metadata
                self.assertEqual((lengths["unit"], lengths["slices"]), ("mm", len(array)))
                self.assertAlmostEqual(lengths["spacing"], PITCH_MM)
                self.assertAlmostEqual(lengths["xorigin"], -x / PITCH_MM)
                self.assertAlmostEqual(lengths["zorigin"], -z / PITCH_MM)
                pixels, mm = file.pages[0].tags["XResolution"].value
                self.assertAlmostEqual(mm / pixels, PITCH_MM)

    @needs("zarr")
    def test_zarr_reads_values(self):
        import zarr

        for path, array in self.each("ome.zarr"):
            values = zarr.open_group(path, mode="r")["0"]
            np.testing.assert_array_equal(values[:], array)
            self.assertEqual(values.dtype, array.dtype)
            self.assertEqual(values.metadata.dimension_names, ("z", "y", "x"))

    @needs("ome_zarr")
    def test_ome_zarr_reads_levels_and_places(self):
        from ome_zarr.io import parse_url
        from ome_zarr.reader import Reader

        sampling = ["--pitch-mm", "0.05", "--shape", "150", "140", "37", "--clip", "--quiet", "--output"]
        for file in ("gear.ome.zarr", "gear.npy"):
            self.command("phantom", "gear", *sampling, self.folder / file)
        whole = np.load(self.folder / "gear.npy")
        (node,) = Reader(parse_url(self.folder / "gear.ome.zarr"))()
        levels = [np.asarray(level) for level in node.data]
        np.testing.assert_array_equal(levels[0], whole)
        self.assertEqual([level.shape for level in levels], [(37, 140, 150), (19, 70, 75), (10, 35, 38)])
        means = whole[:36].reshape(18, 2, 70, 2, 75, 2).mean(axis=(1, 3, 5))
        np.testing.assert_allclose(levels[1][:18], means, rtol=1e-6)
        self.assertEqual([axis["unit"] for axis in node.metadata["axes"]], ["millimeter"] * 3)
        for factor, transforms in zip((1, 2, 4), node.metadata["coordinateTransformations"]):
            np.testing.assert_allclose(transforms[0]["scale"], [0.05 * factor] * 3)
            # The middle of a voxel that covers others is the mean of theirs
            first = [0.05 * (1 - n) / 2 + 0.05 * (factor - 1) / 2 for n in whole.shape]
            np.testing.assert_allclose(transforms[1]["translation"], first)


class Names(unittest.TestCase):
    def test_formats_that_are_none_are_refused(self):
        with self.assertRaisesRegex(tomolith.TomolithError, "nrrd.*tiff.*ome-zarr"):
            tomolith.Job(GEAR, set=['output.volumes=["nifti"]'])
