//! Diffusion through the faces of voxels, explicit in time.
//!
//! **Equation** (Wang et al. 2022, Fig. S12: Fickian flux through the six faces, even in each voxel)
//!
//! ```text
//! O_i ← O_i + Δt·D Σ_j H(d_i, d_j)·(O_j − O_i)/h_ij²        H(a, b) = 2ab/(a + b)
//! ```
//! d: the share of D that a voxel has, 0 where there is no resin, so that no flux passes walls. Air on top of the highest voxel holds its face at a
//! value, half a voxel away: Δt·D·2d_i(air − O_i)/h². The matrix is symmetric, so the transpose is the same step with air at 0.
//!
//! **Limit** Δt ≤ 1/(D(4/h² + 2/h_z²)) ([`longest_step_s`]), h²/(6D) for cubes; with air one half-voxel face more, h²/(7D). Within it no number leaves the range of those around it.
//!
//! **Cost** per step: a volume is read about twice and one is written; 8 million voxels in some 10 ms on two cores.

use crate::domain::Domain;
use tomolith_core::field::HostField;
use tomolith_core::parallel::InParallel;

/// The longest stable step for a diffusion coefficient (mm²/s), s: 1.04 for cubes of 25 µm and 10⁻⁴ mm²/s; ∞ where nothing diffuses.
#[must_use]
pub fn longest_step_s(domain: &Domain, diffusion: f64, air: bool) -> f64 {
    let grid = domain.grid();
    let (across, along) = (grid.pitch_mm.powi(-2), grid.height_mm.powi(-2));
    // Axes of one voxel have no faces
    let faces = |n: usize| if n > 1 { 2.0 } else { 0.0 };
    let [nz, ny, nx] = grid.shape;
    let air = if air {
        2.0 - f64::from(u8::from(nz > 1))
    } else {
        0.0
    };
    let rate = (faces(nx) + faces(ny)) * across + (faces(nz) + air) * along;
    1.0 / (diffusion * rate)
}

/// One step of a diffusion coefficient, in numbers without units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step<'a> {
    domain: &'a Domain,
    /// Δt·D/h² across and along z.
    across: f32,
    along: f32,
    /// Share of D in each voxel; None: 1 everywhere.
    share: Option<&'a [f32]>,
    /// What air holds the top at.
    air: Option<f32>,
}

/// A row of voxels next to another one: values, shares of D.
type Row<'a> = (&'a [f32], Option<&'a [f32]>);

#[inline(always)]
fn harmonic(a: f32, b: f32) -> f32 {
    2.0 * a * b / (a + b).max(f32::MIN_POSITIVE)
}

/// ∂H(a, b)/∂a
#[inline(always)]
fn harmonic_slope(a: f32, b: f32) -> f32 {
    let ratio = b / (a + b).max(f32::MIN_POSITIVE);
    2.0 * ratio * ratio
}

impl<'a> Step<'a> {
    pub(crate) fn new(
        domain: &'a Domain,
        diffusion: f64,
        seconds: f64,
        share: Option<&'a [f32]>,
        air: Option<f32>,
    ) -> Self {
        let grid = domain.grid();
        let rate = diffusion * seconds;
        Step {
            domain,
            across: (rate / grid.pitch_mm.powi(2)) as f32,
            along: (rate / grid.height_mm.powi(2)) as f32,
            share: share.or(domain.resin()),
            air,
        }
    }

    /// The transpose: air at 0.
    pub(crate) fn transposed(self) -> Self {
        Step {
            air: self.air.map(|_| 0.0),
            ..self
        }
    }

    /// Calls `f(out row, row, its neighbors across)` for every row of voxels along z.
    fn each_row<'v>(
        &self,
        values: &'v [f32],
        out: &mut [f32],
        f: impl Fn(&mut [f32], Row<'v>, [Option<Row<'v>>; 4]) + Sync,
    ) where
        'a: 'v,
    {
        let layout = self.domain.layout();
        let ([nz, ny, nx], row) = (layout.grid.shape, layout.row);
        if out.is_empty() {
            return;
        }
        let share = self.share;
        let at = |y: usize, x: usize| {
            let from = (y * nx + x) * row;
            let share = share.map(|s| &s[from..from + nz]);
            (&values[from..from + nz], share)
        };
        out.chunks_mut(nx * row).enumerate().par_each(|(y, plane)| {
            for (x, out) in plane.chunks_exact_mut(row).enumerate() {
                let neighbors = [
                    (x > 0).then(|| at(y, x - 1)),
                    (x + 1 < nx).then(|| at(y, x + 1)),
                    (y > 0).then(|| at(y - 1, x)),
                    (y + 1 < ny).then(|| at(y + 1, x)),
                ];
                f(&mut out[..nz], at(y, x), neighbors);
            }
        });
    }

    /// out ← the step of `values`.
    pub(crate) fn apply(&self, values: &HostField, out: &mut HostField) {
        let (across, along) = (self.across, self.along);
        let air = self.air;
        self.each_row(
            values.as_slice(),
            out.as_mut_slice(),
            |out, (values, share), neighbors| match share {
                None => even_row(out, values, neighbors, [across, along], air),
                Some(share) => uneven_row(out, values, share, neighbors, [across, along], air),
            },
        );
    }

    /// grad_share ← what the shares of D are worth, for a step of `values` whose result has this cotangent.
    pub(crate) fn pull_share(
        &self,
        values: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
    ) {
        let Some(share) = self.share else { return };
        let (across, along, air) = (self.across, self.along, self.air);
        let layout = self.domain.layout();
        let ([nz, ny, nx], row) = (layout.grid.shape, layout.row);
        let (v, c) = (values.as_slice(), cotangent.as_slice());
        let worth =
            |i: usize, j: usize| harmonic_slope(share[i], share[j]) * (v[j] - v[i]) * (c[i] - c[j]);
        let grad = grad.as_mut_slice().chunks_mut(nx * row).enumerate();
        grad.par_each(|(y, plane)| {
            for (at, grad) in plane.iter_mut().enumerate() {
                let (x, z) = (at / row, at % row);
                *grad = 0.0;
                if z >= nz {
                    continue;
                }
                let i = y * nx * row + at;
                let mut sum = 0.0;
                if x > 0 {
                    sum += across * worth(i, i - row);
                }
                if x + 1 < nx {
                    sum += across * worth(i, i + row);
                }
                if y > 0 {
                    sum += across * worth(i, i - nx * row);
                }
                if y + 1 < ny {
                    sum += across * worth(i, i + nx * row);
                }
                if z > 0 {
                    sum += along * worth(i, i - 1);
                }
                if z + 1 < nz {
                    sum += along * worth(i, i + 1);
                } else if let Some(air) = air {
                    sum += 2.0 * along * (air - v[i]) * c[i];
                }
                *grad = sum;
            }
        });
    }
}

fn even_row(
    out: &mut [f32],
    values: &[f32],
    neighbors: [Option<Row<'_>>; 4],
    [across, along]: [f32; 2],
    air: Option<f32>,
) {
    out.copy_from_slice(values);
    for (other, _) in neighbors.into_iter().flatten() {
        for ((out, &value), &other) in out.iter_mut().zip(values).zip(other) {
            *out += across * (other - value);
        }
    }
    let n = values.len();
    for ((out, &value), &above) in out.iter_mut().zip(values).zip(&values[1..]) {
        *out += along * (above - value);
    }
    for ((out, &value), &below) in out[1..].iter_mut().zip(&values[1..]).zip(values) {
        *out += along * (below - value);
    }
    if let Some(air) = air {
        out[n - 1] += 2.0 * along * (air - values[n - 1]);
    }
}

fn uneven_row(
    out: &mut [f32],
    values: &[f32],
    share: &[f32],
    neighbors: [Option<Row<'_>>; 4],
    [across, along]: [f32; 2],
    air: Option<f32>,
) {
    out.copy_from_slice(values);
    for (other, of_other) in neighbors.into_iter().flatten() {
        let of_other = of_other.unwrap_or(share);
        let there = other.iter().zip(of_other);
        for (((out, &value), &d), (&other, &e)) in out.iter_mut().zip(values).zip(share).zip(there)
        {
            *out += across * harmonic(d, e) * (other - value);
        }
    }
    for i in 1..values.len() {
        let flux = along * harmonic(share[i - 1], share[i]) * (values[i] - values[i - 1]);
        out[i - 1] += flux;
        out[i] -= flux;
    }
    if let (Some(air), Some(last)) = (air, values.len().checked_sub(1)) {
        out[last] += 2.0 * along * share[last] * (air - values[last]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::check::noise;
    use tomolith_core::field::Field;
    use tomolith_core::grid::{Volume, VolumeGrid};
    use tomolith_core::near;

    /// Noise on the voxels, 0 in the padding.
    fn noise_on(domain: &Domain, seed: u64) -> HostField {
        let grid = domain.grid().clone();
        let values = noise(seed, grid.len());
        HostField::from_slice(&domain.layout().field_of(&Volume { grid, values }))
    }

    fn walled() -> Domain {
        let grid = VolumeGrid::centered([7, 6, 5], 0.05);
        let mut resin = Volume::filled(grid.clone(), true);
        for i in [0, 3, 17, 55, 56, 120, 209] {
            resin.values[i] = false;
        }
        Domain::new(grid)
            .with_walls(&resin)
            .unwrap()
            .with_air_on_top()
    }

    #[test]
    fn a_point_spreads_by_2dt_along_each_axis_and_keeps_its_mass() {
        // h²/(6D) = 4.17 s: 40 steps of 1 s
        let grid = VolumeGrid {
            height_mm: 0.04,
            ..VolumeGrid::centered([29, 27, 27], 0.05)
        };
        let domain = Domain::new(grid);
        let (mut now, mut next) = (domain.zeros(), domain.zeros());
        now.as_mut_slice()[domain.layout().index(14, 13, 13)] = 1.0;
        let step = Step::new(&domain, 1e-4, 1.0, None, None);
        for _ in 0..40 {
            step.apply(&now, &mut next);
            std::mem::swap(&mut now, &mut next);
        }
        let volume = domain.layout().volume_of(now.as_slice());
        let (mut mass, mut variance) = (0.0, [0.0; 3]);
        for (i, &v) in volume.values.iter().enumerate() {
            mass += f64::from(v);
            for (sum, at) in variance.iter_mut().zip(volume.grid.middle(i)) {
                *sum += f64::from(v) * at * at;
            }
        }
        assert!((mass - 1.0).abs() < 1e-6, "{mass}");
        // 2Dt = 8e-3 mm²: the scheme has this variance exactly
        for v in variance {
            assert!((v / 8e-3 - 1.0).abs() < 1e-3, "{variance:?}");
        }
    }

    #[test]
    fn within_the_limit_nothing_leaves_its_range_beyond_it_it_does() {
        let closed = Domain::new(VolumeGrid::centered([6; 3], 0.05));
        for (domain, air) in [(closed.clone(), false), (closed.with_air_on_top(), true)] {
            let limit = longest_step_s(&domain, 1e-4, air);
            let expected = 0.05 * 0.05 / (if air { 7.0 } else { 6.0 } * 1e-4);
            assert!((limit - expected).abs() < 1e-9);
            for (seconds, stays) in [(0.999 * limit, true), (1.2 * limit, false)] {
                // The worst start: a checkerboard
                let mut now = domain.zeros();
                for i in 0..216 {
                    let (z, y, x) = (i / 36, i / 6 % 6, i % 6);
                    now.as_mut_slice()[domain.layout().index(z, y, x)] =
                        f32::from((x + y + z) % 2 == 1);
                }
                let mut next = domain.zeros();
                Step::new(&domain, 1e-4, seconds, None, air.then_some(1.0)).apply(&now, &mut next);
                let inside = domain.layout().volume_of(next.as_slice());
                let ok = inside
                    .values
                    .iter()
                    .all(|v| (-1e-6..=1.0 + 1e-6).contains(v));
                assert_eq!(ok, stays, "air {air}, {seconds} s");
            }
        }
    }

    #[test]
    fn walls_keep_what_is_behind_them_air_fills_up() {
        let domain = walled();
        let mut now = domain.even(1.0);
        // Nothing flows where all is even, and none enters the walls
        let mut next = domain.zeros();
        let step = Step::new(&domain, 1e-4, 3.0, None, Some(1.0));
        step.apply(&now, &mut next);
        assert_eq!(now.as_slice(), next.as_slice());
        // Mass of the resin is kept without air; with air it ends at 1
        now = noise_on(&domain, 3);
        domain.only_resin(&mut now);
        let closed = Step::new(&domain, 1e-4, 3.0, None, None);
        let before = now.dot(&domain.even(1.0));
        closed.apply(&now, &mut next);
        assert!((next.dot(&domain.even(1.0)) - before).abs() < 1e-5);
        for _ in 0..1500 {
            step.apply(&now, &mut next);
            std::mem::swap(&mut now, &mut next);
        }
        let resin = domain.even(1.0);
        let off = crate::fixtures::apart(&now, &resin);
        assert!(off < 1e-3, "{off}");
    }

    #[test]
    fn the_step_is_symmetric_and_the_derivative_by_shares_right() {
        let domain = walled();
        let resin = domain.even(1.0);
        let mut share = noise_on(&domain, 5);
        share.zip_blocks(&resin, |v, r| (0.6 + 0.3 * v) * r);
        let (a, b) = (noise_on(&domain, 1), noise_on(&domain, 2));
        let (mut fa, mut fb) = (domain.zeros(), domain.zeros());
        let step = Step::new(&domain, 1e-4, 3.0, Some(share.as_slice()), Some(0.0));
        step.apply(&a, &mut fa);
        step.transposed().apply(&b, &mut fb);
        assert!((fa.dot(&b) - a.dot(&fb)).abs() < 1e-5);
        // Shares: a central difference along noise
        let step = Step {
            air: Some(1.0),
            ..step
        };
        let mut grad = domain.zeros();
        step.pull_share(&a, &b, &mut grad);
        let mut along = noise_on(&domain, 9);
        domain.only_resin(&mut along);
        let value = |e: f32| {
            let mut share = share.clone();
            share.axpy(e, &along);
            let mut out = domain.zeros();
            Step {
                share: Some(share.as_slice()),
                ..step
            }
            .apply(&a, &mut out);
            out.dot(&b)
        };
        let difference = (value(0.02) - value(-0.02)) / 0.04;
        let exact = grad.dot(&along);
        near!(difference, exact, 2e-3 * exact.abs().max(0.1));
    }
}
