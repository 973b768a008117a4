//! The middle slice for readers without a script: target, dose and error in the plane across the axis.

use super::blob::blocks;
use crate::number::{escape, significant};
use crate::picture::{Color, Picture, viridis};
use crate::{OBSTACLE, ReportData, SpeciesReport};
use std::fmt::Write as _;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::target::label;

/// Pixels of the longer edge, at most.
const PIXELS: usize = 480;

/// What a voxel becomes, against what it should: not counted, liquid as it should be, solid as it should be, missing, too much.
const FATES: [Color; 5] = [
    [0; 4],
    [140, 150, 162, 34],
    [122, 135, 151, 190],
    [47, 111, 208, 255],
    [214, 69, 80, 255],
];

/// Codes of doses end here; the next one is what is not counted.
const TOP: u8 = 254;

/// The slice half way up the part, or the grid where nothing is part.
fn middle(data: &ReportData<'_>) -> usize {
    let labels = data.first().labels;
    let [nz, ny, nx] = labels.grid.shape;
    let has_part = |z: &usize| labels.values[z * ny * nx..][..ny * nx].contains(&label::PART);
    let first = (0..nz).find(has_part);
    let last = (0..nz).rfind(has_part);
    first
        .zip(last)
        .map_or(nz / 2, |(a, b)| usize::midpoint(a, b))
}

/// Three pictures as HTML; nothing where there are no voxels.
pub(super) fn slices(data: &ReportData<'_>) -> String {
    let first = data.first();
    let grid = &first.labels.grid;
    if grid.is_empty() {
        return String::new();
    }
    let [_, ny, nx] = grid.shape;
    let (z, factor) = (middle(data), nx.max(ny).div_ceil(PIXELS));
    let plane = VolumeGrid {
        shape: [1, ny, nx],
        ..grid.clone()
    };
    let (width, height) = (nx.div_ceil(factor), ny.div_ceil(factor));
    let draw = |palette: &[Color],
                code: &(dyn Fn(&mut dyn Iterator<Item = usize>) -> u8 + Sync)| {
        let codes = blocks(&plane, factor, |rows| {
            code(&mut rows.iter().cloned().flatten().map(|i| z * ny * nx + i))
        });
        // y grows upward, rows of a picture downward
        let picture = Picture::new(width, height, |x, y| codes[(height - 1 - y) * width + x]);
        picture.data_uri(palette)
    };
    let is_resin = |i: &usize| {
        let is_obstacle = data.bodies.is_some_and(|b| b.values[*i] == OBSTACLE);
        first.labels.values[*i] != label::OUTSIDE && !is_obstacle
    };
    let shade = |voxels: &mut dyn Iterator<Item = usize>, value_of: &dyn Fn(usize) -> f64| {
        let counted = voxels.filter(is_resin).map(value_of);
        let (sum, count) = counted.fold((0.0, 0.0), |(s, n), v| (s + v, n + 1.0));
        match count > 0.0 {
            true => (sum / count * f64::from(TOP)).clamp(0.0, f64::from(TOP)) as u8,
            false => TOP + 1,
        }
    };
    let colors = |map: &dyn Fn(f64) -> Color| -> Vec<Color> {
        let color_of = |i: u8| {
            if i > TOP {
                [0; 4]
            } else {
                map(f64::from(i) / f64::from(TOP))
            }
        };
        (0..=255).map(color_of).collect()
    };
    let quantity = match first.quantity {
        "dose" => "Dose",
        _ => "Response",
    };
    let high = first.evaluation.histogram.range[1];
    let inside = |i: usize| f64::from(first.inside.values[i]);
    let response = |i: usize| f64::from(first.response.values[i]);
    let gray = colors(&|t| [122, 135, 151, 34 + (t * 156.0) as u8]);
    let pictures = [
        ("Target", draw(&gray, &|voxels| shade(voxels, &inside))),
        (
            quantity,
            draw(&colors(&viridis), &|voxels| {
                shade(voxels, &|i| response(i) / high)
            }),
        ),
        (
            "Error",
            draw(&FATES, &|voxels| {
                voxels.map(|i| fate(first, i)).max().unwrap_or(0)
            }),
        ),
    ];
    let mut out = format!("<p>The plane at z = {} mm.</p>", significant(grid.z(z), 3));
    for (name, uri) in pictures {
        // Writing into a string cannot fail
        let _ = write!(
            out,
            "<figure><img src=\"{uri}\" alt=\"{0}\" width=\"300\"><figcaption>{0}</figcaption></figure>",
            escape(name)
        );
    }
    out
}

/// Which of [`FATES`] a voxel has; of a gray target, whether it lies beyond its band.
fn fate(print: &SpeciesReport<'_>, i: usize) -> u8 {
    let response = f64::from(print.response.values[i]);
    let is_part = match print.labels.values[i] {
        label::PART => true,
        label::VOID => false,
        _ => return 0,
    };
    if let Some(half_width) = print.evaluation.half_width {
        return match response - f64::from(print.inside.values[i]) {
            off if off > half_width => 4,
            off if off < -half_width => 3,
            _ => 1 + u8::from(is_part),
        };
    }
    let is_solid = response > print.evaluation.gel_threshold.unwrap_or(f64::INFINITY);
    match (is_part, is_solid) {
        (false, false) => 1,
        (true, true) => 2,
        (true, false) => 3,
        (false, true) => 4,
    }
}
