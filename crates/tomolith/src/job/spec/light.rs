//! `[[light]]`: a projector or a wavelength, and what the resin, the machine and the bounds are to it.

use super::angles::Angles;
use crate::error::Error;
use crate::exposure::{PrinterSpec, Rotation};
use crate::io::channel::Channel;
use crate::job::spec::{JobSpec, is_default};
use crate::optics::interface::Polarization;
use crate::units::{Mm, Pitch};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::path::PathBuf;
use tomolith_material::schedule::Power;

/// One projector, or one wavelength.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LightSpec {
    /// Its name, for files; needed when there are several.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Vacuum wavelength, nm.
    #[serde(default = "violet")]
    #[schemars(range(min = 100.0, max = 20_000.0))]
    pub wavelength_nm: f64,
    /// Pixels of a pattern, [columns, rows].
    #[schemars(inner(range(min = 1, max = 16384)))]
    pub pixels: [usize; 2],
    /// Offset of the image's center from the rotation axis [along the columns, up]; 0 when left out.
    #[serde(default, skip_serializing_if = "is_about_axis")]
    pub offset_mm: [Mm; 2],
    /// Azimuths of the frames: a count (full turn; for a single frame the vial stands), {count, start_deg, arc_deg} or {list_deg} (the vial stands during each of
    /// these frames, and no movie is written).
    pub angles: Angles,
    /// Angles at which the optimization averages a frame, which is exposed while the vial turns through its arc. When left out: one for
    /// every half pixel that the rim of the part moves, 4 at most, as far as the time allows; 1 where light is not collimated and level.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1, max = 64))]
    pub sub_angles: Option<usize>,
    /// Sense in which the VIAL turns, seen from above.
    #[serde(default)]
    pub rotation: Rotation,
    /// Polarization before the vial: "s" has its electric field in the plane of ray and vial axis (along the axis where the ray is
    /// level), "p" normal to both; they tilt with the axis.
    #[serde(default)]
    pub polarization: Polarization,
    /// What the resin is to this light, where that differs from `[resin]`.
    #[serde(default, skip_serializing_if = "is_default")]
    pub resin: LightResinSpec,
    /// How strong a pattern value of 1 is in the print in time, where that differs from `schedule.power`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub power: Option<Power>,
    /// How many turns it is shown in the print in time, where that differs from `schedule.turns`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turns: Option<f64>,
    /// What the machine is to this light, where that differs from `[printer]`.
    #[serde(default, skip_serializing_if = "is_default")]
    pub printer: LightPrinterSpec,
    /// Limits of this light's pattern values, where they differ from `[bounds]`.
    #[serde(default, skip_serializing_if = "is_default")]
    pub bounds: LightBoundsSpec,
    /// Which pixels may be lit; the others stay dark. All that can help the part when left out.
    #[serde(default, skip_serializing_if = "is_default")]
    pub selection: SelectionSpec,
    /// How the projector spreads the light of one pixel, measured: an image of it (PNG, TIFF, NPY; one number per pixel of the light, row 0 on top, the lit
    /// pixel in the middle), or a CSV table of radius in mm and light. Every pixel keeps its light when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub psf: Option<PathBuf>,
    /// The optics, `projector.KIND`.
    pub projector: ProjectorSpec,
}

tomolith_core::keys! {
    /// What the resin is at the wavelength of one light; what is left out is that of `[resin]`.
    #[derive(PartialEq)]
    pub struct LightResinSpec {
        /// Refractive index.
        #[schemars(range(min = 1.0, max = 4.0))]
        pub refractive_index: Option<f64>,
        /// Napierian absorption of the active species, 1e-9 to 100 per mm.
        pub absorption_per_mm: Option<f64>,
        /// Napierian attenuation by everything, 1/mm; absorption + scattering of this light where one of these is given and this is not.
        pub attenuation_per_mm: Option<f64>,
        /// Napierian scattering, 1/mm.
        #[schemars(range(min = 0.0))]
        pub scattering_per_mm: Option<f64>,
    }
}

tomolith_core::keys! {
    /// Limits of one light's pattern values; what is left out is that of `[bounds]`.
    #[derive(PartialEq)]
    pub struct LightBoundsSpec {
        /// Smallest value.
        #[schemars(range(min = 0.0, max = 1e9))]
        pub min: Option<f64>,
        /// Largest value.
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1e9))]
        pub max: Option<f64>,
    }
}

tomolith_core::keys! {
    /// What the machine is to one light; what is left out is that of `[printer]`.
    #[derive(PartialEq)]
    pub struct LightPrinterSpec {
        /// Value (level over highest level) and intensity of the device, points [value, intensity], joined by a monotone cubic.
        pub gray_curve: Option<Vec<[f64; 2]>>,
        /// The same from a file with two columns.
        pub gray_curve_file: Option<PathBuf>,
        /// Irradiance of the brightest device pixel at the highest level, at the vial.
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1e9))]
        pub peak_irradiance_mw_per_cm2: Option<f64>,
        /// Channel of color images that shows this light's patterns, "red", "green" or "blue".
        pub channel: Option<Channel>,
    }
}

impl LightPrinterSpec {
    fn has_curve(&self) -> bool {
        self.gray_curve.is_some() || self.gray_curve_file.is_some()
    }
}

impl JobSpec {
    /// The machine as it is to one light; None where the job has none.
    #[must_use]
    pub fn printer_of(&self, light: usize) -> Option<PrinterSpec> {
        let mut printer = self.printer.clone()?;
        let of_light = &self.light[light].printer;
        if of_light.has_curve() {
            printer.gray_curve.clone_from(&of_light.gray_curve);
            printer
                .gray_curve_file
                .clone_from(&of_light.gray_curve_file);
        }
        let peak = of_light.peak_irradiance_mw_per_cm2;
        printer.peak_irradiance_mw_per_cm2 = peak.or(printer.peak_irradiance_mw_per_cm2);
        printer.channel = self.channel_of(light);
        Some(printer)
    }

    /// The channel that shows a light's patterns.
    pub(crate) fn channel_of(&self, light: usize) -> Option<Channel> {
        let of_light = self.light[light].printer.channel;
        of_light.or(self.printer.as_ref()?.channel)
    }

    /// Blames what is wrong with the machine of a light on the light where it is the light that says it.
    pub(crate) fn at_printer_of(&self, light: usize, mut error: Error) -> Error {
        let of_light = &self.light[light].printer;
        if let Error::Config { key, .. } = &mut error {
            let is_curve = key.starts_with("printer.gray_curve") && of_light.has_curve();
            let is_peak =
                key.starts_with("printer.peak") && of_light.peak_irradiance_mw_per_cm2.is_some();
            if is_curve || is_peak {
                *key = format!("light[{light}].{key}");
            }
        }
        error
    }
}

tomolith_core::keys! {
    /// Which pixels of a light may be lit.
    #[derive(PartialEq)]
    pub struct SelectionSpec {
        /// Columns that may be lit, [first, count]; the optical axis stays in the middle of all columns.
        pub columns: Option<[usize; 2]>,
        /// Rows that may be lit, [first, count], row 0 = top; the optical axis stays in the middle of all rows.
        pub rows: Option<[usize; 2]>,
        /// Image of all pixels, relative to the job file (.png, .tif or .npy): those that are 0 (black) stay dark.
        pub mask: Option<PathBuf>,
        /// Pixels whose middle ray meets the vial closer than this to an edge of its outer wall stay dark (square vials and meshes).
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub corner_radius_mm: Option<Mm>,
        /// Switches off pixels that deliver less than this fraction of the best pixel's dose to the part.
        #[schemars(range(min = 0.0, max = 0.999))]
        pub min_contribution: f64 = 0.0,
    }
}

impl SelectionSpec {
    /// Makes pixels so many times as large; the mask is left out.
    pub(crate) fn coarsen(&mut self, factor: usize) {
        for [first, count] in self.columns.iter_mut().chain(&mut self.rows) {
            let end = (*first + *count).div_ceil(factor);
            *first /= factor;
            *count = end - *first;
        }
        self.mask = None;
    }
}

/// The optics of a light: one kind, `projector.KIND`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct ProjectorSpec(pub Value);

impl ProjectorSpec {
    /// Makes pixels larger by a factor.
    pub(crate) fn coarsen(&mut self, factor: f64) {
        for parameters in self.0.as_object_mut().into_iter().flatten() {
            if let Some(pitch) = parameters.1.get_mut("pixel_pitch_mm")
                && let Ok(Pitch(mm)) = serde_json::from_value(pitch.clone())
            {
                // Without the last digits of a product: 0.3, not 0.30000000000000004
                let larger = Pitch(mm.map(|mm| (factor * mm * 1e9).round() / 1e9));
                *pitch = serde_json::to_value(larger).unwrap_or_default();
            }
        }
    }
}

fn is_about_axis(offset: &[Mm; 2]) -> bool {
    offset.iter().all(|mm| mm.0 == 0.0)
}

fn violet() -> f64 {
    405.0
}
