//! The dose model of a job's lights: one of all together, or one of each, whose doses mix to those of species.

use crate::error::Result;
use crate::grid::{Volume, VolumeGrid};
use crate::job::resolve::species::Row;
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::models::masked::MaskedModel;
use crate::models::planner::{self, ModelPlan};
use crate::models::spectral;
use crate::models::{DoseModel, Family, HostModel, OpticalScene, Work};

/// The model of a job's lights: that of all together, or one for each and M; its dose diffuses where the job's does.
///
/// `wanted` are the voxels that each species needs, `unwanted` those it should not reach: a light becomes unknowns where it drives what is
/// wanted, or inhibits what is not.
pub(crate) fn planned(
    job: &ResolvedJob,
    asked: Option<&Family>,
    optics: OpticalScene<'_>,
    grid: &VolumeGrid,
    voxels: Option<&[Voxels]>,
    work: &Work,
) -> Result<ModelPlan> {
    let mut plan = match job.mixing.as_deref() {
        Some(rows) => {
            let mix = |models| mixed(models, rows);
            joined(rows, asked, optics, grid, voxels, work, mix)?
        }
        None => {
            let wanted = voxels.map(|voxels| voxels[0].wanted());
            planner::plan(asked, optics, grid, wanted.as_ref(), work)?
        }
    };
    if super::in_time::diffuses(job) {
        let diffused = super::in_time::diffused(job, Box::new(plan.model))?;
        plan.model = MaskedModel::new(diffused, Vec::new(), 1.0);
    }
    let surrogate = plan.surrogate.take();
    plan.surrogate = surrogate
        .map(|m| super::in_time::diffused(job, m))
        .transpose()?;
    Ok(plan)
}

fn mixed(lights: Vec<HostModel>, rows: &[Row]) -> Result<HostModel> {
    Ok(Box::new(spectral::mixed(lights, rows)?))
}

/// Models of one light each, joined by `join`; their surrogates are mixed.
pub(crate) fn joined(
    rows: &[Row],
    asked: Option<&Family>,
    optics: OpticalScene<'_>,
    grid: &VolumeGrid,
    voxels: Option<&[Voxels]>,
    work: &Work,
    join: impl Fn(Vec<HostModel>) -> Result<HostModel>,
) -> Result<ModelPlan> {
    let count = optics.lights.len();
    let mut plans = Vec::with_capacity(count);
    for i in 0..count {
        let scene = OpticalScene {
            lights: &optics.lights[i..=i],
            optics: &optics.optics[i..=i],
            ..optics
        };
        let wanted = voxels.map(|voxels| lit_by(rows, i, voxels));
        let part = work.part(1.0 / count as f64);
        plans.push(planner::plan(asked, scene, grid, wanted.as_ref(), &part)?);
    }
    let dark = if plans.iter().all(|plan| plan.dark.is_empty()) {
        Vec::new()
    } else {
        let dark_of = |plan: &ModelPlan| {
            let pixels: usize = plan.model.patterns().iter().map(|p| p.len()).sum();
            if plan.dark.is_empty() {
                vec![false; pixels]
            } else {
                plan.dark.clone()
            }
        };
        plans.iter().flat_map(dark_of).collect()
    };
    let is_on_card = plans.iter().any(|plan| plan.is_on_card);
    let mut reasons: Vec<&str> = plans.iter().map(|plan| plan.reason.as_str()).collect();
    reasons.dedup();
    let reason = reasons.join("; then ");
    let surrogates: Option<Vec<_>> = plans.iter_mut().map(|plan| plan.surrogate.take()).collect();
    let boxed = |plan: ModelPlan| Box::new(plan.model) as HostModel;
    let model = join(plans.into_iter().map(boxed).collect())?;
    Ok(ModelPlan {
        is_on_card,
        reason: format!(
            "{} species by {count} lights, each alone: {reason}",
            rows.len()
        ),
        model: MaskedModel::new(model, Vec::new(), 1.0),
        dark,
        surrogate: surrogates.map(|models| mixed(models, rows)).transpose()?,
    })
}

/// Voxels that a light can help: those of species that it drives where they are wanted, of species that it inhibits where they are not.
fn lit_by(rows: &[Row], light: usize, voxels: &[Voxels]) -> Volume<u8> {
    let mut lit = Volume::filled(voxels[0].labels.grid.clone(), 0u8);
    for ((_, row), voxels) in rows.iter().zip(voxels) {
        let useful = match row[light] {
            m if m > 0.0 => voxels.wanted(),
            m if m < 0.0 => voxels.unwanted(),
            _ => continue,
        };
        for (lit, useful) in lit.values.iter_mut().zip(useful.values) {
            *lit |= useful;
        }
    }
    lit
}
