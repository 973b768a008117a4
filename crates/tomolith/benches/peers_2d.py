"""512² voxels, 512 columns, 360 angles, one slice: ASTRA's CPU kernels, a stored sparse matrix in SciPy and in Tomolith, and
Tomolith's own kernels, one after the other in one run.

    cargo bench -p tomolith --bench models --no-run      # prints the path of the program to time
    python peers_2d.py PROGRAM                           # wants astra-toolbox, scipy, numpy

Best of three calls. An update is one voxel and one frame; dose is the printer's direction (back-projection), adjoint its
transpose. SciPy's products are timed on one thread, and on two that take half of the rows each (its kernels release the lock).
"""

import os
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

import astra
import numpy as np
import scipy
import scipy.sparse as sp

N, ANGLES = 512, 360
UPDATES = N * N * ANGLES


def best(call):
    call()
    seconds = []
    for _ in range(3):
        begin = time.perf_counter()
        call()
        seconds.append(time.perf_counter() - begin)
    return min(seconds)


def row(name, threads, dose, adjoint):
    speed = [UPDATES / s / 1e9 for s in (dose, adjoint)]
    print(f"| {name} | {threads} | {dose:.3f} | {speed[0]:.2f} | {adjoint:.3f} | {speed[1]:.2f} |", flush=True)


def halves(matrix):
    """Both halves of the rows, with about as many entries each."""
    middle = int(np.searchsorted(matrix.indptr, matrix.nnz // 2))
    return matrix[:middle], matrix[middle:]


def product(pool, parts, x):
    return np.concatenate(list(pool.map(lambda part: part @ x, parts)))


def kernels(volume, image):
    detector = astra.create_proj_geom("parallel", 1.0, N, np.arange(ANGLES) * 2 * np.pi / ANGLES)
    for kind in ("line", "linear", "strip"):
        projector = astra.create_projector(kind, detector, volume)
        data, sino = astra.data2d.create("-vol", volume, image), astra.data2d.create("-sino", detector)
        back = astra.data2d.create("-vol", volume)
        runs = []
        for name, target in (("FP", ("VolumeDataId", data)), ("BP", ("ReconstructionDataId", back))):
            config = astra.astra_dict(name)
            config.update(ProjectorId=projector, ProjectionDataId=sino)
            config[target[0]] = target[1]
            runs.append(astra.algorithm.create(config))
        adjoint, dose = (best(lambda run=run: astra.algorithm.run(run)) for run in runs)
        row(f"ASTRA {astra.__version__} CPU, `{kind}`", 1, dose, adjoint)
        if kind == "linear":
            linear = astra.matrix.get(astra.projector.matrix(projector))
    return linear


def main():
    volume = astra.create_vol_geom(N, N)
    y, x = np.mgrid[0:N, 0:N] - (N - 1) / 2
    image = (np.hypot(x, y) < 0.48 * N).astype(np.float32)
    linear = kernels(volume, image).astype(np.float32).tocsr()
    transposed = linear.T.tocsr()  # rows are voxels
    sino = linear @ image.ravel()
    name = f"SciPy {scipy.__version__}, CSR of `linear` ({linear.nnz / 1e6:.0f}·10⁶ entries)"
    row(name + ", rows of A and of Aᵀ", 1, best(lambda: transposed @ sino), best(lambda: linear @ image.ravel()))
    with ThreadPoolExecutor(2) as pool:
        a, b = halves(transposed), halves(linear)
        row(name + ", halves of the rows", 2, best(lambda: product(pool, a, sino)), best(lambda: product(pool, b, image.ravel())))
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "linear.npz")
        sp.save_npz(file, transposed, compressed=False)
        del linear, transposed, a, b
        astra.clear()
        for arguments in (["matrix", file], ["plane"]):
            subprocess.run([sys.argv[1], *arguments], check=True)


main()
