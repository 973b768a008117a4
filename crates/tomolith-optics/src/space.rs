//! One ray through any vial, in space.
//!
//! # Model
//! A vial is a nest of closed surfaces, from outside to inside. At each the ray is bent (Snell) and split (Fresnel); in
//! the resin it leaves [`PathSegment`]s along which Beer–Lambert holds. Rays that are not normal to the axis meet walls whose
//! planes of incidence differ, so polarization is followed as a field vector: at an interface its component along
//! ŝ = d×n and the one along p̂ = d×ŝ pass with √T_s and √T_p. Unpolarized light is two such fields of half the power.
//!
//! With [`TraceLimits::reflections`] the reflected part is followed too, through all orders down to `TraceLimits::least_power` of
//! what was emitted; else it is lost. Total reflection keeps all power; the phase between s and p that it adds is not followed.
//!
//! # Scattering
//! With [`SpaceTracer::in_scattering`] and a stream of random numbers, light leaves its expected absorption all along its way from
//! surface to surface, and what it loses to scattering goes on from one point of that way. A way is one segment, or the pieces of it in
//! which the resin differs; a piece of length L scatters P·(μ_s/μ_t)·(1 − e^(−μ_t·L)) of its power P, exactly. The power that goes on is
//! the sum, the piece is drawn by its part of it, the distance in it from the free paths below L, the direction from the phase function:
//! the point has the density μ_s·e^(−∫μ_t) of the map as it is given, and no free path is followed in vain. So the unscattered light
//! is exact, and only what was scattered is random. Below `TraceLimits::least_power` a path lives on with the probability
//! power/least_power (Russian roulette), and so does what is reflected. Scattered light is unpolarized; in a gradient it runs along curves.
//!
//! # Resin that differs from place to place
//! Where absorption is a map ([`AbsorptionMap`]) a segment ends at every cell that takes another part; where the index changes
//! ([`IndexGradient`](super::gradient::IndexGradient)) segments are the chords of a curve, along which the fields turn with the direction.
//!
//! # Equation
//! T = (n₂ cos θ₂ / n₁ cos θ₁)·|t|² = 1 − R, so absorbed + reflected + transmitted + missed + blocked + bath + dropped + cut = 1.
//!
//! # Source
//! Born & Wolf, *Principles of Optics*, § 1.5; Nicolet et al. 2024, § 4.1.
//!
//! # Example
//! Perpendicular light through a cylinder of glass in air, resin of 16 mm at μ = 0.1: 1 − e^−1.6 of what passes two walls.
//! ```
//! use tomolith_optics::interface::Polarization;
//! use tomolith_optics::projector::Ray;
//! use tomolith_optics::resin::Resin;
//! use tomolith_optics::space::{TraceLimits, SpaceTracer};
//! use tomolith_optics::vial::cylinder::Cylinder;
//! let vial = Cylinder { inner_radius_mm: 8.0, outer_radius_mm: 8.7, refractive_index: 1.5 };
//! let tracer = SpaceTracer::new(&vial, Resin::absorbing(1.5, 0.1), 1.0, Polarization::Unpolarized, TraceLimits::default());
//! let path = tracer.trace(Ray { from: [0.0; 3], direction: [-1.0, 0.0, 0.0] });
//! let expected = 0.96 * (1.0 - (-1.6f64).exp()); // 4 % is lost at the first wall, nothing where the indices are equal
//! assert!((path.balance.absorbed - expected).abs() < 1e-12);
//! ```

use super::absorption_map::AbsorptionMap;
use super::interface::{Polarization, reflected_by_metal};
use super::obstacle::{BodyMaterial, Obstacle};
use super::phase::Scattering;
use super::power_balance::PowerBalance;
use super::projector::Ray;
use super::random::Stream;
use super::resin::{Resin, Uptake};
use super::surface::{Crossing, Surface};
use super::trace::Bath;
use super::vial::{CrossSection, Medium, Vial};
use std::f64::consts::TAU;
use std::sync::Arc;
use tomolith_core::vector::{cross, dot, unit};

/// A straight piece of a ray through resin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathSegment {
    /// Where it enters the resin, and its direction, mm.
    pub ray: Ray,
    /// Length, mm.
    pub length: f64,
    /// Power where it enters, per emitted power.
    pub power: f64,
    /// How often its light was scattered before.
    pub order: usize,
    /// What the resin takes along it.
    pub uptake: Uptake,
}

/// How far light is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceLimits {
    /// Whether light reflected at walls is followed.
    pub reflections: bool,
    /// Rays below this part of the emitted power are dropped (and counted).
    pub least_power: f64,
    /// Interfaces that one ray passes at most.
    pub interfaces: usize,
    /// How often light is scattered at most.
    pub orders: usize,
}

impl Default for TraceLimits {
    /// No reflections; 64 interfaces.
    fn default() -> Self {
        TraceLimits {
            reflections: false,
            least_power: 1e-4,
            interfaces: 64,
            orders: 64,
        }
    }
}

/// What became of one ray.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RayPath {
    /// Pieces in resin.
    pub segments: Vec<PathSegment>,
    /// Power balance.
    pub balance: PowerBalance,
}

/// Traces rays in space through one vial.
#[derive(Clone, Debug)]
pub struct SpaceTracer {
    walls: Vec<Surface>,
    /// Index outside of all walls, then inside of each.
    indices: Vec<f64>,
    /// Number of walls around the resin.
    resin_depth: usize,
    obstacles: Vec<Obstacle>,
    resin: Resin,
    map: Option<Arc<AbsorptionMap>>,
    polarization: Polarization,
    bath: Option<Bath>,
    scattering: Option<Scattering>,
    limits: TraceLimits,
    /// Whether light that leaves the resin outwards is gone.
    lets_go: bool,
    /// Whether walls end in one plane.
    shares_faces: bool,
    /// Rays begin this far before the axis, mm.
    far: f64,
}

/// What of a ray is to be known.
#[derive(Clone, Copy, PartialEq)]
enum Extent {
    /// Where all of its power goes.
    Whole,
    /// Its pieces in resin.
    Segments,
}

/// A ray on its way.
#[derive(Clone, Copy)]
struct State {
    ray: Ray,
    fields: Fields,
    depth: usize,
    /// Within this obstacle.
    within: Option<usize>,
    crossed: usize,
    /// How often it was scattered.
    order: usize,
    met_resin: bool,
}

/// Field vectors of two incoherent parts of the light; their squares add up to the power.
#[derive(Clone, Copy)]
struct Fields([[f64; 3]; 2]);

impl Fields {
    fn power(&self) -> f64 {
        self.0.iter().map(|&e| dot(e, e)).sum()
    }

    fn scale(&mut self, power: f64) {
        let factor = power.max(0.0).sqrt();
        self.0 = self.0.map(|e| e.map(|v| v * factor));
    }

    /// The fields of light whose direction turns from `d` to `e`: turned by the smallest angle.
    fn turn(&mut self, d: [f64; 3], e: [f64; 3]) {
        let scale = 1.0 / (1.0 + dot(d, e));
        self.0 = self.0.map(|field| {
            let along = dot(field, e) * scale;
            std::array::from_fn(|i| field[i] - along * (d[i] + e[i]))
        });
    }

    fn new(polarization: Polarization, direction: [f64; 3]) -> Self {
        let axis = [0.0, 0.0, 1.0];
        let across = cross(direction, axis);
        // Light along the axis has no field along it; any pair of normals serves
        let p = if dot(across, across) > 1e-12 {
            unit(across)
        } else {
            [1.0, 0.0, 0.0]
        };
        let s = cross(p, direction);
        let parts = polarization.split();
        Fields([s.map(|v| v * parts.s.sqrt()), p.map(|v| v * parts.p.sqrt())])
    }

    /// The fields behind an interface: components along ŝ and p̂ weakened and turned.
    fn through(&self, s: [f64; 3], [p_in, p_out]: [[f64; 3]; 2], [of_s, of_p]: [f64; 2]) -> Self {
        Fields(self.0.map(|e| {
            let (along_s, along_p) = (of_s * dot(e, s), of_p * dot(e, p_in));
            std::array::from_fn(|i| along_s * s[i] + along_p * p_out[i])
        }))
    }
}

/// Rays steeper than this begin no farther out.
const LEAST_SLANT: f64 = 0.1;
/// Faces nearer than this are one, mm.
const SHARED: f64 = 1e-9;
/// How far behind the surface of a body it is looked up which walls are around, mm: beyond what rounding leaves of a wall on that surface.
const BEYOND: f64 = 1e-6;
/// Chords of one curve at most: light that stays in the resin for so long has no way out.
const MOST_CHORDS: usize = 100_000;
/// Light along a curve is given up when the resin has left this part of it: scattered light may be guided along the axis for ever.
const FADED: f64 = 1e-9;
/// A chord that meets a wall within this part of a step is cut there: its direction is that of a whole step.
const CLOSE: f64 = 0.02;

/// What lies ahead of a ray.
enum Ahead {
    Wall { crossing: Crossing, depth: usize },
    Obstacle { crossing: Crossing, index: usize },
}

impl Ahead {
    fn crossing(&self) -> &Crossing {
        match self {
            Ahead::Wall { crossing, .. } | Ahead::Obstacle { crossing, .. } => crossing,
        }
    }

    fn crossing_mut(&mut self) -> &mut Crossing {
        match self {
            Ahead::Wall { crossing, .. } | Ahead::Obstacle { crossing, .. } => crossing,
        }
    }
}

impl SpaceTracer {
    /// A tracer for a vial with this resin in surroundings of index `surrounding`.
    #[must_use]
    pub fn new(
        vial: &dyn Vial,
        resin: Resin,
        surrounding: f64,
        polarization: Polarization,
        limits: TraceLimits,
    ) -> Self {
        let walls = vial.surfaces();
        let outside = vial.surrounding_index(surrounding, resin.refractive_index);
        let index = |medium: &Medium| match *medium {
            Medium::Resin => resin.refractive_index,
            Medium::Clear(n) => n,
        };
        let depth = walls
            .iter()
            .position(|(_, inside)| *inside == Medium::Resin);
        SpaceTracer {
            indices: std::iter::once(outside)
                .chain(walls.iter().map(|(_, inside)| index(inside)))
                .collect(),
            resin_depth: depth.map_or(usize::MAX, |d| d + 1),
            lets_go: !limits.reflections
                && walls
                    .iter()
                    .all(|(wall, _)| !matches!(wall, Surface::Net(_))),
            shares_faces: walls.windows(2).any(|pair| match (&pair[0].0, &pair[1].0) {
                (Surface::Can(_, a), Surface::Can(_, b)) => a[0] == b[0] || a[1] == b[1],
                _ => false,
            }),
            far: walls
                .iter()
                .fold(4.0 * vial.outer_radius_mm(), |far, (wall, _)| match wall {
                    Surface::Can(_, ends) => {
                        let ends = ends.iter().filter(|z| z.is_finite());
                        ends.fold(far, |far, z| far.max(4.0 * z.abs()))
                    }
                    _ => far,
                }),
            walls: walls.into_iter().map(|(surface, _)| surface).collect(),
            obstacles: Vec::new(),
            resin,
            map: None,
            polarization,
            bath: None,
            scattering: None,
            limits,
        }
    }

    /// The same vial with a resin that scatters too; its total attenuation holds the scattering.
    #[must_use]
    pub fn in_scattering(mut self, scattering: Option<Scattering>) -> Self {
        self.scattering = scattering;
        self
    }

    /// The same vial with a resin whose absorption changes from place to place.
    #[must_use]
    pub fn in_map(mut self, map: Option<Arc<AbsorptionMap>>) -> Self {
        self.map = map;
        self
    }

    /// The same vial in an absorbing bath.
    #[must_use]
    pub fn in_bath(mut self, bath: Option<Bath>) -> Self {
        self.bath = bath;
        let reach = bath.map_or(0.0, |bath| 4.0 * bath.radius_mm);
        self.far = self.far.max(reach);
        self
    }

    /// The same vial with bodies in the light.
    #[must_use]
    pub fn with_obstacles(mut self, obstacles: Vec<Obstacle>) -> Self {
        self.lets_go &= obstacles.is_empty();
        for body in &obstacles {
            self.far = self.far.max(2.0 * body.surface.reach_mm());
        }
        self.obstacles = obstacles;
        self
    }

    /// The wall at which light leaves even, straight resin for ever: its curve, and between which heights it stands, mm. None where light may come
    /// back, where the resin differs from place to place, and of a net.
    #[must_use]
    pub fn last_wall(&self) -> Option<(CrossSection, [f64; 2])> {
        let is_last = self.lets_go && self.resin_depth == self.walls.len();
        let is_even = self.map.is_none() && self.resin.gradient.is_none();
        match self.walls.last().filter(|_| is_last && is_even)? {
            Surface::Prism(curve) => Some((*curve, [f64::NEG_INFINITY, f64::INFINITY])),
            Surface::Can(curve, ends) => Some((*curve, *ends)),
            Surface::Net(_) => None,
        }
    }

    /// Follows one ray, unscattered light only; where it begins along its line does not matter.
    #[must_use]
    pub fn trace(&self, ray: Ray) -> RayPath {
        self.trace_with(ray, None, Extent::Whole)
    }

    /// Follows one ray and what is scattered out of it.
    #[must_use]
    pub fn trace_scattered(&self, ray: Ray, random: &mut Stream) -> RayPath {
        self.trace_with(ray, Some(random), Extent::Whole)
    }

    /// The pieces in resin alone, with random numbers those of scattered light too: light is not followed where it cannot come back.
    #[must_use]
    pub fn segments(&self, ray: Ray, random: Option<&mut Stream>) -> Vec<PathSegment> {
        self.trace_with(ray, random, Extent::Segments).segments
    }

    fn trace_with(&self, ray: Ray, mut random: Option<&mut Stream>, extent: Extent) -> RayPath {
        let mut path = RayPath::default();
        // Back to where no wall has been met
        let [x, y, _] = ray.direction;
        let back = dot(ray.from, ray.direction) + self.far / x.hypot(y).max(LEAST_SLANT);
        let ray = Ray::new(ray.at(-back), ray.direction);
        let mut waiting = vec![State {
            ray,
            fields: Fields::new(self.polarization, ray.direction),
            depth: 0,
            within: None,
            crossed: 0,
            order: 0,
            met_resin: false,
        }];
        while let Some(state) = waiting.pop() {
            self.follow(
                state,
                extent,
                &mut waiting,
                &mut path,
                random.as_deref_mut(),
            );
        }
        path
    }

    /// Follows a ray to its end; what is reflected and to be followed is left in `waiting`.
    fn follow(
        &self,
        mut state: State,
        extent: Extent,
        waiting: &mut Vec<State>,
        path: &mut RayPath,
        mut random: Option<&mut Stream>,
    ) {
        loop {
            let first = path.segments.len();
            let ahead = self.next(&mut state, path);
            let distance = ahead.as_ref().map_or(0.0, |a| a.crossing().distance);
            self.cross_medium(&mut state, distance, path);
            if let (Some(random), Some(scattering)) = (random.as_deref_mut(), &self.scattering) {
                self.scatter(&state, scattering, first, random, waiting, path);
            }
            let Some(ahead) = ahead else { break };
            if extent == Extent::Segments && self.is_final(&state, &ahead) {
                return;
            }
            state.ray.from = state.ray.at(distance);
            state.crossed += 1;
            let power = state.fields.power();
            let after = if state.crossed > self.limits.interfaces {
                path.balance.cut += power;
                0.0
            } else {
                self.thinned(power, random.as_deref_mut(), path)
            };
            if after == 0.0 {
                return;
            }
            if after != power {
                state.fields.scale(after / power);
            }
            if !self.pass(&mut state, &ahead, waiting, path, random.as_deref_mut()) {
                return;
            }
        }
        let left = state.fields.power();
        if state.met_resin {
            path.balance.transmitted += left;
        } else {
            path.balance.missed += left;
        }
    }

    /// What goes on of light of this power where reflections are followed: all of it, or, below `least_power`, nothing (which is
    /// counted), or by chance a ray of that power in its place.
    fn thinned(&self, power: f64, random: Option<&mut Stream>, path: &mut RayPath) -> f64 {
        let least = self.limits.least_power;
        if !self.limits.reflections || power >= least {
            return power;
        }
        self.by_chance(power, random, path)
    }

    /// A ray of `least_power` in place of a weaker one, with the probability of their ratio (Russian roulette); nothing without
    /// random numbers.
    fn by_chance(&self, power: f64, random: Option<&mut Stream>, path: &mut RayPath) -> f64 {
        let least = self.limits.least_power;
        let survives = random.is_some_and(|random| random.uniform() * least < power);
        let after = if survives { least } else { 0.0 };
        path.balance.dropped += power - after;
        after
    }

    /// What goes on from a point of the way just gone, the segments from `first` on: its share moves from absorbed to scattered.
    fn scatter(
        &self,
        state: &State,
        scattering: &Scattering,
        first: usize,
        random: &mut Stream,
        waiting: &mut Vec<State>,
        path: &mut RayPath,
    ) {
        let of_segment =
            |segment: &PathSegment| scattered(segment, scattering.per_mm, segment.length);
        let whole: f64 = path.segments[first..].iter().map(of_segment).sum();
        if whole == 0.0 {
            return;
        }
        path.balance.absorbed -= whole;
        if state.order >= self.limits.orders {
            path.balance.cut += whole;
            return;
        }
        let mut power = whole;
        if power < self.limits.least_power {
            power = self.by_chance(power, Some(random), path);
        }
        if power == 0.0 {
            return;
        }
        let (segments, passed) = (&path.segments[first..], random.uniform() * whole);
        let Some((segment, distance)) = point_of(segments, scattering.per_mm, passed) else {
            return;
        };
        let cosine = scattering.phase.draw(random);
        let direction = deflected(segment.ray.direction, cosine, TAU * random.uniform());
        let mut fields = Fields::new(Polarization::Unpolarized, direction);
        fields.scale(power);
        waiting.push(State {
            ray: Ray::new(segment.ray.at(distance), direction),
            fields,
            order: state.order + 1,
            ..*state
        });
    }

    /// What the medium takes on the way to the next surface.
    fn cross_medium(&self, state: &mut State, length: f64, path: &mut RayPath) {
        let power = state.fields.power();
        if self.in_resin(state) {
            state.met_resin = true;
            let mut left = power;
            let mut leave = |from: f64, to: f64, uptake: Uptake| {
                path.segments.push(PathSegment {
                    ray: Ray {
                        from: state.ray.at(from),
                        ..state.ray
                    },
                    length: to - from,
                    power: left,
                    order: state.order,
                    uptake,
                });
                left *= (-uptake.attenuation_per_mm * (to - from)).exp();
            };
            let plain = self.resin.uptake();
            match &self.map {
                Some(map) => map.for_each_piece(&state.ray, length, plain, leave),
                None if length > 0.0 => leave(0.0, length, plain),
                None => {}
            }
            path.balance.absorbed += power - left;
            if power > 0.0 {
                state.fields.scale(left / power);
            }
        } else if let (Some(bath), 0, None) = (self.bath, state.depth, state.within) {
            let way = bath_way(bath, &state.ray, length);
            let loss = -(-bath.absorption_per_mm * way).exp_m1();
            path.balance.bath += loss * power;
            state.fields.scale(1.0 - loss);
        }
    }

    /// Whether light that passes this surface never comes back to the resin: outwards through convex walls, with nothing beyond
    /// them and no reflections.
    fn is_final(&self, state: &State, ahead: &Ahead) -> bool {
        let outwards = matches!(ahead, Ahead::Wall { depth, .. } if *depth < state.depth);
        outwards && self.in_resin(state) && self.lets_go
    }

    fn in_resin(&self, state: &State) -> bool {
        state.depth == self.resin_depth && state.within.is_none()
    }

    /// The next surface of a ray; where light runs along a curve it is followed there, chord by chord.
    fn next(&self, state: &mut State, path: &mut RayPath) -> Option<Ahead> {
        let Some(gradient) = self.resin.gradient.filter(|_| self.in_resin(state)) else {
            return self.ahead(state);
        };
        let axis = self.resin.refractive_index;
        let (step, begun) = (gradient.step_mm, state.fields.power());
        let mut length = step;
        for _ in 0..MOST_CHORDS {
            let mut chord = gradient.chord(axis, state.ray, length);
            let met = self.ahead(&State {
                ray: chord.ray,
                ..*state
            });
            let mut met = met.filter(|a| a.crossing().distance <= chord.length);
            length = step;
            if let Some(wall) = &mut met {
                let crossing = wall.crossing_mut();
                if crossing.distance > CLOSE * step {
                    // First a chord that ends shortly before the wall
                    length = (1.0 - CLOSE / 2.0) * crossing.distance;
                    continue;
                }
                chord.length = std::mem::take(&mut crossing.distance);
                let shorter = gradient.chord(axis, state.ray, chord.length);
                chord.end = Ray {
                    from: chord.ray.at(chord.length),
                    ..shorter.end
                };
            }
            state.fields.turn(state.ray.direction, chord.end.direction);
            state.ray = chord.ray;
            self.cross_medium(state, chord.length, path);
            state.ray = chord.end;
            if met.is_some() {
                return met;
            }
            if state.fields.power() <= FADED * begun {
                break;
            }
        }
        // Light that the resin guides along the axis
        path.balance.cut += state.fields.power();
        state.fields.scale(0.0);
        None
    }

    /// The next surface of a straight ray: the wall around it, the one it encloses, or an obstacle.
    fn ahead(&self, state: &State) -> Option<Ahead> {
        if let Some(index) = state.within {
            let crossing = self.obstacles[index].surface.leave(&state.ray)?;
            return Some(Ahead::Obstacle { crossing, index });
        }
        let inward = self.walls.get(state.depth).and_then(|wall| {
            let crossing = wall.enter(&state.ray)?;
            let depth = state.depth + 1;
            Some(Ahead::Wall { crossing, depth })
        });
        let outward = || {
            let depth = state.depth.checked_sub(1)?;
            let crossing = self.walls[depth].leave(&state.ray)?;
            Some(Ahead::Wall { crossing, depth })
        };
        let mut nearest = nearer(inward, outward());
        for (index, body) in self.obstacles.iter().enumerate() {
            // A body takes the place of a wall that it lies on
            let found = body.surface.enter(&state.ray).filter(|crossing| {
                let before = |ahead: &Ahead| crossing.distance < ahead.crossing().distance + SHARED;
                nearest.as_ref().is_none_or(before)
            });
            if let Some(crossing) = found {
                nearest = Some(Ahead::Obstacle { crossing, index });
            }
        }
        nearest
    }

    /// Passes a surface; false where the ray ends.
    fn pass(
        &self,
        state: &mut State,
        ahead: &Ahead,
        waiting: &mut Vec<State>,
        path: &mut RayPath,
        random: Option<&mut Stream>,
    ) -> bool {
        let mut behind = *state;
        let n1 = self.index_of(state);
        match *ahead {
            Ahead::Wall { depth, .. } => {
                behind.depth = depth;
                self.skip_shared_faces(&mut behind, state.depth);
            }
            Ahead::Obstacle { index, crossing } => match self.obstacles[index].material {
                BodyMaterial::Black => {
                    path.balance.blocked += state.fields.power();
                    return false;
                }
                BodyMaterial::Diffuse { reflectance } => {
                    self.diffuse(state, crossing.normal, reflectance, waiting, random, path);
                    return false;
                }
                BodyMaterial::Mirror => {
                    self.bounce(state, crossing.normal, [1.0; 2], path);
                    return true;
                }
                BodyMaterial::Metal {
                    refractive_index,
                    extinction_coefficient,
                } => {
                    let cos1 = -dot(state.ray.direction, crossing.normal);
                    let index = [refractive_index, extinction_coefficient];
                    let power = reflected_by_metal(cos1, n1, index);
                    self.bounce(state, crossing.normal, power, path);
                    return true;
                }
                BodyMaterial::Dielectric { .. } if state.within.is_some() => {
                    behind.within = None;
                    behind.depth = self.depth_at(state.ray.at(BEYOND));
                }
                BodyMaterial::Dielectric { .. } => behind.within = Some(index),
            },
        }
        let n2 = self.index_of(&behind);
        let split = split(state, ahead.crossing().normal, n1, n2);
        let reflected_power = split.reflected.fields.power();
        if reflected_power > 0.0 {
            if self.limits.reflections {
                let after = self.thinned(reflected_power, random, path);
                if after > 0.0 {
                    let mut fields = split.reflected.fields;
                    if after != reflected_power {
                        fields.scale(after / reflected_power);
                    }
                    waiting.push(State {
                        ray: split.reflected.ray,
                        fields,
                        ..*state
                    });
                }
            } else {
                path.balance.reflected += reflected_power;
            }
        }
        let Some(transmitted) = split.transmitted else {
            return false;
        };
        *state = State {
            ray: transmitted.ray,
            fields: transmitted.fields,
            ..behind
        };
        true
    }

    /// Sends light back from a body that reflects these shares of s and p.
    fn bounce(&self, state: &mut State, normal: [f64; 3], power: [f64; 2], path: &mut RayPath) {
        let before = state.fields.power();
        let [s, p] = power.map(f64::sqrt);
        // A conductor turns over the field along its surface
        let back = bounced(state, normal, [-s, p]);
        (state.ray, state.fields) = (back.ray, back.fields);
        path.balance.blocked += before - state.fields.power();
    }

    /// How many walls are around a point: where light leaves a body that reaches through them.
    fn depth_at(&self, point: [f64; 3]) -> usize {
        self.walls
            .iter()
            .take_while(|wall| wall.contains(point))
            .count()
    }

    /// Walls that end in one plane are one interface there: what lies between them has no thickness.
    fn skip_shared_faces(&self, behind: &mut State, before: usize) {
        if !self.shares_faces {
            return;
        }
        loop {
            let (crossing, depth) = if behind.depth > before {
                let wall = self.walls.get(behind.depth);
                (wall.and_then(|w| w.enter(&behind.ray)), behind.depth + 1)
            } else if let Some(depth) = behind.depth.checked_sub(1) {
                (self.walls[depth].leave(&behind.ray), depth)
            } else {
                return;
            };
            match crossing {
                Some(crossing) if crossing.distance < SHARED => behind.depth = depth,
                _ => return,
            }
        }
    }

    /// Light that a diffuse body sends back: its share, by Lambert's law, in one random direction; none without random numbers.
    fn diffuse(
        &self,
        state: &State,
        normal: [f64; 3],
        reflectance: f64,
        waiting: &mut Vec<State>,
        random: Option<&mut Stream>,
        path: &mut RayPath,
    ) {
        let power = state.fields.power();
        let mut sent = reflectance * power;
        path.balance.blocked += power - sent;
        let Some(random) = random.filter(|_| state.order < self.limits.orders) else {
            path.balance.cut += sent;
            return;
        };
        if sent < self.limits.least_power {
            sent = self.by_chance(sent, Some(&mut *random), path);
        }
        if sent == 0.0 {
            return;
        }
        // The cosine to the normal has the density 2·cos
        let cosine = random.uniform().sqrt();
        let direction = deflected(normal, cosine, TAU * random.uniform());
        let mut fields = Fields::new(Polarization::Unpolarized, direction);
        fields.scale(sent);
        waiting.push(State {
            ray: Ray::new(state.ray.from, direction),
            fields,
            order: state.order + 1,
            ..*state
        });
    }

    fn index_of(&self, state: &State) -> f64 {
        match state.within.map(|i| self.obstacles[i].material) {
            Some(BodyMaterial::Dielectric { refractive_index }) => refractive_index,
            _ => match self.resin.gradient.filter(|_| self.in_resin(state)) {
                Some(gradient) => gradient.index(self.resin.refractive_index, state.ray.from),
                None => self.indices[state.depth],
            },
        }
    }
}

/// What of a segment's power is scattered on the first `length` mm of it, where scattering takes `per_mm`.
fn scattered(segment: &PathSegment, per_mm: f64, length: f64) -> f64 {
    let mu = segment.uptake.attenuation_per_mm;
    -(-mu * length).exp_m1() * segment.power * per_mm / mu
}

/// Where segments, one after the other, have scattered this much: the segment, and the way along it, mm; None without segments.
fn point_of(segments: &[PathSegment], per_mm: f64, mut power: f64) -> Option<(&PathSegment, f64)> {
    let mut found = None;
    for segment in segments {
        found = Some((segment, power));
        power -= scattered(segment, per_mm, segment.length);
        if power < 0.0 {
            break;
        }
    }
    let (segment, power) = found?;
    // The inverse of `scattered`; what rounding leaves too much of ends with the segment
    let mu = segment.uptake.attenuation_per_mm;
    let distance = -(-power * mu / (segment.power * per_mm)).ln_1p() / mu;
    Some((segment, distance.min(segment.length)))
}

/// The nearer of two surfaces, the first of two at the same distance.
fn nearer(a: Option<Ahead>, b: Option<Ahead>) -> Option<Ahead> {
    match (a, b) {
        (Some(a), Some(b)) if b.crossing().distance < a.crossing().distance => Some(b),
        (None, b) => b,
        (a, _) => a,
    }
}

/// Way of a ray through a bath around the axis before it meets something at `distance`.
fn bath_way(bath: Bath, ray: &Ray, distance: f64) -> f64 {
    let wall = Surface::Prism(CrossSection::Circle(bath.radius_mm));
    if wall.contains(ray.from) {
        let end = wall.leave(ray).map_or(f64::INFINITY, |c| c.distance);
        return end.min(distance);
    }
    wall.enter(ray)
        .map_or(0.0, |c| (distance - c.distance).max(0.0))
}

struct Part {
    ray: Ray,
    fields: Fields,
}

struct Split {
    transmitted: Option<Part>,
    reflected: Part,
}

/// The direction across the plane of incidence.
fn across_incidence(d: [f64; 3], normal: [f64; 3]) -> [f64; 3] {
    let across = cross(d, normal);
    // Along the normal every direction across is as good
    if dot(across, across) > 1e-24 {
        unit(across)
    } else {
        unit(cross(d, least_axis(d)))
    }
}

/// What comes back from a surface, of whose fields s and p these parts are reflected.
fn bounced(state: &State, normal: [f64; 3], parts: [f64; 2]) -> Part {
    let d = state.ray.direction;
    let along = dot(d, normal);
    let back = unit(std::array::from_fn(|i| d[i] - 2.0 * along * normal[i]));
    let s = across_incidence(d, normal);
    Part {
        ray: Ray::new(state.ray.from, back),
        fields: state
            .fields
            .through(s, [cross(d, s), cross(back, s)], parts),
    }
}

/// Snell and Fresnel in space.
fn split(state: &State, normal: [f64; 3], n1: f64, n2: f64) -> Split {
    let d = state.ray.direction;
    let from = state.ray.from;
    let cos1 = -dot(d, normal);
    let s = across_incidence(d, normal);
    let p = cross(d, s);
    let ratio = n1 / n2;
    let sin2_squared = ratio * ratio * (1.0 - cos1 * cos1).max(0.0);
    if sin2_squared >= 1.0 {
        return Split {
            transmitted: None,
            reflected: bounced(state, normal, [1.0; 2]),
        };
    }
    let cos2 = (1.0 - sin2_squared).sqrt();
    let bend = ratio * cos1 - cos2;
    let on = unit(std::array::from_fn(|i| ratio * d[i] + bend * normal[i]));
    let r_s = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2);
    let r_p = (n2 * cos1 - n1 * cos2) / (n2 * cos1 + n1 * cos2);
    let passed = [r_s, r_p].map(|r| (1.0 - r * r).sqrt());
    Split {
        transmitted: Some(Part {
            ray: Ray::new(from, on),
            fields: state.fields.through(s, [p, cross(on, s)], passed),
        }),
        reflected: bounced(state, normal, [r_s, r_p]),
    }
}

/// A direction at this angle (its cosine) and azimuth from another.
fn deflected(d: [f64; 3], cosine: f64, azimuth: f64) -> [f64; 3] {
    let a = unit(cross(d, least_axis(d)));
    let b = cross(d, a);
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let (sin, cos) = azimuth.sin_cos();
    unit(std::array::from_fn(|i| {
        cosine * d[i] + sine * (cos * a[i] + sin * b[i])
    }))
}

fn least_axis(d: [f64; 3]) -> [f64; 3] {
    let least = (0..3).min_by(|&a, &b| d[a].abs().total_cmp(&d[b].abs()));
    std::array::from_fn(|i| f64::from(u8::from(Some(i) == least)))
}

#[cfg(test)]
mod tests;
