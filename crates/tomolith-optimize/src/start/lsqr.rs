//! LSQR: patterns whose dose comes near the wanted one in the sense of least squares, negative values cut off.
//!
//! **Equation** the first `iterations` steps of
//!
//! ```text
//! min over x   Σ over voxels that count (F x − d)² + damping²·σ²·‖x‖²,   d = M⁻¹(target),   then x = c·max(x, 0)
//! ```
//! σ is ‖Fᵀd‖/‖d‖, so that `damping` has no unit; c makes the dose of the part right (least squares, one forward call). Few
//! iterations are wanted: what fits the target better and better does so with negative light.
//!
//! **Source** Paige and Saunders, ACM Trans. Math. Softw. 8, 43 (1982), the bidiagonalization and plane rotations of §4.
//!
//! **Parameters** see [`Params`]. **Limits** linear models only. **Cost** one adjoint and one forward call an iteration, two
//! fields of patterns and one of dose.

use super::{BuildStart, InitialPatterns, StartInput};
use tomolith_core::dose::Work;
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::grid::Volume;
use tomolith_core::kind::{Kind, schema_of};
use tomolith_core::target::label;

tomolith_core::keys! {
    /// The parameters of LSQR.
    pub struct Params {
        /// Steps.
        #[schemars(range(min = 1, max = 1000))]
        pub iterations: usize = 8,
        /// Weight of small patterns, relative to the size of the model.
        #[schemars(range(min = 0.0))]
        pub damping: f64 = 0.0,
    }
}

/// Least squares by LSQR.
#[derive(Clone, Debug)]
pub struct Lsqr(Params);

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildStart<F>> {
    Kind {
        name: "lsqr",
        summary: "least squares between dose and target, a few steps of LSQR, negative values cut off",
        example: "[start.lsqr]\niterations = 8\ndamping = 0.0",
        schema: schema_of::<Params>,
        build: |section| Ok(Box::new(Lsqr(section.parse()?))),
    }
}

/// The model on the voxels that count.
struct Masked<'a, F: Field> {
    input: &'a StartInput<'a, F>,
    counts: F,
    work: &'a Work,
}

impl<F: Field> Masked<'_, F> {
    fn dose(&self, x: &F, out: &mut F) -> Result<()> {
        self.input.model.dose(x, out, self.work)?;
        out.multiply(&self.counts);
        Ok(())
    }

    fn pullback(&self, dose: &F, out: &mut F) -> Result<()> {
        let anywhere = out.zeros_like();
        self.input.model.pullback(&anywhere, dose, out, self.work)
    }
}

impl<F: Field> InitialPatterns<F> for Lsqr {
    fn patterns(&self, input: &StartInput<F>, work: &Work) -> Result<F> {
        input.require_linear("lsqr")?;
        let wanted = input.wanted_dose()?;
        let labels = Volume::new(
            input.labels.grid.clone(),
            input
                .labels
                .values
                .iter()
                .map(|&l| f32::from(u8::from(l != label::OUTSIDE)))
                .collect(),
        );
        let mut counts = input.model.new_dose()?;
        for layout in input.model.outputs() {
            counts.write(layout.offset, &layout.field_of(&labels));
        }
        let masked = Masked {
            input,
            counts,
            work,
        };
        let mut x = self.solve(&masked, &wanted)?;
        x.clamp(0.0, f32::INFINITY);
        input.scaled(x, &wanted, work)
    }
}

impl Lsqr {
    /// The names are those of the paper.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn solve<F: Field>(&self, a: &Masked<'_, F>, b: &F) -> Result<F> {
        let mut x = a.input.model.new_patterns()?;
        let mut u = b.clone();
        let mut beta = unit(&mut u);
        let mut v = x.zeros_like();
        a.pullback(&u, &mut v)?;
        let mut alpha = unit(&mut v);
        if beta * alpha == 0.0 {
            return Ok(x);
        }
        let damping = self.0.damping * alpha;
        let mut w = v.clone();
        let (mut next_u, mut next_v) = (b.zeros_like(), x.zeros_like());
        let (mut phi_bar, mut rho_bar) = (beta, alpha);
        for _ in 0..self.0.iterations {
            a.dose(&v, &mut next_u)?;
            u.scale(-alpha as f32);
            u.axpy(1.0, &next_u);
            beta = unit(&mut u);
            a.pullback(&u, &mut next_v)?;
            v.scale(-beta as f32);
            v.axpy(1.0, &next_v);
            alpha = unit(&mut v);
            // The damping is one more rotation
            let rho_damped = rho_bar.hypot(damping);
            phi_bar *= rho_bar / rho_damped;
            let rho = rho_damped.hypot(beta);
            let (c, s) = (rho_damped / rho, beta / rho);
            let theta = s * alpha;
            rho_bar = -c * alpha;
            let phi = c * phi_bar;
            phi_bar *= s;
            x.axpy((phi / rho) as f32, &w);
            w.scale((-theta / rho) as f32);
            w.axpy(1.0, &v);
            if alpha == 0.0 || beta == 0.0 {
                break;
            }
        }
        Ok(x)
    }
}

/// Scales to norm 1; returns the norm there was.
#[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
fn unit<F: Field>(field: &mut F) -> f64 {
    let norm = field.norm();
    if norm > 0.0 {
        field.scale((1.0 / norm) as f32);
    }
    norm
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::reference::FREE;
    use tomolith_core::field::HostField;
    use tomolith_core::grid::{PatternGrid, VolumeGrid};
    use tomolith_core::near;

    use tomolith_core::target::Target;
    use tomolith_io::csr::Csr;
    use tomolith_models::matrix::MatrixModel;

    /// min ‖Ax − d‖² + λ²‖x‖² of a 4 × 3 matrix, by its normal equations: Cramer's rule.
    fn by_hand(a: [[f64; 3]; 4], d: [f64; 4], lambda: f64) -> [f64; 3] {
        let mut m = [[0.0; 3]; 3];
        let mut r = [0.0; 3];
        for i in 0..3 {
            for j in 0..3 {
                m[i][j] = (0..4).map(|k| a[k][i] * a[k][j]).sum();
            }
            m[i][i] += lambda * lambda;
            r[i] = (0..4).map(|k| a[k][i] * d[k]).sum();
        }
        let determinant = |m: [[f64; 3]; 3]| {
            m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
                - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
                + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
        };
        std::array::from_fn(|column| {
            let mut replaced = m;
            for row in 0..3 {
                replaced[row][column] = r[row];
            }
            determinant(replaced) / determinant(m)
        })
    }

    #[test]
    fn three_steps_solve_three_unknowns() {
        let a = [
            [1.0, 0.2, 0.0],
            [0.1, 1.5, 0.3],
            [0.0, 0.4, 0.8],
            [0.5, 0.1, 0.6],
        ];
        let entries: Vec<(u32, u32, f32)> = (0..12)
            .map(|i| (i / 3, i % 3, a[i as usize / 3][i as usize % 3] as f32))
            .collect();
        let csr = Csr::from_entries(4, 3, &entries);
        let grid = VolumeGrid::centered([1, 2, 2], 0.1);
        let pixels = PatternGrid::full_turn(1, 0.0, 1, 3, 0.1);
        let model = MatrixModel::new(&csr, vec![pixels], grid.clone()).unwrap();
        let wanted = [1.0, 0.5, 0.25, 0.75];
        let target = Target {
            name: String::new(),
            inside: Volume::new(grid.clone(), wanted.map(|v| v as f32).to_vec()),
            gray: true,
        };
        let labels = Volume::filled(grid, label::PART);
        let input = StartInput::new(&model, &target, &labels, &FREE);
        let work = Work::new();
        let masked = Masked {
            input: &input,
            counts: HostField::from_slice(&[1.0; 4]),
            work: &work,
        };
        let d = HostField::from_slice(&wanted.map(|v| v as f32));
        // ‖Aᵀd‖/‖d‖: what `damping` is relative to
        let size = {
            let back: [f64; 3] = std::array::from_fn(|j| (0..4).map(|k| a[k][j] * wanted[k]).sum());
            let norm = |v: &[f64]| v.iter().map(|v| v * v).sum::<f64>().sqrt();
            norm(&back) / norm(&wanted)
        };
        for damping in [0.0, 0.7] {
            let lsqr = Lsqr(Params {
                iterations: 3,
                damping,
            });
            let x = lsqr.solve(&masked, &d).unwrap();
            for (found, expected) in x.as_slice().iter().zip(by_hand(a, wanted, damping * size)) {
                near!(f64::from(*found), expected, 1e-5, "damping {damping}");
            }
        }
    }
}
