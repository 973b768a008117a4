//! The volumes of a page: target, labels, bodies and response of each species, when voxels become solid, properties of the print.

use super::Arrays;
use super::blob::{Codes, NOTHING, deflate, majorities, means, packed, reduced_grid};
use crate::ReportData;
use crate::number::significant;
use serde::Serialize;
use serde_json::{Value, json};
use tomolith_core::grid::{Volume, VolumeGrid};

/// Voxels along an edge, at most; and of each of several moments.
const EDGE: usize = 192;
const EDGE_OF_MOMENTS: usize = 96;

/// What the page knows of a volume.
#[derive(Serialize)]
pub(super) struct VolumeInfo {
    id: String,
    kind: &'static str,
    species: Option<String>,
    name: String,
    unit: String,
    shape_zyx: [usize; 3],
    pitch_mm: f64,
    height_mm: f64,
    center_xyz_mm: [f64; 3],
    bits: u32,
    low: f64,
    high: f64,
    nan: Option<u8>,
    logarithmic: bool,
    reduced: usize,
    full: bool,
}

/// A volume before it is packed.
struct Source<'a> {
    kind: &'static str,
    species: Option<&'a str>,
    name: String,
    unit: &'a str,
    logarithmic: bool,
    /// Voxels along an edge, at most.
    edge: usize,
    values: Values<'a>,
}

enum Values<'a> {
    Numbers(&'a Volume<f32>),
    Codes(&'a Volume<u8>),
}

impl<'a> From<&'a Volume<f32>> for Values<'a> {
    fn from(volume: &'a Volume<f32>) -> Self {
        Values::Numbers(volume)
    }
}

impl<'a> From<&'a Volume<u8>> for Values<'a> {
    fn from(volume: &'a Volume<u8>) -> Self {
        Values::Codes(volume)
    }
}

impl<'a> Source<'a> {
    fn new(
        kind: &'static str,
        species: Option<&'a str>,
        name: &str,
        values: impl Into<Values<'a>>,
    ) -> Self {
        Source {
            kind,
            species,
            name: name.to_owned(),
            unit: "",
            logarithmic: false,
            edge: EDGE,
            values: values.into(),
        }
    }

    fn grid(&self) -> &VolumeGrid {
        match self.values {
            Values::Numbers(volume) => &volume.grid,
            Values::Codes(volume) => &volume.grid,
        }
    }

    /// By how much it is reduced where edges may have so many voxels.
    fn factor(&self, edge: usize) -> usize {
        let longest = self.grid().shape.into_iter().max().unwrap_or(1);
        longest.div_ceil(edge.min(self.edge)).max(1)
    }

    /// The volume with blocks of `factor`³ voxels joined, and their codes.
    fn reduced(&self, id: String, factor: usize) -> (VolumeInfo, Vec<u8>) {
        let coded = match self.values {
            Values::Numbers(volume) => Codes::of(&means(&volume.grid, &volume.values, factor)),
            Values::Codes(volume) => Codes {
                codes: majorities(&volume.grid, &volume.values, factor),
                low: 0.0,
                high: 255.0,
                has_gaps: false,
            },
        };
        let grid = reduced_grid(self.grid(), factor);
        let info = VolumeInfo {
            id,
            kind: self.kind,
            species: self.species.map(str::to_owned),
            name: self.name.clone(),
            unit: self.unit.to_owned(),
            shape_zyx: grid.shape,
            pitch_mm: grid.pitch_mm,
            height_mm: grid.height_mm,
            center_xyz_mm: grid.center_mm,
            bits: 8,
            low: coded.low,
            high: coded.high,
            nan: coded.has_gaps.then_some(NOTHING),
            logarithmic: self.logarithmic,
            reduced: factor,
            full: false,
        };
        (info, coded.codes)
    }
}

/// What is asked of a species, which has a name where there are several.
fn asked<'a>(
    species: Option<&'a str>,
    inside: &'a Volume<f32>,
    labels: &'a Volume<u8>,
) -> [Source<'a>; 2] {
    [
        Source::new("target", species, "target", inside),
        Source::new("labels", species, "labels", labels),
    ]
}

/// The volumes of a report: of the only species, or of each.
fn sources<'a>(data: &'a ReportData<'a>) -> Vec<Source<'a>> {
    let mut all = Vec::new();
    for species in &data.species {
        let name = Some(species.name).filter(|name| !name.is_empty());
        all.extend(asked(name, species.inside, species.labels));
        all.push(Source::new(
            "response",
            name,
            species.quantity,
            species.response,
        ));
    }
    all.extend(
        data.bodies
            .map(|bodies| Source::new("bodies", None, "bodies", bodies)),
    );
    for network in &data.time {
        let name = (data.time.len() > 1).then_some(network.name.as_str());
        all.push(Source {
            unit: "s",
            ..Source::new("cure_time", name, "time of cure", &network.cure_times)
        });
        all.extend(network.snapshots.iter().map(|(seconds, degree)| {
            let moment = format!("degree of cure after {} s", significant(*seconds, 3));
            Source {
                edge: EDGE_OF_MOMENTS,
                ..Source::new("property", name, &moment, degree)
            }
        }));
    }
    all.extend(data.maps.iter().map(|map| Source {
        unit: map.unit,
        logarithmic: map.is_logarithmic,
        ..Source::new("property", None, map.name, map.values)
    }));
    all
}

/// The volumes of a report as text of at most so many bytes: reduced to [`EDGE`] voxels along an edge, and further where that is too much.
pub(super) fn volumes(data: &ReportData<'_>, most_bytes: usize) -> (Vec<VolumeInfo>, Arrays) {
    fitting(&sources(data), most_bytes)
}

fn fitting(sources: &[Source<'_>], most_bytes: usize) -> (Vec<VolumeInfo>, Arrays) {
    let mut edge = EDGE;
    loop {
        let pack = |(i, source): (usize, &Source<'_>)| {
            let id = format!("{}{i}", source.kind);
            let (info, codes) = source.reduced(id, source.factor(edge));
            (info, packed(&codes))
        };
        let packed: Vec<(VolumeInfo, String)> = sources.iter().enumerate().map(pack).collect();
        let bytes: usize = packed.iter().map(|(_, text)| text.len()).sum();
        if bytes <= most_bytes || edge <= 16 {
            return packed
                .into_iter()
                .map(|(info, text)| {
                    let id = info.id.clone();
                    (info, (id, text))
                })
                .unzip();
        }
        edge = edge * 3 / 4;
    }
}

/// The dose of a run on its job's voxels, as text of at most so many bytes.
pub(super) fn dose(dose: &Volume<f32>, most_bytes: usize) -> (VolumeInfo, String) {
    let (mut infos, mut texts) =
        fitting(&[Source::new("response", None, "dose", dose)], most_bytes);
    infos[0].id = "response".to_owned();
    (infos.remove(0), texts.remove(0).1)
}

/// What the page knows of volumes of a run that goes on, and their arrays, packed.
pub type Served = Vec<(Value, Vec<u8>)>;

/// The response of a species of a run that goes on, and what it is called; the species has a name where there are several.
#[must_use]
pub fn served_response(
    i: usize,
    species: Option<&str>,
    quantity: &str,
    response: &Volume<f32>,
) -> Served {
    served(i, &[Source::new("response", species, quantity, response)])
}

/// What is asked of a species of a run that goes on.
#[must_use]
pub fn served_target(
    i: usize,
    species: Option<&str>,
    inside: &Volume<f32>,
    labels: &Volume<u8>,
) -> Served {
    served(i, &asked(species, inside, labels))
}

fn served(i: usize, sources: &[Source<'_>]) -> Served {
    let volume_of = |source: &Source<'_>| {
        let id = format!("{}{i}", source.kind);
        let (info, codes) = source.reduced(id, source.factor(EDGE));
        (json!(info), deflate(&codes))
    };
    sources.iter().map(volume_of).collect()
}

/// The target of a job before it runs.
pub(super) fn target(inside: &Volume<f32>, labels: &Volume<u8>) -> (Vec<VolumeInfo>, Arrays) {
    fitting(&asked(None, inside, labels), usize::MAX)
}
