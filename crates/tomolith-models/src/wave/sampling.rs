//! How finely the wave of a light is sampled: window, depths, lateral samples.
//!
//! Distances of samples along and across the light follow from the [`Taps`] that interpolate them, for light that fills the band evenly: the fewest that
//! stay within the allowed errors. Where that saves time, fields are interpolated from those at fewer depths ([`depth_interpolation`](super::depth_interpolation)), closer samples
//! from those that are computed, and voxels from few of them. Errors that have nothing to do with each other add up as squares: [`WINDOW`]² + [`FIELDS`]² + [`LIGHT`]² ≤ 1.

use super::Settings;
use super::beam::Spreading;
use super::lattice::Lattice;
use super::taps::{Ends, Signal, Taps};
use super::window::{Side, operations, smooth, wide};
use std::f64::consts::FRAC_1_SQRT_2;
use tomolith_core::units::concise;

/// Shares of the allowed error: of the window, and of the depths; where fields are interpolated, of those and of light between them.
const WINDOW: f64 = 0.3;
const PLANES: f64 = 0.95;
const FIELDS: f64 = 0.85;
const LIGHT: f64 = 0.42;

/// Depths and window of one light; lengths in mm.
#[derive(Clone, Debug)]
pub(super) struct Sampling {
    /// Pixels along u and z, those of the guard included.
    pub(super) padded: [usize; 2],
    /// How far a component may travel sideways before it is deleted.
    pub(super) guard: [f64; 2],
    /// Highest frequency kept, in cycles per window: the indices run from −band to band.
    pub(super) band: [usize; 2],
    /// Depths of fields that those of `along` are interpolated from; None: fields are computed at the latter.
    pub(super) fields: Option<Fields>,
    /// Depths on one side of the focal plane, at (k + ½) steps; each stands for its mirror image, too.
    pub(super) along: Ladder,
    /// Samples of the window along u.
    pub(super) across: Ladder,
}

/// Numbers of taps that are tried: from what is transformed, and from what was interpolated to lie closer.
const TAPS: [usize; 4] = [4, 6, 8, 10];
const CLOSE_TAPS: [usize; 3] = [2, 4, 6];

/// Taps for fields, and where the middle of their band is sought, as a share of it: little of their power lies at its upper end.
const FIELD_TAPS: [usize; 5] = [4, 6, 8, 12, 16];
const MIDDLES: [f64; 4] = [0.32, 0.38, 0.44, 0.5];

/// Time of a multiplication and addition of rows over that of an operation of a Fourier transform: 5.5 to 6.5 and 7·10⁹ of them a second and
/// core were measured, of 550 voxels a row.
const ROW_COST: f64 = 1.2;

/// How much longer a frame takes with interpolated fields than their operations say: fields come from far memory. Measured at 0.1 and 1 mm, 256 to
/// 550 pixels across: 1.1 to 1.4 times.
pub(super) const FIELDS_COST: f64 = 1.25;

/// Samples that light is computed at, and those that voxels are interpolated from.
#[derive(Clone, Debug)]
pub(super) struct Ladder {
    /// Those that are computed.
    pub(super) computed: Lattice,
    /// Closer samples, interpolated from those, with their weights.
    pub(super) closer: Option<(Lattice, Taps)>,
    /// Interpolation of voxels from the last of them.
    pub(super) taps: Taps,
}

impl Ladder {
    /// The samples that voxels are interpolated from.
    pub(super) fn last(&self) -> Lattice {
        (self.closer.as_ref()).map_or(self.computed, |(closer, _)| *closer)
    }
}

/// Depths at which fields are transformed; those at closer depths are interpolated from them.
#[derive(Clone, Debug)]
pub(super) struct Fields {
    pub(super) depths: Lattice,
    /// What they are turned back by before, 1/mm.
    pub(super) middle: f64,
    /// Interpolation of fields from them.
    pub(super) taps: Taps,
}

#[derive(Clone, Copy, Debug)]
struct FieldRung {
    depths: Lattice,
    taps: usize,
    middle: f64,
}

/// Samples and taps that are weighed against each other.
#[derive(Clone, Copy, Debug)]
struct Rungs {
    computed: Lattice,
    taps: usize,
    closer: Option<(Lattice, usize)>,
    /// Those of fields.
    fields: Option<FieldRung>,
}

impl Rungs {
    fn new(computed: Lattice, taps: usize, closer: Option<(Lattice, usize)>) -> Self {
        Rungs {
            computed,
            taps,
            closer,
            fields: None,
        }
    }

    /// Samples and taps that a voxel is interpolated from.
    fn last(&self) -> (usize, usize) {
        (self.closer).map_or((self.computed.count, self.taps), |(closer, taps)| {
            (closer.count, taps)
        })
    }

    fn transformed(&self) -> usize {
        (self.fields).map_or(self.computed.count, |fields| fields.depths.count)
    }

    fn built(&self, signal: &Signal) -> Ladder {
        let from_computed = Taps::new(self.taps, signal, &self.computed);
        let (closer, taps) = match self.closer {
            None => (None, from_computed),
            Some((closer, taps)) => (
                Some((closer, from_computed)),
                Taps::new(taps, signal, &closer),
            ),
        };
        Ladder {
            computed: self.computed,
            closer,
            taps,
        }
    }
}

/// Pixels along an edge of the window at most, and depths times pixels of the window: what a frame is computed at.
const MOST_PIXELS: usize = 16384;
const MOST_SAMPLES: f64 = 2e10;

/// All ways to sample the depths between these two.
fn ways_along(beam: &dyn Spreading, depths: [f64; 2], error: f64) -> Vec<Rungs> {
    let signal = beam.along();
    let mut ways = ways_from_light(&signal, depths, error * PLANES);
    let closer = ways_from_light(&signal, depths, error * LIGHT);
    for taps in FIELD_TAPS {
        let middles = MIDDLES.iter().map(|share| share * beam.depth_band());
        let of_middle = |middle| {
            let signal = beam.field(middle)?;
            let depths = Lattice::fewest(taps, &signal, depths, error * FIELDS, MOST_SAMPLES);
            Some(FieldRung {
                depths,
                taps,
                middle,
            })
        };
        let fewest = middles
            .filter_map(of_middle)
            .min_by_key(|way| way.depths.count);
        if let Some(fields) = fewest {
            let finer = closer
                .iter()
                .filter(|way| way.computed.count > fields.depths.count);
            ways.extend(finer.map(|way| Rungs {
                fields: Some(fields),
                ..*way
            }));
        }
    }
    ways
}

/// All ways to sample the depths of light.
fn ways_from_light(signal: &Signal, depths: [f64; 2], error: f64) -> Vec<Rungs> {
    let fewest =
        |taps: usize, error: f64| Lattice::fewest(taps, signal, depths, error, MOST_SAMPLES);
    let half = error * FRAC_1_SQRT_2;
    let close = CLOSE_TAPS.map(|taps| (fewest(taps, half), taps));
    let mut ways = Vec::new();
    for taps in TAPS {
        ways.push(Rungs::new(fewest(taps, error), taps, None));
        let computed = fewest(taps, half);
        for (closer, close_taps) in close {
            if closer.count > computed.count && close_taps < taps {
                ways.push(Rungs::new(computed, taps, Some((closer, close_taps))));
            }
        }
    }
    ways
}

/// All ways to sample a window of some length, of which voxels need a part; `band`: frequencies that must be held.
fn ways_across(signal: &Signal, [window, part]: [f64; 2], band: usize, error: f64) -> Vec<Rungs> {
    let most = window / (2 * band + 2) as f64;
    let computed = |taps: usize, error: f64| {
        let step = Taps::widest(taps, signal, error, most);
        smooth((window / step - 1e-6).ceil() as usize)
    };
    let lattice_of = |step: f64, count: usize| Lattice {
        start: 0.0,
        step,
        count,
        ends: Ends::More,
    };
    let half = error * FRAC_1_SQRT_2;
    let close = CLOSE_TAPS.map(|taps| (Taps::widest(taps, signal, half, most), taps));
    let mut ways = Vec::new();
    for taps in TAPS {
        let count = computed(taps, error);
        ways.push(Rungs::new(
            lattice_of(window / count as f64, count),
            taps,
            None,
        ));
        let count = computed(taps, half);
        let lattice = lattice_of(window / count as f64, count);
        for (step, close_taps) in close {
            if step < lattice.step && close_taps < taps {
                let closer = lattice_of(step, (part / step).ceil() as usize + close_taps + 1);
                ways.push(Rungs::new(lattice, taps, Some((closer, close_taps))));
            }
        }
    }
    ways
}

/// Requirements that a sampling has to meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct SamplingRequirements {
    /// Smallest and largest distance of a voxel from the focal plane, mm.
    pub(super) depths: [f64; 2],
    /// Columns of voxels, and voxels of a column.
    pub(super) voxels: [usize; 2],
    /// Samples of a window along z.
    pub(super) high: f64,
}

impl Sampling {
    /// Depths that are transformed, on one side of the focal plane.
    pub(super) fn transformed(&self) -> Lattice {
        (self.fields.as_ref()).map_or(self.along.computed, |fields| fields.depths)
    }

    /// The quickest sampling with the errors that the settings allow; what is too much of it.
    pub(super) fn new(
        beam: &dyn Spreading,
        sides: [&Side; 2],
        requirements: &SamplingRequirements,
        settings: &Settings,
    ) -> Result<Self, String> {
        let lost = settings.relative_error * WINDOW;
        let wide = [0, 1].map(|i| wide(beam, i, sides[i], requirements.depths, lost));
        if wide.iter().any(|n| *n > MOST_PIXELS as f64) {
            let [u, z] = wide.map(concise);
            return Err(format!("light needs a window of {u} × {z} pixels"));
        }
        let padded = wide.map(|n| 2 * smooth((0.5 * n).ceil() as usize));
        let guard = [0, 1].map(|i| {
            let window = padded[i] as f64 * sides[i].pitch;
            (0.5 * window).max(window - sides[i].reach(0.0))
        });
        let band = [0, 1].map(|i| {
            // Nothing passes at the highest frequency itself
            let highest = beam.highest(i) * padded[i] as f64 * sides[i].pitch;
            ((highest - 1e-6).ceil() as usize - 1).max(1)
        });
        let (along, across) = (beam.along(), beam.across());
        let width = padded[0] as f64 * sides[0].pitch;
        let [low, high] = sides[0].voxels_at(0.0);
        let part = high - low;
        let ways = ways_across(&across, [width, part], band[0], settings.rotation_error);
        let ways_along = ways_along(beam, requirements.depths, settings.relative_error);
        let pairs = ways_along
            .iter()
            .flat_map(|a| ways.iter().map(move |b| (a, b)));
        let cost = |(a, b): &(&Rungs, &Rungs)| {
            let handicap = a.fields.map_or(1.0, |_| settings.fields_cost);
            handicap * cost(a, b, part, band[0], padded[1], requirements)
        };
        let (a, b) = pairs
            .min_by(|a, b| cost(a).total_cmp(&cost(b)))
            .unwrap_or((&ways_along[0], &ways[0]));
        let depths = a.transformed();
        let samples = padded.iter().fold(depths as f64, |all, n| all * *n as f64);
        if samples > MOST_SAMPLES {
            let [u, z] = padded;
            return Err(format!("light needs {depths} depths of {u} × {z} pixels"));
        }
        let fields = a.fields.and_then(|fields| {
            let signal = beam.field(fields.middle)?;
            Some(Fields {
                depths: fields.depths,
                middle: fields.middle,
                taps: Taps::new(fields.taps, &signal, &fields.depths),
            })
        });
        Ok(Sampling {
            padded,
            guard,
            band,
            fields,
            along: a.built(&along),
            across: b.built(&across),
        })
    }
}

/// Time of a dose and a pullback of a frame, in operations of Fourier transforms.
fn cost(
    along: &Rungs,
    across: &Rungs,
    part: f64,
    band: usize,
    padded_z: usize,
    requirements: &SamplingRequirements,
) -> f64 {
    let [columns, heights] = requirements.voxels;
    let lateral = across.computed.count as f64;
    let of_depth = (2 * band + 1) as f64 * operations(requirements.high * padded_z as f64)
        + heights as f64 * operations(lateral);
    let computed = part / across.computed.step;
    let ((last_depths, taps_along), (last, taps_across)) = (along.last(), across.last());
    let depths = along.computed.count as f64;
    let mut width = computed;
    let mut rows = (columns * taps_along * taps_across) as f64;
    if across.closer.is_some() {
        width = width.max(last as f64);
        rows += depths * last as f64 * across.taps as f64;
    }
    if along.closer.is_some() {
        rows += last_depths as f64 * width * along.taps as f64;
    }
    if let Some(fields) = along.fields {
        // Complex; one dose, and a pullback that needs the fields again
        rows += 3.0 * depths * computed * fields.taps as f64;
    }
    3.0 * along.transformed() as f64 * of_depth + 2.0 * ROW_COST * rows * heights as f64
}
