//! Light that frames deliver.
//!
//! **Equation** (Wang et al. 2022, supplement, Note 1)
//!
//! ```text
//! S = Σ_frames Σ_x I_x·A_x·Δt        A_x = C_x/C_all·A
//! ```
//!
//! C_x of the C_all pixels of a frame show gray x, at which the machine gives I_x. **Units** mW/cm², cm², s; S in J.

use std::path::Path;
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::PatternGrid;
use tomolith_io::frames::{Frames, read_frames};
use tomolith_optics::exposure::{Printer, PrinterSpec, Quantized, Rotation};

/// Frames as a machine shows them.
#[derive(Clone, Debug)]
pub struct ShownFrames {
    /// Sum of the intensities of all pixels of each frame, where white is 1.
    pub sums: Vec<f64>,
    /// That of a frame of white pixels.
    pub all_white: f64,
    /// Area of a pixel at the vial, mm².
    pub pixel_mm2: f64,
    /// The pattern value of white, in units of the job.
    pub white: Option<f64>,
}

impl ShownFrames {
    /// The frames of a folder on a machine with this gray curve, channel and these maps (files relative to `base`); `pitch_mm` is that of the canvas.
    ///
    /// # Errors
    /// As [`read_frames`] and [`Printer::new`].
    pub fn read(
        folder: &Path,
        machine: &PrinterSpec,
        base: &Path,
        pitch_mm: [f64; 2],
    ) -> Result<Self> {
        let Frames {
            shape: [count, rows, columns],
            bits,
            full_scale,
            values,
        } = read_frames(folder, machine.channel)?;
        let grid = PatternGrid {
            azimuths: vec![0.0],
            frame_arc: 0.0,
            rows,
            columns,
            pitch_mm,
            offset_mm: [0.0; 2],
        };
        // What a frame's levels put out depends on curve and maps only, not on where the patterns lie
        let spec = PrinterSpec {
            gray_curve: machine.gray_curve.clone(),
            gray_curve_file: machine.gray_curve_file.clone(),
            flat_field: machine.flat_field.clone(),
            dead_pixels: machine.dead_pixels.clone(),
            ..PrinterSpec::default()
        };
        let printer = Printer::new(&spec, base, &grid, Rotation::Clockwise, 1)?;
        let sums = printer.emitted(&Quantized {
            grid: grid.clone(),
            bits,
            full_scale: 1.0,
            values,
        });
        if sums.iter().all(|sum| *sum == 0.0) {
            return Err(Error::format(
                folder,
                format!("{count} frames, all of them dark"),
                "frames with light",
            ));
        }
        Ok(ShownFrames {
            sums,
            all_white: printer.all_white(),
            pixel_mm2: grid.pixel_mm2(),
            white: full_scale.map(f64::from),
        })
    }

    /// Power of a white frame over the irradiance of its brightest pixel, cm²: its area, where all pixels are as bright.
    #[must_use]
    pub fn white_cm2(&self) -> f64 {
        self.all_white * self.pixel_mm2 / 100.0
    }

    /// Light of all frames over that of as many white ones.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.sums.iter().sum::<f64>() / (self.sums.len() as f64 * self.all_white)
    }
}
