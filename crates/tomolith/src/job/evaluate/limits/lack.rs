//! Why light leaves a part of the part without what it needs.

use crate::job::resolve::acting::Acting;
use crate::job::resolve::reach::EndedBy;
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::report::number::significant;
use crate::target::Shape;

/// Shares of the brightest pixel's contribution from which on leaving out what is below is felt.
const FELT: f64 = 0.1;

/// Why light leaves a part of the part without what it needs, and the key that changes it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Lack {
    /// Share of the part, where it is known; else 1.
    pub(crate) share: f64,
    pub(crate) key: String,
    pub(crate) verb: &'static str,
    /// As the beginning of a sentence.
    pub(crate) found: String,
    /// Whether it comes before all other causes, which follow from it.
    pub(crate) comes_first: bool,
}

impl Lack {
    /// Of a species on the voxels of its print, lit by these lights of a job.
    pub(crate) fn of(
        job: &ResolvedJob,
        shape: &dyn Shape,
        fine: &Voxels,
        lights: &[Acting<'_>],
    ) -> Option<Self> {
        Self::of_resin(job)
            .or_else(|| Self::of_motion(job, shape))
            .or_else(|| Self::of_place(job, fine))
            .or_else(|| Self::of_selection(lights))
    }

    fn of_resin(job: &ResolvedJob) -> Option<Self> {
        let is_dark = !job.optics.dark_inside().is_empty();
        is_dark.then(|| Lack {
            share: 1.0,
            key: match job.resin().attenuation_per_mm {
                Some(_) => "resin.attenuation_per_mm".to_owned(),
                None => "resin.absorption_per_mm".to_owned(),
            },
            verb: "lower",
            found: "Next to no light arrives in the middle of the vial".to_owned(),
            comes_first: true,
        })
    }

    fn of_motion(job: &ResolvedJob, shape: &dyn Shape) -> Option<Self> {
        let found = job.optics.unreached_moving(shape)?;
        Some(Lack {
            share: found.share,
            key: job.sides_key(found.light),
            verb: found.ended_by.verb(),
            found: "In some frames the part turns out of the light's field".to_owned(),
            comes_first: true,
        })
    }

    /// Of what lies too far from the axis, or above or below the light: whichever is more of the part.
    fn of_place(job: &ResolvedJob, fine: &Voxels) -> Option<Self> {
        let both = [Self::of_field(job, fine), Self::of_heights(job, fine)];
        let found = both.into_iter().flatten();
        found.max_by(|a, b| a.share.total_cmp(&b.share))
    }

    fn of_field(job: &ResolvedJob, fine: &Voxels) -> Option<Self> {
        let found = job
            .optics
            .unreached(&fine.target.inside, fine.target.gray)?;
        let percent = significant(100.0 * found.share, 2);
        Some(Lack {
            share: found.share,
            key: match found.ended_by {
                EndedBy::Vial => "vial".to_owned(),
                _ => job.sides_key(found.light),
            },
            verb: found.ended_by.verb(),
            found: format!("Light does not reach {percent} % of the part from all sides"),
            comes_first: false,
        })
    }

    fn of_heights(job: &ResolvedJob, fine: &Voxels) -> Option<Self> {
        let found = job.optics.missed(&fine.target.inside, fine.target.gray)?;
        let percent = significant(100.0 * found.share, 2);
        Some(Lack {
            share: found.share,
            key: format!("light[{}].{}", found.light, found.remedy.key),
            verb: found.remedy.verb,
            found: format!("Light passes above or below {percent} % of the part in some frames"),
            comes_first: false,
        })
    }

    fn of_selection(lights: &[Acting<'_>]) -> Option<Self> {
        let least = |acting: &&Acting<'_>| acting.light.selection.min_contribution;
        let acting = lights.iter().max_by(|a, b| least(a).total_cmp(&least(b)))?;
        let least = least(&acting);
        (least >= FELT).then(|| Lack {
            share: 1.0,
            key: format!("light[{}].selection.min_contribution", acting.index),
            verb: "lower",
            found: format!(
                "Pixels stay dark that bring the part less than {} of what the best one brings",
                significant(least, 2)
            ),
            comes_first: false,
        })
    }
}
