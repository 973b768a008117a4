//! Where light goes on its way through vial and part: walls, bodies in the light, and rays of some pixels, for pictures of a job.

use crate::job::resolve::ResolvedJob;
use crate::optics::projector::Ray;
use crate::optics::space::{SpaceTracer, TraceLimits};
use crate::optics::surface::Surface;
use crate::report::page::{FramePaths, LightPath, LightPaths, Scene, SceneOutline};

/// Frames of a turn whose rays are drawn: where those of one frame are those of all, turned, and elsewhere; columns of a frame, and rows of its middle column.
const FRAMES: [usize; 2] = [24, 120];
const COLUMNS: usize = 17;
const ROWS: usize = 5;
/// Corners of a circle.
const CORNERS: usize = 96;
/// Where rays begin and end, over the radius of the vial.
const BEFORE: f64 = 1.25;

/// The machine of a job as pages draw it.
pub(crate) fn scene(job: &ResolvedJob) -> Scene {
    let [low, high] = job.shape().bounds_mm();
    // The sides of the box: the part reaches them, and its corners perhaps not
    let sides = [low[0], low[1], high[0], high[1]].map(f64::abs);
    let walls = job.optics.vial.surfaces();
    let name = |i: usize| {
        if i == 0 {
            "outer wall of the vial"
        } else {
            "wall"
        }
    };
    let bodies = job.optics.paths.first();
    let bodies = bodies.map_or(&[][..], |path| path.obstacles.as_slice());
    let is_round = bodies.is_empty() && job.optics.vial.is_round();
    let walls = (walls.iter().enumerate())
        .filter_map(|(i, (surface, _))| outline(name(i), surface))
        .collect();
    Scene {
        is_round,
        lit_radius_mm: Some(job.optics.reach_mm().0).filter(|mm| mm.is_finite()),
        part_radius_mm: sides.into_iter().fold(0.0, f64::max),
        z_mm: [low[2], high[2]],
        walls,
        lights: (0..job.optics.lights.len())
            .map(|light| LightPaths {
                name: job.light_name(light).unwrap_or("").to_owned(),
                frames: frames(job, light, FRAMES[usize::from(!is_round)]),
            })
            .collect(),
        obstacles: (bodies.iter())
            .filter_map(|body| outline("body in the light", &body.surface))
            .collect(),
    }
}

/// A surface in a horizontal cut; of a mesh nothing.
fn outline(name: &str, surface: &Surface) -> Option<SceneOutline> {
    let (Surface::Prism(curve) | Surface::Can(curve, _)) = surface else {
        return None;
    };
    let on_circle = |radius: f64| {
        let point = move |i| {
            let (sin, cos) = (std::f64::consts::TAU * i as f64 / CORNERS as f64).sin_cos();
            [radius * cos, radius * sin]
        };
        (0..CORNERS).map(point).collect()
    };
    let points = curve.as_circle().map_or_else(|| curve.corners(), on_circle);
    Some(SceneOutline {
        name: name.to_owned(),
        points,
    })
}

/// Even places among `count`, the first and the last included.
fn spread(count: usize, most: usize) -> Vec<usize> {
    let places = count.min(most);
    match places {
        0 | 1 => vec![count / 2; places],
        _ => (0..places)
            .map(|i| i * (count - 1) / (places - 1))
            .collect(),
    }
}

/// Rays of some frames of a light, so many at most.
fn frames(job: &ResolvedJob, light: usize, most: usize) -> Vec<FramePaths> {
    let (light, path) = (&job.optics.lights[light], &job.optics.paths[light]);
    let vial = job.optics.vial.as_ref();
    let tracer = SpaceTracer::new(
        vial,
        light.resin,
        light.surrounding_index,
        light.polarization,
        TraceLimits::default(),
    )
    .with_obstacles(path.obstacles.clone());
    let walls = vial.surfaces();
    let outer = walls.first().map(|(surface, _)| surface);
    let begin = BEFORE * vial.outer_radius_mm();
    let pixels = &light.pixels;
    let every = pixels.frames().div_ceil(most).max(1);
    let (middle_row, middle_column) = (pixels.rows / 2, pixels.columns / 2);
    let columns = spread(pixels.columns, COLUMNS).into_iter();
    let rows = spread(pixels.rows, ROWS).into_iter();
    let places: Vec<(usize, usize)> = columns
        .map(|column| (middle_row, column))
        .chain(rows.map(|row| (row, middle_column)))
        .collect();
    (0..pixels.frames())
        .step_by(every)
        .map(|frame| {
            let azimuth = pixels.azimuths[frame];
            let rays = places.iter().map(|&(row, column)| {
                let point = [pixels.column_u(column), pixels.row_z(row)];
                let ray = path.projector.ray(point, [0.0; 2]);
                traced(
                    &tracer,
                    outer,
                    path.motion.seen_from_vial(ray, azimuth),
                    begin,
                )
            });
            FramePaths {
                frame,
                angle_deg: azimuth.to_degrees(),
                rays: rays.collect(),
            }
        })
        .collect()
}

/// The way of a ray from before the vial: where it meets the vial, then the ends of its pieces in resin. One that meets none goes straight on.
fn traced(tracer: &SpaceTracer, outer: Option<&Surface>, ray: Ray, begin: f64) -> LightPath {
    let nearest = -(0..3)
        .map(|axis| ray.from[axis] * ray.direction[axis])
        .sum::<f64>();
    let ray = Ray {
        from: ray.at(nearest - begin),
        ..ray
    };
    let mut points = vec![ray.from];
    let entered = outer.and_then(|surface| surface.enter(&ray));
    points.extend(entered.map(|crossing| ray.at(crossing.distance)));
    let resin_from = points.len();
    let segments = tracer.segments(ray, None);
    for segment in &segments {
        points.extend([segment.ray.from, segment.ray.at(segment.length)]);
    }
    if segments.is_empty() && entered.is_none() {
        points.push(ray.at(2.0 * begin));
    }
    LightPath { points, resin_from }
}
