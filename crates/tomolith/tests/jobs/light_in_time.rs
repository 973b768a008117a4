//! Materials in the light of the `parallel` model: what diffuses, prints and shades there, against models that know it exactly.

use std::sync::Arc;
use tomolith::check::{self, dose, taylor::Remainders};
use tomolith::field::{Field, HostField};
use tomolith::grid::{PatternGrid, Volume, VolumeGrid};
use tomolith::models::parallel::Parallel;
use tomolith::models::rays::{self, Optics, Rays};
use tomolith::models::wave::{self, incoherent_cone};
use tomolith::models::{DoseModel, Work};
use tomolith::optics::absorption_map::AbsorptionMap;
use tomolith::optics::light::Light;
use tomolith::optics::projector::telecentric::Telecentric;
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::index_matched::IndexMatched;
use tomolith_material::diffused::Diffused;
use tomolith_material::domain::Domain;
use tomolith_material::mixing::Mixing;
use tomolith_material::photopolymer::{Curing, Inhibitor, Network, Params, Photopolymer};
use tomolith_material::printing::Printing;
use tomolith_material::schedule::{Power, Schedule, Turns};
use tomolith_material::shaded::Shaded;
use tomolith_material::{Absorption, Model};

const FRAMES: usize = 24;
const MU: f64 = 0.2;

fn grid() -> VolumeGrid {
    VolumeGrid::centered([4, 40, 40], 0.1)
}

fn lights(frames: usize, map: Option<AbsorptionMap>) -> Light {
    let mut pixels = PatternGrid::full_turn(FRAMES, 0.1, 4, 40, 0.1);
    pixels.azimuths = pixels.azimuths.into_iter().cycle().take(frames).collect();
    let mut light = Light::new(pixels, Resin::absorbing(1.5, MU));
    light.map = map.map(Arc::new);
    light
}

fn parallel(frames: usize, map: Option<AbsorptionMap>) -> Parallel {
    let vial = IndexMatched { radius_mm: 2.5 };
    Parallel::new(&vial, vec![lights(frames, map)], grid()).unwrap()
}

/// Smooth patterns that no symmetry helps, 0.2 to 1.
fn patterns(model: &Model) -> HostField {
    let mut x = model.new_patterns().unwrap();
    for (i, v) in x.as_mut_slice().iter_mut().enumerate() {
        *v = 0.6 + 0.4 * (0.37 * i as f32).sin();
    }
    x
}

fn noise(like: &HostField, seed: u64) -> HostField {
    HostField::from_slice(&check::noise(seed, like.len()))
}

/// A disc off the axis that absorbs more.
fn disc(more: f32) -> Volume<f32> {
    Volume::from_fn(grid(), |[x, y, _]| {
        let is_inside = (x - 0.5).hypot(y + 0.3) < 0.8;
        MU as f32 + if is_inside { more } else { 0.0 }
    })
}

/// Resin that absorbs so much, and all of it makes dose.
fn absorbing(mu: Volume<f32>) -> Absorption {
    Absorption {
        active_per_mm: mu.clone(),
        attenuation_per_mm: mu,
    }
}

/// The same for models that know it: a slice that stands for all heights.
fn map_of(mu: &Volume<f32>) -> AbsorptionMap {
    let slice = mu.values[..40 * 40].to_vec();
    AbsorptionMap::new([1, 40, 40], 0.1, slice.clone(), slice).unwrap()
}

/// What one field has more than another.
fn apart(a: &HostField, b: &HostField) -> HostField {
    let mut off = a.clone();
    off.axpy(-1.0, b);
    off
}

fn rms(a: &HostField) -> f64 {
    (a.dot(a) / a.len() as f64).sqrt()
}

#[test]
fn shaded_light_is_that_of_a_resin_with_a_map() {
    for more in [0.1f32, 0.5] {
        let mu = disc(more);
        let exact = parallel(FRAMES, Some(map_of(&mu)));
        let plain: Arc<Model> = Arc::new(parallel(FRAMES, None));
        let x = patterns(plain.as_ref());
        let before = dose(plain.as_ref(), &x);
        let shaded = Shaded::new(plain, [MU, MU], &absorbing(mu)).unwrap();
        let wanted = dose(&exact, &x);
        let off = apart(&dose(&shaded, &x), &wanted);
        let share = rms(&off) / rms(&apart(&wanted, &before));
        assert!(share < 0.02, "{more}: {share}");
        // ⟨F d, c⟩ = ⟨d, Fᵀc⟩
        let (d, c) = (noise(&x, 3), noise(&wanted, 5));
        let mut back = x.zeros_like();
        let work = Work::new();
        shaded.pullback(&x, &c, &mut back, &work).unwrap();
        let forth = dose(&shaded, &d).dot(&c);
        assert!(
            (forth - back.dot(&d)).abs() < 1e-4 * rms(&wanted) * c.len() as f64,
            "{forth}"
        );
    }
}

/// How far what shading changes by a model that weakens light along its way is from what it changes by one with a map of the absorption, and how far apart
/// both are where nothing shades; relative, rms.
fn off_shaded(plain: Arc<Model>, by_map: &dyn Fn(Option<AbsorptionMap>) -> Box<Model>) -> [f64; 2] {
    let mu = disc(0.5);
    let map = map_of(&mu);
    let shaded = Shaded::new(Arc::clone(&plain), [MU, MU], &absorbing(mu)).unwrap();
    let dose_of = |model: &Model| {
        let x = patterns(model);
        // Amplitudes and energies of one pattern
        let quantity = model.patterns()[0].quantity;
        let values: Vec<f32> = x.as_slice().iter().map(|v| quantity.value(*v)).collect();
        dose(model, &HostField::from_slice(&values))
    };
    let (before, exact) = (dose_of(plain.as_ref()), dose_of(by_map(None).as_ref()));
    let change = apart(&dose_of(&shaded), &before);
    let wanted = apart(&dose_of(by_map(Some(map)).as_ref()), &exact);
    [
        rms(&apart(&change, &wanted)) / rms(&wanted),
        rms(&apart(&before, &exact)) / rms(&exact),
    ]
}

#[test]
fn cones_are_shaded_along_their_middle() {
    let vial = IndexMatched { radius_mm: 2.5 };
    let half_angle_deg = 2.0f64;
    let params = incoherent_cone::Params {
        half_angle_deg,
        ..incoherent_cone::Params::default()
    };
    let cones = incoherent_cone::model(&vial, vec![lights(FRAMES, None)], &params, grid()).unwrap();
    let optics = Optics {
        projector: Arc::new(Telecentric {
            pixel_pitch_mm: [0.1; 2],
            aperture_radius_mm: 1e3 * half_angle_deg.to_radians().tan(),
            working_distance_mm: 1e3,
            focus_mm: 0.0,
        }),
        ..Optics::collimated(0.1)
    };
    let params = rays::Params {
        rays_per_pixel: 64,
        ..rays::Params::default()
    };
    let traced = |map| -> Box<Model> {
        let (lights, optics) = (vec![lights(FRAMES, map)], [optics.clone()]);
        Box::new(Rays::new(&vial, lights, &optics, &params, grid()).unwrap())
    };
    let [off, unshaded] = off_shaded(Arc::new(cones), &traced);
    assert!(off < 0.06, "{off} {unshaded}");
}

#[test]
fn waves_are_shaded_along_their_way() {
    let vial = IndexMatched { radius_mm: 2.5 };
    let params = wave::Params::default();
    let waves = wave::model(&vial, vec![lights(FRAMES, None)], &params, grid()).unwrap();
    // Pixels of 0.1 mm hardly diffract
    let [off, unshaded] = off_shaded(Arc::new(waves), &|map| Box::new(parallel(FRAMES, map)));
    assert!(off < 0.06, "{off} {unshaded}");
}

#[test]
fn resin_that_shades_at_one_height_leaves_the_others_alone() {
    let plain: Arc<Model> = Arc::new(parallel(FRAMES, None));
    let x = patterns(plain.as_ref());
    let mut mu = disc(0.5);
    let slice = mu.values.len() / 4;
    mu.values[..2 * slice].fill(MU as f32);
    let shaded = Shaded::new(plain.clone(), [MU, MU], &absorbing(mu)).unwrap();
    let layout = &plain.outputs()[0];
    let [before, after] = [dose(plain.as_ref(), &x), dose(&shaded, &x)];
    let [before, after] = [before, after].map(|d| layout.volume_of(d.as_slice()).values);
    let apart = |range: std::ops::Range<usize>| {
        let pairs = before[range.clone()].iter().zip(&after[range]);
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0f32, f32::max)
    };
    let most = before.iter().copied().fold(0.0f32, f32::max);
    assert!(apart(0..2 * slice) < 2e-6 * most);
    assert!(apart(2 * slice..4 * slice) > 0.05 * most);
}

fn schedule(own_patterns: bool) -> Schedule {
    let turns = Turns {
        own_patterns,
        power: Power::EnergyPerTurn(0.25),
        ..Turns::new(FRAMES, 20.0, 2.0)
    };
    Schedule::of_turns(&[turns]).unwrap()
}

#[test]
fn a_dose_that_diffuses_is_what_a_material_without_oxygen_prints() {
    // The linear operator against the material, step by step, in the same light
    let threshold = Network {
        dose_diffusion_mm2_per_s: 2e-4,
        ..Network::new("resin", Curing::threshold(1.0))
    };
    let params =
        Params::new(vec![threshold]).diffusing_by(tomolith_material::diffusion::Scheme::Spectral);
    let material = Photopolymer::new(params, Mixing::identity(1), Domain::new(grid())).unwrap();
    let optics: Vec<Box<Model>> = vec![Box::new(parallel(FRAMES, None))];
    let printing = Printing::new(optics, schedule(false), material, Some(0.4)).unwrap();
    let x = patterns(&printing);
    let printed = dose(&printing, &x);
    let mut half = x.clone();
    half.scale(0.5); // two turns of 0.25 mJ/mm² each
    let of_arcs = |arcs: usize| {
        let model: Box<Model> = Box::new(parallel(FRAMES, None));
        let diffused = Diffused::of_schedule(model, 2e-4, &schedule(false), arcs).unwrap();
        rms(&apart(&dose(&diffused, &half), &printed)) / rms(&printed)
    };
    let [one, all] = [of_arcs(1), of_arcs(FRAMES)];
    assert!(all < 2e-3 && one < 0.03 && all < one, "{one} {all}");
    // Without diffusion it is another dose
    let plain = parallel(FRAMES, None);
    assert!(rms(&apart(&dose(&plain, &half), &printed)) > 0.02 * rms(&printed));
}

fn exact(own_patterns: bool) -> Printing {
    let oxygen = Inhibitor {
        capacity_mj_per_mm3: 0.1,
        diffusion_mm2_per_s: 2e-4,
        half_saturation: Some(0.05),
        ..Inhibitor::default()
    };
    let network = Network {
        inhibitors: vec![oxygen],
        ..Network::new("resin", Curing::threshold(0.15))
    };
    let params = Params::new(vec![network]);
    let material = Photopolymer::new(params, Mixing::identity(1), Domain::new(grid())).unwrap();
    let frames = if own_patterns { 2 * FRAMES } else { FRAMES };
    let optics: Vec<Box<Model>> = vec![Box::new(parallel(frames, None))];
    let schedule = schedule(own_patterns);
    Printing::new(optics, schedule, material, Some(2.0)).unwrap()
}

/// ½ Σ (degree of cure − wanted)² and its gradient; wanted: a fine comb that oxygen blurs.
fn loss(model: &Printing, x: &HostField, gradient: Option<&mut HostField>) -> f64 {
    let work = Work::new();
    let layout = &model.outputs()[0];
    let wanted = Volume::from_fn(layout.grid.clone(), |[x, y, _]| {
        let comb = x.hypot(y) < 1.5 && (x * 2.5).floor() as i64 % 2 == 0;
        if comb { 1.1 } else { 0.6 }
    });
    let wanted = HostField::from_slice(&layout.field_of(&wanted));
    let off = apart(&dose(model, x), &wanted);
    let value = 0.5 * off.dot(&off);
    if let Some(gradient) = gradient {
        model.pullback(x, &off, gradient, &work).unwrap();
    }
    value
}

/// Projected gradient steps of a fixed number, each as long as lowers the loss.
fn descend(model: &Printing, x: &mut HostField, steps: usize) -> f64 {
    let mut length = 0.0;
    let mut value = f64::INFINITY;
    for _ in 0..steps {
        let mut gradient = x.zeros_like();
        value = loss(model, x, Some(&mut gradient));
        if length == 0.0 {
            length = 0.05 / gradient.max_abs();
        }
        for _ in 0..12 {
            let mut y = x.clone();
            y.axpy(-length, &gradient);
            y.as_mut_slice().iter_mut().for_each(|v| *v = v.max(0.0));
            let next = loss(model, &y, None);
            if next < value {
                (*x, value) = (y, next);
                length *= 1.6;
                break;
            }
            length *= 0.5;
        }
    }
    value
}

#[test]
fn two_turns_of_their_own_are_never_worse_than_one_repeated() {
    let (repeated, separate) = (exact(false), exact(true));
    let mut x = repeated.new_patterns().unwrap();
    x.fill(0.12);
    let first = descend(&repeated, &mut x, 6);
    // Both turns as the repeated one: the same print
    let mut both = HostField::from_slice(&[x.as_slice(), x.as_slice()].concat());
    let start = loss(&separate, &both, None);
    assert!((start / first - 1.0).abs() < 1e-4, "{start} {first}");
    // The gradient of a turn is another one than that of the other; their sum is that of the repeated one
    let mut of_both = both.zeros_like();
    loss(&separate, &both, Some(&mut of_both));
    let mut of_one = x.zeros_like();
    loss(&repeated, &x, Some(&mut of_one));
    let (one, two) = of_both.as_slice().split_at(x.len());
    let [one, two] = [one, two].map(HostField::from_slice);
    let mut sum = one.clone();
    sum.axpy(1.0, &two);
    let size = rms(&of_one);
    let off = [
        rms(&apart(&sum, &of_one)) / size,
        rms(&apart(&one, &two)) / size,
    ];
    assert!(off[0] < 1e-2 && off[1] > 0.01, "{off:?}");
    // As many further steps: turns of their own go further
    let further = descend(&repeated, &mut x, 4);
    let apart = descend(&separate, &mut both, 4);
    assert!(
        apart < further && further <= first,
        "{apart} {further} {first}"
    );
}

#[test]
fn the_gradient_through_time_in_real_light_passes_a_taylor_test() {
    let model = exact(true);
    let x = patterns(&model);
    let (d, mut gradient) = (noise(&x, 7), x.zeros_like());
    loss(&model, &x, Some(&mut gradient));
    let value = |e: f32| {
        let mut y = x.clone();
        y.axpy(e, &d);
        loss(&model, &y, None)
    };
    let exact = gradient.dot(&d);
    let left = Remainders::over(2, 0.1, &value, exact);
    let is_second = |order: &f64| (1.8..2.2).contains(order);
    assert!(left.orders().iter().all(is_second), "{left:?}");
}
