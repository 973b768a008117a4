//! Where the field of a light ends, and whether a target lies in it.

use crate::error::{Error, Result};
use crate::grid::PatternGrid;
use crate::job::resolve::ResolvedJob;
use crate::job::resolve::optics::Optics;
use crate::job::spec::JobSpec;
use crate::optics::light::Light;
use crate::units::concise;

impl Optics {
    /// Refuses a target whose box no frame of a light covers: sideways, or along the axis where its light passes the axis.
    pub(crate) fn must_be_in_the_fields(
        &self,
        spec: &JobSpec,
        [low, high]: [[f64; 3]; 2],
    ) -> Result<()> {
        // A shape touches every face of its box, so some of it is this far from the axis
        let out = (0..2).map(|i| high[i].max(-low[i])).fold(0.0, f64::max);
        for i in 0..self.lights.len() {
            self.must_be_wide(spec, i, out)?;
            self.must_be_high(spec, i, [low[2], high[2]], out)?;
        }
        Ok(())
    }

    fn must_be_wide(&self, spec: &JobSpec, i: usize, out: f64) -> Result<()> {
        let light = &self.lights[i];
        let [low, high] = field_mm(light);
        // A field on one side of the axis lights all of a part that turns
        let field = high[0].max(-low[0]);
        if out <= field * (1.0 + 1e-9) {
            return Ok(());
        }
        let whole = PatternGrid {
            offset_mm: [0.0; 2],
            ..light.pixels.clone()
        };
        // Pixels that would do are cut down by something else
        let (key, accepted) = match out <= whole.field_mm()[1][0] * (1.0 + 1e-9) {
            true => {
                let (key, accepted) = narrowing(spec, i, SIDEWAYS);
                (key, accepted.to_owned())
            }
            false => {
                let accepted = larger_field(light.pixels.columns, out / field);
                (format!("light[{i}].pixels"), accepted)
            }
        };
        Err(Error::config(
            key,
            format!(
                "the field reaches {} mm sideways from its middle, the target {} mm",
                concise(field.max(0.0)),
                concise(out)
            ),
            accepted,
        ))
    }

    fn must_be_high(
        &self,
        spec: &JobSpec,
        i: usize,
        [low, high]: [f64; 2],
        out: f64,
    ) -> Result<()> {
        let lit = self.lit_heights(i);
        // Less than half a pixel is reported when the voxels are known
        let half = self.lights[i].pixels.pitch_mm[1] / 2.0;
        let [bottom, top] = lit.on_axis;
        if low >= bottom - half && high <= top + half {
            return Ok(());
        }
        let [below, above] = lit.within(out);
        let remedy = self.remedy(i, [below - low, high - above]);
        let is_lopsided = (low + high).abs() > 1e-9 * (high - low);
        let (key, accepted) = match remedy.key {
            "selection" => {
                let (key, accepted) = narrowing(spec, i, ALONG_AXIS);
                (key, accepted.to_owned())
            }
            "offset_mm" if is_lopsided && self.tilt_rad() == 0.0 => (
                "target.offset_mm".to_owned(),
                format!(
                    "a target whose middle lies nearer to that of the light, or {}",
                    remedy.advice
                ),
            ),
            key => (format!("light[{i}].{key}"), remedy.advice),
        };
        Err(Error::config(
            key,
            format!(
                "light passes the axis at heights of {} to {} mm{}, the target lies at {} to {} mm",
                concise(bottom),
                concise(top),
                self.because(),
                concise(low),
                concise(high)
            ),
            accepted,
        ))
    }
}

/// Lowest and highest corner [u, z] of what a light may light, mm.
pub(crate) fn field_mm(light: &Light) -> [[f64; 2]; 2] {
    light.selection.field_mm(&light.pixels)
}

/// Whether an offset or a selection cuts the field of a light sideways.
pub(crate) fn is_cut_sideways(light: &Light) -> bool {
    let whole = PatternGrid {
        offset_mm: [0.0; 2],
        ..light.pixels.clone()
    };
    let sideways = |[low, high]: [[f64; 2]; 2]| [low[0], high[0]];
    sideways(field_mm(light)) != sideways(whole.field_mm())
}

/// Whether some rows of a light may not be lit.
pub(crate) fn is_cut_along_axis(light: &Light) -> bool {
    let along_axis = |[low, high]: [[f64; 2]; 2]| [low[1], high[1]];
    along_axis(field_mm(light)) != along_axis(light.pixels.field_mm())
}

impl ResolvedJob {
    /// The key that moves the sides of a light's field.
    pub(crate) fn sides_key(&self, light: usize) -> String {
        match is_cut_sideways(&self.optics.lights[light]) {
            true => narrowing(&self.spec, light, SIDEWAYS).0,
            false => format!("light[{light}].pixels"),
        }
    }
}

/// How many columns make a field so many times as large.
fn larger_field(columns: usize, times: f64) -> String {
    let needed = columns as f64 * times;
    if !needed.is_finite() {
        return "a field larger than the target: more pixels, a larger pitch, or a smaller target"
            .to_owned();
    }
    format!(
        "at least {} columns of pixels of this pitch (more where the vial bends light), a larger pitch, or a smaller target",
        (needed - 1e-6).ceil()
    )
}

/// Directions of a field.
const SIDEWAYS: usize = 0;
const ALONG_AXIS: usize = 1;

/// The key that makes the field of a light too small for a target though all of its pixels would do, and what would make it larger.
fn narrowing(spec: &JobSpec, i: usize, direction: usize) -> (String, &'static str) {
    let light = &spec.light[i];
    let selection = &light.selection;
    let crop = [selection.columns, selection.rows][direction];
    if crop.is_some() || selection.mask.is_some() {
        let accepted = "pixels that may be lit up to the edge of the target";
        return (format!("light[{i}].selection"), accepted);
    }
    if light.offset_mm[direction].0 != 0.0 {
        let accepted = "an image that still reaches the edge of the target: a smaller offset, or more light.pixels";
        return (format!("light[{i}].offset_mm"), accepted);
    }
    let printer = spec.printer.as_ref();
    let map = match printer.map(|printer| (&printer.dead_pixels, &printer.flat_field)) {
        Some((Some(_), _)) => "dead_pixels",
        Some((None, Some(_))) => "flat_field",
        _ => {
            return (
                format!("light[{i}].selection"),
                "pixels that may be lit up to the edge of the target",
            );
        }
    };
    let accepted =
        "a device that can light the target up to its edge: another map, or printer.offset_px";
    (format!("printer.{map}"), accepted)
}
