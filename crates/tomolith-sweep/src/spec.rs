//! The sweep file, typed; docs/sweeps.md is its page for people.

use serde::Deserialize;
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::path::PathBuf;
use tomolith::job::Leaves;

/// A whole sweep file.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SweepSpec {
    /// The job file, relative to the sweep file.
    pub(crate) job: PathBuf,
    /// Where results go, relative to the current folder.
    pub(crate) folder: Option<PathBuf>,
    /// What each run leaves.
    #[serde(default = "numbers")]
    pub(crate) keep: Leaves,
    /// Numbers of `report.json`, by their key paths.
    #[serde(default = "metrics")]
    pub(crate) metrics: Vec<String>,
    /// Conditions on the values of axes.
    #[serde(default)]
    pub(crate) when: Vec<String>,
    /// Keys of the job, the same for all runs.
    #[serde(default)]
    pub(crate) set: Map<String, Value>,
    /// Keys of the job that follow from the axes.
    #[serde(default)]
    pub(crate) derived: BTreeMap<String, String>,
    /// The keys that are swept.
    #[serde(default)]
    pub(crate) axes: Vec<AxisSpec>,
    /// Points drawn in place of all combinations.
    pub(crate) sample: Option<SampleSpec>,
    /// Which run is the best.
    #[serde(default)]
    pub(crate) best: BestSpec,
    /// Lines over the maps: equations in names of the first two axes.
    #[serde(default)]
    pub(crate) guides: Vec<String>,
    /// Runs start from their neighbors' patterns.
    pub(crate) warm_start: Option<WarmSpec>,
    /// What all runs together may use.
    #[serde(default)]
    pub(crate) resources: ResourcesSpec,
}

impl SweepSpec {
    /// A job without axes: one run.
    pub(crate) fn of_job(job: PathBuf) -> Self {
        SweepSpec {
            job,
            folder: None,
            keep: numbers(),
            metrics: Vec::new(),
            when: Vec::new(),
            set: Map::new(),
            derived: BTreeMap::new(),
            axes: Vec::new(),
            sample: None,
            best: BestSpec::default(),
            guides: Vec::new(),
            warm_start: None,
            resources: ResourcesSpec::default(),
        }
    }
}

/// What is swept: a key of the job with exactly one of `values`, `linear`, `log`; or `cases`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct AxisSpec {
    /// The key of the job; none for cases, which name theirs.
    pub(crate) key: Option<String>,
    /// Its name in conditions, table and pictures.
    pub(crate) name: Option<String>,
    /// Values of several keys at once.
    pub(crate) cases: Option<Vec<CaseSpec>>,
    /// A list.
    pub(crate) values: Option<Vec<Value>>,
    /// Equal steps.
    pub(crate) linear: Option<RangeSpec>,
    /// Equal ratios.
    pub(crate) log: Option<RangeSpec>,
}

impl AxisSpec {
    /// Whether the axis goes by this name.
    pub(crate) fn is_named(&self, name: &str) -> bool {
        let from_key = || self.key.as_deref().map(crate::axes::last_part);
        self.name.clone().or_else(from_key).as_deref() == Some(name)
    }

    /// Whether it takes the place of another axis: that of its key, or of its name where it has cases.
    pub(crate) fn replaces(&self, other: &AxisSpec) -> bool {
        self.key == other.key && (self.key.is_some() || self.name == other.name)
    }
}

/// A named value of an axis: several keys of the job.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CaseSpec {
    /// Its name in table and pictures.
    pub(crate) name: String,
    /// Keys of the job; none: the job as it is.
    #[serde(default)]
    pub(crate) set: Map<String, Value>,
}

/// A range, both ends included.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct RangeSpec {
    /// The first value.
    pub(crate) from: f64,
    /// The last.
    pub(crate) to: f64,
    /// The distance of two, in place of `count`.
    pub(crate) step: Option<f64>,
    /// How many.
    pub(crate) count: Option<usize>,
    /// Whether values are rounded to whole numbers.
    #[serde(default)]
    pub(crate) whole: bool,
}

/// Points that are drawn.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub(crate) enum SampleSpec {
    /// Independent ones.
    Random(DrawSpec),
    /// One in each of equal parts of every axis.
    LatinHypercube(DrawSpec),
}

impl SampleSpec {
    /// Its key, and what it draws.
    pub(crate) fn drawing(self) -> (&'static str, DrawSpec) {
        match self {
            SampleSpec::Random(draw) => ("random", draw),
            SampleSpec::LatinHypercube(draw) => ("latin_hypercube", draw),
        }
    }
}

/// How many points, and which.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct DrawSpec {
    /// How many.
    pub(crate) count: usize,
    /// Another seed gives other points.
    #[serde(default)]
    pub(crate) seed: u64,
}

/// Which run is the best: the one with most, or least, of a metric; `highest = "evaluation.iou"` when neither is given.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct BestSpec {
    /// The metric to have most of.
    pub(crate) highest: Option<String>,
    /// The metric to have least of.
    pub(crate) lowest: Option<String>,
    /// Conditions on metrics and axes.
    #[serde(rename = "where")]
    pub(crate) conditions: Vec<String>,
}

/// Starts from neighbors.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct WarmSpec {
    /// Iterations of a run with a warm start; the job's when left out.
    pub(crate) iterations: Option<usize>,
}

/// What all runs together may use.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct ResourcesSpec {
    /// Memory, GB (10⁹ bytes).
    pub(crate) memory_gb: Option<f64>,
    /// Runs at a time.
    pub(crate) side_by_side: Option<usize>,
}

/// What runs of a sweep leave unless it says otherwise.
fn numbers() -> Leaves {
    Leaves::Metrics
}

fn metrics() -> Vec<String> {
    [
        "evaluation.iou",
        "evaluation.ver",
        "evaluation.pw",
        "evaluation.ipdr",
        "history.loss",
        "history.iterations",
    ]
    .map(str::to_owned)
    .to_vec()
}
