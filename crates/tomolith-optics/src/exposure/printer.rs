//! What a given machine makes of patterns: the table `[printer]`.
//!
//! *What must it do, and who does it.* Patterns are light at the vial. A [`Printer`] says which level every pixel of the
//! device must show for it ([`Printer::expose`]: frames, movies, stacks) and which light levels put into the vial
//! ([`Printer::light_of`]: what is simulated). Geometry is in `placing.rs`, levels in `tone.rs`.
//!
//! # Equation
//! With the even light y_j that device pixel j must show (see `placing.rs`), its brightness F_j ≤ 1 (flat field; 0
//! where it is dead) and the gray curve g (level → intensity, g(top) = 1),
//!
//! ```text
//! s = max y_j/F_j        q_j = the level with g(q_j) nearest to y_j/(s·F_j)        shown: s·F_j·g(q_j)
//! ```
//!
//! s, *white*, is the pattern value (mJ/mm², relative like all doses) that the brightest pixel of the device gives at the
//! highest level. Pixels with F < 0.1 do not raise s: they show white and are dimmer than they should be.
//!
//! # Order of frames
//! A vial that turns the other way than the light's `rotation` sees the frames in the opposite order. The movie begins
//! with the frame whose azimuth is nearest to `start_deg`.
//!
//! # Limits
//! Light that the device cannot switch off (g(0) > 0) is counted on the pixels of the patterns, not around them. With
//! several copies each lies on its own part of the device; what is simulated is the first.
//!
//! # Cost
//! One pass over the shared areas of device and pattern pixels per frame; for a vial off its axis these are found for every frame.
//!
//! # Example
//! A device of 6 × 4 pixels mounted on its side, driven by a gamma of about 2: the pattern's right end is up, and half of
//! the light needs 0.72 of the level.
//! ```
//! use tomolith_optics::exposure::{Printer, PrinterSpec, Rotation};
//! use tomolith_core::grid::{PatternGrid, Patterns};
//! let spec: PrinterSpec = toml::from_str(
//!     "canvas = [6, 4]\nquarter_turns = 1\ngray_curve = [[0.0, 0.0], [0.5, 0.25], [1.0, 1.0]]",
//! ).unwrap();
//! let grid = PatternGrid::full_turn(1, 0.0, 2, 4, 0.1); // 2 rows of 4 columns
//! let printer = Printer::new(&spec, ".".as_ref(), &grid, Rotation::Clockwise, 1).unwrap();
//! let patterns = Patterns { grid, values: vec![0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 2.0] };
//! let mut frames = printer.expose(&patterns, 8).unwrap();
//! assert_eq!(frames.full_scale, 4.0);
//! // Above 0.5 the cubic is 0.25 + 0.375 t + 0.5 t² − 0.125 t³: half of the light at t = 0.438, the value 0.719
//! assert_eq!(frames.values[..6], [0, 0, 255, 183, 0, 0]);
//! let light = printer.light_of(&frames).unwrap();
//! assert!((light.values[3] - 4.0).abs() < 1e-6 && (light.values[7] - 2.0).abs() < 0.02);
//! // A white device shines on 24 pixels, of which the patterns have 8
//! assert_eq!(printer.beside(&frames).unwrap(), 0.0);
//! frames.values.fill(255);
//! assert!((printer.beside(&frames).unwrap() - 16.0 / 24.0).abs() < 1e-9);
//! ```

use super::maps::read_map;
use super::placing::{Overlaps, Placing};
use super::quantize::Quantized;
use super::tone::{Tone, ToneCurve};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::f64::consts::{PI, TAU};
use std::path::{Path, PathBuf};
use tomolith_core::columns::read_pairs;
use tomolith_core::error::{Error, Result, in_range};
use tomolith_core::grid::{PatternGrid, Patterns, PixelMask};
use tomolith_core::kind::check_ranges;
use tomolith_core::parallel::InParallel;
use tomolith_core::units::{Mm, Pitch, exact};
use tomolith_io::channel::Channel;

/// Dimmer pixels do not decide what white is.
const DIMMEST: f64 = 0.1;
/// Most copies on a device.
const MOST_COPIES: usize = 64;
/// Most pixels of the light that a pixel of the device may be wide. Then nothing of the patterns is left, and the number had another unit.
const WIDEST: f64 = 10.0;
/// Pixels of a device along an axis, at most, as the key `canvas` takes them.
const MOST_PIXELS: usize = 16384;

/// Sense in which the vial turns, seen from above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Rotation {
    /// Light then arrives counter-clockwise in the resin: azimuths grow.
    #[default]
    Clockwise,
    /// Azimuths fall.
    Counterclockwise,
}

tomolith_core::keys! {
    /// What stands between the patterns and the vial on a given machine; an empty table shows patterns as they are.
    #[derive(PartialEq)]
    pub struct PrinterSpec {
        /// Pixels of the device, [columns, rows]; as many as the patterns need when left out.
        #[schemars(inner(range(min = 1, max = 16384)))]
        pub canvas: Option<[usize; 2]>,
        /// Size of a device pixel at the vial, one number or [right, up] on the canvas; the light's pixel pitch when left out.
        pub pixel_pitch_mm: Option<Pitch>,
        /// Where the middle of the patterns lies, device pixels [right, up] of the canvas' middle.
        #[schemars(inner(range(min = -16384.0, max = 16384.0)))]
        pub offset_px: [f64; 2] = [0.0; 2],
        /// Mirrors left and right, before the turn.
        pub flip_horizontal: bool = false,
        /// Mirrors up and down, before the turn.
        pub flip_vertical: bool = false,
        /// Quarter turns of the image, counter-clockwise.
        #[schemars(range(min = 0, max = 3))]
        pub quarter_turns: u32 = 0,
        /// A further turn of the image, counter-clockwise, degrees: a device or an axis that is not quite upright.
        #[schemars(range(min = -45.0, max = 45.0))]
        pub rotation_deg: f64 = 0.0,
        /// How far right (along the columns of the patterns) the axis of rotation lies of where it should.
        #[schemars(extend("minimum" = -1000.0, "maximum" = 1000.0))]
        pub axis_offset_mm: Mm = Mm(0.0),
        /// How far the middle of the vial is from the axis of the stage.
        #[schemars(extend("minimum" = 0.0, "maximum" = 1000.0))]
        pub eccentricity_mm: Mm = Mm(0.0),
        /// Azimuth, in the resin frame, at which the middle of the vial is off the axis, degrees.
        #[schemars(range(min = -360.0, max = 360.0))]
        pub eccentricity_deg: f64 = 0.0,
        /// Places of several copies, device pixels [right, up] of `offset_px`; one copy in the middle when left out.
        #[schemars(inner(inner(range(min = -16384.0, max = 16384.0))))]
        pub copies_px: Vec<[f64; 2]> = vec![[0.0; 2]],
        /// Sense in which the machine turns the vial, seen from above; the light's `rotation` when left out.
        pub rotation: Option<Rotation>,
        /// Azimuth from which the light of the first frame arrives, degrees; that of the light's first angle when left out.
        #[schemars(range(min = -360.0, max = 360.0))]
        pub start_deg: Option<f64>,
        /// Value (level over highest level) and intensity of the device, points [value, intensity], joined by a monotone cubic; proportional when left out.
        pub gray_curve: Option<Vec<[f64; 2]>>,
        /// The same from a file with two columns (numbers parted by commas, blanks or tabs; lines with # are skipped).
        pub gray_curve_file: Option<PathBuf>,
        /// Channel of color images that shows the patterns, "red", "green" or "blue", for a projector of which one color is used: frames
        /// are 8-bit RGB, black in the other channels, and the movie is lossless; gray when left out.
        pub channel: Option<Channel>,
        /// Brightness of each device pixel, an image of the canvas' size, relative to job file (.png, .tif or .npy).
        pub flat_field: Option<PathBuf>,
        /// Device pixels that stay dark, an image of the canvas' size: white (0.5 or more) is dead.
        pub dead_pixels: Option<PathBuf>,
        /// Images a second that the device shows; frames that follow faster are refused.
        #[schemars(range(min = 1.0, max = 100_000.0))]
        pub refresh_hz: f64 = 60.0,
        /// Irradiance of the brightest device pixel at the highest level, at the vial.
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1e9))]
        pub peak_irradiance_mw_per_cm2: Option<f64>,
        /// Longest time that the print may take, s: with the peak irradiance and resin.critical_dose_mj_per_mm3 it bounds
        /// the pixels.
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1e9))]
        pub time_s: Option<f64>,
        /// Also writes all frames as one array, frames.npz.
        pub stack: bool = false,
    }
}

impl PrinterSpec {
    /// Checks every number, without reading files.
    ///
    /// # Errors
    /// [`Error::Config`] with the key below `printer`.
    pub fn ranges(&self) -> Result<()> {
        check_ranges("printer", self)?;
        for pitch in self.pixel_pitch_mm.iter().flat_map(|pitch| pitch.0) {
            let accepted = "a length above 0, at most 100 mm";
            in_range(
                pitch > 0.0 && pitch <= 100.0,
                "printer.pixel_pitch_mm",
                pitch,
                accepted,
            )?;
        }
        if self.copies_px.is_empty() || self.copies_px.len() > MOST_COPIES {
            return Err(Error::config(
                "printer.copies_px",
                format!("{} places", self.copies_px.len()),
                format!("1 to {MOST_COPIES} places [right, up]"),
            ));
        }
        if self.gray_curve.is_some() && self.gray_curve_file.is_some() {
            return Err(Error::config(
                "printer.gray_curve",
                "both `gray_curve` and `gray_curve_file`",
                "one of the two",
            ));
        }
        match &self.gray_curve {
            Some(points) => ToneCurve::new(points, "printer.gray_curve").map(drop),
            None => Ok(()),
        }
    }

    /// Refuses a bit depth that frames of this machine do not have.
    ///
    /// # Errors
    /// [`Error::Config`] for more than 8 bits in a channel.
    pub fn must_hold(&self, bits: u32) -> Result<()> {
        match self.channel {
            Some(channel) if bits > 8 => Err(Error::config(
                "evaluate.bit_depth",
                format!(
                    "{bits} bits together with printer.channel = \"{}\", whose frames are 8-bit RGB",
                    channel.name()
                ),
                "1 to 8 bits, or no printer.channel",
            )),
            _ => Ok(()),
        }
    }

    /// Files that the table names, to be made absolute.
    pub fn files_mut(&mut self) -> impl Iterator<Item = &mut PathBuf> {
        self.gray_curve_file
            .iter_mut()
            .chain(&mut self.flat_field)
            .chain(&mut self.dead_pixels)
    }

    /// The same machine with pixels so many times as large, for quick trials; its maps are left out.
    pub fn coarsen(&mut self, factor: f64) {
        for count in self.canvas.iter_mut().flatten() {
            *count = (*count as f64 / factor).ceil() as usize + 2;
        }
        self.pixel_pitch_mm
            .iter_mut()
            .for_each(|pitch| pitch.0 = pitch.0.map(|mm| factor * mm));
        let lengths = self
            .offset_px
            .iter_mut()
            .chain(self.copies_px.iter_mut().flatten());
        lengths.for_each(|length| *length /= factor);
        for pair in &mut self.copies_px {
            *pair = pair.map(|length| length + length.signum() * f64::from(length != 0.0));
        }
        (self.flat_field, self.dead_pixels) = (None, None);
    }
}

impl PrinterSpec {
    /// The frame of the patterns that is shown as number j, and how far the first one is from `start_deg`, degrees. Frames of several `turns` are shown turn
    /// after turn, each of them alike.
    ///
    /// # Errors
    /// [`Error::Config`] for a start within a part of a turn.
    pub fn order(
        &self,
        azimuths: &[f64],
        frame_arc: f64,
        rotation: Rotation,
        turns: usize,
    ) -> Result<(Vec<usize>, f64)> {
        let frames = azimuths.len() / turns;
        let is_full = (frame_arc * frames as f64 - TAU).abs() < 1e-9;
        let is_forward = self.rotation.is_none_or(|turns| turns == rotation);
        let (first, away) = match self.start_deg {
            None => (0, 0.0),
            Some(start) if !is_full => {
                return Err(Error::config(
                    "printer.start_deg",
                    format!("{start} degrees, but the angles are not a full turn"),
                    "leave this key out: for a part of a turn, light.angles.start_deg says where it begins",
                ));
            }
            Some(start) => {
                let away = |k: &usize| {
                    let turn = (azimuths[*k] - start.to_radians()).rem_euclid(TAU);
                    if turn > PI { turn - TAU } else { turn }
                };
                let nearer = |a: &usize, b: &usize| away(a).abs().total_cmp(&away(b).abs());
                let first = (0..frames).min_by(nearer).unwrap_or(0);
                (first, away(&first).to_degrees())
            }
        };
        let within_turn = |j: usize| match (is_forward, is_full) {
            (true, _) => (first + j) % frames,
            (false, true) => (first + frames - j) % frames,
            (false, false) => frames - 1 - j,
        };
        let shown = |j: usize| j / frames * frames + within_turn(j % frames);
        Ok(((0..azimuths.len()).map(shown).collect(), away))
    }
}

/// A machine that shows the patterns of one light.
#[derive(Clone, Debug)]
pub struct Printer {
    /// One per copy.
    placings: Vec<Placing>,
    /// Shift of the pattern along u of each frame of the patterns, mm.
    shifts: Vec<f64>,
    /// The areas that device and pattern share, per copy, where they are the same for all frames.
    overlaps: Option<Vec<Overlaps>>,
    /// Frame of the patterns that is shown as number j.
    order: Vec<usize>,
    curve: Option<ToneCurve>,
    /// Brightness of device pixels, 0 where they are dead.
    brightness: Option<Vec<f32>>,
    pattern: PatternGrid,
    notes: Vec<String>,
}

impl Printer {
    /// The machine of a table for patterns on a grid, which has frames of its own for so many `turns`; files are relative to `base`.
    ///
    /// # Errors
    /// [`Error::Config`] with the key below `printer`: ranges, a canvas that is smaller than the patterns, copies that
    /// overlap, maps of another size, a start or a rotation that the angles do not allow; [`Error::Io`] and
    /// [`Error::Format`] for files.
    pub fn new(
        spec: &PrinterSpec,
        base: &Path,
        pattern: &PatternGrid,
        rotation: Rotation,
        turns: usize,
    ) -> Result<Self> {
        spec.ranges()?;
        must_resolve(spec, pattern)?;
        let mut notes = Vec::new();
        notes.extend(taken_pitch(spec, pattern));
        let phase = spec.eccentricity_deg.to_radians();
        let shift = |azimuth: &f64| {
            spec.axis_offset_mm.0 + spec.eccentricity_mm.0 * (phase - azimuth).sin()
        };
        let shifts: Vec<f64> = pattern.azimuths.iter().map(shift).collect();
        let placings = placings(spec, pattern, &shifts)?;
        let (order, away) = spec.order(&pattern.azimuths, pattern.frame_arc, rotation, turns)?;
        if let (Some(start), true) = (spec.start_deg, away.abs() > 1e-6) {
            notes.push(format!(
                "no frame has the azimuth {start} degrees: the movie begins with the nearest one, {away:.3} degrees away"
            ));
        }
        let mut printer = Printer {
            overlaps: None,
            curve: curve(spec, base)?,
            brightness: brightness(spec, base, placings[0].canvas)?,
            placings,
            shifts,
            order,
            pattern: pattern.clone(),
            notes,
        };
        if spec.eccentricity_mm.0 == 0.0 {
            printer.note_blur();
            let shift = printer.shifts.first().copied().unwrap_or(0.0);
            printer.overlaps = Some(printer.placings.iter().map(|p| p.overlaps(shift)).collect());
        }
        Ok(printer)
    }

    /// What people should know, one sentence each.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    fn note_blur(&mut self) {
        let shift = self.shifts.first().copied().unwrap_or(0.0);
        let placing = &self.placings[0];
        let Some([right, down]) = placing.miss(shift) else {
            return;
        };
        if right.abs().max(down.abs()) > 1e-3 {
            self.notes.push(format!(
                "the patterns are {:.2} columns and {:.2} rows off the pixel grid of the device, which blurs them; use an even \
                 number of pixels in light.pixels and printer.canvas, or shift printer.offset_px by half a pixel",
                right.abs(),
                down.abs()
            ));
        }
    }

    /// The device's pixels and frames, in the order in which they are shown.
    #[must_use]
    pub fn canvas_grid(&self) -> PatternGrid {
        let placing = &self.placings[0];
        PatternGrid {
            azimuths: self
                .order
                .iter()
                .map(|&k| self.pattern.azimuths[k])
                .collect(),
            frame_arc: self.pattern.frame_arc,
            rows: placing.canvas[1],
            columns: placing.canvas[0],
            pitch_mm: placing.pitch,
            offset_mm: [0.0; 2],
        }
    }

    fn device_pixels(&self) -> usize {
        let [columns, rows] = self.placings[0].canvas;
        columns * rows
    }

    fn bright(&self, device: usize) -> f64 {
        self.brightness
            .as_ref()
            .map_or(1.0, |b| f64::from(b[device]))
    }

    /// The areas shared in a frame of the patterns, for one copy.
    fn overlaps(&self, frame: usize, copy: usize) -> Cow<'_, Overlaps> {
        match &self.overlaps {
            Some(same) => Cow::Borrowed(&same[copy]),
            None => Cow::Owned(self.placings[copy].overlaps(self.shifts[frame])),
        }
    }

    /// Every device pixel that a frame of the patterns lights, and its intensity at the vial.
    fn each_pixel(&self, patterns: &Patterns, frame: usize, mut put: impl FnMut(usize, f64)) {
        for copy in 0..self.placings.len() {
            self.overlaps(frame, copy)
                .forward(patterns.frame(frame), &mut put);
        }
    }

    /// The pattern value of white: what the brightest device pixel must give.
    fn white(&self, patterns: &Patterns) -> f64 {
        let largest = |frame: usize| {
            let mut most = 0.0f64;
            self.each_pixel(patterns, frame, |device, value| {
                let bright = self.bright(device);
                if bright >= DIMMEST {
                    most = most.max(value / bright);
                }
            });
            most
        };
        let most: Vec<f64> = (0..self.order.len()).par_map(largest);
        most.into_iter().fold(0.0, f64::max)
    }

    /// Levels of all frames for these patterns, in the order in which they are shown.
    ///
    /// # Errors
    /// [`Error::Config`] when `bits` is not 1…16; [`Error::Shape`] when the patterns are not those of the printer;
    /// [`Error::NonFinite`] when a value is negative, infinite or not a number.
    pub fn expose(&self, patterns: &Patterns, bits: u32) -> Result<Quantized> {
        super::quantize::check(patterns, bits)?;
        same_shape("patterns of the printer", &self.pattern, &patterns.grid)?;
        let (white, tone) = (
            self.white(patterns) as f32,
            Tone::new(self.curve.as_ref(), bits),
        );
        let grid = self.canvas_grid();
        let mut values = vec![0; grid.len()];
        if white > 0.0 {
            values
                .chunks_mut(self.device_pixels())
                .zip(&self.order)
                .par_each(|(levels, &frame)| {
                    self.each_pixel(patterns, frame, |device, value| {
                        let bright = self.bright(device);
                        if bright > 0.0 {
                            let wanted = value / (f64::from(white) * bright);
                            levels[device] = tone.level(wanted.min(1.0));
                        }
                    });
                });
        }
        Ok(Quantized {
            grid,
            bits,
            full_scale: white,
            values,
        })
    }

    /// The light that frames put into the vial of the first copy: patterns, in the order of the light's angles.
    ///
    /// # Errors
    /// [`Error::Shape`] when the frames are not those of the device.
    pub fn light_of(&self, frames: &Quantized) -> Result<Patterns> {
        same_shape("frames of the printer", &self.canvas_grid(), &frames.grid)?;
        let tone = Tone::new(self.curve.as_ref(), frames.bits);
        let white = f64::from(frames.full_scale);
        let pixels = self.pattern.rows * self.pattern.columns;
        let shown: Vec<Vec<f32>> = self.order.iter().enumerate().par_map(|(j, &frame)| {
            let levels = &frames.values[j * self.device_pixels()..][..self.device_pixels()];
            let mut light = vec![0.0f64; pixels];
            let value =
                |device: usize| tone.intensity(levels[device]) * white * self.bright(device);
            self.overlaps(frame, 0).back(value, &mut light);
            light.into_iter().map(|v| v as f32).collect()
        });
        let mut patterns = Patterns::dark(self.pattern.clone());
        for (&frame, light) in self.order.iter().zip(shown) {
            patterns.values[frame * pixels..][..pixels].copy_from_slice(&light);
        }
        Ok(patterns)
    }

    /// Share of the light of frames on pixels that no pixel of the patterns meets, of any copy, without what level 0 gives; 0 for dark frames.
    ///
    /// # Errors
    /// [`Error::Shape`] when the frames are not those of the device.
    pub fn beside(&self, frames: &Quantized) -> Result<f64> {
        same_shape("frames of the printer", &self.canvas_grid(), &frames.grid)?;
        let tone = Tone::new(self.curve.as_ref(), frames.bits);
        let mut even = Patterns::dark(self.pattern.clone());
        even.values.fill(1.0);
        let sums: Vec<[f64; 2]> = self.order.iter().enumerate().par_map(|(j, &frame)| {
            let levels = &frames.values[j * self.device_pixels()..][..self.device_pixels()];
            let mut covered = vec![0.0; self.device_pixels()];
            self.each_pixel(&even, frame, |device, share| covered[device] += share);
            let light = |device: usize| {
                let lit = tone.intensity(levels[device]) - self.dark_light();
                lit.max(0.0) * self.bright(device)
            };
            let pixels = covered.iter().enumerate();
            pixels.fold([0.0; 2], |[all, beside], (device, share)| {
                let light = light(device);
                let is_beside = *share <= 0.0;
                [all + light, beside + light * f64::from(u8::from(is_beside))]
            })
        });
        let [all, beside] = (sums.iter()).fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d]);
        Ok(if all > 0.0 { beside / all } else { 0.0 })
    }

    /// Whether some of its pixels give no light.
    #[must_use]
    pub fn has_dead_pixels(&self) -> bool {
        let mut brightness = self.brightness.iter().flat_map(|all| all.iter());
        brightness.any(|&bright| bright <= 0.0)
    }

    /// Which pixels of the patterns the device can light at all, for the first copy: those that lie on dead pixels alone it cannot.
    /// None when it can light every one.
    #[must_use]
    pub fn lightable(&self) -> Option<PixelMask> {
        if !self.has_dead_pixels() {
            return None;
        }
        let (rows, columns) = (self.pattern.rows, self.pattern.columns);
        let frames = match &self.overlaps {
            Some(_) => 1,
            None => self.pattern.frames(),
        };
        let of_frame = |frame: usize| {
            let mut light = vec![0.0; rows * columns];
            self.overlaps(frame, 0)
                .back(|device| self.bright(device), &mut light);
            light
        };
        let light: Vec<Vec<f64>> = (0..frames).par_map(of_frame);
        let mask = PixelMask::new([frames, rows, columns], |frame, row, column| {
            light[frame][row * columns + column] > 0.0
        });
        (!mask.is_open()).then_some(mask)
    }

    /// The brightness of the darkest pixel that is not dead, where that of the brightest is 1.
    #[must_use]
    pub fn dimmest(&self) -> f64 {
        let map = self.brightness.iter().flatten().copied();
        f64::from(map.filter(|bright| *bright > 0.0).fold(1.0, f32::min))
    }

    /// What a pixel gives at level 0, where white is 1.
    #[must_use]
    pub fn dark_light(&self) -> f64 {
        Tone::new(self.curve.as_ref(), 1).intensity(0)
    }

    /// Sum of the intensities of all device pixels at white, where that of the brightest is 1.
    #[must_use]
    pub fn all_white(&self) -> f64 {
        (0..self.device_pixels())
            .map(|device| self.bright(device))
            .sum()
    }

    /// Sum of the intensities of all device pixels of each frame, where white is 1.
    #[must_use]
    pub fn emitted(&self, frames: &Quantized) -> Vec<f64> {
        let tone = Tone::new(self.curve.as_ref(), frames.bits);
        frames
            .values
            .chunks(self.device_pixels().max(1))
            .par_map(|levels| {
                let light =
                    |(device, &level): (usize, &u16)| tone.intensity(level) * self.bright(device);
                levels.iter().enumerate().map(light).sum()
            })
    }
}

fn same_shape(what: &str, expected: &PatternGrid, found: &PatternGrid) -> Result<()> {
    if expected.shape() == found.shape() {
        return Ok(());
    }
    Err(Error::shape(
        format!("{what} [frame, row, column]"),
        expected.shape(),
        found.shape(),
    ))
}

/// Size of a device pixel, mm: that of the patterns' pixels as they are turned, unless the table says another.
pub(super) fn device_pitch(spec: &PrinterSpec, pattern: &PatternGrid) -> [f64; 2] {
    let [u, z] = pattern.pitch_mm;
    let turned = if spec.quarter_turns.is_multiple_of(2) {
        [u, z]
    } else {
        [z, u]
    };
    spec.pixel_pitch_mm.map_or(turned, |pitch| pitch.0)
}

/// Refuses device pixels that are much larger than those of the patterns.
fn must_resolve(spec: &PrinterSpec, pattern: &PatternGrid) -> Result<()> {
    let [device, light] =
        [device_pitch(spec, pattern), pattern.pitch_mm].map(|pitch| pitch[0].max(pitch[1]));
    if device <= WIDEST * light {
        return Ok(());
    }
    Err(Error::config(
        "printer.pixel_pitch_mm",
        format!(
            "{} mm, {:.0} times the width of the light's pixels",
            exact(device),
            device / light
        ),
        format!(
            "the size of a device pixel at the vial in mm, at most {WIDEST} times that of the light's pixels ({} mm)",
            exact(light)
        ),
    ))
}

/// Says how large the pixels of a device are taken to be, where its table does not say it.
fn taken_pitch(spec: &PrinterSpec, pattern: &PatternGrid) -> Option<String> {
    let is_left_out = spec.canvas.is_some() && spec.pixel_pitch_mm.is_none();
    is_left_out.then(|| {
        let [right, up] = device_pitch(spec, pattern).map(exact);
        let size = if right == up { right } else { format!("{right} × {up}") };
        format!(
            "printer.pixel_pitch_mm is left out, so a pixel of the device is taken to be as large at the vial as one of the light, {size} mm: if it is not, the part \
             prints larger or smaller by as much"
        )
    })
}

/// Where each copy lies; refuses a canvas that cannot hold them.
fn placings(spec: &PrinterSpec, pattern: &PatternGrid, shifts: &[f64]) -> Result<Vec<Placing>> {
    let most = shifts.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = shifts.iter().copied().fold(f64::INFINITY, f64::min);
    let copies = spec.copies_px.iter();
    let mut placings: Vec<_> = copies.map(|c| Placing::new(spec, pattern, *c)).collect();
    for (i, a) in placings.iter().enumerate() {
        for (j, b) in placings.iter().enumerate().skip(i + 1) {
            if a.overlap([b.offset[0] - a.offset[0], b.offset[1] - a.offset[1]]) {
                return Err(Error::config(
                    "printer.copies_px",
                    format!("copies {} and {} overlap", i + 1, j + 1),
                    "places that are further apart",
                ));
            }
        }
    }
    let mut needed = [0, 0];
    for placing in &placings {
        let one = placing.needed([least, most]);
        needed = [needed[0].max(one[0]), needed[1].max(one[1])];
    }
    match spec.canvas {
        None if needed.iter().any(|pixels| *pixels > MOST_PIXELS) => {
            return Err(Error::config(
                "printer.pixel_pitch_mm",
                format!(
                    "pixels so small that the patterns need {} × {} of them",
                    needed[0], needed[1]
                ),
                format!(
                    "the size of a device pixel at the vial in mm, with which they need at most {MOST_PIXELS} along an axis"
                ),
            ));
        }
        None => placings
            .iter_mut()
            .for_each(|placing| placing.canvas = needed),
        Some(canvas) if canvas[0] < needed[0] || canvas[1] < needed[1] => {
            return Err(Error::config(
                "printer.canvas",
                format!(
                    "{} × {} pixels, but the patterns of {} × {} need {} × {} with their scale, turns and offsets",
                    canvas[0], canvas[1], pattern.columns, pattern.rows, needed[0], needed[1]
                ),
                format!(
                    "at least [{}, {}], or fewer light.pixels",
                    needed[0], needed[1]
                ),
            ));
        }
        Some(_) => {}
    }
    Ok(placings)
}

fn curve(spec: &PrinterSpec, base: &Path) -> Result<Option<ToneCurve>> {
    if let Some(points) = &spec.gray_curve {
        return ToneCurve::new(points, "printer.gray_curve").map(Some);
    }
    let Some(file) = &spec.gray_curve_file else {
        return Ok(None);
    };
    let points = read_pairs(&base.join(file), "value and intensity");
    let points = points.map_err(|e| at_key("gray_curve_file", e))?;
    ToneCurve::new(&points, "printer.gray_curve_file").map(Some)
}

/// Flat field and dead pixels as one map.
fn brightness(spec: &PrinterSpec, base: &Path, canvas: [usize; 2]) -> Result<Option<Vec<f32>>> {
    let read = |key: &str, file: &Option<PathBuf>| {
        let map = file
            .as_ref()
            .map(|file| read_map(&base.join(file), canvas, "canvas"));
        map.transpose().map_err(|e| at_key(key, e))
    };
    let mut map = read("flat_field", &spec.flat_field)?;
    if let Some(map) = &mut map {
        let most = map.iter().copied().fold(0.0, f32::max);
        if most <= 0.0 {
            return Err(Error::config(
                "printer.flat_field",
                "a map that is dark everywhere",
                "an image of an even white",
            ));
        }
        map.iter_mut().for_each(|v| *v /= most);
    }
    if let Some(dead) = read("dead_pixels", &spec.dead_pixels)? {
        let map = map.get_or_insert_with(|| vec![1.0; dead.len()]);
        for (bright, dead) in map.iter_mut().zip(dead) {
            if dead >= 0.5 {
                *bright = 0.0;
            }
        }
    }
    Ok(map)
}

/// Says which key named a file that cannot be used.
fn at_key(key: &str, error: Error) -> Error {
    error.of_file("").under(&format!("printer.{key}"))
}
