//! Where an optimizer begins.
//!
//! *What must it do, and who does it.* A [`InitialPatterns`] makes first patterns from the target; the table [`STARTS`] holds them.
//! Whatever the method, the patterns lie within the bounds, and one forward call scales them so that the part gets its dose.

pub mod fbp;
pub mod given;
pub mod level;
pub mod lsqr;

use super::Limits;
pub use given::GivenFiles;
use tomolith_core::dose::{DoseLayout, DoseModel, Quantity, Work};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{Bounds, Field, HostField};
use tomolith_core::grid::Volume;
use tomolith_core::kind::{Kind, Read};
use tomolith_core::parallel::elements;
use tomolith_core::response::{Identity, Response};
use tomolith_core::target::{Target, label};
use tomolith_objective::buffer::near_the_other_kind;

/// What first patterns are made from.
pub struct StartInput<'a, F: Field = HostField> {
    /// The model.
    pub model: &'a dyn DoseModel<Field = F>,
    /// The target on the grid of the model's first output.
    pub target: &'a Target,
    /// Label of each voxel ([`label`]), array order.
    pub labels: &'a Volume<u8>,
    /// M of the one equation: the target is a response, and its inverse the dose that is wanted.
    pub response: &'a dyn Response,
    /// Smallest and largest value per light.
    pub limits: &'a [Limits],
    /// Absorption of the active species in each voxel, array order; None where it is the same everywhere.
    pub absorption: Option<&'a Volume<f32>>,
}

impl<'a, F: Field> StartInput<'a, F> {
    /// For a target that is a dose, in a resin that absorbs alike everywhere.
    pub fn new(
        model: &'a dyn DoseModel<Field = F>,
        target: &'a Target,
        labels: &'a Volume<u8>,
        limits: &'a [Limits],
    ) -> Self {
        StartInput {
            model,
            target,
            labels,
            response: &Identity,
            limits,
            absorption: None,
        }
    }
}

/// Absorption below this part of the largest counts as none: no light makes up for it.
const NEGLIGIBLE: f32 = 1e-6;

/// Share of a response that ends, such as a logistic one, for which no dose is asked.
const REST: f64 = 0.01;

/// A method that makes initial patterns.
pub trait InitialPatterns<F: Field = HostField>: std::fmt::Debug + Send + Sync {
    /// First patterns, within the bounds.
    ///
    /// # Errors
    /// [`Error::Canceled`], [`Error::Unsupported`] when the model does not allow it, or not enough memory.
    fn patterns(&self, input: &StartInput<F>, work: &Work) -> Result<F>;
    /// Whether the patterns are given, and do not depend on the target.
    fn is_given(&self) -> bool {
        false
    }
    /// Whether it asks for the doses with which the material responds as the target wants.
    fn asks_for_doses(&self) -> bool {
        !self.is_given()
    }
    /// The files that a job begins with, where it begins with files.
    fn files(&self) -> Option<&GivenFiles<F>> {
        None
    }
}

/// Reads a start from its section.
pub type BuildStart<F = HostField> = Read<Box<dyn InitialPatterns<F>>>;

/// Every start, for patterns in host memory; the first is the default.
pub static STARTS: &[Kind<BuildStart>] = starts();

/// Every start, wherever patterns live; the first is the default.
#[must_use]
pub const fn starts<F: Field>() -> &'static [Kind<BuildStart<F>>] {
    const {
        &[
            fbp::kind(),
            level::uniform(),
            level::zero(),
            given::kind(),
            lsqr::kind(),
        ]
    }
}

impl<F: Field> StartInput<'_, F> {
    /// The layout of the model's first output, whose grid target and labels must share.
    fn layout(&self) -> Result<&DoseLayout> {
        let layout = self.model.outputs().first().ok_or_else(|| {
            Error::unsupported("a start from the target", "the model has no output")
        })?;
        let absorption = self.absorption.map(|map| ("absorption", &map.grid));
        let grids = [
            ("target", &self.target.inside.grid),
            ("labels", &self.labels.grid),
        ];
        for (what, found) in grids.into_iter().chain(absorption) {
            if found.shape != layout.grid.shape {
                return Err(Error::shape(
                    format!("{what} of the start"),
                    layout.grid.shape,
                    found.shape,
                ));
            }
        }
        Ok(layout)
    }

    /// The wanted dose of every element of the dose field, 0 where a voxel is no part or does not count.
    fn wanted_dose(&self) -> Result<F> {
        let layout = self.layout()?;
        let most = self.most_dose();
        let dose_of = |value: f32| self.response.inverse(value).clamp(0.0, most);
        let (gray, part) = (self.target.gray, dose_of(1.0));
        let mut wanted = Volume::filled(layout.grid.clone(), 0.0f32);
        elements(&mut wanted.values, |i, wanted| {
            *wanted = match self.labels.values[i] {
                label::OUTSIDE => 0.0,
                _ if gray => dose_of(self.target.inside.values[i]),
                label::PART => part,
                _ => 0.0,
            };
        });
        let mut field = layout.field_of(&wanted);
        if let Some(cells) = &layout.cells {
            let mut labels = layout.field_of(self.labels);
            cells.label(&mut labels);
            let wanted_of = |&label: &u8| if label == label::PART { part } else { 0.0 };
            field = labels.iter().map(wanted_of).collect();
        }
        self.dose_of(&field)
    }

    /// The largest dose that is asked for: 1, or that of nearly all of a response that ends; the last of it would ask for more without end.
    #[expect(clippy::cast_possible_truncation, reason = "doses are f32")]
    fn most_dose(&self) -> f32 {
        let [lowest, highest] = self.response.range();
        if highest.is_infinite() {
            return f32::MAX;
        }
        let nearly = highest - REST * (highest - lowest.max(0.0));
        self.response.inverse(nearly as f32).max(1.0)
    }

    /// A dose whose first output has these elements.
    fn dose_of(&self, elements: &[f32]) -> Result<F> {
        let mut dose = self.model.new_dose()?;
        dose.write(self.layout()?.offset, elements);
        Ok(dose)
    }

    /// A dose over α^`power`, α being relative to the largest; 0 where nothing absorbs. The dose itself where α is the same everywhere.
    fn over_absorption(&self, dose: &F, power: i32) -> Result<F> {
        let mut dose = dose.clone();
        if let Some(map) = self.absorption {
            let layout = self.layout()?;
            let largest = map.values.iter().copied().fold(0.0, f32::max);
            let factor = |&alpha: &f32| match alpha / largest {
                relative if relative > NEGLIGIBLE => relative.powi(-power),
                _ => 0.0,
            };
            let inverse = Volume::new(map.grid.clone(), map.values.iter().map(factor).collect());
            let mut factors = dose.zeros_like();
            factors.write(layout.offset, &layout.field_of(&inverse));
            dose.multiply(&factors);
        }
        Ok(dose)
    }

    /// A dose times the part of its voxel that each element has: what stands for integrals over the resin.
    fn weighed(&self, dose: &F) -> F {
        let mut dose = dose.clone();
        for layout in self.model.outputs() {
            if let Some(cells) = &layout.cells {
                let mut shares = dose.zeros_like();
                shares.fill(1.0);
                shares.write(layout.offset, &cells.shares(layout.len()));
                dose.multiply(&shares);
            }
        }
        dose
    }

    /// Brings patterns into the bounds and scales them: least squares between their dose and the wanted one, over the voxels
    /// that want any.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn scaled(&self, mut x: F, wanted: &F, work: &Work) -> Result<F> {
        let mut dose = self.model.new_dose()?;
        self.model.dose(&x, &mut dose, work)?;
        dose.keep_positive(wanted);
        let (both, square) = (dose.dot(wanted), dose.dot(&dose));
        if both > 0.0 && square > 0.0 {
            let factor = both / square;
            x.scale(if self.model.quantity() == Quantity::Amplitude {
                factor.sqrt()
            } else {
                factor
            } as f32);
        }
        self.bounded(x)
    }

    /// Scales patterns that another model made, so that this one's dose is the wanted one as well as a factor can make it.
    ///
    /// # Errors
    /// As [`InitialPatterns::patterns`].
    pub fn scaled_anew(&self, x: F, work: &Work) -> Result<F> {
        let wanted = self.wanted_dose()?;
        self.scaled(x, &wanted, work)
    }

    /// Brings patterns into the bounds.
    fn bounded(&self, mut x: F) -> Result<F> {
        let (zero, bounds) = (x.zeros_like(), x.compile_bounds(&self.bounds()?));
        x.move_along(&zero, 0.0, &bounds);
        Ok(x)
    }

    /// The target per element of the dose field as a [`Problem`](super::Problem::with_target) wants it: 1 in the part and 0 in the
    /// void, or gray values; −1 where a voxel does not count.
    ///
    /// # Errors
    /// As [`InitialPatterns::patterns`].
    pub fn target_field(&self) -> Result<F> {
        let layout = self.layout()?;
        let gray = self.target.gray;
        let mut target = Volume::filled(layout.grid.clone(), 0.0f32);
        elements(&mut target.values, |i, target| {
            *target = match self.labels.values[i] {
                label::OUTSIDE => -1.0,
                _ if gray => self.target.inside.values[i],
                label::PART => 1.0,
                _ => 0.0,
            };
        });
        self.dose_of(&layout.field_of(&target))
    }

    /// Marks at the part's surface as a [`Problem`](super::Problem::with_edges) wants them.
    ///
    /// # Errors
    /// As [`InitialPatterns::patterns`].
    pub fn edge_field(&self) -> Result<F> {
        let layout = self.layout()?;
        let near = near_the_other_kind(self.target, layout.grid.pitch_mm);
        let marks = Volume::new(
            layout.grid.clone(),
            near.into_iter().map(f32::from).collect(),
        );
        self.dose_of(&layout.field_of(&marks))
    }

    fn bounds(&self) -> Result<Bounds> {
        super::problem::bounds(self.model.patterns(), self.limits)
    }

    fn require_linear(&self, what: &str) -> Result<()> {
        if self.model.is_linear() {
            return Ok(());
        }
        Err(Error::unsupported(
            format!("start `{what}`"),
            format!("{} is not linear", self.model.describe()),
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::check::example;
    use tomolith_core::check::{self, small::SmallModel};
    use tomolith_core::kind::Section;
    use tomolith_core::response::Logistic;
    use tomolith_core::response::table::{Beyond, Table};

    /// Mean dose of part and of void.
    fn contrast(model: &SmallModel, labels: &Volume<u8>, x: &HostField) -> [f64; 2] {
        let dose = check::dose(model, x);
        let labels = model.layout().field_of(labels);
        [label::PART, label::VOID].map(|wanted| {
            let doses = dose
                .as_slice()
                .iter()
                .zip(&labels)
                .filter(|(_, l)| **l == wanted);
            let doses: Vec<f64> = doses.map(|(&d, _)| f64::from(d)).collect();
            doses.iter().sum::<f64>() / doses.len() as f64
        })
    }

    /// A file of uniform patterns whose mean part dose is near 1.
    fn saved(model: &SmallModel, labels: &Volume<u8>, folder: &tempfile::TempDir) -> String {
        let mut x = check::even_patterns(model, 1.0);
        let [part, _] = contrast(model, labels, &x);
        x.fill(0.95 / part as f32);
        let shown = model.patterns()[0].patterns_of(x.as_slice());
        let file = folder.path().join("patterns.npz");
        let pair = tomolith_io::npy::PatternPair {
            light: None,
            shown: &shown,
            raw: None,
        };
        tomolith_io::npy::write_patterns(&file, &[pair], &Work::new()).unwrap();
        file.to_string_lossy().into_owned()
    }

    #[test]
    fn every_row_keeps_the_bounds_and_gives_the_part_its_dose() {
        let model = SmallModel::new(32, 48, 3);
        let (target, labels) = model.ring();
        let folder = tempfile::tempdir().unwrap();
        let responses: [&dyn Response; 2] =
            [&Identity, &Logistic::new(Default::default()).unwrap()];
        for row in STARTS {
            for response in responses {
                let limits = [Limits::default()];
                let input = StartInput {
                    model: &model,
                    target: &target,
                    labels: &labels,
                    response,
                    limits: &limits,
                    absorption: None,
                };
                let mut section = example(row);
                if row.name == "patterns" {
                    section.value["file"] = saved(&model, &labels, &folder).into();
                }
                let start = (row.build)(&section).unwrap();
                let x = start.patterns(&input, &Work::new()).unwrap();
                assert!(
                    x.as_slice().iter().all(|&v| v >= 0.0 && v.is_finite()),
                    "{}",
                    row.name
                );
                let [part, void] = contrast(&model, &labels, &x);
                if row.name == "zero" {
                    assert_eq!(part, 0.0);
                } else {
                    // Least squares, so the mean is a little below the wanted dose of 1
                    assert!(
                        (0.9..1.000_1).contains(&part),
                        "{}: mean part dose {part}, void {void}",
                        row.name
                    );
                }
                let limits = [Limits { min: 0.1, max: 0.3 }];
                let input = StartInput {
                    limits: &limits,
                    ..input
                };
                let x = start.patterns(&input, &Work::new()).unwrap();
                assert!(
                    x.as_slice().iter().all(|v| (0.1..=0.3).contains(v)),
                    "{}",
                    row.name
                );
            }
        }
    }

    #[test]
    fn a_response_in_other_units_gets_a_start_in_these() {
        let model = SmallModel::new(32, 48, 3);
        let (target, labels) = model.ring();
        let limits = [Limits::default()];
        // Doses 4 times as large; the second ends at its target, of whose last hundredth no dose is asked
        let rising = Table::new(&[0.0, 4.0, 8.0], &[0.0, 1.0, 2.0], Beyond::Linear).unwrap();
        let ending = Table::new(&[0.0, 4.0], &[0.0, 1.0], Beyond::Flat).unwrap();
        for row in STARTS
            .iter()
            .filter(|row| !["zero", "patterns"].contains(&row.name))
        {
            let start = (row.build)(&example(row)).unwrap();
            let mean = |response: &dyn Response| {
                let input = StartInput {
                    response,
                    ..StartInput::new(&model, &target, &labels, &limits)
                };
                let x = start.patterns(&input, &Work::new()).unwrap();
                contrast(&model, &labels, &x)[0]
            };
            let plain = mean(&Identity);
            for (response, factor) in [(&rising, 4.0), (&ending, 3.96)] {
                // `lsqr` ends by a tolerance, in f32
                let ratio = mean(response) / plain / factor;
                assert!((ratio - 1.0).abs() < 1e-3, "{}: {ratio}", row.name);
            }
        }
    }

    #[test]
    fn filtering_separates_part_and_void() {
        let model = SmallModel::new(32, 48, 3);
        let (target, labels) = model.ring();
        let limits = [Limits::default()];
        let input = StartInput::new(&model, &target, &labels, &limits);
        let separation = |filter: &str| {
            let section = Section::new(
                "start.fbp",
                serde_json::json!({"filter": filter, "negative": "clip"}),
            );
            let x = (STARTS[0].build)(&section)
                .unwrap()
                .patterns(&input, &Work::new())
                .unwrap();
            let [part, void] = contrast(&model, &labels, &x);
            part - void
        };
        let plain = separation("none");
        for filter in ["ram_lak", "shepp_logan", "cosine", "hamming", "hann"] {
            let filtered = separation(filter);
            assert!(
                filtered > plain + 0.1,
                "{filter} separates by {filtered}, none by {plain}"
            );
        }
    }
}
