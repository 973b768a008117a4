//! The material of a job, and the voxels that hold it.

use crate::error::{Error, Result};
use crate::grid::{Volume, VolumeGrid};
use crate::job::resolve::ResolvedJob;
use crate::job::spec::species::Row;
use crate::job::spec::{DiffusionSpec, JobSpec};
use crate::target::Role;
use tomolith_core::parallel::table;
use tomolith_material::diffusion::Scheme;
use tomolith_material::domain::Domain;
use tomolith_material::mixing::Mixing;
use tomolith_material::photopolymer::{Curing, Network, Params, Photopolymer};

/// The material of a job: what it says, or a threshold at the resin's critical dose.
pub(crate) fn material(
    spec: &JobSpec,
    rows: Option<&[Row]>,
    domain: Domain,
) -> Result<Photopolymer> {
    let names = rows.map_or_else(
        || vec!["resin".to_owned()],
        |rows| rows.iter().map(|(name, _)| name.clone()).collect(),
    );
    let material = spec.material.as_ref();
    let diffusion = material.and_then(|material| material.diffusion);
    let params = match material.and_then(|material| material.photopolymer.clone()) {
        Some(photopolymer) => photopolymer,
        None => {
            let critical = spec.resin.critical_dose_mj_per_mm3.ok_or_else(|| {
                let found = match diffusion {
                    Some(_) => "a dose that diffuses in a resin without resin.critical_dose_mj_per_mm3",
                    None => "a schedule without a material, and a resin without resin.critical_dose_mj_per_mm3",
                };
                Error::config(
                    "material",
                    found,
                    "one of the two: the dose that turns the resin solid, or [material.photopolymer]",
                )
            })?;
            let network = |name: &String| Network {
                dose_diffusion_mm2_per_s: diffusion.map_or(0.0, |d| d.mm2_per_s),
                ..Network::new(name, Curing::threshold(critical))
            };
            Params {
                diffusion: if diffusion.is_some() {
                    Scheme::Spectral
                } else {
                    Scheme::default()
                },
                ..Params::new(names.iter().map(network).collect())
            }
        }
    };
    let matrix = match rows {
        Some(rows) => rows.iter().map(|(_, row)| row.clone()).collect(),
        None => vec![vec![1.0; spec.light.len()]],
    };
    let key = "material.photopolymer";
    Photopolymer::new(params, Mixing::new(matrix)?, domain).map_err(|e| e.under(key))
}

impl ResolvedJob {
    pub(crate) fn photopolymer(&self, domain: Domain) -> Result<Photopolymer> {
        material(&self.spec, self.mixing.as_deref(), domain)
    }

    /// How the dose diffuses; None where it stays.
    pub(crate) fn diffusion(&self) -> Option<DiffusionSpec> {
        let material = self.spec.material.as_ref();
        material.and_then(|material| material.diffusion)
    }
}

/// Voxels of resin between walls that nothing passes, and air where the job says so.
pub(crate) fn domain(job: &ResolvedJob, grid: &VolumeGrid) -> Result<Domain> {
    let mut domain = Domain::new(grid.clone());
    let (material, photopolymer) = (job.spec.material.as_ref(), job.spec.photopolymer());
    if photopolymer.is_some_and(|params| params.diffusion == Scheme::Faces) {
        domain = domain.with_walls(&resin(job, grid)?)?;
    }
    if material.is_some_and(|material| material.air_on_top) {
        domain = domain.with_air_on_top();
    }
    Ok(domain)
}

/// Which voxels hold resin: those in the vial, but in no body and no insert.
pub(crate) fn resin(job: &ResolvedJob, grid: &VolumeGrid) -> Result<Volume<bool>> {
    let optics = &job.optics;
    let holds = |i: usize| {
        let middle = grid.middle(i);
        optics.vial.in_resin(middle) && !optics.in_obstacle(middle)
    };
    let mut values = table(grid.len(), holds);
    if let Some(insert) = job.first().shape.body(Role::Insert) {
        let shares = insert.sample(grid)?.values;
        let pairs = values.iter_mut().zip(shares);
        pairs.for_each(|(resin, share)| *resin &= share < 0.5);
    }
    Ok(Volume {
        grid: grid.clone(),
        values,
    })
}
