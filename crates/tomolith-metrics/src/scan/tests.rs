use super::*;
use tomolith_core::check::{on_threads, random};
use tomolith_core::target::label::{OUTSIDE, PART, VOID};

/// From, to, and the IoU between them as a fraction.
type Piece = (f64, f64, u128, u128);

/// Everything by sorting: pieces of the threshold axis.
fn brute_pieces(labels: &[u8], response: &[f32]) -> Vec<Piece> {
    let counted: Vec<(f32, u8)> = response
        .iter()
        .copied()
        .zip(labels.iter().copied())
        .filter(|(_, l)| *l != OUTSIDE)
        .collect();
    let mut values: Vec<f64> = counted.iter().map(|c| f64::from(c.0)).collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    let parts = counted.iter().filter(|c| c.1 == PART).count() as u128;
    let start = values[0].min(0.0);
    let mut edges = vec![start];
    edges.extend(values.iter().filter(|v| **v > start));
    edges.push(f64::INFINITY);
    edges
        .windows(2)
        .map(|e| {
            let above = |l: u8| {
                counted
                    .iter()
                    .filter(|c| c.1 == l && f64::from(c.0) > e[0])
                    .count() as u128
            };
            (e[0], e[1], above(PART), parts + above(VOID))
        })
        .collect()
}

fn highest(pieces: &[Piece]) -> Option<&Piece> {
    pieces.iter().max_by(|a, b| (a.2 * b.3).cmp(&(b.2 * a.3)))
}

fn brute_best(pieces: &[Piece]) -> Option<Plateau> {
    let best = highest(pieces)?;
    let is_best = |p: &Piece| p.2 * best.3 == best.2 * p.3;
    if best.2 == 0 {
        return None;
    }
    let mut longest: Option<Plateau> = None;
    for group in pieces
        .chunk_by(|a, b| is_best(a) && is_best(b))
        .filter(|g| is_best(&g[0]))
    {
        let run = Plateau {
            from: group[0].0,
            to: group[group.len() - 1].1,
            iou: best.2 as f64 / best.3 as f64,
        };
        if longest.is_none_or(|l| run.to - run.from > l.to - l.from) {
            longest = Some(run);
        }
    }
    longest
}

fn brute_length(pieces: &[Piece]) -> f64 {
    let best = highest(pieces).unwrap();
    pieces
        .iter()
        .filter(|p| 20 * p.2 * best.3 > 19 * best.2 * p.3)
        .map(|p| p.1.clamp(0.0, 1.0) - p.0.clamp(0.0, 1.0))
        .sum()
}

/// The run of pieces round a threshold whose IoU is at least the best − 1/100.
fn brute_round(pieces: &[Piece], best: &Plateau) -> (f64, f64) {
    let (_, _, above, below) = *highest(pieces).unwrap();
    let is_near = |p: &Piece| 100 * p.2 * below + below * p.3 >= 100 * above * p.3;
    let of_best = pieces.iter().position(|p| p.0 == best.from).unwrap();
    let before = pieces[..of_best].iter().rev().take_while(|p| is_near(p));
    let after = pieces[of_best..].iter().take_while(|p| is_near(p));
    let from = before.last().map_or(best.from, |p| p.0);
    (from, after.last().unwrap().1)
}

/// Responses of many kinds: overlapping, separated, few values, tiny steps, negative, constant.
fn cases() -> Vec<(Vec<u8>, Vec<f32>)> {
    let mut cases = Vec::new();
    for seed in 0..240u64 {
        let mut dice = random(seed);
        let n = 1 + (dice() * 120.0) as usize;
        let kind = seed % 8;
        let mut labels = Vec::new();
        let mut response = Vec::new();
        for _ in 0..n {
            let label = [OUTSIDE, VOID, VOID, PART, PART][(dice() * 5.0) as usize];
            let shift = f32::from(label) * 0.2;
            labels.push(label);
            response.push(match kind {
                0 => dice() + shift,
                1 => f32::from(label) + 0.3 * dice(),
                2 => (dice() * 5.0).floor() / 4.0,
                // All in a few buckets: only the low bits differ
                3 => f32::from_bits(0.75f32.to_bits() + (dice() * 3000.0) as u32),
                4 => dice() - 0.7 + shift,
                5 => 0.5,
                6 => {
                    if label == OUTSIDE {
                        f32::NAN
                    } else {
                        -dice()
                    }
                }
                _ => {
                    (dice() * 3.0).floor() * if dice() < 0.5 { 0.0 } else { -0.0 }
                        + (dice() * 2.0).floor()
                }
            });
        }
        cases.push((labels, response));
    }
    cases
}

#[test]
fn best_plateau_and_window_are_those_of_a_full_sort() {
    let mut seen = [0; 3];
    for (labels, response) in cases() {
        let scan = Scan::new(&labels, &response).unwrap();
        if !labels.contains(&PART) {
            assert_eq!((scan.best_plateau(), scan.length_near_best()), (None, None));
            seen[0] += 1;
            continue;
        }
        let pieces = brute_pieces(&labels, &response);
        let best = brute_best(&pieces);
        assert_eq!(scan.best_plateau(), best, "{labels:?} {response:?}");
        seen[if best.is_some() { 1 } else { 2 }] += 1;
        let round = scan.round_best();
        assert_eq!(round.is_some(), best.is_some());
        if let (Some(round), Some(best)) = (round, best) {
            let expected = brute_round(&pieces, &best);
            assert_eq!((round.from, round.to), expected, "{labels:?} {response:?}");
            assert_eq!(round.iou, best.iou);
        }
        if best.is_some() {
            let (a, b) = (
                scan.length_near_best().unwrap_or(0.0),
                brute_length(&pieces),
            );
            assert!((a - b).abs() < 1e-12, "{a} {b}");
            // Near another print's IoU, to within a bucket at the ends
            let cut = 0.57 * best.map_or(0.0, |best| best.iou);
            let all = pieces.iter();
            let above = all.filter(|p| p.2 as f64 / p.3.max(1) as f64 > cut);
            let length: f64 = above
                .map(|p| p.1.clamp(0.0, 1.0) - p.0.clamp(0.0, 1.0))
                .sum();
            let found = scan.length_near(cut / 0.95).unwrap_or(0.0);
            assert!((found - length).abs() < 1e-3, "{found} {length}");
        }
    }
    assert!(seen[0] > 0 && seen[1] > 150, "{seen:?}");
}

#[test]
fn a_hundredth_below_the_best_is_still_round_it() {
    // 100 part voxels: without the weakest IoU is 99/100, which counts; without the two weakest 98/100, which does not
    let labels: Vec<u8> = [VOID].into_iter().chain([PART; 100]).collect();
    let mut response = vec![0.9f32; 101];
    response[..3].copy_from_slice(&[0.25, 0.5, 0.625]);
    let round = Scan::new(&labels, &response).unwrap().round_best().unwrap();
    // Below 0.25 the void gels too: 100/101 is within a hundredth of 1
    assert_eq!((round.from, round.to, round.iou), (0.0, 0.625, 1.0));
    // Two void voxels at 0.75: 100/102 is the best, 99/102 near it, 98/102 is not, and 98/100 beyond 0.75 is near again
    let labels = [[VOID; 2].as_slice(), &[PART; 100]].concat();
    let mut response = vec![0.9f32; 102];
    response[..4].copy_from_slice(&[0.75, 0.75, 0.5, 0.625]);
    let round = Scan::new(&labels, &response).unwrap().round_best().unwrap();
    assert_eq!((round.from, round.to), (0.0, 0.625));
}

#[test]
fn a_dark_part_is_not_printed_by_any_threshold() {
    let scan = Scan::new(&[PART, PART, VOID], &[0.0, -0.0, 0.0]).unwrap();
    assert_eq!(
        (scan.best_plateau(), scan.length_near_best()),
        (None, Some(0.0))
    );
    // With negative responses too, the lowest threshold prints all that is above the lowest value
    let scan = Scan::new(&[PART, VOID], &[-0.5, -1.5]).unwrap();
    assert_eq!(
        scan.best_plateau(),
        Some(Plateau {
            from: -1.5,
            to: -0.5,
            iou: 1.0
        })
    );
}

#[test]
fn the_curve_is_exact_where_it_is_given() {
    for (labels, response) in cases() {
        let scan = Scan::new(&labels, &response).unwrap();
        let curve = scan.curve(50);
        assert_eq!(curve.is_empty(), !labels.contains(&PART));
        for [t, iou] in curve {
            assert_eq!(Some(iou), scan.iou_at(t), "{t}");
        }
    }
}

#[test]
fn spreads_are_those_of_the_definition() {
    for (labels, response) in cases() {
        let scan = Scan::new(&labels, &response).unwrap();
        for (label, spread) in [(PART, scan.part()), (VOID, scan.void())] {
            let values: Vec<f64> = labels
                .iter()
                .zip(&response)
                .filter(|(l, _)| **l == label)
                .map(|(_, v)| f64::from(*v))
                .collect();
            let Some(spread) = spread else {
                assert!(values.is_empty());
                continue;
            };
            let n = values.len() as f64;
            let mean = values.iter().sum::<f64>() / n;
            let deviation = (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n).sqrt();
            assert_eq!(spread.count, values.len() as u64);
            assert!(
                (spread.mean - mean).abs() < 1e-12 && (spread.deviation - deviation).abs() < 1e-9
            );
            assert_eq!(
                f64::from(spread.min),
                values.iter().copied().fold(f64::INFINITY, f64::min)
            );
        }
    }
}

#[test]
fn many_blocks_give_the_same_numbers_for_any_number_of_threads() {
    let n = 5 * BLOCK + 777;
    let mut dice = random(5);
    let labels: Vec<u8> = (0..n)
        .map(|i| if i % 3 == 0 { PART } else { VOID })
        .collect();
    let response: Vec<f32> = labels
        .iter()
        .map(|l| 0.3 * f32::from(*l) + 0.5 * dice())
        .collect();
    let run = |threads| {
        on_threads(threads, || {
            let scan = Scan::new(&labels, &response).unwrap();
            (
                scan.part(),
                scan.void(),
                scan.best_plateau(),
                scan.length_near_best(),
                scan.curve(99),
                scan.histogram([0.0, 1.0], 10),
            )
        })
    };
    let one = run(1);
    assert_eq!(one, run(3));
    assert_eq!(
        one.5.iter().map(|c| c[0]).sum::<u64>(),
        n.div_ceil(3) as u64
    );
    // t = 0.65: 9/10 of the part above, 3/10... the part lies in [0.6, 1.1), the void in [0.3, 0.8)
    let mut values: Vec<(f32, u8)> = response
        .iter()
        .copied()
        .zip(labels.iter().copied())
        .collect();
    values.sort_by(|a, b| b.0.total_cmp(&a.0));
    let (mut a, mut b, mut best) = (0u64, 0u64, 0.0f64);
    let total = n.div_ceil(3) as f64;
    for group in values.chunk_by(|x, y| x.0 == y.0) {
        a += group.iter().filter(|v| v.1 == PART).count() as u64;
        b += group.iter().filter(|v| v.1 == VOID).count() as u64;
        best = best.max(a as f64 / (total + b as f64));
    }
    assert_eq!(one.2.unwrap().iou, best);
}

#[test]
fn numbers_that_are_not_finite_count_only_inside() {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let error = Scan::new(&[PART, VOID], &[1.0, bad]).err();
        assert!(matches!(error, Some(Error::NonFinite { .. })));
        assert!(Scan::new(&[PART, OUTSIDE], &[1.0, bad]).is_ok());
    }
    assert!(matches!(Scan::new(&[PART], &[]), Err(Error::Shape { .. })));
}
