//! The print's surface in the colors of its deviation from the target: on the page, and as `print.ply`.
//!
//! Views are orthographic: a z-buffer, normals that are means over the triangles of a corner, light from the viewer's upper left.
//! A pixel is one of [`STEPS`] colors in one of [`SHADES`] shades, so that a picture stays a small PNG with a palette.

use super::figures::{FATES, bar_svg, nice_length};
use super::number::significant;
use super::picture::{Color, Picture};
use std::path::Path;
use tomolith_core::error::Result;
use tomolith_io::ply::{PlyCorners, write_ply};
use tomolith_metrics::isosurface::Isosurface;
use tomolith_metrics::surface::Deviation;

/// Colors of the deviation, and shades of each.
const STEPS: usize = 15;
const SHADES: usize = 17;
/// Index of what is not the print.
const NOTHING: u8 = 255;
/// Pixels of a view's longer edge.
const PIXELS: usize = 620;
/// Width of a view in its own units, the height follows.
const UNITS: f64 = 500.0;
/// Share of the corners whose deviation has a color of its own; those beyond have the color of the end.
const WITHIN: f64 = 0.95;
/// Ends of the colors within a power of ten.
const ENDS: [f64; 11] = [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];
/// From where the two views look: azimuth and elevation, degrees, and how that is called.
const VIEWS: [(f64, f64, &str); 2] = [
    (-60.0, 30.0, "From above (azimuth −60°, elevation 30°)"),
    (
        120.0,
        -30.0,
        "From the other side, from below (azimuth 120°, elevation −30°)",
    ),
];

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
fn color(at: f64) -> Color {
    let off = 2.0 * at - 1.0;
    let end = if off < 0.0 { FATES[3].0 } else { FATES[4].0 };
    let blend = |from: u8, to: u8| {
        (f64::from(from) + (f64::from(to) - f64::from(from)) * off.abs().min(1.0)).round() as u8
    };
    [
        blend(214, end[0]),
        blend(218, end[1]),
        blend(222, end[2]),
        255,
    ]
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
        .map(|off| {
            let [red, green, blue, _] = color(place(*off, reach));
            [red, green, blue]
        })
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

/// The section of the page.
pub(super) fn section(deviation: &Deviation, pitch_mm: f64) -> String {
    let reach = reach_um(&deviation.off_um);
    let ends = deviation
        .off_um
        .iter()
        .fold([0.0f32; 2], |[low, high], off| {
            [low.min(*off), high.max(*off)]
        });
    let length = |um: f32| {
        let um = f64::from(um);
        let voxels = crate::html::voxels(um.abs() / (1e3 * pitch_mm));
        format!("{} µm ({voxels})", significant(um.abs(), 3))
    };
    let figures: String = VIEWS
        .iter()
        .map(|(azimuth, elevation, caption)| {
            let camera = Camera::new(*azimuth, *elevation);
            format!(
                "<figure>{}<figcaption>{caption}</figcaption></figure>",
                view_svg(&camera, deviation, reach, caption)
            )
        })
        .collect();
    let ticks = [
        format!("≤ −{} µm", significant(reach, 3)),
        format!("≥ +{} µm", significant(reach, 3)),
    ];
    format!(
        "<section><h2>Where the print is off</h2><p class=\"muted\">The predicted surface, red where it is too large, blue where it is too small. It stands out by up to {} and \
         falls short by up to {}; colors end at ±{} µm, within which at least {:.0} % of its corners lie. Regions that do not print at all have no surface here, and bodies that are not printed are left out. The same surface in mm: <code>print.ply</code> (colors, and <code>deviation_um</code> at every corner) and \
         <code>print.stl</code>.</p><div class=\"pair\">{figures}</div>{}</section>",
        length(ends[1]),
        length(ends[0]),
        significant(reach, 3),
        100.0 * WITHIN,
        bar_svg(color, "deviation", "", ticks),
    )
}

/// From where a view looks.
struct Camera {
    /// To the right, up, and to the viewer.
    axes: [[f64; 3]; 3],
}

impl Camera {
    fn new(azimuth_deg: f64, elevation_deg: f64) -> Self {
        let (sin, cos) = azimuth_deg.to_radians().sin_cos();
        let (up, level) = elevation_deg.to_radians().sin_cos();
        Camera {
            axes: [
                [-sin, cos, 0.0],
                [-up * cos, -up * sin, level],
                [level * cos, level * sin, up],
            ],
        }
    }

    /// A point or direction along the view's axes.
    fn seen(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        self.axes.map(|[a, b, c]| a * x + b * y + c * z)
    }
}

/// Directions out of the surface at its corners, along the view's axes: sums over triangles, each by its area.
fn normals(surface: &Isosurface, seen: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let mut normals = vec![[0.0; 3]; seen.len()];
    for triangle in &surface.triangles {
        let [a, b, c] = triangle.map(|i| seen[i as usize]);
        let (u, v) = (
            [0, 1, 2].map(|i| b[i] - a[i]),
            [0, 1, 2].map(|i| c[i] - a[i]),
        );
        let n = [
            u[1] * v[2] - u[2] * v[1],
            u[2] * v[0] - u[0] * v[2],
            u[0] * v[1] - u[1] * v[0],
        ];
        for &corner in triangle {
            let sum = &mut normals[corner as usize];
            *sum = [0, 1, 2].map(|i| sum[i] + n[i]);
        }
    }
    normals
}

/// Light from the viewer's upper left.
const LIGHT: [f64; 3] = [-0.25, 0.25, 0.935];
/// Brightness of what the light does not reach.
const AMBIENT: f64 = 0.45;

fn brightness(normal: [f64; 3]) -> f64 {
    let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    let cosine: f64 = normal.iter().zip(LIGHT).map(|(n, l)| n * l).sum();
    if length > 0.0 {
        AMBIENT + (1.0 - AMBIENT) * (cosine / length).max(0.0)
    } else {
        AMBIENT
    }
}

/// A corner in a view: column and row in pixels, toward the viewer in mm; place on the colors' scale; brightness.
type Dot = [f64; 5];

/// A picture, and mm of its width.
fn view(camera: &Camera, deviation: &Deviation, reach_um: f64) -> (Picture, f64) {
    let surface = &deviation.surface;
    let seen: Vec<[f64; 3]> = surface
        .corners
        .iter()
        .map(|corner| camera.seen(corner.map(f64::from)))
        .collect();
    let range = |axis: usize| {
        let values = seen.iter().map(|p| p[axis]);
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| {
            [low.min(v), high.max(v)]
        })
    };
    let [[left, right], [bottom, top]] = [range(0), range(1)];
    let mm = (right - left).max(top - bottom) / (PIXELS - 2) as f64;
    if !(mm > 0.0 && mm.is_finite()) {
        return (Picture::new(1, 1, |_, _| NOTHING), 1.0);
    }
    let pixels = |length: f64| (length / mm).ceil() as usize + 2;
    let (width, height) = (pixels(right - left), pixels(top - bottom));
    let dots: Vec<Dot> = seen
        .iter()
        .zip(normals(surface, &seen))
        .zip(&deviation.off_um)
        .map(|((&[x, y, depth], normal), &off)| {
            let (column, row) = (1.0 + (x - left) / mm, 1.0 + (top - y) / mm);
            [column, row, depth, place(off, reach_um), brightness(normal)]
        })
        .collect();
    let mut canvas = Canvas {
        width,
        nearest: vec![f64::NEG_INFINITY; width * height],
        pixels: vec![NOTHING; width * height],
    };
    for triangle in &surface.triangles {
        canvas.draw(triangle.map(|i| &dots[i as usize]));
    }
    let picture = Picture {
        width,
        height,
        pixels: canvas.pixels,
    };
    (picture, mm * width as f64)
}

/// A picture in the making.
struct Canvas {
    width: usize,
    /// How near to the viewer what stands in a pixel is.
    nearest: Vec<f64>,
    pixels: Vec<u8>,
}

impl Canvas {
    /// Draws a triangle where it is nearer than what is there, if it shows its outside.
    fn draw(&mut self, [a, b, c]: [&Dot; 3]) {
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        // Rows run downwards, so what is counter-clockwise from outside has a negative area
        if area >= 0.0 {
            return;
        }
        // Centers of pixels, at whole numbers and a half, between the outermost corners
        let centers = |axis: usize| {
            let low = a[axis].min(b[axis]).min(c[axis]);
            let high = a[axis].max(b[axis]).max(c[axis]);
            (low - 0.5).ceil().max(0.0) as usize..(high + 0.5).floor() as usize
        };
        for row in centers(1) {
            for column in centers(0) {
                let (x, y) = (column as f64 + 0.5, row as f64 + 0.5);
                let share =
                    |p: &Dot, q: &Dot| ((p[0] - x) * (q[1] - y) - (p[1] - y) * (q[0] - x)) / area;
                let shares = [share(b, c), share(c, a), share(a, b)];
                if shares.iter().any(|share| *share < 0.0) {
                    continue;
                }
                let at = |i: usize| shares[0] * a[i] + shares[1] * b[i] + shares[2] * c[i];
                let pixel = row * self.width + column;
                if at(2) > self.nearest[pixel] {
                    self.nearest[pixel] = at(2);
                    self.pixels[pixel] = index(at(3), at(4));
                }
            }
        }
    }
}

/// Palette index of a place on the colors' scale and a brightness.
fn index(place: f64, brightness: f64) -> u8 {
    let step = |value: f64, count: usize| (value.clamp(0.0, 1.0) * (count - 1) as f64).round();
    let shade = step((brightness - AMBIENT) / (1.0 - AMBIENT), SHADES);
    (step(place, STEPS) * SHADES as f64 + shade) as u8
}

fn palette() -> Vec<Color> {
    let mut palette: Vec<Color> = (0..STEPS * SHADES)
        .map(|i| {
            let (step, shade) = (i / SHADES, i % SHADES);
            let share = |i: usize, count: usize| i as f64 / (count - 1) as f64;
            let brightness = AMBIENT + (1.0 - AMBIENT) * share(shade, SHADES);
            let [red, green, blue, _] = color(share(step, STEPS));
            let shaded = |channel: u8| (f64::from(channel) * brightness).round() as u8;
            [shaded(red), shaded(green), shaded(blue), 255]
        })
        .collect();
    palette.push([0; 4]);
    palette
}

/// A view with its scale bar.
fn view_svg(camera: &Camera, deviation: &Deviation, reach_um: f64, name: &str) -> String {
    let (picture, mm) = view(camera, deviation, reach_um);
    let tall = UNITS * picture.height as f64 / picture.width as f64;
    let length = nice_length(mm / 4.0);
    let (bar, y) = (UNITS * length / mm, tall + 18.0);
    format!(
        "<svg class=\"slice\" viewBox=\"0 0 {UNITS} {:.1}\" role=\"img\" aria-label=\"{name}\">\
         <image href=\"{}\" width=\"{UNITS}\" height=\"{tall:.2}\" preserveAspectRatio=\"none\"/>\
         <path class=\"scale\" d=\"M10 {y:.1}h{bar:.1}\"/><text x=\"{:.1}\" y=\"{:.1}\">{} mm</text></svg>",
        tall + 34.0,
        picture.data_uri(&palette()),
        bar + 18.0,
        y + 5.0,
        significant(length, 2),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::grid::{Volume, VolumeGrid};
    use tomolith_metrics::isosurface::isosurface;

    /// A ball round a place, too large in its upper half and too small in the lower one.
    fn ball(radius_mm: f64) -> Deviation {
        let grid = VolumeGrid::centered([30, 30, 30], 0.1);
        let depth = |i: usize| {
            let [x, y, z] = [grid.x(i % 30), grid.y(i / 30 % 30), grid.z(i / 900)];
            (1.0 + radius_mm - x.hypot(y).hypot(z)) as f32
        };
        let volume = Volume {
            values: (0..grid.len()).map(depth).collect(),
            grid: grid.clone(),
        };
        let surface = isosurface(&volume, 1.0);
        let off = |corner: &[f32; 3]| if corner[2] > 0.0 { 20.0 } else { -20.0 };
        Deviation {
            off_um: surface.corners.iter().map(off).collect(),
            surface,
            coarsened: 1,
        }
    }

    #[test]
    fn a_ball_is_a_disc_red_above_and_blue_below_and_its_near_side_is_seen() {
        let ball = ball(1.2);
        let (picture, mm) = view(&Camera::new(-60.0, 0.0), &ball, 20.0);
        let (w, h) = (picture.width, picture.height);
        assert!(
            (mm - 2.4).abs() < 0.03 && w.abs_diff(h) <= 3,
            "{mm} {w} {h}"
        );
        let filled = picture.pixels.iter().filter(|p| **p != NOTHING).count() as f64;
        let disc = std::f64::consts::PI * (1.2 / mm * w as f64).powi(2);
        assert!((filled / disc - 1.0).abs() < 0.01, "{filled} {disc}");
        let at = |x: f64, y: f64| {
            let pixel = picture.pixels[(y * h as f64) as usize * w + (x * w as f64) as usize];
            (usize::from(pixel) / SHADES, usize::from(pixel) % SHADES)
        };
        assert_eq!((at(0.5, 0.25).0, at(0.5, 0.75).0), (STEPS - 1, 0));
        // Light comes from the upper left: the far side would be dark throughout
        assert!(at(0.35, 0.3).1 > at(0.65, 0.3).1 && at(0.65, 0.3).1 > at(0.75, 0.75).1);
        // From above only red is seen, from below only blue
        for (elevation, step) in [(90.0, STEPS - 1), (-90.0, 0)] {
            let (picture, _) = view(&Camera::new(0.0, elevation), &ball, 20.0);
            let middle = picture.pixels[h / 2 * picture.width + w / 2];
            assert_eq!(usize::from(middle) / SHADES, step);
        }
    }

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
        assert_eq!((blue, red), (FATES[3].0, FATES[4].0));
        assert!(gray[..3].iter().all(|c| (200..230).contains(c)));
        assert_eq!(palette().len(), 256);
        assert_eq!(index(1.0, 1.0), 254);
    }

    #[test]
    fn nothing_to_see_is_no_trouble() {
        let empty = Deviation {
            surface: Isosurface::default(),
            off_um: Vec::new(),
            coarsened: 1,
        };
        let (picture, _) = view(&Camera::new(0.0, 0.0), &empty, 1.0);
        assert_eq!(picture.pixels, [NOTHING]);
    }
}
