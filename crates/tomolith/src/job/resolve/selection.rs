//! Which pixels of a light may be lit: the table `selection` of a light.
//!
//! Columns, rows, an image and the corners of the vial are masks; a pixel may be lit where all of them allow it. How much a pixel
//! must bring to the part is seen when the model is known (see [`crate::models::selection`]).

use crate::error::{Error, Result};
use crate::exposure::read_map;
use crate::grid::{PatternGrid, PixelMask};
use crate::job::spec::SelectionSpec;
use crate::models::rays;
use crate::optics::edges::Edges;
use crate::optics::light::Selection;
use crate::optics::projector::Ray;
use crate::optics::vial::Vial;
use std::path::Path;
use std::sync::Arc;

/// What a table chooses; `key` is its path, `base` the folder of the job file.
/// Refuses an image that cannot be used, a vial without edges, and a choice of no pixel.
pub(crate) fn selection_of(
    spec: &SelectionSpec,
    key: &str,
    base: &Path,
    pixels: &PatternGrid,
    vial: &dyn Vial,
    optics: &rays::Optics,
) -> Result<Selection> {
    let mut masks: Vec<PixelMask> = crop(spec, pixels).into_iter().collect();
    if let Some(file) = &spec.mask {
        masks.push(image(&format!("{key}.mask"), &base.join(file), pixels)?);
    }
    if let Some(radius) = spec.corner_radius_mm {
        let key = format!("{key}.corner_radius_mm");
        masks.push(corners(&key, radius.0, pixels, vial, optics)?);
    }
    let selection = Selection {
        masks: masks.into_iter().map(Arc::new).collect(),
        min_contribution: spec.min_contribution,
        has_background: false,
    };
    let [low, high] = selection.field_mm(pixels);
    if low[0] >= high[0] || low[1] >= high[1] {
        return Err(Error::config(
            key,
            "leaves no pixel that may be lit",
            "columns, rows and a mask that have pixels in common",
        ));
    }
    Ok(selection)
}

/// The columns and rows that a table names.
fn crop(spec: &SelectionSpec, pixels: &PatternGrid) -> Option<PixelMask> {
    if spec.columns.is_none() && spec.rows.is_none() {
        return None;
    }
    let within = |range: Option<[usize; 2]>, i: usize| {
        range.is_none_or(|[first, count]| (first..first + count).contains(&i))
    };
    Some(PixelMask::new(
        [1, pixels.rows, pixels.columns],
        |_, row, column| within(spec.rows, row) && within(spec.columns, column),
    ))
}

/// The pixels that are not 0 in an image.
fn image(key: &str, file: &Path, pixels: &PatternGrid) -> Result<PixelMask> {
    let (rows, columns) = (pixels.rows, pixels.columns);
    let values = read_map(file, [columns, rows], "light's pixels").map_err(|error| {
        let (found, accepted) = match &error {
            Error::Format {
                path,
                found,
                accepted,
            } => (format!("{}: {found}", path.display()), accepted.clone()),
            other => (other.to_string(), "a file that can be read".to_owned()),
        };
        Error::config(key, found, accepted)
    })?;
    if values.iter().all(|&value| value == 0.0) {
        return Err(Error::config(
            key,
            format!("{} is black everywhere", file.display()),
            "an image that is not black where pixels may be lit",
        ));
    }
    Ok(PixelMask::new([1, rows, columns], |_, row, column| {
        values[row * columns + column] > 0.0
    }))
}

/// The pixels whose middle ray meets the vial farther than `radius` from every edge of its outer wall, or misses it.
fn corners(
    key: &str,
    radius: f64,
    pixels: &PatternGrid,
    vial: &dyn Vial,
    optics: &rays::Optics,
) -> Result<PixelMask> {
    let walls = vial.surfaces();
    let wall = walls.first().map(|(wall, _)| wall);
    let edges = wall.map(Edges::of).unwrap_or_default();
    let Some(wall) = wall.filter(|_| !edges.is_empty()) else {
        return Err(Error::config(
            key,
            "a radius about the edges of the vial, but its outer wall has none",
            "a square vial, or a mesh with sharp edges",
        ));
    };
    let away = |frame: usize, row: usize, column: usize| {
        let point = [pixels.column_u(column), pixels.row_z(row)];
        let ray = optics.projector.ray(point, [0.0; 2]);
        let ray = optics.motion.seen_from_vial(ray, pixels.azimuths[frame]);
        // Rays are given by any of their points
        let [x, y, z] = ray.from;
        let back = x.hypot(y).hypot(z) + 2.0 * vial.outer_radius_mm();
        let ray = Ray {
            from: ray.at(-back),
            ..ray
        };
        let hit = wall.enter(&ray).map(|crossing| ray.at(crossing.distance));
        hit.is_none_or(|point| edges.distance_mm(point) >= radius)
    };
    let alike =
        vial.is_invariant() && optics.projector.is_collimated() && optics.motion.tilt_rad == 0.0;
    let rows = if alike { 1 } else { pixels.rows };
    Ok(PixelMask::new(
        [pixels.frames(), rows, pixels.columns],
        away,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::vial::square::Square;

    const VIAL: Square = Square::new(5.0, 6.0, 1.5);

    #[test]
    fn pixels_near_the_corners_of_a_square_vial_stay_dark_from_every_side() {
        // 16 frames, 80 columns of 0.1 mm, three rows
        let pixels = PatternGrid::full_turn(16, 0.05, 3, 80, 0.1);
        let optics = rays::Optics::collimated(0.1);
        let mask = corners("key", 0.7, &pixels, &VIAL, &optics).unwrap();
        let mut dark = 0;
        for (frame, &azimuth) in pixels.azimuths.iter().enumerate() {
            let (sin, cos) = azimuth.sin_cos();
            for column in 0..80 {
                let u = pixels.column_u(column);
                // The nearest of the points at which the line meets the planes of faces, within these
                let (from, along) = ([-u * sin, u * cos], [-cos, -sin]);
                let mut hits: Vec<(f64, f64)> = Vec::new();
                for axis in 0..2 {
                    for wall in [-3.0, 3.0] {
                        let t = (wall - from[axis]) / along[axis];
                        let other = from[1 - axis] + t * along[1 - axis];
                        if other.abs() <= 3.0 {
                            hits.push((t, 3.0 - other.abs()));
                        }
                    }
                }
                let first = hits.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
                let expected = first.is_none_or(|(_, from_edge)| from_edge >= 0.7);
                assert_eq!(
                    mask.allows([frame, 1, column]),
                    expected,
                    "{frame} {column}"
                );
                dark += usize::from(!expected);
            }
        }
        assert!(dark > 16 * 10, "{dark}");
    }

    #[test]
    fn a_leaning_prism_has_the_same_edges_at_all_heights() {
        let pixels = PatternGrid::full_turn(4, 0.0, 40, 40, 0.2);
        let leaning = rays::Optics::collimated(0.2).tilted(0.5);
        let mask = corners("key", 0.5, &pixels, &VIAL, &leaning).unwrap();
        assert!((0..40).all(|row| mask.allows([1, row, 20]) && !mask.allows([1, row, 5])));
    }

    #[test]
    fn a_round_vial_has_no_edges() {
        let vial = crate::optics::vial::index_matched::IndexMatched { radius_mm: 2.0 };
        let pixels = PatternGrid::full_turn(4, 0.0, 4, 4, 0.2);
        let optics = rays::Optics::collimated(0.2);
        let error = corners("key", 0.5, &pixels, &vial, &optics).unwrap_err();
        assert!(error.to_string().contains("has none"), "{error}");
    }
}
