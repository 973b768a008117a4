//! `[evaluate]` and `[output]`: how the written patterns are evaluated, and what is written.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::path::PathBuf;

/// How much finer than a job's voxels those of an evaluation are at least.
pub(crate) const LEAST_REFINE: usize = 2;

/// The most bits at which patterns are improved on their levels; with more, rounding costs next to nothing (docs/choices.md).
const MOST_BITS: u32 = 5;

tomolith_core::keys! {
    /// How the written patterns are evaluated: their dose is simulated again, turning and on a finer grid.
    pub struct EvaluateSpec {
        /// Bits to which patterns are quantized.
        #[schemars(range(min = 1, max = 16))]
        pub bit_depth: u32 = 8,
        /// What follows the optimization where a machine has 5 bits or fewer, or pixels that are turned, shifted or of another size than those of the light:
        /// "optimized" improves the patterns as the machine shows them, "rounded" leaves them.
        pub levels: Levelling = Levelling::Optimized,
        /// Angles at which the arc of a frame is averaged. When left out: 4, and where frames are few one for every pixel that the rim of the part moves, as
        /// far as a turn then has 720.
        #[schemars(range(min = 1, max = 64))]
        pub sub_angles: Option<usize>,
        /// How many times finer than the job's the voxels of the evaluation are; lowered, with a warning, where the memory budget is too small. When left out: as fine as the
        /// optimization's, up to 3·10⁷ voxels, and at least 2.
        #[schemars(range(min = 1, max = 32))]
        pub refine: Option<usize>,
        /// Dose at which the resin turns solid; the one with the best IoU when left out.
        #[schemars(range(min = 1e-6, max = 1e6))]
        pub threshold: Option<f64>,
        /// Percent of the voxels that trimmed metrics leave out at each end, in part and in void.
        #[schemars(range(min = 0.0, max = 49.9))]
        pub trim_percent: f64 = 0.025,
        /// Whether distances between the surfaces of print and target are measured. They take most of the time of a small evaluation, and a sweep that collects none
        /// leaves them out.
        pub surfaces: bool = true,
        /// IoU that the evaluation must reach: below it the command ends with exit code 1.
        #[schemars(range(min = 0.0, max = 1.0))]
        pub require_iou: Option<f64>,
        /// Gray targets: share of the voxels that must be in their bands; below it the command ends with exit code 1.
        #[schemars(range(min = 0.0, max = 1.0))]
        pub require_in_band: Option<f64>,
    }
}

/// How patterns come to few levels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Levelling {
    /// They are improved on them.
    #[default]
    #[serde(rename = "optimized")]
    Optimized,
    /// Each pixel takes the nearest.
    Rounded,
}

tomolith_core::keys! {
    /// What is written, and where.
    pub struct OutputSpec {
        /// The run folder, relative to the current folder; `out/` and the job's name when left out.
        pub folder: Option<PathBuf>,
        /// Turns of the vial per minute: gives the movie its frame rate.
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1000.0))]
        pub rpm: f64 = 10.0,
        /// The movie: "h264" (default; 8 bits, within a few levels, every player shows it), "lossless" (PNG frames in a
        /// QuickTime file, every level exact at any bit depth; also in place of "h264" where printer.channel is given) or "none".
        pub movie: MovieCoding = MovieCoding::default(),
        /// Whether `evaluation/` holds what the report's numbers are of: response, target and labels on the evaluation's voxels, for `tomolith metrics`. (`dose.npy` is
        /// the dose on the job's voxels.)
        pub evaluation: bool = false,
        /// Formats of `volumes/`, which holds doses, target, labels and properties on the job's voxels for other programs: "nrrd" (3D Slicer, ITK), "tiff" (ImageJ, Fiji),
        /// "ome-zarr" (napari, neuroglancer). `dose.npy` and `dose.vti` (ParaView) are written anyway.
        pub volumes: BTreeSet<VolumeFormat> = BTreeSet::new(),
    }
}

/// A format in which other programs open volumes.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize, JsonSchema,
)]
#[serde(rename_all = "kebab-case")]
pub enum VolumeFormat {
    /// NRRD.
    Nrrd,
    /// TIFF of several pages, with the lengths that ImageJ reads.
    Tiff,
    /// OME-Zarr 0.5.
    OmeZarr,
}

impl VolumeFormat {
    /// What the names of its files end in.
    pub(crate) fn ending(self) -> &'static str {
        match self {
            VolumeFormat::Nrrd => "nrrd",
            VolumeFormat::Tiff => "tif",
            VolumeFormat::OmeZarr => "ome.zarr",
        }
    }
}

/// How the movie's frames are coded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum MovieCoding {
    /// MP4 with H.264.
    #[default]
    H264,
    /// QuickTime with PNG.
    Lossless,
    /// No movie.
    None,
}

impl EvaluateSpec {
    /// Whether the written patterns have few levels.
    pub(crate) fn has_few_levels(&self) -> bool {
        self.bit_depth <= MOST_BITS
    }

    /// Whether patterns are improved on their few levels.
    pub(crate) fn improves_levels(&self) -> bool {
        self.has_few_levels() && self.levels == Levelling::Optimized
    }
}
