//! Where patterns lie on the pixels of a device.
//!
//! # Equation
//! A point of a pattern has the coordinates u (right, along the columns) and z (up), mm from the middle of the pattern.
//! Its place on the device, in pixels right (X) and up (Y) of the canvas' middle, is
//!
//! ```text
//! (X, Y) = P⁻¹ · R(90°·turns + angle) · S · (u + a + w·sin(φ − α_k), z) + offset + copy
//! ```
//!
//! S = diag(±1, ±1) the flips, R a counter-clockwise turn of the image as it is looked at (row 0 on top), a the axis
//! offset, w and φ size and azimuth of the eccentricity, α_k the azimuth of frame k, P = diag(right, up) the size of a device pixel
//! at the vial. The middle of the vial is w away from the axis of the stage, at azimuth φ of the resin frame:
//! seen from α_k it lies w·sin(φ − α_k) to the right.
//!
//! # Light between pixels
//! Both grids are of rectangles on which light is even. With A_ij the area that device pixel j shares with pattern pixel i,
//! a device pixel shows the mean of the pattern over itself, and a pattern pixel gets the mean of the device over itself:
//!
//! ```text
//! forward   y_j = Σ_i A_ij x_i / |j|        back   x_i = Σ_j A_ij y_j / |i|
//! ```
//!
//! Energy is kept both ways: Σ_j |j|·y_j = Σ_i |i|·x_i while the pattern lies on the canvas. Where the grids fall on each
//! other both are exact copies; where they do not, the way there and back is a blur of about one pixel, which is what the
//! vial gets.

use super::printer::{PrinterSpec, device_pitch};
use tomolith_core::grid::PatternGrid;

/// Areas (in pattern pixels) are multiples of this, so that rounding makes no neighbors of pixels that only touch.
const GRAIN: f64 = 1e-9;
/// Device pixels by which a pattern may stand out of the canvas: rounding.
const SLACK: f64 = 1e-6;

/// Device pixels ↔ pattern pixels; see the [module page](self).
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Placing {
    /// Columns and rows of the canvas.
    pub(super) canvas: [usize; 2],
    /// Columns and rows of a pattern, and their pitches, mm.
    pub(super) pattern: [usize; 2],
    pub(super) pattern_pitch: [f64; 2],
    /// Size of a device pixel at the vial [right, up], mm.
    pub(super) pitch: [f64; 2],
    /// Turn of the image: cosine and sine.
    pub(super) turn: [f64; 2],
    /// Signs of u and z before the turn.
    pub(super) flips: [f64; 2],
    /// Pixels right and up of the canvas' middle.
    pub(super) offset: [f64; 2],
}

/// Cosine and sine of quarter turns and a further angle (degrees); exact when there is no further angle.
pub(super) fn turn(quarters: u32, degrees: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    (0..quarters % 4).fold([cos, sin], |[cos, sin], _| [-sin, cos])
}

impl Placing {
    /// A copy of patterns so many pixels right and up; without a canvas in the table, one pixel stands for it.
    pub(super) fn new(spec: &PrinterSpec, pattern: &PatternGrid, copy: [f64; 2]) -> Self {
        let sign = |flip: bool| if flip { -1.0 } else { 1.0 };
        Placing {
            canvas: spec.canvas.unwrap_or([1, 1]),
            pattern: size_of(pattern),
            pattern_pitch: pattern.pitch_mm,
            pitch: device_pitch(spec, pattern),
            turn: turn(spec.quarter_turns, spec.rotation_deg),
            flips: [sign(spec.flip_horizontal), sign(spec.flip_vertical)],
            offset: [spec.offset_px[0] + copy[0], spec.offset_px[1] + copy[1]],
        }
    }

    /// The place on the device of a point of the pattern, pixels right and up of the middle.
    pub(super) fn place_of(&self, u: f64, z: f64) -> [f64; 2] {
        let [x, y] = [self.flips[0] * u, self.flips[1] * z];
        let [cos, sin] = self.turn;
        [
            (cos * x - sin * y) / self.pitch[0] + self.offset[0],
            (sin * x + cos * y) / self.pitch[1] + self.offset[1],
        ]
    }

    /// The point of the pattern plane (u, z in mm, without the axis' offset) at a place on the device, in pixels right
    /// and up of the middle.
    pub(super) fn to_plane(&self, x: f64, y: f64) -> [f64; 2] {
        let x = (x - self.offset[0]) * self.pitch[0];
        let y = (y - self.offset[1]) * self.pitch[1];
        let [cos, sin] = self.turn;
        [
            self.flips[0] * (cos * x + sin * y),
            self.flips[1] * (cos * y - sin * x),
        ]
    }

    /// Column and row of a pattern (fractions, cell i from i to i + 1) of a corner between device pixels, when the
    /// pattern is shifted by `shift` mm along u.
    fn to_pattern(&self, column: f64, row: f64, shift: f64) -> [f64; 2] {
        let [columns, rows] = self.canvas.map(|n| n as f64);
        let [u, z] = self.to_plane(column - columns / 2.0, rows / 2.0 - row);
        [
            (u - shift) / self.pattern_pitch[0] + self.pattern[0] as f64 / 2.0,
            self.pattern[1] as f64 / 2.0 - z / self.pattern_pitch[1],
        ]
    }

    /// Half the size of the patterns, mm.
    pub(super) fn half(&self) -> [f64; 2] {
        std::array::from_fn(|i| self.pattern[i] as f64 * self.pattern_pitch[i] / 2.0)
    }

    /// Columns and rows that a canvas needs so that no pixel of a pattern is outside for these shifts.
    pub(super) fn needed(&self, shifts: [f64; 2]) -> [usize; 2] {
        let [u, z] = self.half();
        let mut reach = [0.0f64; 2];
        for shift in shifts {
            for (u, z) in [(u, z), (-u, z), (u, -z), (-u, -z)] {
                let place = self.place_of(u + shift, z);
                reach = [reach[0].max(place[0].abs()), reach[1].max(place[1].abs())];
            }
        }
        reach.map(|reach| (2.0 * reach - SLACK).ceil().max(1.0) as usize)
    }

    /// Whether two copies that are so far apart (pixels) share light.
    pub(super) fn overlap(&self, [dx, dy]: [f64; 2]) -> bool {
        let here = Placing {
            offset: [0.0; 2],
            ..self.clone()
        };
        let [u, z] = here.to_plane(dx, dy);
        let [half_u, half_z] = self.half();
        let slack = SLACK * self.pitch[0].min(self.pitch[1]);
        u.abs() < 2.0 * half_u - slack && z.abs() < 2.0 * half_z - slack
    }

    /// By which part of a pixel (right, down) patterns miss the device's pixels; None when the grids differ in pitch or
    /// are turned, so that no shift would bring them onto each other.
    pub(super) fn miss(&self, shift: f64) -> Option<[f64; 2]> {
        let [u, z] = self.pattern_pitch;
        let [right, up] = match self.turn {
            [_, 0.0] => [u, z],
            [0.0, _] => [z, u],
            _ => return None,
        };
        let differ = |a: f64, b: f64| (a / b - 1.0).abs() > 1e-9;
        if differ(self.pitch[0], right) || differ(self.pitch[1], up) {
            return None;
        }
        let corner = self.to_pattern(0.0, 0.0, shift);
        Some(corner.map(|c| c - c.round()))
    }

    /// Pairs of device and pattern pixels that share light when the pattern is shifted by `shift` mm along u.
    pub(super) fn overlaps(&self, shift: f64) -> Overlaps {
        let mut found = Overlaps {
            scale: self.pattern_pitch[0] * self.pattern_pitch[1] / (self.pitch[0] * self.pitch[1]),
            device: Vec::new(),
            ends: Vec::new(),
            pattern: Vec::new(),
            area: Vec::new(),
        };
        let ([left, right], [top, bottom]) = self.window(shift);
        let mut shared = Vec::new();
        for row in top..bottom {
            for column in left..right {
                let corner = |dx: usize, dy: usize| {
                    self.to_pattern((column + dx) as f64, (row + dy) as f64, shift)
                };
                shared.clear();
                let square = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                self.shared(&square, &mut shared);
                if !shared.is_empty() {
                    found.device.push((row * self.canvas[0] + column) as u32);
                    found.pattern.extend(shared.iter().map(|s| s.0));
                    found.area.extend(shared.iter().map(|s| s.1));
                    found.ends.push(found.area.len());
                }
            }
        }
        found
    }

    /// Columns and rows of the canvas that can hold light of the pattern.
    fn window(&self, shift: f64) -> ([usize; 2], [usize; 2]) {
        let [u, z] = self.half();
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for (u, z) in [(u, z), (-u, z), (u, -z), (-u, -z)] {
            let [x, y] = self.place_of(u + shift, z);
            let place = [
                x + self.canvas[0] as f64 / 2.0,
                self.canvas[1] as f64 / 2.0 - y,
            ];
            for axis in 0..2 {
                low[axis] = low[axis].min(place[axis]);
                high[axis] = high[axis].max(place[axis]);
            }
        }
        let range = |axis: usize| {
            let most = self.canvas[axis] as f64;
            [
                low[axis].floor().clamp(0.0, most) as usize,
                high[axis].ceil().clamp(0.0, most) as usize,
            ]
        };
        (range(0), range(1))
    }

    /// Pattern pixels under a device pixel, with the area that they share, in pattern pixels.
    fn shared(&self, square: &[[f64; 2]; 4], found: &mut Vec<(u32, f64)>) {
        let low = |axis: usize| square.iter().map(|p| p[axis]).fold(f64::INFINITY, f64::min);
        let high = |axis: usize| {
            square
                .iter()
                .map(|p| p[axis])
                .fold(f64::NEG_INFINITY, f64::max)
        };
        let (low, high) = ([low(0), low(1)], [high(0), high(1)]);
        let aligned = self.turn.contains(&0.0);
        let cells = |axis: usize| {
            let most = self.pattern[axis] as f64;
            low[axis].floor().clamp(0.0, most) as usize..high[axis].ceil().clamp(0.0, most) as usize
        };
        for row in cells(1) {
            for column in cells(0) {
                let cell = [column as f64, row as f64];
                let area = if aligned {
                    let along =
                        |axis: usize| high[axis].min(cell[axis] + 1.0) - low[axis].max(cell[axis]);
                    along(0).max(0.0) * along(1).max(0.0)
                } else {
                    area_in_cell(square, cell)
                };
                let area = (area / GRAIN).round() * GRAIN;
                if area > 0.0 {
                    // A whole number of grains near 1 is 1: copies stay exact
                    let area = if (area - 1.0).abs() < GRAIN {
                        1.0
                    } else {
                        area
                    };
                    found.push(((row * self.pattern[0] + column) as u32, area));
                }
            }
        }
    }
}

/// Area of a convex polygon inside the unit square at `cell` (Sutherland and Hodgman's clipping, then the shoelace rule).
fn area_in_cell(polygon: &[[f64; 2]], cell: [f64; 2]) -> f64 {
    let mut points = polygon.to_vec();
    for axis in 0..2 {
        for (limit, sign) in [(cell[axis], 1.0), (cell[axis] + 1.0, -1.0)] {
            let inside = |p: &[f64; 2]| sign * (p[axis] - limit);
            let mut kept = Vec::with_capacity(points.len() + 1);
            for (i, here) in points.iter().enumerate() {
                let next = &points[(i + 1) % points.len()];
                let (a, b) = (inside(here), inside(next));
                if a >= 0.0 {
                    kept.push(*here);
                }
                if (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0) {
                    let t = a / (a - b);
                    kept.push([
                        here[0] + t * (next[0] - here[0]),
                        here[1] + t * (next[1] - here[1]),
                    ]);
                }
            }
            points = kept;
            if points.len() < 3 {
                return 0.0;
            }
        }
    }
    let twice: f64 = points
        .iter()
        .enumerate()
        .map(|(i, p)| {
            let q = points[(i + 1) % points.len()];
            p[0] * q[1] - p[1] * q[0]
        })
        .sum();
    twice.abs() / 2.0
}

/// Which device pixel shares how much light with which pattern pixel.
#[derive(Clone, Debug)]
pub(super) struct Overlaps {
    /// Area of a pattern pixel in device pixels.
    scale: f64,
    /// Device pixels that share any light, and where their entries end.
    device: Vec<u32>,
    ends: Vec<usize>,
    pattern: Vec<u32>,
    area: Vec<f64>,
}

impl Overlaps {
    /// Device pixels with the range of their entries.
    fn rows(&self) -> impl Iterator<Item = (usize, std::ops::Range<usize>)> {
        self.device.iter().enumerate().map(|(i, &device)| {
            let begin = if i == 0 { 0 } else { self.ends[i - 1] };
            (device as usize, begin..self.ends[i])
        })
    }

    /// What the device must show: `put(device pixel, value)` for a pattern of one frame.
    pub(super) fn forward(&self, pattern: &[f32], mut put: impl FnMut(usize, f64)) {
        for (device, entries) in self.rows() {
            let sum: f64 = entries
                .map(|e| self.area[e] * f64::from(pattern[self.pattern[e] as usize]))
                .sum();
            put(device, sum * self.scale);
        }
    }

    /// What the pattern's pixels get of a device that shows `value(device pixel)`; added to `pattern`.
    pub(super) fn back(&self, value: impl Fn(usize) -> f64, pattern: &mut [f64]) {
        for (device, entries) in self.rows() {
            let value = value(device);
            for e in entries {
                pattern[self.pattern[e] as usize] += self.area[e] * value;
            }
        }
    }
}

/// Columns and rows of a light's patterns.
pub(super) fn size_of(grid: &PatternGrid) -> [usize; 2] {
    [grid.columns, grid.rows]
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::near;

    fn plain(canvas: [usize; 2], pattern: [usize; 2]) -> Placing {
        Placing {
            canvas,
            pattern,
            pattern_pitch: [0.1; 2],
            pitch: [0.1; 2],
            turn: turn(0, 0.0),
            flips: [1.0, 1.0],
            offset: [0.0; 2],
        }
    }

    fn shown(placing: &Placing, pattern: &[f32], shift: f64) -> Vec<f64> {
        let mut device = vec![0.0; placing.canvas[0] * placing.canvas[1]];
        placing
            .overlaps(shift)
            .forward(pattern, |j, value| device[j] = value);
        device
    }

    #[test]
    fn grids_that_fall_on_each_other_are_copied_bit_for_bit() {
        let pattern: Vec<f32> = (0..6).map(|i| (i as f32 * 0.37).sin().abs()).collect();
        let f = |i: usize| f64::from(pattern[i]);
        let placing = plain([5, 4], [3, 2]);
        let mut expected = [0.0; 20];
        for (i, at) in [6, 7, 8, 11, 12, 13].into_iter().enumerate() {
            expected[at] = f(i);
        }
        assert_eq!(shown(&placing, &pattern, 0.0), expected);
        // One pixel right and down; one pixel of axis offset moves along u
        let moved = Placing {
            offset: [1.0, -1.0],
            ..placing.clone()
        };
        assert_eq!(shown(&moved, &pattern, 0.0)[12..15], [f(0), f(1), f(2)]);
        assert_eq!(shown(&moved, &pattern, -0.1)[11..14], [f(0), f(1), f(2)]);
        // A quarter turn counter-clockwise brings the right end up
        let turned = Placing {
            turn: turn(1, 0.0),
            ..plain([2, 3], [3, 2])
        };
        assert_eq!(
            shown(&turned, &pattern, 0.0),
            [f(2), f(5), f(1), f(4), f(0), f(3)]
        );
        let flat = Placing {
            pitch: [0.1, 0.2],
            pattern_pitch: [0.2, 0.1],
            ..turned.clone()
        };
        assert_eq!(shown(&flat, &pattern, 0.0), shown(&turned, &pattern, 0.0));
        assert_eq!(flat.miss(0.0), Some([0.0, 0.0]));
        let flipped = Placing {
            flips: [-1.0, 1.0],
            ..turned
        };
        assert_eq!(
            shown(&flipped, &pattern, 0.0),
            [f(0), f(3), f(1), f(4), f(2), f(5)]
        );
    }

    #[test]
    fn light_is_neither_lost_nor_made_at_any_scale_and_angle() {
        let pattern: Vec<f32> = (0..35).map(|i| 1.0 + (i % 9) as f32).collect();
        for (pitch, pattern_pitch, degrees, quarters, shift) in [
            ([0.1; 2], [0.1; 2], 0.0, 0, 0.033),
            ([0.07; 2], [0.1; 2], 0.0, 3, 0.0),
            ([0.23; 2], [0.1; 2], 3.0, 1, -0.02),
            ([0.1; 2], [0.1; 2], -20.0, 2, 0.04),
            ([0.05, 0.08], [0.2, 0.1], 7.0, 1, 0.01),
        ] {
            let placing = Placing {
                pitch,
                pattern_pitch,
                turn: turn(quarters, degrees),
                flips: [1.0, -1.0],
                offset: [0.3, -0.4],
                ..plain([40, 40], [7, 5])
            };
            let device = shown(&placing, &pattern, shift);
            let area = |pitch: [f64; 2]| pitch[0] * pitch[1];
            let sent: f64 = device.iter().sum::<f64>() * area(pitch);
            let light: f64 = pattern.iter().map(|&v| f64::from(v)).sum();
            let wanted = light * area(pattern_pitch);
            near!(sent / wanted, 1.0, 1e-6, "{pitch:?} {degrees}");
            let mut back = vec![0.0; pattern.len()];
            placing.overlaps(shift).back(|j| device[j], &mut back);
            let got: f64 = back.iter().sum::<f64>() * area(pattern_pitch);
            assert!(got < wanted && got > 0.7 * wanted, "{got} of {wanted}");
            // An even device comes back even: every pattern pixel is covered once
            let mut even = vec![0.0; pattern.len()];
            placing.overlaps(shift).back(|_| 2.0, &mut even);
            assert!(even.iter().all(|v| (v - 2.0).abs() < 1e-6), "{even:?}");
        }
    }

    #[test]
    fn a_fifth_of_a_pixel_is_shared_four_to_one() {
        let placing = Placing {
            offset: [0.2, 0.0],
            ..plain([5, 1], [3, 1])
        };
        let device = shown(&placing, &[0.0, 1.0, 0.0], 0.0);
        for (found, expected) in device.iter().zip([0.0, 0.0, 0.8, 0.2, 0.0]) {
            assert!((found - expected).abs() < 1e-8, "{device:?}");
        }
        let miss = placing.miss(0.0).unwrap();
        near!(miss[0], -0.2, 1e-9);
        near!(miss[1], 0.0, 1e-9);
    }

    #[test]
    fn needs_grow_with_turns_and_offsets() {
        let placing = plain([1, 1], [30, 10]);
        assert_eq!(placing.needed([0.0, 0.0]), [30, 10]);
        let turned = Placing {
            turn: turn(1, 0.0),
            ..placing.clone()
        };
        assert_eq!(turned.needed([0.0; 2]), [10, 30]);
        let moved = Placing {
            offset: [-5.0, 2.0],
            ..placing.clone()
        };
        assert_eq!(moved.needed([0.0; 2]), [40, 14]);
        assert_eq!(placing.needed([-0.1, 0.3]), [36, 10]);
        assert!(placing.overlap([29.0, 0.0]) && !placing.overlap([30.0, 0.0]));
        assert!(placing.overlap([29.0, 9.0]) && !placing.overlap([0.0, -10.0]));
    }
}
