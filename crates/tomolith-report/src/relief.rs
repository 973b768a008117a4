//! `print.ply`: the print's surface in the colors of its deviation from the target.

use std::path::Path;
use tomolith_core::error::Result;
use tomolith_io::ply::{PlyCorners, write_ply};
use tomolith_metrics::surface::Deviation;

/// Colors where the print is too small and where it is too large, those of errors on the page.
const TOO_SMALL: [u8; 3] = [47, 111, 208];
const TOO_LARGE: [u8; 3] = [214, 69, 80];
/// Share of the corners whose deviation lies within the color scale; those beyond have the color of its end.
const WITHIN: f64 = 0.95;
/// Ends of the colors within a power of ten.
const ENDS: [f64; 11] = [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];

/// Deviations up to which colors differ, µm: one of [`ENDS`] times a power of ten, not smaller than [`WITHIN`] of all.
fn reach_um(off_um: &[f32]) -> f64 {
    let mut sizes: Vec<f32> = off_um.iter().map(|off| off.abs()).collect();
    let rank = (sizes.len() as f64 * WITHIN) as usize;
    if rank >= sizes.len() {
        return 1.0;
    }
    let (_, size, _) = sizes.select_nth_unstable_by(rank, f32::total_cmp);
    // Below a nanometer there is nothing to see
    let size = f64::from(*size).max(1e-3);
    let power = 10f64.powf(size.log10().floor());
    ENDS.into_iter()
        .map(|m| m * power)
        .find(|reach| *reach >= size * (1.0 - 1e-6))
        .unwrap_or(10.0 * power)
}

/// From too small (0, blue) over right (½, gray) to too large (1, red).
fn color(at: f64) -> [u8; 3] {
    let off = 2.0 * at - 1.0;
    let end = if off < 0.0 { TOO_SMALL } else { TOO_LARGE };
    let blend = |from: u8, to: u8| {
        (f64::from(from) + (f64::from(to) - f64::from(from)) * off.abs().min(1.0)).round() as u8
    };
    [blend(214, end[0]), blend(218, end[1]), blend(222, end[2])]
}

/// Place on the scale of [`color`].
fn place(off_um: f32, reach_um: f64) -> f64 {
    (0.5 + 0.5 * f64::from(off_um) / reach_um).clamp(0.0, 1.0)
}

/// Writes the surface with the property `deviation_um` and colors.
pub(super) fn write(path: &Path, part: &str, deviation: &Deviation) -> Result<()> {
    let reach = reach_um(&deviation.off_um);
    let colors: Vec<[u8; 3]> = deviation
        .off_um
        .iter()
        .map(|off| color(place(*off, reach)))
        .collect();
    let comment = format!(
        "mm: {part}, predicted print; deviation_um: signed distance to the target's surface in micrometers, positive where the print is too large; \
         colors from blue (-{reach} um) over gray to red (+{reach} um)"
    );
    let corners = PlyCorners {
        places: &deviation.surface.corners,
        name: "deviation_um",
        numbers: &deviation.off_um,
        colors: &colors,
    };
    write_ply(path, &comment, &corners, &deviation.surface.triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_reaches_what_nearly_all_corners_have() {
        let mut off = vec![3.0f32; 1000];
        off[..45].fill(-900.0);
        assert_eq!(reach_um(&off), 3.0);
        // Not far beyond the largest, or all would be gray
        off[..60].fill(-264.0);
        assert_eq!(reach_um(&off), 300.0);
        assert_eq!(reach_um(&[0.0; 4]), 1e-3);
        assert_eq!(reach_um(&[]), 1.0);
    }

    #[test]
    fn colors_run_from_blue_over_gray_to_red() {
        let [blue, gray, red] = [-1.0, 0.0, 1.0].map(|off| color(place(off * 50.0, 50.0)));
        assert_eq!((blue, red), (TOO_SMALL, TOO_LARGE));
        assert!(gray.iter().all(|c| (200..230).contains(c)));
    }
}
