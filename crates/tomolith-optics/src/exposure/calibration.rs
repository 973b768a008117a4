//! Frames for setting a machine up: where the light is, how sharp, how gray, and which way round.
//!
//! A frame is drawn in the plane of the patterns (u right, z up, mm, the axis of rotation at u = 0) and shown through the
//! machine's scale, turns, flips and offsets, so that it looks right at the vial when the `[printer]` table is right. The
//! border, the checkerboard and the gray steps belong to the device and are drawn on its pixels. Levels are not passed
//! through the gray curve or the maps: the frames are there to measure these.
//!
//! | name | what it shows |
//! |---|---|
//! | `border` | the outermost pixels: is the whole canvas in view? |
//! | `checkerboard` | black and white squares, eight along the shorter edge: pixel pitch, straightness, evenness |
//! | `crosshair` | lines through the middle of the patterns: where the middle is |
//! | `gray_steps` | 16 equal steps of the level from black to white: the gray curve |
//! | `siemens_star` | 36 spokes: focus, the same in all directions |
//! | `axis_lines` | the axis of rotation (u = 0), the edges of the patterns and marks every tenth of their width: does the axis stand where it should? |
//! | `orientation` | a letter F in the field of the patterns: is it upright and not mirrored? |
//!
//! ```
//! use tomolith_optics::exposure::{CALIBRATIONS, Calibration, PrinterSpec};
//! use tomolith_core::grid::PatternGrid;
//! let spec: PrinterSpec = toml::from_str("canvas = [64, 48]").unwrap();
//! let field = PatternGrid::full_turn(1, 0.0, 40, 40, 0.1);
//! let calibration = Calibration::new(&spec, &field, 8).unwrap();
//! assert!(CALIBRATIONS.iter().any(|(name, _)| *name == "border"));
//! let border = calibration.draw("border").unwrap();
//! assert_eq!(border.values.iter().filter(|v| **v == 255).count(), 2 * 64 + 2 * 46);
//! ```

use super::placing::Placing;
use super::printer::PrinterSpec;
use super::quantize::{Quantized, check_bits};
use std::f64::consts::PI;
use tomolith_core::error::{Error, Result, nearest_name};
use tomolith_core::grid::PatternGrid;
use tomolith_core::parallel::table;
use tomolith_io::channel::Channel;
use tomolith_io::frames::top_level;

/// Every calibration frame: its name and what it is for.
pub const CALIBRATIONS: &[(&str, &str)] = &[
    (
        "border",
        "The outermost pixels: is the whole canvas in view?",
    ),
    (
        "checkerboard",
        "Black and white squares: pixel pitch, straightness, evenness",
    ),
    (
        "crosshair",
        "Lines through the middle of the patterns: where the middle is",
    ),
    ("gray_steps", "16 equal steps of the level: the gray curve"),
    (
        "siemens_star",
        "36 spokes: focus, the same in all directions",
    ),
    (
        "axis_lines",
        "The axis of rotation and the edges of the patterns: does the axis stand where it should?",
    ),
    ("orientation", "A letter F: is it upright and not mirrored?"),
];

/// Squares of the checkerboard along the shorter edge, gray steps, spokes.
const FIELDS: usize = 8;
const STEPS: usize = 16;
const SPOKES: f64 = 36.0;
/// Samples along each edge of a pixel, where a shape ends inside of it.
const SAMPLES: usize = 4;
/// Half the width of a line, device pixels.
const HALF_LINE: f64 = 1.0;

/// Draws calibration frames for a machine.
#[derive(Clone, Debug)]
pub struct Calibration {
    placing: Placing,
    axis_mm: f64,
    bits: u32,
    channel: Option<Channel>,
}

impl Calibration {
    /// For a machine and the field of a light's patterns.
    ///
    /// # Errors
    /// [`Error::Config`] for numbers out of range, and more than 8 bits in a channel.
    pub fn new(spec: &PrinterSpec, field: &PatternGrid, bits: u32) -> Result<Self> {
        spec.ranges()?;
        check_bits(bits)?;
        spec.must_hold(bits)?;
        let mut placing = Placing::new(spec, field, [0.0; 2]);
        let axis_mm = spec.axis_offset_mm.0;
        if spec.canvas.is_none() {
            placing.canvas = placing.needed([axis_mm, axis_mm]);
        }
        Ok(Calibration {
            placing,
            axis_mm,
            bits,
            channel: spec.channel,
        })
    }

    /// The channel of color images that shows the frames.
    #[must_use]
    pub fn channel(&self) -> Option<Channel> {
        self.channel
    }

    /// One frame by its name, `[row, column]` of the canvas.
    ///
    /// # Errors
    /// [`Error::Config`] for a name that is not in [`CALIBRATIONS`].
    pub fn draw(&self, name: &str) -> Result<Quantized> {
        let [columns, rows] = self.placing.canvas;
        let (top, half) = (f64::from(top_level(self.bits)), self.half_mm());
        // Places in device pixels from the middle, or in mm at the vial
        let on_device = |light: &(dyn Fn(f64, f64) -> f64 + Sync)| self.fill(light);
        let at_vial = |light: &(dyn Fn(f64, f64) -> bool + Sync)| {
            self.fill(&|x, y| {
                let [u, z] = self.placing.to_plane(x, y);
                f64::from(u8::from(light(u - self.axis_mm, z)))
            })
        };
        let line = HALF_LINE * f64::midpoint(self.placing.pitch[0], self.placing.pitch[1]);
        let values = match name {
            "border" => on_device(&|x, y| {
                let edge = (columns as f64 / 2.0 - x.abs()).min(rows as f64 / 2.0 - y.abs());
                f64::from(u8::from(edge < 1.0))
            }),
            "checkerboard" => on_device(&|x, y| {
                // Whole pixels, so that a ruler on one square gives the pitch
                let edge = (columns.min(rows) / FIELDS).max(1) as f64;
                let field = |v: f64| (v / edge).floor() as i64;
                f64::from(u8::from((field(x) + field(y)) % 2 == 0))
            }),
            "gray_steps" => on_device(&|x, _| {
                let step = ((x / columns as f64 + 0.5) * STEPS as f64).floor();
                step.clamp(0.0, (STEPS - 1) as f64) / (STEPS - 1) as f64
            }),
            "crosshair" => at_vial(&|u, z| {
                let ring = u.hypot(z) - half[0].min(half[1]) / 2.0;
                u.abs() < line || z.abs() < line || ring.abs() < line
            }),
            "siemens_star" => at_vial(&|u, z| {
                let inside = u.hypot(z) < half[0].min(half[1]);
                inside && (z.atan2(u) * SPOKES / (2.0 * PI)).rem_euclid(1.0) < 0.5
            }),
            "axis_lines" => at_vial(&|u, z| {
                let edge = (u.abs() - half[0]).abs() < line && z.abs() < half[1];
                let mark = (u / half[0] * 5.0)
                    .rem_euclid(1.0)
                    .min(1.0 - (u / half[0] * 5.0).rem_euclid(1.0));
                let marks =
                    u.abs() < half[0] && mark * half[0] / 5.0 < line && z.abs() < half[1] / 20.0;
                u.abs() < line || edge || marks
            }),
            "orientation" => at_vial(&|u, z| {
                let size = 0.8 * half[0].min(half[1]);
                let (u, z) = (u / size, z / size);
                let stem = (-0.6..-0.3).contains(&u) && z.abs() < 1.0;
                let upper = (-0.6..0.6).contains(&u) && (0.7..1.0).contains(&z);
                let lower = (-0.6..0.3).contains(&u) && (0.0..0.3).contains(&z);
                stem || upper || lower
            }),
            other => {
                let names = || CALIBRATIONS.iter().map(|c| c.0);
                return Err(Error::Config {
                    key: "calibration".to_owned(),
                    found: format!("unknown frame `{other}`"),
                    accepted: names().collect::<Vec<_>>().join(", "),
                    nearest: nearest_name(other, names()).map(str::to_owned),
                    place: None,
                });
            }
        };
        let grid = PatternGrid {
            frame_arc: 0.0,
            pitch_mm: self.placing.pitch,
            ..PatternGrid::full_turn(1, 0.0, rows, columns, 1.0)
        };
        Ok(Quantized {
            grid,
            bits: self.bits,
            full_scale: 1.0,
            values: values
                .into_iter()
                .map(|v| (v * top + 0.5).floor() as u16)
                .collect(),
        })
    }

    /// Half the size of the patterns, mm.
    fn half_mm(&self) -> [f64; 2] {
        self.placing.half()
    }

    /// Mean over each device pixel of a picture that is given at places in device pixels from the middle.
    fn fill(&self, light: &(dyn Fn(f64, f64) -> f64 + Sync)) -> Vec<f64> {
        let [columns, rows] = self.placing.canvas;
        let at = |i: usize| (i as f64 + 0.5) / SAMPLES as f64;
        table(rows * columns, |i| {
            let (x, y) = ((i % columns) as f64, (i / columns) as f64);
            let mut sum = 0.0;
            for dy in 0..SAMPLES {
                for dx in 0..SAMPLES {
                    sum += light(
                        x + at(dx) - columns as f64 / 2.0,
                        rows as f64 / 2.0 - y - at(dy),
                    );
                }
            }
            sum / (SAMPLES * SAMPLES) as f64
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn calibration(toml: &str, bits: u32) -> Calibration {
        let spec: PrinterSpec = toml::from_str(toml).unwrap();
        Calibration::new(&spec, &PatternGrid::full_turn(1, 0.0, 60, 40, 0.1), bits).unwrap()
    }

    fn drawn(toml: &str, name: &str) -> Vec<u16> {
        calibration(toml, 8).draw(name).unwrap().values
    }

    #[test]
    fn every_frame_is_drawn_and_uses_black_and_white() {
        for (name, _) in CALIBRATIONS {
            let frame = calibration("canvas = [128, 96]", 10).draw(name).unwrap();
            assert_eq!(frame.values.len(), 128 * 96);
            assert_eq!(frame.values.iter().min(), Some(&0), "{name}");
            assert_eq!(frame.values.iter().max(), Some(&1023), "{name}");
        }
        let steps = drawn("canvas = [128, 96]", "gray_steps");
        let row: Vec<u16> = (0..16).map(|i| steps[i * 8 + 4]).collect();
        assert_eq!(row, (0..16).map(|i| i * 17).collect::<Vec<u16>>());
    }

    #[test]
    fn the_squares_of_the_checkerboard_are_square() {
        let values = drawn("canvas = [128, 96]", "checkerboard");
        let at = |row: usize, column: usize| values[row * 128 + column];
        // Twelve pixels along both edges, from the middle of the canvas
        for i in 0..12 {
            assert_eq!(at(48, 64), at(48 + i, 64 + i));
        }
        assert_ne!(at(48, 64), at(60, 64));
        assert_ne!(at(48, 64), at(48, 76));
    }

    #[test]
    fn the_axis_is_drawn_where_the_machine_has_it() {
        // 0.7 mm right of the middle of the patterns, which lie 10 pixels right: column 64 + 10 + 7
        let machine = "canvas = [128, 96]\noffset_px = [10, 0]\naxis_offset_mm = 0.7";
        let values = drawn(machine, "crosshair");
        let top: Vec<usize> = (0..128).filter(|c| values[*c] == 255).collect();
        assert_eq!(top, [80, 81]);
        // On a device that lies on its side the axis is a row
        let values = drawn("canvas = [128, 96]\nquarter_turns = 1", "axis_lines");
        assert!((0..128).all(|c| values[48 * 128 + c] == 255));
    }

    #[test]
    fn the_letter_follows_turns_and_flips() {
        let letter = |toml: &str| drawn(toml, "orientation");
        let upright = letter("canvas = [60, 60]");
        let turned = letter("canvas = [60, 60]\nquarter_turns = 1");
        let flipped = letter("canvas = [60, 60]\nflip_horizontal = true");
        for (row, column) in (0..60).flat_map(|r| (0..60).map(move |c| (r, c))) {
            // A quarter turn counter-clockwise takes the right end up
            assert_eq!(upright[row * 60 + column], turned[(59 - column) * 60 + row]);
            assert_eq!(upright[row * 60 + column], flipped[row * 60 + 59 - column]);
        }
        assert_ne!(upright, turned);
    }

    #[test]
    fn unknown_frames_and_depths_are_refused() {
        let message = calibration("", 8).draw("boarder").unwrap_err().to_string();
        assert!(message.contains("did you mean `border`?"), "{message}");
        let field = PatternGrid::full_turn(1, 0.0, 4, 4, 0.1);
        for bits in [0, 17] {
            assert!(Calibration::new(&PrinterSpec::default(), &field, bits).is_err());
        }
    }
}
