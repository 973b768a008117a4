//! One collimated ray through a z-invariant vial.
//!
//! # Model
//! The ray starts outside at lateral coordinate u, travels along −(cos α, sin α) in the resin frame, and is refracted at
//! every wall (Snell), losing power there (Fresnel, each polarization for itself). Where it runs through resin it leaves
//! a [`PlanarSegment`]: a straight piece along which Beer–Lambert holds. Reflected light is lost; the [`PowerBalance`] says how much.
//! A [`Bath`] weakens it on the way to the vial.
//!
//! # Example
//! A ray through the middle of an index-matched cylinder of radius 6 mm runs 12 mm through resin:
//! ```
//! use tomolith_optics::interface::Polarization;
//! use tomolith_optics::resin::Resin;
//! use tomolith_optics::trace::Tracer;
//! use tomolith_optics::vial::index_matched::IndexMatched;
//! let tracer = Tracer::new(&IndexMatched { radius_mm: 6.0 }, Resin::absorbing(1.5, 0.1), 1.0, Polarization::S);
//! let path = tracer.trace(0.0, 0.0);
//! assert_eq!(path.segments[0].from, [6.0, 0.0]); // azimuth 0: light comes from +x
//! assert!((path.segments[0].length - 12.0).abs() < 1e-12);
//! assert!((path.balance.absorbed - (1.0 - (-1.2f64).exp())).abs() < 1e-12); // Beer–Lambert
//! ```

use super::interface::{Polarization, Transmittance, refract};
use super::power_balance::PowerBalance;
use super::resin::Resin;
use super::vial::{CrossSection, Medium, Vial, Wall};

/// A straight piece of a ray through resin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarSegment {
    /// Where it enters the resin, mm.
    pub from: [f64; 2],
    /// Unit direction of travel.
    pub direction: [f64; 2],
    /// Length, mm.
    pub length: f64,
    /// Power at `from` per emitted power: all walls and all resin before it.
    pub power: f64,
}

/// What surrounds the vial, up to a round wall about the axis, and absorbs. Light enters it as it would enter nothing: its
/// container is index-matched or flat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bath {
    /// Napierian absorption, 1/mm, ≥ 0.
    pub absorption_per_mm: f64,
    /// Where it ends, mm from the axis.
    pub radius_mm: f64,
}

impl Bath {
    /// Way through the bath of a ray that starts outside at `position` and meets the vial after `distance` mm.
    fn way(self, position: [f64; 2], direction: [f64; 2], distance: f64) -> f64 {
        let entry = CrossSection::Circle(self.radius_mm).enter(position, direction);
        entry.map_or(0.0, |(entry, ..)| (distance - entry).max(0.0))
    }
}

/// What became of one ray.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlanarPath {
    /// Pieces in resin, in order of travel.
    pub segments: Vec<PlanarSegment>,
    /// Power balance.
    pub balance: PowerBalance,
    /// The walls and faces passed, in order: rays of equal class form one smooth bundle.
    pub class: Vec<u8>,
}

/// Traces rays through one vial.
#[derive(Clone, Debug)]
pub struct Tracer {
    walls: Vec<Wall>,
    /// Refractive index outside and inside each wall.
    indices: Vec<f64>,
    resin: Resin,
    polarization: Polarization,
    bath: Option<Bath>,
}

/// A bounded number of walls can be met by a ray that is never reflected.
const MOST_CROSSINGS: usize = 64;

impl Tracer {
    /// A tracer for a vial with this resin in surroundings of index `surrounding`.
    #[must_use]
    pub fn new(
        vial: &dyn Vial,
        resin: Resin,
        surrounding: f64,
        polarization: Polarization,
    ) -> Self {
        let walls = vial.walls();
        let outside = vial.surrounding_index(surrounding, resin.refractive_index);
        let indices = std::iter::once(outside)
            .chain(walls.iter().map(|wall| match wall.inside {
                Medium::Resin => resin.refractive_index,
                Medium::Clear(n) => n,
            }))
            .collect();
        Tracer {
            walls,
            indices,
            resin,
            polarization,
            bath: None,
        }
    }

    /// The same vial in an absorbing bath.
    #[must_use]
    pub fn in_bath(mut self, bath: Option<Bath>) -> Self {
        self.bath = bath;
        self
    }

    /// The ray at lateral coordinate `u` (mm) of a frame from `azimuth` (rad).
    #[must_use]
    pub fn trace(&self, u: f64, azimuth: f64) -> PlanarPath {
        let (sin, cos) = azimuth.sin_cos();
        let vial = self.walls.first();
        let vial = vial.map_or(1.0, |wall| wall.curve.inscribed_radius());
        let far = 4.0 * self.bath.map_or(vial, |bath| bath.radius_mm.max(vial));
        let mut position = [far * cos - u * sin, far * sin + u * cos];
        let mut direction = [-cos, -sin];
        let mut power = self.polarization.split();
        let mut path = PlanarPath::default();
        let mut depth = 0; // number of walls around the ray

        for _ in 0..MOST_CROSSINGS {
            let Some(hit) = self.next_wall(position, direction, depth) else {
                break;
            };
            if let (true, Some(bath)) = (path.class.is_empty(), self.bath) {
                let way = bath.way(position, direction, hit.distance);
                let loss = -(-bath.absorption_per_mm * way).exp_m1();
                path.balance.bath += loss * (power.s + power.p);
                power.s *= 1.0 - loss;
                power.p *= 1.0 - loss;
            }
            if depth > 0 && self.walls[depth - 1].inside == Medium::Resin {
                self.cross_resin(position, direction, hit.distance, &mut power, &mut path);
            }
            for axis in 0..2 {
                position[axis] += hit.distance * direction[axis];
            }
            let (n1, n2) = (self.indices[depth], self.indices[hit.depth_after]);
            let Some((bent, passed)) = refract(direction, hit.normal, n1, n2) else {
                path.balance.reflected += power.s + power.p;
                power = Transmittance { s: 0.0, p: 0.0 };
                path.class.push(u8::MAX);
                break;
            };
            path.balance.reflected += power.s * (1.0 - passed.s) + power.p * (1.0 - passed.p);
            power = Transmittance {
                s: power.s * passed.s,
                p: power.p * passed.p,
            };
            direction = bent;
            depth = hit.depth_after;
            path.class.push(hit.face);
        }
        let left = power.s + power.p;
        if path.segments.is_empty() {
            path.balance.missed += left;
        } else {
            path.balance.transmitted += left;
        }
        path
    }

    /// What light of power 1 leaves along `length` mm of resin: 1 − e^(−μ_t·length), or the length in pure Radon mode.
    #[must_use]
    pub fn deposit(&self, length: f64) -> f64 {
        if self.resin.pure_radon {
            length
        } else {
            -(-self.resin.attenuation_per_mm * length).exp_m1()
        }
    }

    fn cross_resin(
        &self,
        from: [f64; 2],
        direction: [f64; 2],
        length: f64,
        power: &mut Transmittance,
        path: &mut PlanarPath,
    ) {
        path.segments.push(PlanarSegment {
            from,
            direction,
            length,
            power: power.s + power.p,
        });
        let loss = -(-self.resin.attenuation_per_mm * length).exp_m1();
        path.balance.absorbed += loss * (power.s + power.p);
        power.s *= 1.0 - loss;
        power.p *= 1.0 - loss;
    }

    /// The next wall a ray meets: the one around it, or the one it encloses.
    fn next_wall(&self, position: [f64; 2], direction: [f64; 2], depth: usize) -> Option<Hit> {
        let inward = self.walls.get(depth).and_then(|wall| {
            let (distance, normal, face) = wall.curve.enter(position, direction)?;
            Some(Hit {
                distance,
                normal,
                depth_after: depth + 1,
                face: tag(depth, face),
            })
        });
        if inward.is_some() || depth == 0 {
            return inward;
        }
        let (distance, normal, face) = self.walls[depth - 1].curve.leave(position, direction)?;
        Some(Hit {
            distance,
            normal,
            depth_after: depth - 1,
            face: tag(depth - 1, face) + 128,
        })
    }
}

struct Hit {
    distance: f64,
    /// Unit normal against the ray.
    normal: [f64; 2],
    depth_after: usize,
    face: u8,
}

/// The number of a face among those of all walls.
fn tag(wall: usize, face: u8) -> u8 {
    debug_assert!(face < CrossSection::MOST_FACES, "no room for face {face}");
    (wall as u8) * CrossSection::MOST_FACES + face
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vial::{
        cylinder::Cylinder, double_tube::DoubleTube, index_matched::IndexMatched, square::Square,
    };
    use tomolith_core::near;

    fn vials() -> Vec<Box<dyn Vial>> {
        vec![
            Box::new(IndexMatched { radius_mm: 6.0 }),
            Box::new(Cylinder::new(8.0, 8.7, 1.58)),
            Box::new(Square::new(10.0, 12.4, 1.54)),
            Box::new(DoubleTube::new(
                [7.354, 6.363, 3.18, 2.58],
                [1.5, 1.5, 1.33],
            )),
        ]
    }

    #[test]
    fn power_is_accounted_for_in_every_vial_and_polarization() {
        for vial in vials() {
            for polarization in [Polarization::Unpolarized, Polarization::S, Polarization::P] {
                let tracer = Tracer::new(
                    vial.as_ref(),
                    Resin::absorbing(1.4849, 0.1),
                    1.0,
                    polarization,
                );
                for i in 0..400 {
                    let balance = tracer
                        .trace(-10.0 + 0.05 * f64::from(i) + 1e-3, 0.3)
                        .balance;
                    near!(balance.total(), 1.0, 1e-12, "{vial:?} {balance:?}");
                }
            }
        }
    }

    #[test]
    fn a_bath_weakens_light_up_to_the_vial() {
        let bath = Bath {
            absorption_per_mm: 0.15,
            radius_mm: 12.0,
        };
        for vial in vials() {
            let resin = Resin::absorbing(1.4849, 0.1);
            let clear = Tracer::new(vial.as_ref(), resin, 1.33, Polarization::S);
            let absorbing = clear.clone().in_bath(Some(bath));
            for u in [-3.0f64, 0.0, 2.5] {
                let (a, b) = (clear.trace(u, 0.0), absorbing.trace(u, 0.0));
                assert!((b.balance.total() - 1.0).abs() < 1e-12);
                // Light comes from +x: it enters the bath at √(R² − u²), a round vial at √(r² − u²)
                let outer = vial.walls()[0].curve.half_chord(0, u.abs());
                let way = (12.0f64.powi(2) - u * u).sqrt() - outer.unwrap();
                let expected = a.segments[0].power * (-0.15 * way).exp();
                near!(b.segments[0].power, expected, 1e-12, "{vial:?} {u}");
            }
        }
    }

    #[test]
    fn bouguer_invariant_holds_in_the_cylinder() {
        let (n_r, n_s) = (1.4849, 1.0);
        let vial = Cylinder::new(8.0, 8.7, 1.58);
        let tracer = Tracer::new(&vial, Resin::absorbing(n_r, 0.1), n_s, Polarization::S);
        for u in [-8.5, -5.0, -0.1, 0.0, 2.0, 7.9, 8.6] {
            let segment = tracer.trace(u, 1.1).segments[0];
            let b = segment.from[0] * segment.direction[1] - segment.from[1] * segment.direction[0];
            near!(n_r * b.abs(), n_s * f64::abs(u), 1e-9, "u = {u}: {b}");
        }
    }

    #[test]
    fn a_double_tube_is_lit_before_and_behind_its_inner_tube() {
        let vials = vials();
        let tracer = Tracer::new(
            vials[3].as_ref(),
            Resin::absorbing(1.48, 0.1),
            1.0,
            Polarization::S,
        );
        let path = tracer.trace(0.0, 0.0);
        assert_eq!(path.segments.len(), 2);
        for segment in &path.segments {
            assert!((segment.length - (6.363 - 3.18)).abs() < 1e-9);
        }
        // Between the segments: two glass walls and two faces of the core, all at normal incidence
        let fresnel = |a: f64, b: f64| 1.0 - ((a - b) / (a + b)).powi(2);
        let walls = fresnel(1.48, 1.5).powi(2) * fresnel(1.5, 1.33).powi(2);
        let expected = path.segments[0].power * (-0.1 * path.segments[0].length).exp() * walls;
        assert!((path.segments[1].power - expected).abs() < 1e-12);
    }

    #[test]
    fn absorbed_fractions_agree_with_another_program() {
        // Dr.TVAM 0.9.0, one pixel, regular sampling; its (n_s/n_resin)² factor divided out.
        // cylinder 7.5/8 mm, 1.54/1.49, μ 0.1; square 10.191/12.408 mm, 1.54/1.347, μ 0.03; index-matched 7.5 mm, μ 0.1
        let cylinder = Cylinder::new(7.5, 8.0, 1.54);
        let square = Square::new(10.191, 12.408, 1.54);
        let matched = IndexMatched { radius_mm: 7.5 };
        type Case<'a> = (&'a dyn Vial, f64, f64, [f64; 4], [f64; 4]);
        let even = [0.0, 2.0, 4.0, 6.0];
        let cases: [Case<'_>; 3] = [
            (
                &matched,
                1.49,
                0.1,
                even,
                [0.776853, 0.764400, 0.718838, 0.593442],
            ),
            (
                &cylinder,
                1.49,
                0.1,
                even,
                [0.334011, 0.331635, 0.323445, 0.303546],
            ),
            (
                &square,
                1.347,
                0.03,
                [0.0, 2.0, 4.0, 6.5],
                [0.137991, 0.137991, 0.137991, 0.0],
            ),
        ];
        for (vial, n, mu, places, rows) in cases {
            let tracer = Tracer::new(
                vial,
                Resin::absorbing(n, mu),
                1.0,
                Polarization::Unpolarized,
            );
            let factor = if vial.walls().len() == 1 { 1.0 } else { n * n };
            for (u, published) in places.into_iter().zip(rows) {
                let absorbed = tracer.trace(u, 0.0).balance.absorbed;
                near!(absorbed, published * factor, 2e-3, "{vial:?} u = {u}");
            }
        }
    }
}
