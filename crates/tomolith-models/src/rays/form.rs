//! The model as data that a backend computes elsewhere: see [`tomolith_core::dose::rays`].

use super::solid::Pieces;
use super::{Accumulation, Rays, matrix_cache};
use crate::{DoseModel, Work};
use std::ops::Range;
use tomolith_core::dose::form::{Form, Masked};
use tomolith_core::dose::rays::{LightRays, RayGeometry, RaySegment};
use tomolith_core::error::Result;
use tomolith_core::parallel::InParallel;
use tomolith_optics::projector::Ray;
use tomolith_optics::space::PathSegment;

/// Largest number of segments: 2.1 GB.
const MOST: usize = matrix_cache::MOST * matrix_cache::BYTES / size_of::<RaySegment>();

/// Frames of a light, at most, of which the passed voxels are counted.
const COUNTED: usize = 16;

/// Which segments a form is to have.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Wanted {
    /// Those that meet voxels.
    InGrid,
    /// All: from elsewhere light is scattered to voxels, too.
    All,
}

/// The rays of some columns of pixels: how many segments each pixel has, the segments, and the voxels that they pass.
#[derive(Default)]
struct Followed {
    counts: Vec<u32>,
    segments: Vec<RaySegment>,
    passed: f64,
}

impl Rays {
    /// The form of a model; None where [`geometry`](Self::geometry) is.
    pub(crate) fn to_form(&self, work: &Work) -> Result<Option<Form>> {
        let geometry = self.in_grid(work)?;
        Ok(geometry.map(|geometry| Form::Rays(Masked::new(geometry))))
    }

    /// Rays that meet voxels as data; None where [`geometry`](Self::geometry) is.
    pub(crate) fn in_grid(&self, work: &Work) -> Result<Option<RayGeometry>> {
        self.geometry(Wanted::InGrid, work)
    }

    /// Unscattered light as data; None of random accumulation, and where there are more segments than [`MOST`].
    pub(super) fn geometry(&self, wanted: Wanted, work: &Work) -> Result<Option<RayGeometry>> {
        if self.accumulation != Accumulation::Integral {
            return Ok(None);
        }
        let (mut lights, mut segments, mut updates) = (Vec::new(), 0, 0.0);
        for light in 0..self.sources.len() {
            let of_light = match self.shared_rays(light) {
                Some(shared) => Some((shared, self.counted(light, work)?)),
                None => self.all_rays(light, wanted, MOST - segments, work)?,
            };
            let Some((rays, passed)) = of_light else {
                return Ok(None);
            };
            segments += rays.segments.len();
            if segments > MOST {
                return Ok(None);
            }
            updates += passed;
            lights.push(rays);
        }
        Ok(Some(RayGeometry {
            patterns: self.patterns.clone(),
            output: self.output.clone(),
            corner: self.lattice.corner(),
            lights,
            scattered: Vec::new(),
            z_coupling: self.facts().z_coupling,
            updates: updates as u64,
            summary: self.describe(),
        }))
    }

    /// Area that one ray of a pixel stands for, mm².
    pub(super) fn area(&self, light: usize) -> f64 {
        self.patterns[light].grid.pixel_mm2() / self.sources[light].rays() as f64
    }

    /// The rays of a light whose frames all have the same.
    fn shared_rays(&self, light: usize) -> Option<LightRays> {
        // Frames see a surface that cuts voxels each from another side
        let shared = self.sources[light].shared();
        let (paths, starts) = shared.filter(|_| self.solid.is_none())?;
        let area = self.area(light);
        let frames = 0..self.patterns[light].grid.frames();
        let azimuths = frames.flat_map(|frame| self.sources[light].azimuths(frame));
        let turn = |azimuth: f64| [azimuth.cos() as f32, azimuth.sin() as f32];
        Some(LightRays {
            segments: paths
                .iter()
                .map(|path| self.lattice.ray(path, area))
                .collect(),
            starts: starts.to_vec(),
            turns: Some(azimuths.map(turn).collect()),
        })
    }

    /// About how many voxels the rays of all frames of a light pass.
    fn counted(&self, light: usize, work: &Work) -> Result<f64> {
        let layout = &self.patterns[light];
        let (frames, columns) = (layout.grid.frames(), layout.grid.columns);
        let (mut passed, mut pixels) = (0.0, 0);
        for frame in (0..frames).step_by(frames.div_ceil(COUNTED).max(1)) {
            work.check()?;
            let pairs = frame * columns..(frame + 1) * columns;
            let followed: Vec<f64> =
                pairs.par_map(|pair| self.follow(light, Wanted::InGrid, pair).passed);
            passed += followed.into_iter().sum::<f64>();
            pixels += layout.elements_of(frame..frame + 1).len();
        }
        Ok(passed * layout.len() as f64 / pixels.max(1) as f64)
    }

    /// The rays of a light whose frames have different ones, and the voxels that they pass; None of more than `most` segments.
    fn all_rays(
        &self,
        light: usize,
        wanted: Wanted,
        most: usize,
        work: &Work,
    ) -> Result<Option<(LightRays, f64)>> {
        let (mut segments, mut starts, mut passed) = (Vec::new(), vec![0], 0.0);
        for pairs in self.chunks(light, 0..self.patterns[light].grid.frames()) {
            work.check()?;
            let followed: Vec<Followed> = pairs.par_map(|pair| self.follow(light, wanted, pair));
            for column in followed {
                for count in column.counts {
                    starts.push(starts[starts.len() - 1] + count);
                }
                segments.extend(column.segments);
                passed += column.passed;
            }
            if segments.len() > most {
                return Ok(None);
            }
        }
        let rays = LightRays {
            segments,
            starts,
            turns: None,
        };
        Ok(Some((rays, passed)))
    }

    /// The rays of one column of pixels, counted through all frames.
    fn follow(&self, light: usize, wanted: Wanted, pair: usize) -> Followed {
        let layout = &self.patterns[light];
        let (columns, area) = (layout.grid.columns, self.area(light));
        let run = layout.runs[pair];
        let rows: Range<u32> = run.bottom..run.bottom + run.count;
        let (mut found, mut pieces) = (Followed::default(), Pieces::default());
        for row in rows {
            let before = found.segments.len();
            let (frame, column) = (pair / columns, pair % columns);
            let mut add = |path: PathSegment, is_inside: bool| {
                let in_grid = self.lattice.segment(&path, area, 0);
                if in_grid.is_some() || wanted == Wanted::All {
                    found.passed += in_grid.map_or(0.0, |(_, segment)| segment.passed());
                    let ray = self.lattice.ray(&path, area);
                    let energy = if is_inside { -ray.energy } else { ray.energy };
                    found.segments.push(RaySegment { energy, ..ray });
                }
            };
            self.sources[light].for_each_path_segment(frame, column, row as usize, |path| {
                let Some(solid) = &self.solid else {
                    return add(path, false);
                };
                solid.inside(&path.ray, path.length, &mut pieces);
                let mut at = 0.0;
                for &[from, to] in pieces.found() {
                    add(part(&path, [at, from]), false);
                    add(part(&path, [from, to]), true);
                    at = to;
                }
                add(part(&path, [at, path.length]), false);
            });
            found.counts.push((found.segments.len() - before) as u32);
        }
        found
    }
}

/// The part of a path segment from one place on it to another, mm.
fn part(path: &PathSegment, [from, to]: [f64; 2]) -> PathSegment {
    PathSegment {
        ray: Ray {
            from: path.ray.at(from),
            ..path.ray
        },
        length: to - from,
        power: path.power * (-path.uptake.attenuation_per_mm * from).exp(),
        ..*path
    }
}
