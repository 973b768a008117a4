//! Dose models of waves and of incoherent cones, computed on the card.
//!
//! **Model** [`tomolith_core::dose::waves`]: what the `wave` and `incoherent_cone` models of the processor give of their discretization. Frames are
//! computed in batches: light at samples ([`propagation`]), and from there to voxels and back ([`rotation`]). Every sum has one order, so the same run has the same bits.
//!
//! **Cost** that of the processor's model, docs/wave.md. Memory in addition to fields: the batch, at most [`BATCH`] where a single frame takes less,
//! and the transfer functions of the modes.

mod kernels;
mod propagation;
mod rotation;

use crate::device::{Buffer, Gpu};
use crate::field::GpuField;
use crate::mask::Mask;
use crate::strips::must_be_bound;
use crate::transforms::Transform;
use propagation::{Batch, DevicePropagation};
use rotation::DeviceRotation;
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::waves::{WaveForm, WaveGeometry, WaveLight};
use tomolith_core::dose::{DoseLayout, DoseModel, Facts, PatternLayout, Space, Work};
use tomolith_core::error::{Error, Result};

/// Bytes of the frames that are computed together.
const BATCH: u64 = 512 << 20;
/// Numbers of their fields at a depth that are transformed together: below 100 ms on a small card.
const MOST_NUMBERS: usize = 1 << 25;

/// A model of waves whose fields are on a graphics card.
pub(crate) struct GpuWaves {
    gpu: Gpu,
    geometry: Arc<Geometry>,
    mask: Mask,
}

/// What models of the same light and voxels share on the card.
struct Geometry {
    form: Arc<WaveGeometry>,
    lights: Vec<DeviceLight>,
}

struct DeviceLight {
    propagation: DevicePropagation,
    rotation: DeviceRotation,
    /// Frames of a batch.
    together: usize,
}

/// A piece of a dose, with its columns of voxels.
type Voxels<'a> = (Range<usize>, &'a Buffer);

impl Geometry {
    fn new(gpu: &Gpu, form: &Arc<WaveGeometry>, work: &Work) -> Result<Self> {
        let light = |(light, layout): (&WaveLight, &PatternLayout)| {
            work.check()?;
            DeviceLight::new(gpu, form, light, layout)
        };
        let lights = form.lights.iter().zip(&form.patterns).map(light);
        let geometry = Geometry {
            form: form.clone(),
            lights: lights.collect::<Result<_>>()?,
        };
        gpu.check().map(|()| geometry)
    }
}

impl DeviceLight {
    fn new(
        gpu: &Gpu,
        form: &WaveGeometry,
        light: &WaveLight,
        layout: &PatternLayout,
    ) -> Result<Self> {
        must_be_computed(light, &form.output, &gpu.adapter().name)?;
        let propagation =
            DevicePropagation::new(gpu, light, layout, form.output.row, form.is_linear);
        let [all, largest] = propagation.bytes();
        let shared = (16 * layout.runs.len() as u64).max(DeviceRotation::bytes(&light.rotation));
        let advice = "fewer rows or columns, larger errors of the model";
        must_be_bound(gpu, largest.max(shared), advice)?;
        let frames = (gpu.binding_bytes() / largest).min(BATCH / all);
        let numbers = MOST_NUMBERS / propagation.transformed();
        Ok(DeviceLight {
            propagation,
            rotation: DeviceRotation::new(gpu, &light.rotation, &form.output),
            together: (frames as usize).min(numbers).max(1),
        })
    }
}

impl GpuWaves {
    /// The model of a form on a card.
    /// Refuses a frame that does not fit a binding.
    pub(crate) fn new(gpu: &Gpu, form: &WaveForm, work: &Work) -> Result<Self> {
        let geometry = gpu.shared(
            |known: &Geometry| Arc::ptr_eq(&known.form, &form.geometry),
            || Geometry::new(gpu, &form.geometry, work),
        )?;
        Ok(GpuWaves {
            gpu: gpu.clone(),
            geometry,
            mask: Mask::new(gpu, form),
        })
    }

    fn form(&self) -> &WaveGeometry {
        &self.geometry.form
    }

    /// Columns of voxels in each piece of a dose.
    fn voxels_of<'a>(&self, dose: &'a GpuField) -> impl Iterator<Item = Voxels<'a>> {
        let row = self.form().output.row;
        let ranges = dose.ranges().map(move |r| r.start / row..r.end / row);
        ranges.zip(dose.pieces())
    }

    /// Calls `with` for batches of some frames of all lights whose pixels lie in one piece each, those of `x`.
    fn batches(
        &self,
        frames: &Range<usize>,
        x: &GpuField,
        work: &Work,
        mut with: impl FnMut(&DeviceLight, &Batch<'_>) -> Result<()>,
    ) -> Result<()> {
        let pieces: Vec<Range<usize>> = x.ranges().collect();
        for (light, range) in tomolith_core::dose::own_frames(&self.form().patterns, frames) {
            let (layout, light) = (&self.form().patterns[light], &self.geometry.lights[light]);
            let mut begin = range.start;
            while begin < range.end {
                work.check()?;
                let frames = together(
                    layout,
                    begin..range.end.min(begin + light.together),
                    &pieces,
                );
                let elements = layout.elements_of(frames.clone());
                begin = frames.end;
                let holds = |p: &Range<usize>| p.start <= elements.start && elements.end <= p.end;
                // A piece is whole frames
                let piece = pieces.iter().position(holds).unwrap_or(0);
                let batch = Batch {
                    frames,
                    piece,
                    begin: pieces[piece].start,
                    mask: &self.mask,
                };
                with(light, &batch)?;
            }
        }
        self.gpu.submit();
        self.gpu.check()
    }

    /// doses += samples of a batch
    fn add(&self, light: &DeviceLight, batch: &Batch<'_>, computed: Buffer, dose: &GpuField) {
        let frames = batch.frames.len();
        let samples = light.propagation.interpolate(frames, computed);
        for (columns, piece) in self.voxels_of(dose) {
            (light.rotation).gather(&batch.frames, &samples, &columns, piece);
        }
    }

    /// What voxels ask of the computed samples of a batch.
    fn asked(&self, light: &DeviceLight, batch: &Batch<'_>, cotangent: &GpuField) -> Buffer {
        let frames = batch.frames.len();
        let bytes = (4 * frames * light.rotation.rows() * self.form().output.row) as u64;
        let samples = self.gpu.zeros(bytes);
        for (columns, piece) in self.voxels_of(cotangent) {
            (light.rotation).ask(&batch.frames, &samples, &columns, piece);
        }
        light.propagation.interpolate_back(frames, samples)
    }
}

/// Refuses lengths and places that the kernels cannot have.
fn must_be_computed(light: &WaveLight, output: &DoseLayout, card: &str) -> Result<()> {
    let lengths = light.transforms.samples.map(|comb| comb.length);
    let mut lengths = lengths.into_iter().chain(light.transforms.padded);
    let found = if let Some(length) = lengths.find(|n| !Transform::holds(*n)) {
        format!("Fourier transforms of {length} numbers")
    } else if !DeviceRotation::holds(&light.rotation, output) {
        "so many samples between the focal plane and the voxels".to_owned()
    } else {
        return Ok(());
    };
    Err(Error::unsupported(
        card,
        format!(
            "{found}; use the processor (--device cpu), or other voxels or errors of the model"
        ),
    ))
}

/// The first of some frames whose pixels lie in one piece; at least one.
fn together(layout: &PatternLayout, frames: Range<usize>, pieces: &[Range<usize>]) -> Range<usize> {
    let start = layout.elements_of(frames.start..frames.start + 1);
    let piece = pieces.iter().find(|piece| piece.end >= start.end);
    let most = piece.map_or(start.end, |piece| piece.end);
    let fits = |f: &usize| layout.elements_of(*f..f + 1).end <= most;
    let more = (frames.start + 1..frames.end).take_while(fits).count();
    frames.start..frames.start + 1 + more
}

impl DoseModel for GpuWaves {
    type Field = GpuField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            patterns: &self.form().patterns,
            outputs: std::slice::from_ref(&self.form().output),
            z_coupling: self.form().z_coupling,
            is_linear: self.form().is_linear,
        }
    }

    fn new_field(&self, space: Space) -> Result<GpuField> {
        let WaveGeometry {
            patterns, output, ..
        } = self.form();
        GpuField::of_space(&self.gpu, space, patterns, output)
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &GpuField,
        dose: &mut GpuField,
        work: &Work,
    ) -> Result<()> {
        self.batches(&frames, x, work, |light, batch| {
            let spectra = light.propagation.spectra(batch, x);
            let samples = (light.propagation).shine(batch.frames.len(), &spectra, work)?;
            self.add(light, batch, samples, dose);
            Ok(())
        })
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &GpuField,
        cotangent: &GpuField,
        grad: &mut GpuField,
        work: &Work,
    ) -> Result<()> {
        self.batches(&frames, grad, work, |light, batch| {
            let (propagation, count) = (&light.propagation, batch.frames.len());
            let samples = self.asked(light, batch, cotangent);
            // The derivative of linear light does not ask where
            let spectra = (!self.form().is_linear).then(|| propagation.spectra(batch, x));
            let sum = propagation.send_back(count, spectra.as_ref(), &samples, work)?;
            propagation.to_pixels(&sum, batch, grad);
            Ok(())
        })
    }

    fn along(&self, x: &GpuField, d: &GpuField, work: &Work) -> Result<Option<Vec<GpuField>>> {
        if self.form().is_linear {
            let mut term = self.new_dose()?;
            self.dose(d, &mut term, work)?;
            return Ok(Some(vec![term]));
        }
        let terms = [self.new_dose()?, self.new_dose()?];
        let all = 0..tomolith_core::dose::frames_of(&self.form().patterns);
        self.batches(&all, x, work, |light, batch| {
            let (propagation, count) = (&light.propagation, batch.frames.len());
            let [of_x, of_d] = [x, d].map(|image| propagation.spectra(batch, image));
            let samples = propagation.shine_along(count, [&of_x, &of_d], work)?;
            for (samples, term) in samples.into_iter().zip(&terms) {
                self.add(light, batch, samples, term);
            }
            Ok(())
        })?;
        Ok(Some(terms.into()))
    }

    fn updates(&self) -> u64 {
        self.form().updates
    }

    fn describe(&self) -> String {
        let WaveGeometry { model, summary, .. } = self.form();
        format!("{model} (on {}; {summary})", self.gpu.adapter().name)
    }
}
