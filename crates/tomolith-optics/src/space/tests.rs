use super::super::gradient::IndexGradient;
use super::super::phase::isotropic::Isotropic;
use super::super::surface::Net;
use super::super::trace::Tracer;
use super::super::vial::cylinder::Cylinder;
use super::super::vial::double_tube::DoubleTube;
use super::super::vial::ended::{End, Ended};
use super::super::vial::index_matched::IndexMatched;
use super::super::vial::square::Square;
use super::*;
use std::sync::Arc;
use tomolith_core::near;
use tomolith_core::units::Mm;
use tomolith_io::mesh::samples::cuboid;

const GLASS: Cylinder = Cylinder::new(7.5, 8.0, 1.54);

fn resin() -> Resin {
    Resin::absorbing(1.49, 0.1)
}

fn tracer(vial: &dyn Vial, polarization: Polarization, limits: TraceLimits) -> SpaceTracer {
    SpaceTracer::new(vial, resin(), 1.0, polarization, limits)
}

/// Light that is scattered once, and followed to its end.
fn once() -> TraceLimits {
    TraceLimits {
        orders: 1,
        least_power: 0.0,
        ..TraceLimits::default()
    }
}

/// Resin whose index changes with the distance from the axis.
fn bent(quadratic_per_mm2: f64, quartic_per_mm4: f64, step_mm: f64) -> Resin {
    Resin {
        gradient: Some(IndexGradient {
            quadratic_per_mm2,
            quartic_per_mm4,
            step_mm,
        }),
        ..resin()
    }
}

fn length(path: &RayPath) -> f64 {
    path.segments.iter().map(|segment| segment.length).sum()
}

/// A box from corner to corner.
fn block([low, high]: [[f64; 3]; 2], material: BodyMaterial) -> Obstacle {
    let net = Net::new(&cuboid(low, high), "mesh").unwrap();
    Obstacle {
        surface: Surface::Net(Arc::new(net)),
        material,
    }
}

fn level(u: f64, azimuth: f64) -> Ray {
    let (sin, cos) = azimuth.sin_cos();
    Ray::new([-u * sin, u * cos, 0.4], [-cos, -sin, 0.0])
}

#[test]
fn level_rays_do_what_the_tracer_of_the_plane_says() {
    let square = Square::new(10.0, 12.4, 1.54);
    let double = DoubleTube::new(RADII, [1.5, 1.52, 1.0]);
    for vial in [&GLASS as &dyn Vial, &square, &double] {
        for polarization in [Polarization::Unpolarized, Polarization::S, Polarization::P] {
            let plane = Tracer::new(vial, resin(), 1.0, polarization);
            let space = tracer(vial, polarization, TraceLimits::default());
            for i in 0..60 {
                let (u, azimuth) = (0.13 * f64::from(i) - 3.9, 0.21 * f64::from(i));
                let (a, b) = (plane.trace(u, azimuth), space.trace(level(u, azimuth)));
                assert_eq!(a.segments.len(), b.segments.len(), "{vial:?} {u}");
                for (a, b) in a.segments.iter().zip(&b.segments) {
                    assert!((a.length - b.length).abs() < 1e-9, "{vial:?} {u}");
                    assert!((a.power - b.power).abs() < 1e-9, "{vial:?} {u}");
                    assert!((a.from[0] - b.ray.from[0]).abs() < 1e-9);
                    assert!((a.direction[1] - b.ray.direction[1]).abs() < 1e-9);
                }
                assert!((b.balance.total() - 1.0).abs() < 1e-12);
                assert!((a.balance.absorbed - b.balance.absorbed).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn a_leaning_ray_keeps_bouguers_invariant_and_the_slope_that_snell_gives_along_the_axis() {
    // n·(component along z) and n·(moment about z) are invariants of a round vial
    let space = tracer(&GLASS, Polarization::Unpolarized, TraceLimits::default());
    let direction = unit([-1.0, 0.1, -0.25]);
    let ray = Ray::new([0.0, 3.1, 0.2], direction);
    let moment = |ray: &Ray| ray.from[0] * ray.direction[1] - ray.from[1] * ray.direction[0];
    let segment = space.trace(ray).segments[0];
    assert!((segment.ray.direction[2] - direction[2] / 1.49).abs() < 1e-14);
    assert!((moment(&segment.ray) - moment(&ray) / 1.49).abs() < 1e-12);
}

#[test]
fn with_reflections_all_light_is_found_again() {
    let limits = TraceLimits {
        reflections: true,
        least_power: 1e-7,
        interfaces: 200,
        ..TraceLimits::default()
    };
    let mut clear = resin();
    clear.absorption_per_mm = 0.0;
    clear.attenuation_per_mm = 0.0;
    // Through the axis of a clear vial all interfaces are plain: their incoherent sum has a closed form
    let space = SpaceTracer::new(&GLASS, clear, 1.0, Polarization::S, limits);
    let path = space.trace(level(0.0, 0.3));
    assert!((path.balance.total() - 1.0).abs() < 1e-12);
    assert!(path.balance.dropped < 1e-4, "{:?}", path.balance);
    let r = |a: f64, b: f64| ((a - b) / (a + b)).powi(2);
    // Two walls of two interfaces each, then the pair of them; R/T adds up along incoherent interfaces
    let ratios =
        2.0 * (r(1.0, 1.54) / (1.0 - r(1.0, 1.54)) + r(1.54, 1.49) / (1.0 - r(1.54, 1.49)));
    let transmitted: f64 = 1.0 / (1.0 + ratios);
    // The last ray of every order leaves the vial after resin, forwards or backwards: only the first reflections miss it
    let sum: f64 = path.segments.iter().map(|segment| segment.power).sum();
    assert!(sum > transmitted);
    let without_resin = path.balance.missed;
    assert!((path.balance.transmitted + without_resin + path.balance.dropped - 1.0).abs() < 1e-12);
    // What leaves backwards before any resin: the first two interfaces alone
    let two = r(1.0, 1.54) / (1.0 - r(1.0, 1.54)) + r(1.54, 1.49) / (1.0 - r(1.54, 1.49));
    assert!((without_resin - two / (1.0 + two)).abs() < 1e-6);
}

#[test]
fn scattered_light_is_accounted_for_and_its_first_order_is_where_quadrature_puts_it() {
    let vial = IndexMatched { radius_mm: 2.0 };
    let run = |orders: usize| {
        let limits = TraceLimits { orders, ..once() };
        milk(&vial, resin(), limits)
    };
    // Mean power of the scattered segment: (μ_s/μ_t)(1 − e^(−μ_t·4)), whatever was drawn
    let expected = MILK_PER_MM / 0.6 * (1.0 - (-2.4f64).exp());
    let ray = level(0.0, 0.0);
    let (mut depth, mut cosine) = (0.0, 0.0);
    let paths: u32 = 20_000;
    for i in 0..paths {
        let path = run(1).trace_scattered(ray, &mut Stream::new([1, 0, u64::from(i), 0]));
        assert!((path.balance.total() - 1.0).abs() < 1e-12);
        assert!((path.segments[1].power - expected).abs() < 1e-12);
        depth += (2.0 - path.segments[1].ray.from[0]) / f64::from(paths);
        cosine += path.segments[1].ray.direction[2] / f64::from(paths);
    }
    // Mean free path below 4 mm: 1/μ − 4/(e^(4μ) − 1), and no direction is preferred
    let mean = 1.0 / 0.6 - 4.0 / (2.4f64.exp() - 1.0);
    assert!((depth - mean).abs() < 0.04, "{depth} {mean}");
    assert!(cosine.abs() < 0.02);
    // With all orders the power that is dropped is small, and the balance is whole
    let path = run(64).trace_scattered(ray, &mut Stream::new([2, 0, 0, 0]));
    assert!((path.balance.total() - 1.0).abs() < 1e-12 && path.segments.len() > 20);
}

#[test]
fn black_bodies_take_the_light_behind_them_and_clear_ones_of_the_resin_s_index_do_nothing() {
    let with = |material| {
        tracer(&GLASS, Polarization::Unpolarized, TraceLimits::default())
            .with_obstacles(vec![block([[-1.0; 3], [1.0; 3]], material)])
    };
    let plain = tracer(&GLASS, Polarization::Unpolarized, TraceLimits::default());
    let ray = level(0.3, 0.0);
    let whole = plain.trace(ray);
    let shadow = with(BodyMaterial::Black).trace(ray);
    assert!((shadow.segments[0].length - (whole.segments[0].length / 2.0 - 1.0)).abs() < 1e-2);
    assert!((shadow.balance.total() - 1.0).abs() < 1e-12);
    assert!(shadow.balance.blocked > 0.1 && shadow.segments.len() == 1);
    let matched = with(BodyMaterial::Dielectric {
        refractive_index: 1.49,
    })
    .trace(ray);
    let gap = 2.0 / -matched.segments[0].ray.direction[0];
    assert!((length(&matched) - (whole.segments[0].length - gap)).abs() < 1e-9);
    let mirror = with(BodyMaterial::Mirror).trace(ray);
    assert_eq!(mirror.segments.len(), 2);
    assert!(mirror.segments[1].ray.direction[0] > 0.9, "sent back");
    assert!((mirror.balance.total() - 1.0).abs() < 1e-12);
}

#[test]
fn a_metal_sends_back_what_its_index_says() {
    let metal = BodyMaterial::Metal {
        refractive_index: 1.5,
        extinction_coefficient: 2.8,
    };
    let metal = block([[-1.0; 3], [1.0; 3]], metal);
    let plain = tracer(&GLASS, Polarization::Unpolarized, TraceLimits::default());
    let path = plain.with_obstacles(vec![metal]).trace(level(0.0, 0.0));
    // Normal incidence from 1.49: (0.01² + 2.8²)/(2.99² + 2.8²)
    let reflected = (0.01f64.powi(2) + 2.8f64.powi(2)) / (2.99f64.powi(2) + 2.8f64.powi(2));
    let [to, back] = &path.segments[..] else {
        panic!("{path:?}");
    };
    let arrived = to.power * (-0.1 * to.length).exp();
    assert!((back.power / arrived - reflected).abs() < 1e-12);
    assert!((path.balance.blocked / arrived - (1.0 - reflected)).abs() < 1e-12);
    assert!((path.balance.total() - 1.0).abs() < 1e-12);
}

#[test]
fn a_body_that_reaches_through_a_wall_takes_its_place() {
    let body = |from, to, material| block([[from, -1.0, -1.0], [to, 1.0, 1.0]], material);
    let clear = BodyMaterial::Dielectric {
        refractive_index: 1.49,
    };
    let square = Square::new(10.0, 12.0, 1.6);
    let with = |bodies: Vec<Obstacle>| {
        tracer(&square, Polarization::Unpolarized, TraceLimits::default())
            .with_obstacles(bodies)
            .trace(level(0.3, 0.0))
    };
    // Of the resin's index, from outside into the resin: one interface in place of two, 4 mm of resin
    let fresnel = 1.0 - (0.49f64 / 2.49).powi(2);
    for outside in [6.5, 6.0] {
        let path = with(vec![body(4.0, outside, clear)]);
        let [segment] = &path.segments[..] else {
            panic!("{path:?}");
        };
        assert!((segment.length - 9.0).abs() < 1e-9, "{segment:?}");
        assert!((segment.power - fresnel).abs() < 1e-12);
    }
    // From the wall's inner face on, and from the resin out through the far wall
    let path = with(vec![body(4.0, 5.0, clear), body(-7.0, -4.0, clear)]);
    assert_eq!(path.segments.len(), 1);
    assert!((path.segments[0].length - 8.0).abs() < 1e-9);
    assert!((path.balance.total() - 1.0).abs() < 1e-12 && path.balance.transmitted > 0.3);
    for outside in [6.5, 5.0] {
        let path = with(vec![body(4.0, outside, BodyMaterial::Black)]);
        assert!(path.segments.iter().all(|segment| segment.length < 1e-9));
        assert!(path.balance.blocked > 0.8);
    }
}

/// Luneburg's lens, n² = 2 − ρ²/R², in a tube that light does not see.
fn lens(radius: f64, step_mm: f64) -> SpaceTracer {
    let tube = Cylinder::new(radius, radius + 0.5, 1.0);
    let resin = Resin {
        refractive_index: 2.0f64.sqrt(),
        ..bent(-0.5 / radius.powi(2), 0.0, step_mm)
    };
    SpaceTracer::new(&tube, resin, 1.0, Polarization::P, TraceLimits::default())
}

#[test]
fn luneburgs_lens_gathers_parallel_light_in_one_point_of_its_rim() {
    let radius = 4.0;
    let miss = |height: f64, step: f64| {
        let path = lens(radius, step).trace(level(height, 0.0));
        assert!((path.balance.total() - 1.0).abs() < 1e-12);
        // Nothing is reflected where indices are equal: all that is missing was absorbed along the curve
        let lost = 1.0 - (-0.1 * length(&path)).exp();
        near!(path.balance.absorbed, lost, 1e-5, "{height}");
        let last = path.segments[path.segments.len() - 1];
        let [x, y, _] = last.ray.at(last.length);
        (x + radius).hypot(y)
    };
    // The steps go round ellipses exactly, if a little too fast: what is left is the cut at the rim
    for height in [0.4, 1.7, 3.1, 3.8] {
        let [coarse, fine] = [0.1, 0.025].map(|step| miss(height, step));
        assert!(
            coarse < 1e-3 && fine < 7e-5,
            "{height}: {coarse:e} {fine:e}"
        );
    }
}

#[test]
fn the_error_of_a_curve_falls_with_the_square_of_its_chords() {
    let end = |step_mm: f64| {
        let resin = bent(0.004, -2e-4, step_mm);
        let tracer = SpaceTracer::new(&GLASS, resin, 1.0, Polarization::P, TraceLimits::default());
        let path = tracer.trace(level(3.0, 0.0));
        let last = path.segments[path.segments.len() - 1];
        last.ray.at(last.length)
    };
    let exact = end(0.005);
    let miss = |step| {
        let found = end(step);
        (0..3)
            .map(|i| (found[i] - exact[i]).powi(2))
            .sum::<f64>()
            .sqrt()
    };
    let (coarse, fine) = (miss(0.4), miss(0.1));
    assert!(fine < 1e-3 && fine < coarse / 10.0, "{coarse:e} {fine:e}");
}

#[test]
fn along_a_curve_bouguers_invariant_is_kept() {
    let (radius, height) = (4.0, 2.3);
    let path = lens(radius, 0.02).trace(level(height, 0.0));
    // The last one is cut by the wall and has the direction of a whole step
    for segment in &path.segments[..path.segments.len() - 1] {
        let middle = segment.ray.at(segment.length / 2.0);
        let index = (2.0 - (middle[0].powi(2) + middle[1].powi(2)) / radius.powi(2)).sqrt();
        let [dx, dy, _] = segment.ray.direction;
        let moment = index * (middle[0] * dy - middle[1] * dx);
        assert!((moment - height).abs() < 1e-4, "{moment}");
    }
}

#[test]
fn light_through_the_ends_of_a_vial_is_bent_there_and_level_light_does_not_see_them() {
    let vial = closed(GLASS, 0.0);
    let ended = tracer(&vial, Polarization::Unpolarized, TraceLimits::default());
    let open = tracer(&GLASS, Polarization::Unpolarized, TraceLimits::default());
    assert_eq!(ended.trace(level(2.0, 0.3)), open.trace(level(2.0, 0.3)));
    // From above through the free surface and out through the plate: 11 mm of resin between planes
    let down = Ray::new([0.0, 0.0, 6.0], unit([0.3, 0.0, -1.0]));
    let path = ended.trace(down);
    let sine = 0.3 / 1.09f64.sqrt() / 1.49;
    let length = 11.0 / (1.0 - sine * sine).sqrt();
    assert_eq!(path.segments.len(), 1);
    near!(path.segments[0].length, length, 1e-9, "{:?}", path.segments);
    assert!((path.segments[0].ray.direction[0] - sine).abs() < 1e-12);
    assert!((path.balance.total() - 1.0).abs() < 1e-12);
    // Along the axis no wall is met but the ends: air to resin, resin to glass, glass to air
    let axis = ended.trace(Ray {
        direction: [0.0, 0.0, -1.0],
        ..down
    });
    let r = |a: f64, b: f64| ((a - b) / (a + b)).powi(2);
    let passed = (1.0 - r(1.0, 1.49)) * (1.0 - r(1.49, 1.54)) * (1.0 - r(1.54, 1.0));
    assert!((axis.balance.transmitted - passed * (-1.1f64).exp()).abs() < 1e-12);
    // Above the vial there is nothing
    let over = ended.trace(Ray::new([0.0, 0.0, 6.5], [-1.0, 0.0, 0.0]));
    assert!((over.balance.missed - 1.0).abs() < 1e-12 && over.segments.is_empty());
}

const RADII: [f64; 4] = [9.0, 8.0, 3.0, 2.5];
const TUBE: DoubleTube = DoubleTube::new(RADII, [1.5, 1.52, 1.33]);

/// A vial with a plate of 1 mm under −5 mm, and another over 6 mm of this thickness.
fn closed(vial: impl Vial + 'static, lid_mm: f64) -> Ended {
    let end = |z_mm, thickness_mm| {
        let [z_mm, thickness_mm] = [z_mm, thickness_mm].map(Mm);
        Some(End { z_mm, thickness_mm })
    };
    Ended::new(Box::new(vial), end(-5.0, 1.0), end(6.0, lid_mm)).unwrap()
}

#[test]
fn along_the_axis_of_a_closed_double_tube_light_passes_plate_and_surface() {
    let vial = closed(TUBE, 0.0);
    let closed = tracer(&vial, Polarization::Unpolarized, TraceLimits::default());
    let through = |media: &[f64]| {
        let passed = |pair: &[f64]| 1.0 - ((pair[0] - pair[1]) / (pair[0] + pair[1])).powi(2);
        media.windows(2).map(passed).product::<f64>()
    };
    for up in [1.0, -1.0] {
        let at = |x: f64| {
            let ray = Ray::new([0.6 * x, 0.8 * x, 1.0], [0.0, 0.0, up]);
            let path = closed.trace(ray);
            assert!((path.balance.total() - 1.0).abs() < 1e-12, "{x} {up}");
            path
        };
        // Core, inner glass and the rim of the outer tube: no resin on the way
        for (x, media) in [
            (0.0, [1.0, 1.5, 1.33, 1.0]),
            (2.75, [1.0, 1.5, 1.52, 1.0]),
            (8.5, [1.0, 1.5, 1.5, 1.0]),
        ] {
            let path = at(x);
            assert!(path.segments.is_empty(), "{x} {up}");
            near!(path.balance.missed, through(&media), 1e-12, "{x} {up}");
        }
        // Between the tubes: 11 mm of resin at 0.1 per mm
        let path = at(5.0);
        let left = (-1.1f64).exp();
        let [before, behind] = [&[1.0, 1.5, 1.49][..], &[1.49, 1.0]].map(through);
        let entered = if up > 0.0 { before } else { behind };
        assert!((path.balance.transmitted - before * behind * left).abs() < 1e-12);
        assert!((path.balance.absorbed - entered * (1.0 - left)).abs() < 1e-12);
        assert!(path.segments.len() == 1 && (path.segments[0].length - 11.0).abs() < 1e-12);
    }
    // Level light does not see the ends
    let open = tracer(&TUBE, Polarization::Unpolarized, TraceLimits::default());
    assert_eq!(closed.trace(level(2.0, 0.3)), open.trace(level(2.0, 0.3)));
}

#[test]
fn of_one_index_a_closed_double_tube_is_the_resin_that_a_straight_line_passes() {
    let clear = DoubleTube::new(RADII, [1.49; 3]);
    // Way of a line within a cylinder about the axis, from one height to another
    let within = |ray: &Ray, radius: f64, [low, high]: [f64; 2]| {
        let ([x, y, z], [dx, dy, dz]) = (ray.from, ray.direction);
        let (a, half) = (dx * dx + dy * dy, x * dx + y * dy);
        let root = (half * half - a * (x * x + y * y - radius * radius)).sqrt();
        let (from, to) = ((-half - root) / a, (-half + root) / a);
        let ends = [(low - z) / dz, (high - z) / dz];
        if root.is_nan() {
            return 0.0;
        }
        (to.min(ends[0].max(ends[1])) - from.max(ends[0].min(ends[1]))).max(0.0)
    };
    let (mut random, mut through_core) = (Stream::new([4, 0, 0, 0]), 0);
    for lid_mm in [0.0, 0.5] {
        let vial = closed(clear.clone(), lid_mm);
        let limits = TraceLimits::default();
        let space = SpaceTracer::new(&vial, resin(), 1.49, Polarization::Unpolarized, limits);
        for _ in 0..4000 {
            let mut point = |half: f64| [(); 3].map(|()| half * (2.0 * random.uniform() - 1.0));
            let ray = Ray::new(point(6.0), unit(point(1.0)));
            let heights = [-5.0, 6.0];
            let core = within(&ray, 3.0, heights);
            let way = within(&ray, 8.0, heights) - core;
            let path = space.trace(ray);
            near!(length(&path), way, 1e-9, "{ray:?}");
            let taken = 1.0 - (-0.1 * way).exp();
            assert!((path.balance.absorbed - taken).abs() < 1e-10, "{ray:?}");
            through_core += u32::from(core > 0.0);
        }
    }
    assert!(through_core > 2000, "{through_core}");
}

/// A vial of meshes, from outside to inside.
#[derive(Debug)]
struct Nets(Vec<(Surface, Medium)>);

impl Vial for Nets {
    fn walls(&self) -> Vec<super::super::vial::Wall> {
        TUBE.walls()
    }

    fn surfaces(&self) -> Vec<(Surface, Medium)> {
        self.0.clone()
    }
}

/// An upright prism of many sides, the middles of two of them on the axis x, outward.
fn prism(radius: f64, [low, high]: [f64; 2]) -> tomolith_io::mesh::Mesh {
    const SIDES: u32 = 256;
    let turn = TAU / f64::from(SIDES);
    let corner = |i: u32, z: f64| {
        let (sin, cos) = ((f64::from(i) + 0.5) * turn).sin_cos();
        let reach = radius / (turn / 2.0).cos();
        [reach * cos, reach * sin, z]
    };
    let mut vertices: Vec<_> = (0..SIDES)
        .flat_map(|i| [corner(i, low), corner(i, high)])
        .collect();
    vertices.extend([[0.0, 0.0, low], [0.0, 0.0, high]]);
    let sides = (0..SIDES).flat_map(|i| {
        let (a, b) = (2 * i, 2 * ((i + 1) % SIDES));
        let (below, above) = (2 * SIDES, 2 * SIDES + 1);
        [
            [a, b, b + 1],
            [a, b + 1, a + 1],
            [b, a, below],
            [a + 1, b + 1, above],
        ]
    });
    tomolith_io::mesh::Mesh {
        triangles: sides.collect(),
        vertices,
    }
}

#[test]
fn a_closed_double_tube_is_what_meshes_of_it_are() {
    let vial = closed(TUBE, 0.5);
    // Meshes must not touch: the inner tube stands 1 µm off its ends, where these rays do not pass
    let net = |radius: f64, heights: [f64; 2]| {
        let mesh = prism(radius, heights);
        assert!(mesh.signed_volume() > 0.0);
        Surface::Net(Arc::new(Net::new(&mesh, "mesh").unwrap()))
    };
    let heights = [[-6.0, 6.5], [-5.0, 6.0], [-4.999, 5.999], [-4.998, 5.998]];
    let nets = TUBE.walls().into_iter().zip(heights);
    let nets = Nets(
        nets.zip(RADII)
            .map(|((wall, heights), radius)| (net(radius, heights), wall.inside))
            .collect(),
    );
    let [cans, nets] = [&vial as &dyn Vial, &nets].map(|vial| {
        let limits = TraceLimits::default();
        SpaceTracer::new(vial, resin(), 1.4, Polarization::Unpolarized, limits)
    });
    let mut through = 0;
    for i in 0..40 {
        // Across the axis, through the bottom plate and both walls of the inner tube
        let (x, sine) = (5.0 + 0.05 * f64::from(i), 0.86 + 0.002 * f64::from(i));
        let ray = Ray::new([x, 0.0, -6.0], [-sine, 0.0, (1.0 - sine * sine).sqrt()]);
        let (a, b) = (cans.trace(ray), nets.trace(ray));
        assert_eq!(a.segments.len(), b.segments.len(), "{i}");
        for (a, b) in a.segments.iter().zip(&b.segments) {
            assert!((a.length - b.length).abs() < 1e-9, "{i}");
            assert!((a.power - b.power).abs() < 1e-12, "{i}");
            assert!((0..3).all(|k| (a.ray.from[k] - b.ray.from[k]).abs() < 1e-9));
        }
        assert!((a.balance.absorbed - b.balance.absorbed).abs() < 1e-12);
        assert!((a.balance.transmitted - b.balance.transmitted).abs() < 1e-12);
        through += usize::from(a.segments.len() == 2 && a.segments[0].ray.from[2] == -5.0);
    }
    assert!(through > 20, "{through}");
}

#[test]
fn absorption_from_cell_to_cell_adds_up_along_a_ray() {
    let values: Vec<f32> = (0..60).map(|i| 0.05 * (i * 7 % 13) as f32).collect();
    let map = AbsorptionMap::new([3, 4, 5], 1.3, values.clone(), values).unwrap();
    let mapped =
        tracer(&GLASS, Polarization::S, TraceLimits::default()).in_map(Some(Arc::new(map)));
    let open = tracer(&GLASS, Polarization::S, TraceLimits::default());
    for i in 0..20 {
        let mut ray = level(0.2 * f64::from(i) - 2.0, 0.31 * f64::from(i));
        ray.direction = unit([ray.direction[0], ray.direction[1], 0.02 * f64::from(i)]);
        let (a, b) = (mapped.trace(ray), open.trace(ray));
        assert!((a.balance.total() - 1.0).abs() < 1e-12);
        let depth = |path: &RayPath| {
            let loss_of =
                |segment: &PathSegment| segment.length * segment.uptake.attenuation_per_mm;
            path.segments.iter().map(loss_of).sum::<f64>()
        };
        assert!((length(&a) - length(&b)).abs() < 1e-9 && a.segments.len() > 3);
        let taken = b.segments[0].power * (1.0 - (-depth(&a)).exp());
        assert!((a.balance.absorbed - taken).abs() < 1e-12);
    }
}

#[test]
fn a_diffuse_body_sends_back_its_share_by_lamberts_law() {
    let diffuse = BodyMaterial::Diffuse { reflectance: 0.7 };
    let body = block([[-3.0; 3], [0.0, 3.0, 3.0]], diffuse);
    let vial = IndexMatched { radius_mm: 5.0 };
    let tracer = tracer(&vial, Polarization::Unpolarized, once()).with_obstacles(vec![body]);
    let ray = level(0.3, 0.0);
    let straight = tracer.trace(ray);
    let met = straight.segments[0].power * (-0.1 * straight.segments[0].length).exp();
    assert!((straight.balance.blocked - 0.3 * met).abs() < 1e-12);
    assert!((straight.balance.cut - 0.7 * met).abs() < 1e-12);
    let (mut cosine, mut square) = (0.0, 0.0);
    let paths: u32 = 20_000;
    for i in 0..paths {
        let path = tracer.trace_scattered(ray, &mut Stream::new([3, 0, u64::from(i), 0]));
        assert!((path.balance.total() - 1.0).abs() < 1e-12);
        let sent = path.segments[1];
        assert!((sent.power - 0.7 * met).abs() < 1e-12 && sent.order == 1);
        cosine += sent.ray.direction[0] / f64::from(paths);
        square += sent.ray.direction[0].powi(2) / f64::from(paths);
    }
    // Of the density 2·cos over the cosine: mean 2/3, mean square 1/2; five standard deviations
    let error = 5.0 / f64::from(paths).sqrt();
    near!(cosine, 2.0 / 3.0, error * (1.0f64 / 18.0).sqrt());
    near!(square, 0.5, error * (1.0f64 / 12.0).sqrt());
}

#[test]
fn segments_alone_are_those_of_the_whole_path() {
    let tube = DoubleTube::new(RADII, [1.5, 1.52, 1.0]);
    let body = block([[3.2, -1.0, -1.0], [4.0, 1.0, 1.0]], BodyMaterial::Mirror);
    for reflections in [false, true] {
        let limits = TraceLimits {
            reflections,
            least_power: 0.02,
            ..TraceLimits::default()
        };
        for vial in [&GLASS as &dyn Vial, &tube] {
            for bodies in [vec![], vec![body.clone()]] {
                let tracer = milk(vial, resin(), limits).with_obstacles(bodies);
                for i in 0..100 {
                    let ray = level(0.1 * i as f64 - 5.0, 0.3 * i as f64);
                    let draws = || Stream::new([1, 2, i, 3]);
                    let whole = tracer.trace_scattered(ray, &mut draws());
                    assert_eq!(tracer.segments(ray, Some(&mut draws())), whole.segments);
                    assert_eq!(tracer.segments(ray, None), tracer.trace(ray).segments);
                }
            }
        }
    }
}

/// Resin that scatters isotropically, 0.5 per mm beside what it absorbs.
const MILK_PER_MM: f64 = 0.5;

fn milk(vial: &dyn Vial, resin: Resin, limits: TraceLimits) -> SpaceTracer {
    let scattering = Scattering::new(MILK_PER_MM, Isotropic {});
    let resin = Resin {
        attenuation_per_mm: resin.absorption_per_mm + MILK_PER_MM,
        ..resin
    };
    SpaceTracer::new(vial, resin, 1.0, Polarization::Unpolarized, limits)
        .in_scattering(Some(scattering))
}

/// Two halves of resin, x < 0 and x > 0, that absorb unlike.
const HALVES: [f64; 2] = [0.05, 0.6];

fn halves() -> Option<Arc<AbsorptionMap>> {
    let active = HALVES.map(|a| a as f32).to_vec();
    let total = active.iter().map(|a| a + MILK_PER_MM as f32).collect();
    Some(Arc::new(
        AbsorptionMap::new([1, 1, 2], 20.0, active, total).unwrap(),
    ))
}

/// Attenuation of the half that a point is in.
fn half(x: f64) -> f64 {
    MILK_PER_MM + HALVES[usize::from(x > 0.0)]
}

#[test]
fn light_scattered_in_two_unlike_halves_is_where_quadrature_puts_it() {
    let vial = IndexMatched { radius_mm: 2.0 };
    let tracer = milk(&vial, resin(), once()).in_map(halves());
    // Along −x through the axis: 2 mm of the half that takes more, then 2 mm of the other
    let ray = level(0.0, 0.0);
    let direct = tracer.trace(ray);
    let [first, second] = [half(1.0), half(-1.0)];
    let left = (-2.0 * (first + second)).exp();
    assert!((direct.balance.transmitted - left).abs() < 1e-7);
    // Power of what is scattered: μ_s ∫ e^(−τ)
    let of_half = |mu: f64| (1.0 - (-2.0 * mu).exp()) * MILK_PER_MM / mu;
    let expected = of_half(first) + (-2.0 * first).exp() * of_half(second);
    // Where it is scattered first, and what either half takes of it: quadrature over the ray and all directions
    let attenuated = |x: f64| {
        let depth = 2.0 - x;
        (-(first * depth.min(2.0) + second * (depth - 2.0).max(0.0))).exp()
    };
    let taken = |x: f64, [dx, dy]: [f64; 2]| {
        let flat = dx.hypot(dy);
        let across = x * dy / flat;
        let way = (-x * dx / flat + (4.0 - across * across).sqrt()) / flat;
        let turn = if x * dx < 0.0 {
            (-x / dx).min(way)
        } else {
            way
        };
        let first = half(x);
        let mut power = [0.0; 2];
        power[usize::from(x > 0.0)] += 1.0 - (-first * turn).exp();
        let other = half(-x);
        power[usize::from(x < 0.0)] +=
            (-first * turn).exp() * (1.0 - (-other * (way - turn)).exp());
        // Of what is lost in a half, only this is not scattered again
        [0, 1].map(|side| power[side] * HALVES[side] / (HALVES[side] + MILK_PER_MM))
    };
    let (mut depth, mut sides) = (0.0, [0.0; 2]);
    let (along, polar, around) = (400, 80, 160);
    for i in 0..along {
        let x = 2.0 - 4.0 * (f64::from(i) + 0.5) / f64::from(along);
        let source = MILK_PER_MM * attenuated(x) * 4.0 / f64::from(along);
        depth += source * (2.0 - x) / expected;
        for j in 0..polar {
            let up = (f64::from(j) + 0.5) / f64::from(polar);
            let flat = (1.0 - up * up).sqrt();
            for k in 0..around {
                let angle = TAU * (f64::from(k) + 0.5) / f64::from(around);
                let part = source / f64::from(polar * around);
                let found = taken(x, [flat * angle.cos(), flat * angle.sin()]);
                (0..2).for_each(|side| sides[side] += part * found[side]);
            }
        }
    }
    let paths: u32 = 100_000;
    let (mut mean, mut powers, mut squares) = ([0.0; 2], [0.0; 2], [0.0; 2]);
    for i in 0..paths {
        let path = tracer.trace_scattered(ray, &mut Stream::new([6, 0, u64::from(i), 0]));
        assert!((path.balance.total() - 1.0).abs() < 1e-12);
        let again: Vec<&PathSegment> = path
            .segments
            .iter()
            .filter(|segment| segment.order == 1)
            .collect();
        near!(again[0].power, expected, 1e-7, "{}", again[0].power);
        let way = 2.0 - again[0].ray.from[0];
        mean[0] += way / f64::from(paths);
        mean[1] += way * way / f64::from(paths);
        let mut deposit = [0.0; 2];
        for segment in again {
            let uptake = segment.uptake;
            let lost = segment.power * -(-uptake.attenuation_per_mm * segment.length).exp_m1();
            let side = usize::from(segment.ray.at(segment.length / 2.0)[0] > 0.0);
            deposit[side] += lost * uptake.active_per_mm / uptake.attenuation_per_mm;
        }
        for side in 0..2 {
            powers[side] += deposit[side] / f64::from(paths);
            squares[side] += deposit[side] * deposit[side] / f64::from(paths);
        }
    }
    // Five standard errors
    let error = |square: f64, mean: f64| 5.0 * ((square - mean * mean) / f64::from(paths)).sqrt();
    near!(mean[0], depth, error(mean[1], mean[0]), "{mean:?}");
    for side in 0..2 {
        let allowed = error(squares[side], powers[side]);
        assert!(allowed < 0.05 * sides[side]);
        near!(powers[side], sides[side], allowed, "{powers:?} {sides:?}");
    }
}

#[test]
fn an_even_map_and_an_even_gradient_leave_paths_as_they_are() {
    let limits = TraceLimits {
        least_power: 0.02,
        ..TraceLimits::default()
    };
    let plain = milk(&GLASS, resin(), limits);
    let even = AbsorptionMap::new([4, 4, 4], 3.0, vec![0.1; 64], vec![0.6; 64]).unwrap();
    let mapped = milk(&GLASS, resin(), limits).in_map(Some(Arc::new(even)));
    let chords = milk(&GLASS, bent(0.0, 0.0, 0.4), limits);
    // Where light of every order begins; a curve ends where 1e-9 of its light is left, a straight segment at the wall
    let turns = |path: &RayPath| {
        let orders = 0..=path
            .segments
            .iter()
            .map(|segment| segment.order)
            .max()
            .unwrap_or(0);
        let first = |order| path.segments.iter().find(|segment| segment.order == order);
        let first = orders.filter_map(first).map(|segment| segment.ray.from);
        first.collect::<Vec<_>>()
    };
    let mut scattered = 0;
    for i in 0..200 {
        let ray = level(0.02 * i as f64 - 2.0, 0.3 * i as f64);
        let draws = || Stream::new([9, 0, i, 0]);
        let expected = plain.trace_scattered(ray, &mut draws());
        for other in [&mapped, &chords] {
            let found = other.trace_scattered(ray, &mut draws());
            assert!((found.balance.total() - 1.0).abs() < 1e-12);
            let apart = found.balance.absorbed - expected.balance.absorbed;
            assert!(apart.abs() < 1e-6, "{i}: {apart:e}");
            let (a, b) = (turns(&found), turns(&expected));
            assert_eq!(a.len(), b.len(), "{i}");
            for (a, b) in a.iter().zip(&b) {
                assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-4), "{i}");
            }
            scattered += a.len() - 1;
        }
    }
    assert!(scattered > 4 * 400, "{scattered}");
}

#[test]
fn scattered_light_runs_along_the_curves_of_a_gradient() {
    let bent = bent(-0.01, 5e-5, 0.05);
    let profile = bent.gradient.unwrap();
    let tracer = milk(&GLASS, bent, once());
    let index = |at: [f64; 3]| profile.index(1.49, at);
    let ray = level(2.0, 0.1);
    let way =
        |segments: &[&PathSegment]| segments.iter().map(|segment| segment.length).sum::<f64>();
    let (mut guided, mut bends) = (0, 0.0f64);
    for i in 0..300 {
        let path = tracer.trace_scattered(ray, &mut Stream::new([2, 0, i, 0]));
        assert!((path.balance.total() - 1.0).abs() < 1e-12);
        let [direct, once] = [0, 1].map(|order| {
            let segments = path
                .segments
                .iter()
                .filter(|segment| segment.order == order);
            segments.collect::<Vec<_>>()
        });
        // What goes on is what the whole curve scattered, from a point of it
        let expected = direct[0].power * (1.0 - (-0.6 * way(&direct)).exp()) * MILK_PER_MM / 0.6;
        assert!((once[0].power - expected).abs() < 1e-12);
        let from = once[0].ray.from;
        let passes = |segment: &&&PathSegment| {
            let to: [f64; 3] = std::array::from_fn(|k| from[k] - segment.ray.from[k]);
            let along = dot(to, segment.ray.direction);
            let off = cross(to, segment.ray.direction);
            (-1e-9..segment.length + 1e-9).contains(&along) && dot(off, off) < 1e-18
        };
        assert!(direct.iter().any(|segment| passes(&segment)), "{i}");
        // Bouguer: n·(r × d)_z and n·d_z stay; the last chord is cut and has the direction of a whole step
        let invariants = |segment: &PathSegment| {
            let middle = segment.ray.at(segment.length / 2.0);
            let ([x, y, _], [dx, dy, dz]) = (middle, segment.ray.direction);
            let n = index(middle);
            [n * (x * dy - y * dx), n * dz]
        };
        let begun = invariants(once[0]);
        for segment in &once[..once.len() - 1] {
            let found = invariants(segment);
            assert!((found[0] - begun[0]).abs() < 2e-4 && (found[1] - begun[1]).abs() < 1e-4);
        }
        let (a, b) = (once[0].ray.direction, once[once.len() - 1].ray.direction);
        bends = bends.max(dot(a, b).min(1.0).acos());
        // Light whose n·d_z is more than the index at the wall never meets it: it fades
        if begun[1].abs() > index([7.5, 0.0, 0.0]) + 1e-3 {
            guided += 1;
            let end = (-0.6 * way(&once)).exp();
            assert!((5e-10..1e-9).contains(&end), "{end:e}");
            assert!(path.balance.cut > 0.0);
        }
    }
    assert!(guided > 5 && bends > 0.3, "{guided} {bends}");
}
