//! The brightness of given patterns with the lowest loss.
//!
//! **Equation** s that minimizes L(s·d) for a dose d, s > 0: steps of ln s that double from 1 on, up to a factor of 2, so that none passes over the doses that print
//! to darkness, whose loss may be lower than that of too much light; then golden sections of ln s until they are narrower than 10⁻⁵. Where the loss becomes 0 the
//! search ends there.
//!
//! **Limits** the minimum next to s = 1 where there are several; factors from 10⁻⁶ to 10⁶. **Cost** about 30 values of the objective, and one for each factor of 2.
//!
//! ```
//! let (factor, loss) = tomolith_optimize::brightness::lowest(&|s| (s - 2.5f64).powi(2) + 1.0);
//! assert!((factor - 2.5).abs() < 1e-3 && loss < 1.0001);
//! ```

/// The largest factor, and the smallest is its inverse.
const FARTHEST: f64 = 1e6;
/// The first step of ln s.
const STEP: f64 = 0.02;
/// Its largest one.
const LONGEST: f64 = std::f64::consts::LN_2;
/// How near ln s is found.
const NEAR: f64 = 1e-5;
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// The factor with the lowest loss, and that loss; 1 where no other is lower.
pub fn lowest(loss: &dyn Fn(f64) -> f64) -> (f64, f64) {
    let at = |log: f64| (log, loss(log.exp()));
    let mut middle = (0.0, loss(1.0));
    if middle.1 == 0.0 {
        return (1.0, 0.0);
    }
    let (mut left, mut right) = (at(-STEP), at(STEP));
    // Downhill, by steps that double
    let down = if right.1 < middle.1 { 1.0 } else { -1.0 };
    if down < 0.0 {
        std::mem::swap(&mut left, &mut right);
    }
    let mut step = STEP;
    while right.1 < middle.1 {
        if right.1 == 0.0 || right.0.abs() >= FARTHEST.ln() {
            return (right.0.exp(), right.1);
        }
        step = (2.0 * step).min(LONGEST);
        (left, middle, right) = (middle, right, at(right.0 + down * step));
    }
    while (right.0 - left.0).abs() > NEAR && middle.1 > 0.0 {
        // Into the longer part
        let towards = if (right.0 - middle.0).abs() > (middle.0 - left.0).abs() {
            right.0
        } else {
            left.0
        };
        let new = at(middle.0 + (1.0 - GOLDEN) * (towards - middle.0));
        let is_right = towards == right.0;
        match (new.1 < middle.1, is_right) {
            (true, true) => (left, middle) = (middle, new),
            (true, false) => (right, middle) = (middle, new),
            (false, true) => right = new,
            (false, false) => left = new,
        }
    }
    (middle.0.exp(), middle.1)
}

#[cfg(test)]
mod tests {
    use super::lowest;

    #[test]
    fn the_lowest_is_found_on_both_sides_and_far_away() {
        for goal in [0.02, 0.7, 0.999, 1.0, 1.001, 1.8, 90.0] {
            let (factor, _) = lowest(&|s| (s / goal - 1.0).powi(2) + 0.1);
            assert!((factor / goal - 1.0).abs() < 1e-3, "{factor} for {goal}");
        }
    }

    #[test]
    fn darkness_is_not_taken_for_the_end_of_too_much_light() {
        // A part that asks for 0.9, and a void of 0.4 of its dose that bears 0.7
        let loss =
            |dose: f64| (0.9 - dose).max(0.0).powi(2) + (0.4 * dose - 0.7).max(0.0).powi(2) + 0.01;
        for bright in [3.0, 448.0, 4e4, 1e-3, 1e-5] {
            let (factor, found) = lowest(&|s| loss(s * bright));
            assert!(found < 0.0101, "{factor} of {bright}: {found}");
        }
    }

    #[test]
    fn nothing_is_changed_where_nothing_is_gained() {
        assert_eq!(lowest(&|_| 0.0), (1.0, 0.0));
        assert!((lowest(&|_| 2.0).0 - 1.0).abs() < 0.02);
        assert!(lowest(&|_| f64::NAN).0.is_finite());
        assert!(lowest(&|s| 1.0 / s).0 >= 1e3, "ends somewhere");
    }

    #[test]
    fn a_loss_of_zero_ends_the_search() {
        let band = |s: f64| (2.0 - s).max(s - 2.2).max(0.0);
        assert_eq!(lowest(&band).1, 0.0);
        assert_eq!(band(lowest(&band).0), 0.0);
    }
}
