//! Several species at one exposure. A print has only one, so species that are best at doses of their own are printed together only where their networks gel at
//! doses of that ratio.
//!
//! **Definition** Of all doses, the one at which the lowest IoU of all species is the largest, every network gelling at that dose. Between the points of
//! their curves IoU is taken as linear.

use serde::Serialize;

/// What several species become together.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OneExposure {
    /// The dose at which every network gels, in units of the job.
    pub gel_dose: f64,
    /// IoU of each species there.
    pub iou: Vec<f64>,
}

impl OneExposure {
    /// Of the IoU of each species over its dose, `[dose, IoU]` with ascending doses; None for fewer than two species, and where no dose lies on all curves.
    ///
    /// ```
    /// use tomolith_report::species::OneExposure;
    /// // Perfect at doses of 1 and 2: nearest to that together at 1.5
    /// let [a, b] = [[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]], [[1.0, 0.0], [2.0, 1.0], [3.0, 0.0]]];
    /// let both = OneExposure::of(&[a.to_vec(), b.to_vec()]).unwrap();
    /// assert_eq!((both.gel_dose, both.iou), (1.5, vec![0.5, 0.5]));
    /// ```
    #[must_use]
    pub fn of(curves: &[Vec<[f64; 2]>]) -> Option<Self> {
        if curves.len() < 2 {
            return None;
        }
        let mut doses: Vec<f64> = curves.iter().flatten().map(|point| point[0]).collect();
        doses.sort_by(f64::total_cmp);
        // Two lines that cross meet between the points of the curves
        let middles = doses
            .windows(2)
            .map(|pair| f64::midpoint(pair[0], pair[1]))
            .collect::<Vec<_>>();
        let all = doses.into_iter().chain(middles);
        let at = |gel_dose: f64| {
            let iou = curves.iter().map(|curve| iou_at(curve, gel_dose));
            let iou = iou.collect::<Option<Vec<_>>>()?;
            Some(OneExposure { gel_dose, iou })
        };
        all.filter_map(at)
            .max_by(|a, b| a.lowest().total_cmp(&b.lowest()))
    }

    /// The lowest of the IoU.
    fn lowest(&self) -> f64 {
        self.iou.iter().copied().fold(f64::INFINITY, f64::min)
    }
}

/// IoU at a dose, between the points of its curve; None beside them.
fn iou_at(curve: &[[f64; 2]], dose: f64) -> Option<f64> {
    let pair = curve
        .windows(2)
        .find(|pair| pair[0][0] <= dose && dose <= pair[1][0])?;
    let [[low, before], [high, after]] = [pair[0], pair[1]];
    let share = if high > low {
        (dose - low) / (high - low)
    } else {
        0.0
    };
    Some(before + share * (after - before))
}
