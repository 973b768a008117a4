//! The numbers of Wang et al. 2022 (supplement), printed and checked.

use std::f64::consts::PI;
use std::path::{Path, PathBuf};
use tomolith_core::Error;
use tomolith_core::columns::Columns;
use tomolith_core::near;
use tomolith_core::response::curve::Curve;
use tomolith_planning::buildup::{TurningVial, bessel_less_struve, wall_rate};
use tomolith_planning::gray::{CurveForm, GrayCurve, Polynomial};
use tomolith_planning::impulse::Post;
use tomolith_planning::kinetics::{self, Kinetics};
use tomolith_planning::response::{Axes, ResponseFit};
use tomolith_planning::voxel::Setup;

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/calibration")
}

/// A measurement of the examples.
fn measured(name: &str) -> Curve {
    Curve::read(&examples().join(name)).unwrap()
}

fn worst(fit: &Polynomial, table: &Curve) -> f64 {
    fit.residuals(table)
        .iter()
        .fold(0.0, |worst, r| worst.max(r.abs()))
}

#[test]
fn printed_gray_fits_are_the_least_squares_of_the_table() {
    let (visible, uv) = (measured("gray-visible.csv"), measured("gray-uv.csv"));
    let quadratic = Polynomial::fit(&visible, 2).unwrap();
    let [c0, c1, c2] = quadratic.coefficients[..] else {
        panic!()
    };
    near!(c2, -1.98883e-4, 5e-10);
    near!(c1, 0.095_088_72, 5e-9);
    near!(c0, -6.71576, 5e-6);
    let line = Polynomial::fit(&uv, 1).unwrap();
    near!(line.coefficients[1], 0.128_668, 5e-7);
    near!(line.coefficients[0], -0.194_783, 5e-7);
    assert!(worst(&line, &uv) < 0.0225, "{}", worst(&line, &uv));
    let off = worst(&quadratic, &visible);
    assert!((0.12..0.122).contains(&off), "{off}");
    // As printed, to one digit
    let printed = Polynomial {
        coefficients: vec![-6.7158, 0.0951, -0.0002],
    };
    let off = worst(&printed, &visible);
    assert!((0.13..0.132).contains(&off), "{off}");
    let [low, high] = printed.usable(255.0).unwrap();
    near!(low, 86.27, 0.01);
    near!(high, 237.75, 1e-9);
    // Printed and table agree to the digits of the table: at white 4.530 against 4.62
    near!(quadratic.at(255.0), 4.600, 0.001);
    near!(printed.at(255.0), 4.530, 0.001);
}

#[test]
fn a_monotone_curve_has_every_point_and_rises_where_the_quadratic_falls() {
    let table = measured("gray-visible.csv");
    let found = GrayCurve::new(&table, 255.0, CurveForm::Monotone).unwrap();
    for (gray, irradiance) in table.doses.iter().zip(&table.responses) {
        near!(found.at(*gray), irradiance, 1e-6);
    }
    let points = found.points();
    assert_eq!(
        (points.len(), points[0], points[255][0]),
        (256, [0.0, 0.0], 1.0)
    );
    assert!(points.windows(2).all(|w| w[1][1] > w[0][1]));
    assert_eq!(found.notes.len(), 1, "below gray 102 nothing was measured");
    let Err(error) = GrayCurve::new(&table, 255.0, CurveForm::Quadratic) else {
        panic!("a curve that falls was taken")
    };
    let message = error.to_string();
    tomolith_core::contains!(message, "usable from gray 86.15 to 239.06");
    assert!(GrayCurve::new(&measured("gray-uv.csv"), 255.0, CurveForm::Line).is_ok());
}

#[test]
fn gray_values_of_both_forms_give_the_irradiance_of_the_example() {
    let table = measured("gray-uv.csv");
    // UV: 30 600 frames of 0.04 s; 11.3 mm × 20 mm, in the text 2.3 cm²
    for (form, area_cm2, gray) in [
        (CurveForm::Line, 2.26, 147.6),
        (CurveForm::Line, 2.3, 145.1),
        (CurveForm::Monotone, 2.26, 148.6),
        (CurveForm::Monotone, 2.3, 145.7),
    ] {
        let fit = GrayCurve::new(&table, 255.0, form).unwrap();
        let irradiance = 52e3 / (area_cm2 * 1224.0);
        // 0.8 of a gray value of 0.129 mW/cm²
        near!(fit.at(gray), irradiance, 0.1);
    }
}

#[test]
fn inhibitor_and_kinetics_fit_the_balls_where_one_dose_misses() {
    for (name, spread) in [("balls-uv.csv", 0.35), ("balls-visible.csv", 0.08)] {
        let balls = measured(name);
        let fit = kinetics::fit(&balls).unwrap();
        near!(fit.dose_spread, spread, 0.005);
        assert!(fit.worst() < 0.05, "{fit:?}");
        assert!((0.0..=1.0).contains(&fit.kinetics.order), "{fit:?}");
        assert!(fit.kinetics.min_irradiance < balls.doses[0]);
    }
}

#[test]
fn kinetics_come_back_from_their_own_times() {
    let made_of = Kinetics {
        min_irradiance: 3.0,
        supply_per_s: 0.004,
        cure_s: 80.0,
        order: 0.5,
        reference: 30.0,
    };
    let pairs: Vec<[f64; 2]> = [4.0, 5.0, 7.0, 10.0, 15.0, 20.0, 30.0]
        .iter()
        .map(|i| [*i, made_of.time_s(*i).unwrap()])
        .collect();
    let fit = kinetics::fit(&Curve::of_pairs(&pairs).unwrap()).unwrap();
    near!(fit.kinetics.min_irradiance, 3.0, 1e-4);
    near!(fit.kinetics.supply_per_s, 0.004, 1e-6);
    near!(fit.kinetics.order, 0.5, 1e-4);
    near!(fit.kinetics.inhibitor_dose(), 750.0, 0.2);
    assert!(fit.worst() < 1e-6);
    assert!(fit.ranges.is_some());
    let few = kinetics::fit(&Curve::of_pairs(&pairs[..3]).unwrap());
    assert!(matches!(few, Err(Error::Config { key, .. }) if key == "irradiance"));
    // A best m below its range ends at 0
    let beyond = Kinetics {
        order: -0.2,
        ..made_of
    };
    let pairs: Vec<[f64; 2]> = (pairs.iter())
        .map(|[i, _]| [*i, beyond.time_s(*i).unwrap()])
        .collect();
    let fit = kinetics::fit(&Curve::of_pairs(&pairs).unwrap()).unwrap();
    assert_eq!(fit.kinetics.order, 0.0);
    assert!(fit.is_order_at_end);
    let [.., supply, _, order] = fit.ranges.unwrap();
    assert!(supply[0] < fit.kinetics.supply_per_s && fit.kinetics.supply_per_s < supply[1]);
    assert!(order[0] == 0.0 && order[1] > 0.0);
}

/// Times of k = 0.01 per s, I_min = 3 mW/cm², t₁ = 60 s and m = 1, with noise of 2 %.
const LINEAR: [f64; 10] = [3.2, 3.5, 4.0, 5.0, 7.0, 10.0, 14.0, 20.0, 30.0, 40.0];

fn of_linear(times: [f64; 10]) -> kinetics::KineticsFit {
    kinetics::fit(&Curve::new(&LINEAR, &times).unwrap()).unwrap()
}

/// The least of all has m = −0.3; that of 0 ≤ m ≤ 1 is not at the nearer end (bounded least squares of scipy).
#[test]
fn the_best_order_of_the_range_is_looked_for_within_it() {
    let fit = of_linear([
        1022.12, 871.343, 745.032, 576.634, 400.435, 276.895, 188.501, 131.904, 89.0211, 68.1724,
    ]);
    near!(fit.kinetics.order, 0.991, 0.001);
    near!(fit.kinetics.supply_per_s, 0.00448, 1e-5);
    assert!(!fit.is_order_at_end);
    let cost: f64 = fit.residuals.iter().map(|r| r.ln_1p().powi(2)).sum();
    near!(cost, 0.002_025_3, 1e-7);
}

/// The valley is bent: slopes at the least would say 0.00049 ± 0.00018, and 0.2 ± 1.1 for the order. Ends of the profile: scipy.
#[test]
fn a_range_reaches_as_far_as_the_points_allow() {
    let fit = of_linear([
        987.394, 848.172, 749.506, 575.548, 396.464, 273.4, 188.909, 137.267, 92.4286, 70.0598,
    ]);
    near!(fit.kinetics.supply_per_s, 4.933e-4, 1e-6);
    let [irradiance, supply, cure, order] = fit.ranges.unwrap();
    near!(supply[0], 4.047e-4, 1e-6);
    near!(supply[1], 1.434e-3, 3e-6);
    near!(irradiance[1], 1.897, 0.005);
    near!(cure[1], 35.84, 0.1);
    near!(order[1], 0.907, 0.005);
    assert_eq!(order[0], 0.0);
}

/// Where the law is nearly linear in what is fitted, a range is one standard error either way.
#[test]
fn ranges_of_many_points_are_standard_errors() {
    let made_of = Kinetics {
        min_irradiance: 3.0,
        supply_per_s: 0.01,
        cure_s: 60.0,
        order: 0.6,
        reference: 40.0,
    };
    let times: Vec<f64> = (LINEAR.iter().enumerate())
        .map(|(i, irradiance)| {
            let noise = [0.001, -0.001, -0.001, 0.001][i % 4];
            made_of.time_s(*irradiance).unwrap() * f64::exp(noise)
        })
        .collect();
    let fit = kinetics::fit(&Curve::new(&LINEAR, &times).unwrap()).unwrap();
    let found = fit.kinetics;
    let values = [
        found.min_irradiance,
        found.supply_per_s,
        found.cure_s,
        found.order,
    ];
    for ([low, high], value) in fit.ranges.unwrap().iter().zip(values) {
        near!((high - value) / (value - low), 1.0, 0.1, "{fit:?}");
    }
}

/// The induction time in closed form against its differential equation.
#[test]
fn induction_is_the_solution_of_its_equation() {
    let resin = Kinetics {
        min_irradiance: 2.0,
        supply_per_s: 0.05,
        cure_s: 1e-9,
        order: 0.0,
        reference: 5.0,
    };
    let (light, dt) = (5.0, 1e-4);
    let kappa = resin.supply_per_s / resin.min_irradiance;
    let (mut inhibitor, mut seconds) = (1.0, 0.0);
    while inhibitor > 0.0 {
        inhibitor += dt * (resin.supply_per_s * (1.0 - inhibitor) - kappa * light);
        seconds += dt;
    }
    near!(resin.time_s(light).unwrap(), seconds, 2e-3);
    near!(resin.inhibitor_used(0.5), 0.25, 1e-12);
}

#[test]
fn stiffness_is_a_logistic_of_the_place() {
    let table = Columns::read(&examples().join("stiffness.csv")).unwrap();
    let pairs = table.pairs("x_plus_y_mm", "modulus_mpa").unwrap();
    let axes = Axes {
        log_dose: false,
        log_response: true,
    };
    let fit = ResponseFit::logistic(&pairs, axes, false).unwrap();
    let found = fit.logistic.as_ref().unwrap();
    near!(found.params.lower, 0.705, 0.03);
    near!(10f64.powf(found.params.lower), 5.1, 0.3);
    near!(found.params.upper, 3.959, 0.05);
    near!(found.params.midpoint, 11.0, 0.05);
    near!(1.0 / found.params.steepness, 0.64, 0.05);
    assert!(fit.rms <= 0.135, "{}", fit.rms);
    near!(fit.width_10_90().unwrap(), 2.8, 0.2);
    let errors = found.errors.unwrap();
    assert!(errors[3] > 0.01 && errors[3] < 0.2, "{errors:?}");
    // The table is one that a job takes
    let job: toml::Value = toml::from_str(&fit.job_table()).unwrap();
    near!(
        job["response"]["logistic"]["midpoint"].as_float().unwrap(),
        11.0,
        0.05,
    );
}

/// Rates of the notes' table: axis, half way, wall.
#[test]
fn rates_of_a_turn() {
    for (depth, [axis, half, wall], ratio) in [
        (0.1, [4.54e-5, 1.63e-3, 0.51596], 11_365.0),
        (0.25, [1.832e-2, 5.088e-2, 0.54054], 29.5),
        (0.5, [0.1353, 0.1935, 0.58544], 4.33),
        (1.0, [0.3679, 0.4175, 0.67108], 1.82),
        (2.0, [0.6065, 0.6367, 0.77791], 1.28),
        (5.0, [0.8187, 0.8317, 0.89060], 1.09),
    ] {
        let vial = TurningVial {
            radius_mm: 7.0,
            penetration_mm: 7.0 * depth,
            turn_deg_per_s: 5.0,
        };
        for (r, expected) in [(0.0, axis), (0.5, half), (1.0, wall)] {
            let found = vial.mean_rate(r);
            near!(found / expected, 1.0, 2.5e-3, "{depth} {r}: {found}");
            // To the digits that the table has
            let digits = 10f64.powf(-3.0 + expected.log10().floor() + 1.0);
            near!(found, expected, 0.6 * digits, "{depth} {r}");
        }
        near!(vial.mean_rate(0.0), (-1.0 / depth).exp(), 1e-12);
        near!(vial.mean_rate(1.0), wall_rate(1.0 / depth), 1e-9);
        assert!((vial.mean_rate(1.0) / vial.mean_rate(0.0) / ratio - 1.0).abs() < 3e-3);
    }
}

/// Half of a turn a wall point stands in the light, the other half in the dark, however strongly the resin absorbs.
#[test]
fn a_wall_point_of_a_dark_resin_gets_half_of_the_light() {
    for penetration_mm in [1e-8, 1e-15, 1e-20] {
        let vial = TurningVial {
            radius_mm: 8.0,
            penetration_mm,
            turn_deg_per_s: 5.0,
        };
        near!(vial.mean_rate(1.0), 0.5, 1e-6, "{penetration_mm}");
    }
}

/// Where the two series meet, and against the integral (2/π)·∫ e^(−x·cos θ) dθ over a quarter turn.
#[test]
fn bessel_less_struve_is_its_integral() {
    let integral = |x: f64| {
        let n = 20_000;
        let h = PI / 2.0 / f64::from(n);
        let at = |i: i32| (-x * ((f64::from(i) + 0.5) * h).cos()).exp();
        2.0 / PI * h * (0..n).map(at).sum::<f64>()
    };
    for x in [0.0, 0.3, 1.0, 4.0, 10.0, 14.9, 15.1, 20.0, 40.0] {
        near!(bessel_less_struve(x), integral(x), 2e-8);
    }
}

#[test]
fn the_wall_has_a_plateau_from_20_to_50_s() {
    let vial = TurningVial {
        radius_mm: 1.0,
        penetration_mm: 0.1,
        turn_deg_per_s: 5.0,
    };
    near!(vial.dose(1.0, 0.0, 20.0), 18.556, 5e-4);
    near!(vial.dose(1.0, 0.0, 50.0), 18.575, 5e-4);
    near!(vial.dose(1.0, 0.0, 72.0), 37.149, 5e-4);
    near!(vial.dose(1.0, 0.0, 72.0), 72.0 * vial.mean_rate(1.0), 1e-9);
    near!(
        vial.dose(1.0, 0.0, 720.0),
        10.0 * vial.dose(1.0, 0.0, 72.0),
        1e-9,
    );
    // Curing time leads back to the dose, through turns too, and the axis is slow by e^10
    for (r, phase, dose) in [
        (1.0, 0.0, 10.0),
        (0.5, 1.0, 3.0),
        (1.0, 2.0, 100.0),
        (0.3, 4.0, 0.01),
    ] {
        let time = vial.curing_s(r, phase, dose).unwrap();
        near!(vial.dose(r, phase, time), dose, 1e-6);
    }
    near!(
        vial.curing_s(0.0, 0.0, 1e-3).unwrap(),
        1e-3 * 10f64.exp(),
        1e-6,
    );
    let rest = TurningVial {
        turn_deg_per_s: 0.0,
        ..vial
    };
    near!(rest.dose(1.0, 0.0, 3.0), 3.0, 1e-9);
    near!(rest.curing_s(1.0, PI, 1.0).unwrap(), 20f64.exp(), 1.0);
}

#[test]
fn pixel_and_step_cross_at_the_closed_form() {
    let setup = Setup {
        pixels: 1024.0,
        fps: 60.0,
        dose_time_s: 4.0,
        penetration_mm: 12.0,
        turn_deg_per_s: None,
    };
    let crossing = setup.crossing_mm().unwrap();
    near!(
        crossing,
        12.0 * (PI * 1024.0 / (2.0 * 60.0 * 4.0)).ln(),
        1e-12,
    );
    let difference = |radius: f64| {
        let size = setup.printed(radius);
        size.step_mm - size.pixel_mm
    };
    assert!(difference(0.99 * crossing) > 0.0 && difference(1.01 * crossing) < 0.0);
    near!(difference(crossing), 0.0, 1e-12);
    // The step is largest where R = D_p
    let step = |radius: f64| setup.printed(radius).step_mm;
    assert!(step(12.0) > step(11.9) && step(12.0) > step(12.1));
    assert_eq!(setup.corrected_crossing_mm(), Some(crossing));
    // No more angles than a half turn has: at 36°/s these are 5 s of frames
    let turning = Setup {
        turn_deg_per_s: Some(36.0),
        ..setup
    };
    let (slow, fast) = (turning.corrected(1.0), turning.corrected(60.0));
    near!(slow.angles, 60.0 * setup.curing_s(1.0), 1e-9);
    near!(slow.covered, setup.curing_s(1.0) / 5.0, 1e-12);
    near!(fast.angles, 300.0, 1e-9);
    assert_eq!(fast.covered, 1.0);
    // At R* (23 mm) the axis takes 27 s: half turns of 5 s have shown their angles before, half turns of 60 s have not
    assert_eq!(turning.corrected_crossing_mm(), None);
    let slow = Setup {
        turn_deg_per_s: Some(3.0),
        ..setup
    };
    assert_eq!(slow.corrected_crossing_mm(), Some(crossing));
    assert_eq!(Setup { fps: 1e5, ..setup }.crossing_mm(), None);
}

#[test]
fn plain_posts_are_wider_than_they_should_be() {
    for (width, low, high) in [(1.0, 1.95, 2.45), (5.0, 1.23, 1.32)] {
        let mut ratios = Vec::new();
        for step_deg in [0.25, 1.0, 2.0, 4.0] {
            for radius in [0.0, 0.5, 0.9] {
                let post = Post {
                    pixels: 200,
                    width,
                    radius,
                    step_deg,
                };
                post.check().unwrap();
                ratios.extend(post.plain().fwhm().map(|fwhm| fwhm / width));
            }
        }
        let least = ratios.iter().copied().fold(f64::INFINITY, f64::min);
        let most = ratios.iter().copied().fold(0.0, f64::max);
        assert!(least > low && most < high, "{width}: {least} to {most}");
    }
}

/// In the continuum: (4/π)·ln(1 + √2) of the width in the middle, 0.766 at the middle of an edge.
#[test]
fn a_wide_post_has_the_dose_of_the_continuum() {
    let post = Post {
        pixels: 256,
        width: 40.0,
        radius: 0.0,
        step_deg: 0.5,
    };
    let plain = post.plain();
    let middle = plain.dose(20.0, -20.0);
    near!(middle / 40.0, 4.0 / PI * (1.0 + 2f64.sqrt()).ln(), 0.005);
    near!(plain.dose(40.0, -20.0) / 40.0, 0.766, 0.01);
}

#[test]
fn a_corrected_post_is_nearly_as_wide_as_it_should_be() {
    let post = Post {
        pixels: 64,
        width: 5.0,
        radius: 0.5,
        step_deg: 2.0,
    };
    let (plain, corrected) = (post.plain(), post.corrected());
    for (plain, corrected) in plain.fwhm().into_iter().zip(corrected.fwhm()) {
        assert!(plain / 5.0 > 1.2, "{plain}");
        assert!((corrected / 5.0 - 1.0).abs() < 0.12, "{corrected}");
    }
}
