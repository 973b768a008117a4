//! The lights of a model, and how their samples lie on voxels: what does not depend on how light spreads.

use super::Settings;
use super::beam::Spreading;
use super::frame_rotation::FrameRotation;
use super::light::{Propagation, SpreadingForm, WaveLight};
use super::number::Number;
use super::sampling::{Sampling, SamplingRequirements};
use super::spectrum::{Heights, Windows};
use super::window::{Side, Span};
use crate::parallel::is_straight;
use crate::{DoseLayout, DoseModel, PatternLayout, Work, ZCoupling};
use std::ops::Range;
use tomolith_core::dose::form::{Form, Masked};
use tomolith_core::dose::waves::WaveGeometry;
use tomolith_core::dose::{Facts, Space};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::HostField;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::units::concise;
use tomolith_optics::light::Light;
use tomolith_optics::vial::Vial;

/// The reason why the model does not support a vial and its lights; None when it does.
#[must_use]
pub fn beyond(vial: &dyn Vial, lights: &[Light]) -> Option<&'static str> {
    let any = |f: &dyn Fn(&Light) -> bool| lights.iter().any(f);
    if any(&|light| !is_straight(vial, light)) {
        Some(
            "it has a single refractive index, but this vial refracts or has walls; use [vial.index_matched]",
        )
    } else if any(&|light| light.resin.gradient.is_some()) {
        Some("it has a single refractive index, but the resin's changes from place to place")
    } else if any(&|light| light.map.is_some()) {
        Some("it needs the same absorption everywhere in the resin")
    } else if any(&|light| light.bath.is_some()) {
        Some("it does not model absorption before the vial")
    } else {
        None
    }
}

/// What a model says of its propagation.
pub(super) trait ModelPropagation: Propagation<f32> + Sized {
    const MODEL: &'static str;
    /// Images that light of a frame is the sum of.
    fn modes(&self) -> usize;
    /// How light spreads as data; None where no data say it.
    fn form(&self) -> Option<SpreadingForm>;
    /// The coefficients of [`DoseModel::along`]: by default that of a linear model.
    fn along(
        lights: &Lights<Self>,
        _x: &HostField,
        d: &HostField,
        work: &Work,
    ) -> Result<Vec<HostField>> {
        let mut term = lights.new_dose()?;
        lights.dose(d, &mut term, work)?;
        Ok(vec![term])
    }
}

/// A model: all its lights.
pub(super) struct Lights<P: Propagation<f32>> {
    lights: Vec<WaveLight<f32, P>>,
    pub(super) patterns: Vec<PatternLayout>,
    output: DoseLayout,
}

impl<P: ModelPropagation> Lights<P> {
    /// Lights that `build(light, layout of dose, which, first frame)` makes; `model`: key of the model.
    pub(super) fn new(
        model: &str,
        vial: &dyn Vial,
        lights: Vec<Light>,
        grid: VolumeGrid,
        build: impl Fn(&Light, &DoseLayout, usize, usize) -> Result<WaveLight<f32, P>>,
    ) -> Result<Self> {
        if let Some(reason) = beyond(vial, &lights) {
            return Err(Error::unsupported(model, reason));
        }
        if grid.is_empty() {
            let found = format!("shape {:?} [z, y, x]", grid.shape);
            return Err(Error::config("grid", found, "at least one voxel"));
        }
        let layout = DoseLayout::new("dose", grid, 0);
        let (mut built, mut patterns) = (Vec::new(), Vec::new());
        let (mut offset, mut first_frame) = (0, 0);
        for (which, light) in lights.into_iter().enumerate() {
            light.check()?;
            let pixels = light.layout(offset);
            built.push(build(&light, &layout, which, first_frame)?);
            offset += pixels.len();
            first_frame += light.pixels.frames();
            patterns.push(pixels);
        }
        Ok(Lights {
            lights: built,
            patterns,
            output: layout,
        })
    }

    pub(super) fn each(&self) -> impl Iterator<Item = (&WaveLight<f32, P>, &PatternLayout)> {
        self.lights.iter().zip(&self.patterns)
    }

    /// The sampling of the lights, for people; equal lights share one line.
    fn summary(&self) -> String {
        let of_light = |light: &WaveLight<f32, P>| {
            let s = &light.propagation.windows().sampling;
            let depths = s.transformed();
            let modes = match light.propagation.modes() {
                1 => String::new(),
                n => format!(", {n} modes"),
            };
            format!(
                "{} depths {} mm apart on either side of the focus, window of {} × {} pixels, {} lateral samples{modes}",
                depths.count,
                concise(depths.step),
                s.padded[0],
                s.padded[1],
                s.across.computed.count,
            )
        };
        let mut lights: Vec<String> = self.lights.iter().map(of_light).collect();
        lights.dedup();
        lights.join("; ")
    }
}

/// A model of light that spreads from a focal plane.
pub trait WaveModel: DoseModel<Field = HostField> {
    /// The model as data, for where a card computes it: not of a single slice, nor where no data say how its light spreads.
    fn data(&self) -> Option<Form>;
}

impl<P: ModelPropagation> WaveModel for Lights<P> {
    fn data(&self) -> Option<Form> {
        if self.output.grid.shape[0] == 1 {
            return None;
        }
        let of_light = |light: &WaveLight<f32, P>| Some(light.form(light.propagation.form()?));
        Some(Form::Waves(Masked::new(WaveGeometry {
            patterns: self.patterns.clone(),
            output: self.output.clone(),
            z_coupling: self.z_coupling(),
            is_linear: P::IS_LINEAR,
            lights: self.lights.iter().map(of_light).collect::<Option<_>>()?,
            updates: self.updates(),
            model: P::MODEL,
            summary: self.summary(),
        })))
    }
}

impl<P: ModelPropagation> DoseModel for Lights<P> {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        // How far along z light reaches from its row
        let reach = |light: &WaveLight<f32, P>| light.propagation.windows().sampling.guard[1];
        Facts {
            patterns: &self.patterns,
            outputs: std::slice::from_ref(&self.output),
            z_coupling: ZCoupling::Halo(self.lights.iter().map(reach).fold(0.0, f64::max)),
            is_linear: P::IS_LINEAR,
        }
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        Ok(self.facts().host_field(space))
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        for (light, layout) in self.each() {
            let local = light.local_frames(&frames, layout);
            light.add_dose(layout, local, x.as_slice(), dose.as_mut_slice(), work)?;
        }
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        for (light, layout) in self.each() {
            let local = light.local_frames(&frames, layout);
            let grad = &mut grad.as_mut_slice()[layout.elements_of(local.clone())];
            let (x, cotangent) = (x.as_slice(), cotangent.as_slice());
            light.pull_back(layout, local, x, cotangent, grad, work)?;
        }
        Ok(())
    }

    fn along(&self, x: &HostField, d: &HostField, work: &Work) -> Result<Option<Vec<HostField>>> {
        P::along(self, x, d, work).map(Some)
    }

    /// Voxels times frames.
    fn updates(&self) -> u64 {
        let heights = self.output.grid.shape[0];
        self.each()
            .map(|(light, p)| (light.turn.columns() * heights * p.grid.frames()) as u64)
            .sum()
    }

    fn describe(&self) -> String {
        format!("{} ({})", P::MODEL, self.summary())
    }
}

/// Columns of voxels in the resin.
struct ResinColumns {
    in_resin: Vec<bool>,
    /// Distance of the farthest from the axis, mm.
    radius: f64,
}

impl ResinColumns {
    fn new(vial: &dyn Vial, grid: &VolumeGrid) -> Self {
        let [_, ny, nx] = grid.shape;
        let place = |i: usize| [grid.x(i % nx), grid.y(i / nx)];
        let in_resin: Vec<bool> = (0..nx * ny)
            .map(|i| vial.in_resin([place(i)[0], place(i)[1], 0.0]))
            .collect();
        let columns = (0..nx * ny).filter(|&i| in_resin[i]).map(place);
        let radius = columns.map(|[x, y]| x.hypot(y)).fold(0.0, f64::max);
        ResinColumns { in_resin, radius }
    }
}

/// The transforms that a light needs for the voxels in the resin.
fn windows_of<T: Number>(
    light: &Light,
    beam: &dyn Spreading,
    columns: &ResinColumns,
    settings: &Settings,
    grid: &VolumeGrid,
) -> Result<Windows<T>> {
    let (pixels, radius, focus_mm) = (&light.pixels, columns.radius, settings.focus_mm);
    let heights = heights_of(pixels.pitch_mm[1], grid)?;
    let nz = grid.shape[0];
    let u = Side {
        pitch: pixels.pitch_mm[0],
        pixels: pixels.columns,
        from: pixels.column_u(0),
        voxels: Span::Disc {
            radius,
            focus: focus_mm,
        },
    };
    let z = Side {
        pitch: pixels.pitch_mm[1],
        pixels: pixels.rows,
        from: pixels.row_z(pixels.rows - 1),
        voxels: Span::Between(grid.z(0), grid.z(nz - 1)),
    };
    let requirements = SamplingRequirements {
        depths: [
            (focus_mm.abs() - radius).max(0.0),
            (radius + focus_mm.abs()).max(u.pitch),
        ],
        voxels: [columns.in_resin.iter().filter(|is_in| **is_in).count(), nz],
        high: heights.finer as f64,
    };
    let sampling = Sampling::new(beam, [&u, &z], &requirements, settings).map_err(|found| {
        Error::config(
            settings.model,
            format!(
                "{found} up to {} mm from the focal plane, which would take too long",
                concise(requirements.depths[1])
            ),
            "a focal plane closer to the axis, larger errors, another aperture or angle, fewer or larger pixels",
        )
    })?;
    Ok(Windows::new(sampling, [&u, &z], heights, nz))
}

/// Operations of the Fourier transforms of a frame's dose and pullback at most: some ten minutes of a core.
const MOST_WORK: f64 = 3e12;

/// The transforms of a light of so many modes; refuses those that take too long.
pub(super) fn affordable_windows(
    vial: &dyn Vial,
    light: &Light,
    beam: &dyn Spreading,
    settings: &Settings,
    grid: &VolumeGrid,
    modes: usize,
) -> Result<Windows<f32>> {
    let windows = windows_of(light, beam, &ResinColumns::new(vial, grid), settings, grid)?;
    let depths = windows.sampling.transformed().count;
    let [image, depth] = windows.operations();
    let work = 3.0 * (image + (depths * modes) as f64 * depth);
    if work > MOST_WORK {
        let [u, z] = windows.sampling.padded;
        return Err(Error::config(
            settings.model,
            format!(
                "a frame takes {depths} depths of {u} × {z} pixels, {modes} modes: {work:.1e} operations, which would take too long"
            ),
            "fewer rings, a focal plane closer to the axis, larger errors, fewer or larger pixels",
        ));
    }
    Ok(windows)
}

/// A light whose samples turn with an index-matched vial.
pub(super) fn turning<T: Number, P: Propagation<T>>(
    vial: &dyn Vial,
    light: &Light,
    beam: &dyn Spreading,
    settings: &Settings,
    layout: &DoseLayout,
    first_frame: usize,
    propagate: impl FnOnce(Windows<T>) -> P,
) -> Result<WaveLight<T, P>> {
    let grid = &layout.grid;
    let [_, ny, nx] = grid.shape;
    let columns = ResinColumns::new(vial, grid);
    let windows = windows_of(light, beam, &columns, settings, grid)?;
    let turn = FrameRotation::new(vial, light, grid, columns.in_resin, settings, &windows);
    let propagation = propagate(windows);
    let light = WaveLight::new(propagation, turn, [nx, ny], layout.row, first_frame);
    Ok(light)
}

/// How rows of pixels and of voxels lie on each other.
pub(super) fn heights_of(row_mm: f64, grid: &VolumeGrid) -> Result<Heights> {
    let ratio = row_mm / grid.pitch_mm;
    let whole =
        |r: f64| (r.round() >= 1.0 && (r / r.round() - 1.0).abs() < 1e-6).then(|| r.round());
    match (whole(ratio), whole(1.0 / ratio)) {
        (Some(finer), _) => Ok(Heights {
            finer: finer as usize,
            stride: 1,
        }),
        (None, Some(stride)) => Ok(Heights {
            finer: 1,
            stride: stride as usize,
        }),
        (None, None) => {
            let nearest = if ratio > 1.0 {
                row_mm / ratio.round()
            } else {
                row_mm * (1.0 / ratio).round()
            };
            Err(Error::config(
                "grid.pitch_mm",
                format!(
                    "voxels of {} mm and rows of pixels {row_mm} mm apart",
                    grid.pitch_mm
                ),
                format!(
                    "with [model.wave] and [model.incoherent_cone] a whole multiple or fraction of the rows' distance, such as {nearest:.6} mm"
                ),
            ))
        }
    }
}
