//! From measurements to what limits a print.

use crate::grid::PatternGrid;
use crate::job::evaluate::limits::*;
use crate::job::resolve::acting::Acting;
use crate::metrics::{gray, iou};
use crate::optics::light::Light;
use crate::optics::resin::Resin;
use crate::optimize::{Row, StopReason};
use crate::target::HorizontalFaces;

/// The numbers of the first example.
fn measurements() -> Measurements {
    Measurements {
        kind: &iou::KIND,
        optimized: Some(1.0),
        written: Some(1.0),
        own_turning: Some(0.9992),
        turning: Some(0.975),
        unrounded: None,
        pitches_mm: [0.056, 0.028],
        bits: 8,
        has_machine: false,
        by_pixels: false,
        dark_light: None,
        apart_from_mm: None,
        has_dim_pixels: false,
        arcs: Some(Arcs {
            text: "2°".to_owned(),
            key: "light.angles".to_owned(),
        }),
        saw_finer: false,
        pixel_key: "light[0].projector.collimated.pixel_pitch_mm".to_owned(),
        pixel_light: None,
        is_simulated: false,
        is_toy: false,
        has_few_angles: false,
        lack: None,
        has_level_heights: false,
        has_no_iterations: false,
        has_own_sub_angles: false,
        held_by: None,
        best: None,
        stands: false,
        starts_at_zero: false,
        has_background: false,
        ends: None,
        falling: None,
    }
}

/// The same example with other IoUs: as optimized, as written, turning on the same voxels and on finer ones.
fn measured([optimized, written, own_turning, turning]: [f64; 4]) -> Measurements {
    Measurements {
        optimized: Some(optimized),
        written: Some(written),
        own_turning: Some(own_turning),
        turning: Some(turning),
        ..measurements()
    }
}

#[track_caller]
fn begins(text: &str, with: &str) {
    assert!(text.starts_with(with), "{text}");
}

#[track_caller]
fn ends(text: &str, with: &str) {
    assert!(text.ends_with(with), "{text}");
}

fn losses(limits: &PrintLimits) -> Vec<(Cause, f64)> {
    let losses = limits.causes.iter();
    losses
        .map(|l| (l.cause, (l.loss * 1e4).round() / 1e4))
        .collect()
}

#[test]
fn rounding_is_told_from_the_voxels_that_see_it() {
    // Two bits: the job's own voxels see nothing of it, the optimizer's do
    let limits = Measurements {
        unrounded: Some(0.997),
        bits: 2,
        own_turning: None,
        saw_finer: true,
        ..measured([0.990, 0.990, 0.990, 0.987])
    };
    let limits = limits.limits();
    assert_eq!(
        limits.sentence,
        "Predicted IoU 0.987 (before rounding 0.997): 2 bits −0.010. To improve, raise `evaluate.bit_depth`."
    );
    let losses = losses(&limits);
    assert_eq!(losses, [(Cause::Levels, 0.01), (Cause::Optics, 0.003)]);
    begins(
        &limits.causes[0].advice,
        "Written with 2 bits the print has IoU 0.987 instead of 0.997.",
    );
}

#[test]
fn the_largest_loss_comes_first_and_names_the_key() {
    let limits = measurements().limits();
    assert_eq!(
        limits.sentence,
        "Predicted IoU 0.975 (the optimizer saw 1.000): finer grid −0.024, rotation −0.001. To improve, lower `grid.pitch_mm`."
    );
    assert_eq!(
        losses(&limits),
        [
            (Cause::Grid, 0.0242),
            (Cause::Turning, 0.0008),
            (Cause::Levels, 0.0),
            (Cause::Optics, 0.0)
        ]
    );
    assert_eq!(
        limits.causes[0].advice,
        "On voxels of 28 µm instead of 56 µm the print has IoU 0.975 instead of 0.999: the optimizer resolves nothing below a voxel. \
         Lower `grid.pitch_mm`."
    );
    let toy = Measurements {
        is_toy: true,
        ..measurements()
    };
    let sentence = toy.limits().sentence;
    ends(
        &sentence,
        "rotation −0.001. This is a toy of the job: run without `--toy` before you change it.",
    );
    // Nothing to gain, nothing to change
    let advice = |i: usize| limits.causes[i].advice.as_str();
    assert_eq!(
        advice(1),
        "The vial turns by 2° during each frame, which gives IoU 0.999 instead of 1.000."
    );
    assert_eq!(
        advice(2),
        "Written with 8 bits the patterns have IoU 1.000 as before on the job's own voxels."
    );
    ends(advice(3), "voxels: there is nothing left to improve.");
}

#[test]
fn a_part_beyond_the_light_needs_a_larger_field() {
    let limits_of = |optimized: f64, share: f64, key: &str| {
        let lack = Lack {
            share,
            key: key.to_owned(),
            verb: "raise",
            found: "Light does not reach 24 % of the part from all sides".to_owned(),
            comes_first: false,
        };
        let measured = Measurements {
            lack: Some(lack),
            ..measured([optimized; 4])
        };
        measured.limits()
    };
    let limits = limits_of(0.8, 0.24, "light.pixels");
    ends(&limits.sentence, "To improve, raise `light.pixels`.");
    let advice = &limits.causes[0].advice;
    ends(
        advice,
        "Light does not reach 24 % of the part from all sides: raise `light.pixels`.",
    );
    // Half of all sides are enough for a good print
    let good = limits_of(0.985, 1.0, "light.offset_mm").sentence;
    ends(&good, "pixel_pitch_mm`, with more light.pixels.");
    // A rim of the part is not what lacks most
    let rim = limits_of(0.8, 0.02, "light.pixels").sentence;
    ends(&rim, "pixel_pitch_mm`, with more light.pixels.");
}

#[test]
fn what_follows_from_the_light_comes_behind_it_where_the_part_turns_out_of_it() {
    let sentence_of = |optimized: f64| {
        let lack = Lack {
            share: 0.3,
            key: "light[0].pixels".to_owned(),
            verb: "raise",
            found: "In some frames the part turns out of the light's field".to_owned(),
            comes_first: true,
        };
        let measured = Measurements {
            lack: Some(lack),
            ..measured([optimized, optimized, optimized, 0.77])
        };
        measured.limits().sentence
    };
    ends(&sentence_of(0.91), "To improve, raise `light[0].pixels`.");
    // Where the light lacks nothing, the grid does
    ends(&sentence_of(0.9995), "To improve, lower `grid.pitch_mm`.");
}

#[test]
fn turning_that_the_optimization_did_not_see_is_not_counted_twice() {
    let measured = Measurements {
        saw_finer: true,
        has_own_sub_angles: true,
        ..measured([1.0, 1.0, 0.983, 0.981])
    };
    let limits = measured.limits();
    assert_eq!(
        losses(&limits)[..2],
        [(Cause::Turning, 0.017), (Cause::Optics, 0.002)]
    );
    ends(&limits.sentence, "To improve, raise `light.sub_angles`.");
}

#[test]
fn voxels_are_called_coarser_only_where_they_are() {
    let sentence_of = |pitches_mm| {
        let measured = Measurements {
            saw_finer: true,
            pitches_mm,
            ..measurements()
        };
        measured.limits().sentence
    };
    assert!(sentence_of([0.056, 0.014]).contains("(on the job's own, coarser voxels 1.000)"));
    assert!(sentence_of([0.056, 0.056]).contains("(before the patterns are written 1.000)"));
}

#[test]
fn the_losses_of_a_run_add_up_to_what_is_missing() {
    let limits = measured([0.95, 0.94, 0.935, 0.93]).limits();
    let sum: f64 = limits.causes.iter().map(|l| l.loss).sum();
    assert!((1.0 - sum - 0.93).abs() < 1e-12);
    assert_eq!(limits.causes[0].cause, Cause::Optics);
    ends(
        &limits.sentence,
        "To improve, try a lower `light[0].projector.collimated.pixel_pitch_mm`, with more light.pixels.",
    );
}

#[test]
fn iterations_take_the_share_by_which_the_loss_still_fell() {
    let row = |iteration: usize, loss: f64| Row {
        loss,
        ..Row::at(iteration)
    };
    let history = |end: f64| -> Vec<Row> {
        let mut rows: Vec<Row> = (0..=30).map(|i| row(i, 100.0)).collect();
        rows.extend((31..=40).map(|i| row(i, end)));
        rows
    };
    let falling = Falling::of(StopReason::Iterations, &history(80.0)).unwrap();
    assert_eq!(
        (falling.fall.last, falling.fall.all, falling.key),
        (10, 40, "stop.iterations")
    );
    assert!((falling.fall.share - 0.2).abs() < 1e-12);
    assert_eq!(Falling::of(StopReason::Iterations, &history(99.5)), None);
    assert_eq!(Falling::of(StopReason::Steady, &history(80.0)), None);
    assert_eq!(Falling::of(StopReason::Iterations, &[]), None);
    let text_of = |end| Fall::of(&history(end)).map(|fall| fall.to_string());
    assert_eq!(
        text_of(80.0).as_deref(),
        Some("not converged: the loss fell by 20 % in the last 10 iterations")
    );
    assert_eq!(
        text_of(99.5).as_deref(),
        Some("converged: the loss fell by 0.5 % in the last 10 iterations")
    );
    assert_eq!(text_of(101.0), None);
    assert_eq!(Fall::of(&history(80.0)[..1]), None);
    let limits = Measurements {
        falling: Some(falling),
        ..measured([0.9; 4])
    }
    .limits();
    // A fifth of what the patterns lack, and a fifth of the rest
    let of = |cause| limits.causes.iter().find(|l| l.cause == cause).unwrap();
    let [iterations, optics] = [Cause::Iterations, Cause::Optics].map(of);
    tomolith_core::near!(iterations.loss, 0.036, 1e-12);
    tomolith_core::near!(optics.loss, 0.064, 1e-12);
    assert_eq!(
        iterations.advice,
        "The loss function still fell by 20 % in the last 10 of 40 iterations: more may recover a part of what the patterns lack. Raise `stop.iterations`."
    );
    begins(
        &limits.causes[0].advice,
        "Before they are written, the patterns reach IoU 0.900 on the job's own voxels; most of the rest is the limit of this light.",
    );
}

fn acting<'a>(index: usize, name: Option<&'a str>, light: &'a Light) -> Acting<'a> {
    Acting { index, name, light }
}

#[test]
fn flat_ends_within_rows_are_what_limits_a_prism() {
    // Rows of 56 µm with an edge at 0: a gear 3 mm high reaches 26.786 of them to each side
    let rows = PatternGrid::full_turn(180, 0.0, 64, 176, 0.056);
    let light = Light::new(rows, Resin::absorbing(1.5, 0.1));
    let ends_of = |part_mm| RowEnds::of_prism(part_mm, &[acting(0, None, &light)]);
    let ends = ends_of([-1.5, 1.5]).unwrap();
    assert!((ends.share - 2.0 * (27.0 * 0.056 - 1.5) / 3.0).abs() < 1e-12);
    let gear = |turning| Measurements {
        own_turning: None,
        saw_finer: true,
        ends: Some(ends.clone()),
        ..measured([0.995, 0.995, 0.995, turning])
    };
    let limits = gear(0.985).limits();
    assert_eq!(losses(&limits)[0], (Cause::Ends, 0.008));
    begins(
        &limits.causes[0].advice,
        "The part ends at z = −1.5 and 1.5 mm, inside rows of pixels, but light ends with a row, at −1.512 and 1.512 mm. 0.8 % of the part's volume lies between.",
    );
    // The light's share is what is left
    assert!(
        (limits.causes[1].loss - 0.007).abs() < 1e-9 && limits.causes[1].cause == Cause::Optics
    );
    // A print that seems better than that was judged on voxels that end with the rows
    let is_hidden = |gear: Measurements| {
        let sentence = gear.limits().sentence;
        sentence.contains("rows of pixels −0.008, which voxels of this size do not show")
    };
    assert!(is_hidden(gear(1.0)) && !is_hidden(gear(0.985)));
    // So was one that loses no more than its few levels do
    let of_few_levels = Measurements {
        bits: 3,
        optimized: Some(1.0),
        written: Some(0.91),
        ..gear(0.91)
    };
    assert!(is_hidden(of_few_levels));
    let gear = Measurements {
        ends: ends_of([-1.512, 1.512]),
        ..gear(0.985)
    };
    assert!(gear.limits().causes.iter().all(|l| l.cause != Cause::Ends));
}

#[test]
fn horizontal_faces_inside_rows_limit_any_part_and_the_light_should_move() {
    // Rows of 0.1 mm from z = −0.5 to 0.5; faces of 3 mm² 0.03 mm below an edge
    let rows = PatternGrid::full_turn(90, 0.0, 10, 10, 0.1);
    let light = Light::new(rows, Resin::absorbing(1.5, 0.1));
    let faces = HorizontalFaces {
        volume_mm3: 2.0,
        areas: vec![(0.17, 3.0), (0.37, 3.0)],
    };
    let ends_of = |part_mm| RowEnds::of(&faces, part_mm, &[acting(0, None, &light)]).unwrap();
    let found = ends_of([-0.4, 0.4]);
    assert!((found.share - 0.09).abs() < 1e-12, "{found:?}");
    let moved = found.worthy_move().unwrap();
    assert!(
        (moved + 0.03).abs() < 0.1 / 64.0 && found.best_move.1 < 0.003,
        "{found:?}"
    );
    // Not where its tip would leave the light
    assert_eq!(ends_of([-0.4, 0.49]).worthy_move(), None);
    let limits = Measurements {
        saw_finer: true,
        own_turning: None,
        ends: Some(found),
        ..measured([0.995, 0.995, 0.995, 0.9])
    }
    .limits();
    begins(
        &limits.causes[0].advice,
        "Horizontal faces of the part lie inside rows of pixels, but light ends with a row. 9 % of the part's volume lies between, ",
    );
    ends(
        &limits.sentence,
        "move the light down by 0.03 mm with `light.offset_mm`.",
    );
}

#[test]
fn of_several_lights_the_one_that_limits_is_named() {
    let light = |frames, pitch| {
        let pixels = PatternGrid::full_turn(frames, 0.0, 4, 8, pitch);
        Light::new(pixels, Resin::absorbing(1.5, 0.1))
    };
    let lights = [light(120, 0.05), light(180, 0.1)];
    let both = [("violet", 0), ("uv", 1)].map(|(name, i)| acting(i, Some(name), &lights[i]));
    let arcs = Arcs::of(&both).unwrap();
    assert_eq!(arcs.text, "3° (violet) and 2° (uv)");
    assert_eq!(arcs.key, "light[0].angles");
    let one = Arcs::of(&[acting(0, None, &lights[0])]).unwrap();
    assert_eq!((&one.text[..], &one.key[..]), ("3°", "light.angles"));
    let measured = Measurements {
        arcs: Some(arcs),
        pixel_key: "light[1].projector.collimated.pixel_pitch_mm".to_owned(),
        pixel_light: Some("uv".to_owned()),
        ends: RowEnds::of_prism([-0.15, 0.2], &both[1..]),
        ..measured([0.9, 0.9, 0.88, 0.88])
    };
    let limits = measured.limits();
    let joined: String = limits
        .causes
        .iter()
        .map(|l| l.advice.clone() + "\n")
        .collect();
    for text in [
        "The vial turns by 3° (violet) and 2° (uv) during each frame",
        "Raise `light[0].angles`",
        "Finer pixels of uv on the same field (more light.pixels) may bring more",
        "inside rows of pixels of uv, but",
    ] {
        assert!(joined.contains(text), "{joined}");
    }
    ends(&limits.sentence, "pixel_pitch_mm` (uv).");
}

#[test]
fn a_threshold_that_is_far_off_and_too_few_sides_are_named() {
    let turning = |iou| Measurements {
        saw_finer: true,
        own_turning: None,
        ..measured([1.0, 1.0, 1.0, iou])
    };
    let off = Measurements {
        best: Some(0.98),
        ..turning(0.0)
    };
    ends(
        &off.limits().sentence,
        "exposure −0.980. To improve, change `evaluate.threshold`.",
    );
    let few = Measurements {
        has_few_angles: true,
        ..turning(0.5)
    };
    ends(&few.limits().sentence, "To improve, raise `light.angles`.");
    let held = Measurements {
        has_few_angles: false,
        held_by: Some("bounds.max".to_owned()),
        ..few
    };
    ends(&held.limits().sentence, "To improve, raise `bounds.max`.");
    // What was given is not improved by a key of the job
    let given = Measurements {
        is_simulated: true,
        ..measured([0.5; 4])
    };
    let sentence = given.limits().sentence;
    assert!(!sentence.contains("To improve"), "{sentence}");
}

#[test]
fn with_few_levels_and_a_named_threshold_the_losses_add_up_too() {
    let few = Measurements {
        saw_finer: true,
        own_turning: None,
        bits: 1,
        unrounded: Some(0.95),
        best: Some(0.762),
        ..measured([1.0, 1.0, 1.0, 0.638])
    };
    let sum: f64 = losses(&few.limits()).iter().map(|(_, loss)| loss).sum();
    assert!((sum - (1.0 - 0.638)).abs() < 1e-12, "{sum}");
    let light = |limits: &PrintLimits| {
        let of_light = limits
            .causes
            .iter()
            .find(|limit| limit.cause == Cause::Optics);
        of_light.unwrap().advice.clone()
    };
    // What others take leaves nothing to the light, but that is no good print
    let none_left = Measurements {
        unrounded: Some(1.0),
        ..few
    };
    ends(
        &light(&none_left.limits()),
        "IoU 0.762: the other causes take what it lacks.",
    );
}

#[test]
fn angles_that_only_the_optimization_counts_are_no_finer_grid() {
    let stands = Measurements {
        stands: true,
        pitches_mm: [0.1; 2],
        ..measured([0.6, 0.6, 0.4, 0.4])
    };
    let limits = stands.limits();
    assert!(limits.causes.iter().all(|limit| limit.cause != Cause::Grid));
    let turning = limits
        .causes
        .iter()
        .find(|limit| limit.cause == Cause::Turning);
    let turning = turning.unwrap();
    assert_eq!(
        (turning.key.as_str(), turning.loss),
        ("evaluate.sub_angles", 0.6 - 0.4)
    );
}

#[test]
fn a_loss_of_zero_from_the_start_and_a_bright_background_are_named() {
    let low = || Measurements {
        saw_finer: true,
        ..measured([0.5, 0.5, 0.5, 0.5])
    };
    let idle = Measurements {
        has_no_iterations: true,
        starts_at_zero: true,
        ..low()
    };
    ends(&idle.limits().sentence, "To improve, change `objective`.");
    let lit = Measurements {
        has_background: true,
        ..low()
    };
    ends(&lit.limits().sentence, "To improve, lower `bounds.min`.");
}

#[test]
fn what_was_not_measured_is_not_said() {
    // A simulation of patterns optimizes nothing
    let patterns = Measurements {
        is_simulated: true,
        ..measurements()
    };
    let sentence = patterns.limits().sentence;
    begins(
        &sentence,
        "Predicted IoU 0.975 (unwritten, on the job's grid: 1.000): ",
    );
    ends(
        &sentence,
        "To improve, make the patterns anew: lower `grid.pitch_mm`.",
    );
    // Of frames it is not known what was wanted
    let frames = Measurements {
        is_simulated: true,
        optimized: None,
        ..measurements()
    };
    assert_eq!(losses(&frames.limits()), [(Cause::Turning, 0.0008)]);
    assert_eq!(
        frames.limits().sentence,
        "Predicted IoU 0.975: rotation −0.001."
    );
    // An optimization that averages its frames over their arcs
    let turning = Measurements {
        own_turning: None,
        ..measurements()
    };
    assert_eq!(losses(&turning.limits())[0], (Cause::Grid, 0.025));
    let empty = Measurements {
        optimized: Some(0.0),
        written: None,
        own_turning: None,
        turning: None,
        ..measurements()
    };
    assert_eq!(empty.limits().sentence, "");
}

#[test]
fn the_error_of_a_gray_print_rises_where_an_iou_falls() {
    let limits = Measurements {
        kind: &gray::RMS,
        ..measured([0.126, 0.13, 0.13, 0.128])
    }
    .limits();
    begins(
        &limits.sentence,
        "Predicted rms error 0.128 (the optimizer saw 0.126): 8 bits +0.004, finer grid −0.002.",
    );
    assert_eq!(
        losses(&limits)[..2],
        [(Cause::Optics, 0.126), (Cause::Levels, 0.004)]
    );
}

#[test]
fn light_that_a_machine_leaves_at_level_0_is_named() {
    let on_machine = || Measurements {
        has_machine: true,
        written: Some(0.953),
        own_turning: None,
        ..measured([0.984, 0.953, 0.953, 0.95])
    };
    let machine = on_machine();
    let advice_of = |machine: &Measurements| machine.limits().causes[0].advice.clone();
    let apart = advice_of(&machine);
    assert!(apart.contains("Bring the pixels"), "{apart}");
    let few = |by_pixels| {
        advice_of(&Measurements {
            bits: 4,
            by_pixels,
            ..on_machine()
        })
    };
    assert!(few(true).contains("Bring the pixels"));
    tomolith_core::contains!(few(false), "Raise `evaluate.bit_depth`");
    let dark = Measurements {
        dark_light: Some([0.05, 0.125]),
        ..machine
    };
    let text = advice_of(&dark);
    tomolith_core::contains!(
        text,
        "gives 5 % of white, 0.125 in these patterns",
        "Raise `bounds.min`."
    );
    tomolith_core::contains!(
        dark.limits().sentence,
        "To improve, count the light of level 0: raise `bounds.min`."
    );
    let dim = Measurements {
        dark_light: None,
        has_dim_pixels: true,
        ..dark
    };
    let text = dim.limits().sentence;
    tomolith_core::contains!(
        text,
        "and the image away from dead or dim ones, in `printer`"
    );
}
