//! Checkpoints: what a run needs to go on after it was cut off.
//!
//! One file, `state.safetensors`, holds the arrays and, as JSON under the key `tomolith` of its header, everything else. It is
//! written aside and renamed, so it is always whole: a kill at any moment leaves the old one or the new one.
//!
//! A request to stop ends the writing, too, when the run's [patience](Work::PATIENCE) does: the checkpoint that stands stays. A last
//! one is written where it is expected to be done by then; where none stands, one of the patterns alone is.
//!
//! `contents = "all"` holds patterns, dose and the optimizer's memory: the resumed run has the bits of the uninterrupted one.
//! `contents = "patterns"` holds the patterns alone, a small part of the size: the resumed run begins anew from there.
//!
//! Where patterns are [shares of several ranks](Checkpoints::share), rank 0 puts them together and writes the file of patterns that a process
//! alone would write: any number of ranks goes on from it, and all of them must see its folder.
//!
//! Without a stated interval a checkpoint is written when at least fifty times the duration of the last one has passed
//! (and ten seconds), so that they cost less than 2 % of the time. The first is taken to cost what its bytes take at
//! 300 MB/s.

use super::keep::Best;
use super::run::Row;
use super::{Counters, Memory, SavedArray};
use safetensors::Dtype;
use safetensors::tensor::{Metadata, TensorInfo};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::HashMap;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use tomolith_core::error::{Error, Result, above_zero};
use tomolith_core::field::{Field, HostField};
use tomolith_core::ranks::{Shares, together};
use tomolith_core::units::exact;
use tomolith_core::work::Work;
use tomolith_io::{open_regular, write_whole_under};

/// What a checkpoint holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Contents {
    /// Everything: a resumed run has the bits of the uninterrupted one.
    #[default]
    All,
    /// Only the patterns: a resumed run begins anew from them.
    Patterns,
}

/// `[checkpoint]` of a job.
#[derive(Clone, Debug, Default, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Params {
    /// Seconds between checkpoints; "auto" (default): at least ten, and so that they cost less than 2 % of the time
    #[serde(with = "seconds_or_auto")]
    #[schemars(
        schema_with = "seconds_or_auto_schema",
        default = "seconds_or_auto::auto"
    )]
    pub every_s: Option<f64>,
    /// What they hold: "all" (default; resuming is exact) or "patterns" (small; resuming begins anew from them)
    pub contents: Contents,
}

/// `None` is written as "auto", so that a job with every default written out names it.
mod seconds_or_auto {
    use serde::de::{Error, Unexpected};
    use serde::{Deserialize, Deserializer, Serializer};
    use serde_json::Value;

    const EXPECTED: &str = "seconds above 0, or \"auto\"";

    pub(super) fn auto() -> &'static str {
        "auto"
    }

    pub(super) fn serialize<S: Serializer>(every: &Option<f64>, to: S) -> Result<S::Ok, S::Error> {
        match every {
            Some(seconds) => to.serialize_f64(*seconds),
            None => to.serialize_str(auto()),
        }
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
        let value = Value::deserialize(from)?;
        match &value {
            Value::String(word) if word == auto() => Ok(None),
            Value::String(word) => Err(D::Error::invalid_value(Unexpected::Str(word), &EXPECTED)),
            Value::Number(number) => Ok(number.as_f64()),
            other => Err(D::Error::custom(format!(
                "found {other}, expected {EXPECTED}"
            ))),
        }
    }
}

fn seconds_or_auto_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schemars::json_schema!({
        "anyOf": [{ "type": "number", "exclusiveMinimum": 0 }, { "const": "auto" }]
    })
}

/// Writes checkpoints to a folder from time to time, and reads one back.
#[derive(Debug)]
pub struct Checkpoints {
    folder: PathBuf,
    fingerprint: String,
    job: Value,
    /// See [`remember`](Self::remember).
    found: Value,
    every: Option<Duration>,
    contents: Contents,
    /// Of the levels of a job, the one that is optimized.
    level: usize,
    /// Whether a run goes on from what it finds in the folder.
    resumes: bool,
    /// Whether a run writes a checkpoint at its end, for one with more iterations.
    keeps_end: bool,
    last: Instant,
    /// How long the last one took, and how many bytes it held.
    written: Option<(Duration, usize)>,
    /// Whether the last one did not fit on the disk.
    is_disk_full: bool,
    /// Where patterns are spread over ranks.
    shares: Option<Shares>,
}

/// Bytes per second that the first checkpoint is taken to reach.
const RATE: f64 = 3e8;

/// Everything of a checkpoint but the arrays.
#[derive(Debug, Deserialize, Serialize)]
struct Header {
    format: u32,
    fingerprint: String,
    /// The tables of the job, to say what has changed.
    #[serde(default)]
    job: Value,
    #[serde(default)]
    found: Value,
    contents: Contents,
    level: usize,
    best: Best,
    counters: Counters,
    history: Vec<Row>,
    numbers: Value,
}

/// Name of the file.
pub const CHECKPOINT: &str = "state.safetensors";

/// The format of this file.
const FORMAT: u32 = 4;

/// Last array of a file: checksums of its header and of every array before, in their order.
const CHECKSUMS: &str = "checksums";

/// Disk space for checkpoints: what has become of it.
#[derive(Debug)]
pub enum DiskSpace {
    /// The disk is full: the run goes on without them.
    Full(Error),
    /// There is space again, and a checkpoint is written.
    FreeAgain,
}

/// What a run gives to a checkpoint.
pub(super) struct Saved<'a, F> {
    pub(super) patterns: &'a F,
    pub(super) best: Best,
    /// The best patterns, when they are others.
    pub(super) best_patterns: Option<&'a F>,
    pub(super) dose: &'a F,
    /// Regions whose dose is an earlier one.
    pub(super) unknown: &'a [bool],
    /// What the model remembers of earlier patterns.
    pub(super) model: Option<&'a F>,
    pub(super) memory: Memory<'a>,
    pub(super) counters: Counters,
    pub(super) history: &'a [Row],
}

impl Checkpoints {
    /// Checkpoints in a folder (made when the first is written). The fingerprint is that of the job: a checkpoint of another one
    /// is refused.
    ///
    /// # Errors
    /// [`Error::Config`] for an interval that is not above 0.
    pub fn new(folder: impl Into<PathBuf>, fingerprint: u64, params: &Params) -> Result<Self> {
        above_zero("checkpoint.every_s", params.every_s.unwrap_or(1.0))?;
        Ok(Checkpoints {
            folder: folder.into(),
            fingerprint: format!("{fingerprint:016x}"),
            job: Value::Null,
            found: Value::Null,
            every: params
                .every_s
                .map(|s| Duration::try_from_secs_f64(s).unwrap_or(Duration::MAX)),
            contents: params.contents,
            level: 0,
            resumes: true,
            keeps_end: true,
            last: Instant::now(),
            written: None,
            is_disk_full: false,
            shares: None,
        })
    }

    /// With the tables of the job: a checkpoint of another one is then refused by the names of the keys that differ.
    #[must_use]
    pub fn describing(mut self, job: Value) -> Self {
        self.job = job;
        self
    }

    /// From here on checkpoints hold what was found before the loop, for a run that goes on.
    pub fn remember(&mut self, found: Value) {
        self.found = found;
    }

    /// From here on checkpoints are of this level, counted from 0: patterns of other levels may have other pixels.
    pub fn begin_level(&mut self, level: usize) {
        self.level = level;
    }

    /// From here on the patterns of this process are a rank's share: files hold those of all ranks and nothing else.
    pub fn share(&mut self, shares: Shares) {
        self.contents = Contents::Patterns;
        self.shares = Some(shares);
    }

    /// What this rank came to, if no rank failed.
    fn agreed<T>(&self, result: Result<T>) -> Result<T> {
        match &self.shares {
            Some(shares) => together(shares.ranks().as_ref(), result),
            None => result,
        }
    }

    /// The run begins anew: a checkpoint that the folder holds stays there until the first one of this run takes its place.
    pub fn begin_anew(&mut self) {
        self.resumes = false;
    }

    /// Nobody will go on from the end of the run: checkpoints are written before it only.
    pub fn leave_out_end(&mut self) {
        self.keeps_end = false;
    }

    /// Whether a run that ends by itself leaves a checkpoint of its end.
    pub(super) fn keeps_end(&self) -> bool {
        self.keeps_end
    }

    /// The checkpoint to go on from: one of the level at hand.
    pub(super) fn open_of_level(&self) -> Result<Option<Checkpoint>> {
        if !self.resumes {
            return Ok(None);
        }
        let found = self.agreed(self.open())?;
        Ok(found.filter(|found| found.level() == self.level))
    }

    /// The file.
    #[must_use]
    pub fn file(&self) -> PathBuf {
        self.folder.join(CHECKPOINT)
    }

    /// Whether it is time for the next one, which would hold what is `saved`.
    pub(super) fn is_due<F: Field>(&self, saved: &Saved<'_, F>) -> bool {
        let bytes = bytes(saved, self.contents);
        let is_due = self.last.elapsed() >= self.wait(bytes);
        saved.patterns.any(is_due)
    }

    /// Time between two checkpoints of so many bytes: that of the job, else 50 times what the next one is expected to take, and 10 s at
    /// least.
    fn wait(&self, bytes: usize) -> Duration {
        (self.every).unwrap_or_else(|| (self.expected(bytes) * 50).max(Duration::from_secs(10)))
    }

    /// How long a checkpoint of so many bytes takes: as long as the last one, and what it holds more (that of a finer level).
    fn expected(&self, bytes: usize) -> Duration {
        let (took, held) = self.written.unwrap_or_default();
        took + Duration::from_secs_f64(bytes.saturating_sub(held) as f64 / RATE)
    }

    /// What the last checkpoint after a request to stop may hold, to be written within so long a time: everything, where it is
    /// expected to be there by then; else the patterns, where there is no checkpoint of this run to go on from; else nothing.
    fn contents_within<F: Field>(&self, left: Duration, saved: &Saved<'_, F>) -> Option<Contents> {
        let expected = self.expected(bytes(saved, self.contents));
        let has_one = self.written.is_some() || (self.resumes && self.file().exists());
        // Ranks that share the patterns write them together or not at all
        if self.shares.is_some() || expected <= left {
            Some(self.contents)
        } else if has_one {
            None
        } else {
            Some(Contents::Patterns)
        }
    }

    /// Writes a checkpoint where there is room for it, and time where the run was asked to stop; on a full disk the next one comes when
    /// it would have come anyway. Tells when that begins and when it is over.
    pub(super) fn try_write<F: Field>(
        &mut self,
        saved: Saved<'_, F>,
        work: &Work,
    ) -> Result<Option<DiskSpace>> {
        let contents = match work.is_stop_asked() {
            true => self.contents_within(work.patience_left(), &saved),
            false => Some(self.contents),
        };
        let written = match contents {
            Some(contents) => self.write(saved, contents, work),
            None => Err(Error::Canceled),
        };
        let settled = self.settle(written);
        self.agreed(settled)
    }

    /// What a checkpoint that was or was not written means for the next ones.
    fn settle(&mut self, written: Result<()>) -> Result<Option<DiskSpace>> {
        let error = match written {
            Ok(()) => {
                let again = std::mem::take(&mut self.is_disk_full);
                return Ok(again.then_some(DiskSpace::FreeAgain));
            }
            Err(error) if error.is_full_disk() => error,
            // The one before stays
            Err(Error::Canceled) => return Ok(None),
            Err(error) => return Err(error),
        };
        self.last = Instant::now();
        let before = std::mem::replace(&mut self.is_disk_full, true);
        Ok((!before).then_some(DiskSpace::Full(error)))
    }

    /// Writes a checkpoint.
    /// An error leaves the one before.
    fn write<F: Field>(
        &mut self,
        saved: Saved<'_, F>,
        contents: Contents,
        work: &Work,
    ) -> Result<()> {
        let begin = Instant::now();
        let held = bytes(&saved, contents);
        let whole = self.whole(&saved);
        let check = || saved.patterns.check();
        let header = Header {
            format: FORMAT,
            fingerprint: self.fingerprint.clone(),
            job: self.job.clone(),
            found: self.found.clone(),
            contents,
            level: self.level,
            best: saved.best,
            counters: saved.counters,
            history: saved.history.to_vec(),
            numbers: saved.memory.numbers,
        };
        match &whole {
            // Another rank writes
            Some(fields) if fields.is_empty() => {}
            Some(fields) => {
                let arrays = fields.iter().map(|(name, field)| {
                    let array = SavedArray::of_field(field);
                    ((*name).to_owned(), array)
                });
                self.write_file(&header, arrays.collect(), &check, work)?;
            }
            None => {
                let patterns = SavedArray::of_field(saved.patterns);
                let mut arrays = vec![("patterns".to_owned(), patterns)];
                let best = saved.best_patterns.map(SavedArray::of_field);
                arrays.extend(best.map(|best| ("best".to_owned(), best)));
                if contents == Contents::All {
                    arrays.push(("dose".to_owned(), SavedArray::of_field(saved.dose)));
                    if !saved.unknown.is_empty() {
                        let unknown = SavedArray::of_flags(saved.unknown);
                        arrays.push(("unknown".to_owned(), unknown));
                    }
                    let model = saved.model.map(SavedArray::of_field);
                    arrays.extend(model.map(|array| ("model".to_owned(), array)));
                    let memory = saved.memory.arrays.into_iter();
                    arrays.extend(memory.map(|(name, array)| (format!("memory.{name}"), array)));
                }
                self.write_file(&header, arrays, &check, work)?;
            }
        }
        self.written = Some((begin.elapsed(), held));
        self.last = Instant::now();
        Ok(())
    }

    /// The patterns of all ranks, where this process has a share of them; nothing on a rank that does not write.
    fn whole<F: Field>(&self, saved: &Saved<'_, F>) -> Option<Vec<(&'static str, HostField)>> {
        let shares = self.shares.as_ref()?;
        let fields = [
            ("patterns", Some(saved.patterns)),
            ("best", saved.best_patterns),
        ];
        let mut whole = Vec::new();
        for (name, share) in fields {
            if let Some(share) = share {
                let field = HostField::from_slice(&shares.whole(&share.to_host()));
                whole.push((name, field));
            }
        }
        whole.retain(|_| shares.ranks().is_first());
        Some(whole)
    }

    /// Removes what a killed run left half written: it would keep a disk full.
    fn clear_leftovers(&self) {
        let Ok(entries) = std::fs::read_dir(&self.folder) else {
            return;
        };
        let begin = format!(".{CHECKPOINT}.");
        for entry in entries.flatten() {
            if entry.file_name().to_string_lossy().starts_with(&begin) {
                let _ = std::fs::remove_file(entry.path());
            }
        }
    }

    /// Writes header and arrays aside, then renames, if a check says that what was read of the arrays is true.
    fn write_file(
        &self,
        header: &Header,
        arrays: Vec<(String, SavedArray)>,
        check: &dyn Fn() -> Result<()>,
        work: &Work,
    ) -> Result<()> {
        let file = self.file();
        std::fs::create_dir_all(&self.folder).map_err(|e| Error::io(&self.folder, e))?;
        self.clear_leftovers();
        let text = serde_json::to_string(header).map_err(|e| damaged(&file, &e.to_string()))?;
        let mut bytes = 0;
        let mut place_of = |dtype: Dtype, len: usize, size: usize| {
            let begin = bytes;
            bytes += size;
            TensorInfo {
                dtype,
                shape: vec![len],
                data_offsets: (begin, bytes),
            }
        };
        let tensors = arrays.iter().map(|(name, array)| {
            let info = place_of(array.dtype, array.len, array.size());
            (name.clone(), info)
        });
        let mut tensors: Vec<_> = tensors.collect();
        let sums = 1 + arrays.len();
        let info = place_of(Dtype::U64, sums, sums * size_of::<u64>());
        tensors.push((CHECKSUMS.to_owned(), info));
        let info = HashMap::from([("tomolith".to_owned(), text)]);
        let metadata =
            Metadata::new(Some(info), tensors).map_err(|e| damaged(&file, &e.to_string()))?;
        let mut text = serde_json::to_vec(&metadata).map_err(|e| damaged(&file, &e.to_string()))?;
        // The format aligns its arrays
        text.resize(text.len().next_multiple_of(8), b' ');
        write_whole_under(&file, &work.aside(), bytes, |file| {
            file.write_all(&(text.len() as u64).to_le_bytes())?;
            file.write_all(&text)?;
            let mut sums = vec![checksum(&text)];
            for (_, array) in &arrays {
                let bytes = (array.bytes)();
                file.write_all(&bytes)?;
                sums.push(checksum(&bytes));
            }
            check()?;
            let sums = sums.into_iter().flat_map(u64::to_le_bytes);
            Ok(file.write_all(&sums.collect::<Vec<u8>>())?)
        })
    }

    /// The checkpoint of the folder, or None when there is none.
    ///
    /// # Errors
    /// [`Error::Format`] when it belongs to another job, version or is damaged; [`Error::Io`].
    pub fn open(&self) -> Result<Option<Checkpoint>> {
        let path = self.file();
        if path.symlink_metadata().is_err() {
            return Ok(None);
        }
        let mut file = open_regular(&path)?;
        let (metadata, data_begin, sum) = read_header(&path, &mut file)?;
        let text = metadata.metadata().as_ref().and_then(|m| m.get("tomolith"));
        let text = text.ok_or_else(|| damaged(&path, "no Tomolith header"))?;
        let header: Header =
            serde_json::from_str(text).map_err(|e| damaged(&path, &e.to_string()))?;
        if header.format != FORMAT {
            return Err(damaged(
                &path,
                &format!("a checkpoint of format {}", header.format),
            ));
        }
        let sums = read_checksums(&path, &mut file, &metadata, data_begin)?;
        if sums.first() != Some(&sum) {
            return Err(damaged(&path, "its header is not as it was written"));
        }
        if header.fingerprint != self.fingerprint {
            let mut changes = Vec::new();
            differences("", &header.job, &self.job, &mut changes);
            let changed = match (changes.as_slice(), &self.job) {
                (_, Value::Null) => "another problem".to_owned(),
                ([], _) => {
                    "the target's voxels, or the content of a file that the job names, have changed"
                        .to_owned()
                }
                (changes, _) => changes.join(", "),
            };
            return Err(Error::format(
                path,
                format!("a checkpoint of another job: {changed}"),
                "a checkpoint of this job",
            ));
        }
        Ok(Some(Checkpoint {
            path,
            file,
            metadata,
            data_begin,
            sums,
            header,
            shares: self.shares.clone(),
        }))
    }
}

/// Key paths at which two jobs differ, with both values.
pub fn differences(path: &str, was: &Value, is: &Value, found: &mut Vec<String>) {
    if was == is {
        return;
    }
    let inner = |key: &str| match path {
        "" => key.to_owned(),
        path => format!("{path}.{key}"),
    };
    match (was, is) {
        (Value::Object(was), Value::Object(is)) => {
            let keys: std::collections::BTreeSet<_> = was.keys().chain(is.keys()).collect();
            for key in keys {
                let value_of =
                    |map: &serde_json::Map<_, _>| map.get(key).cloned().unwrap_or_default();
                differences(&inner(key), &value_of(was), &value_of(is), found);
            }
        }
        (Value::Array(was), Value::Array(is)) if was.len() == is.len() => {
            for (i, (was, is)) in was.iter().zip(is).enumerate() {
                differences(&format!("{path}[{i}]"), was, is, found);
            }
        }
        _ => {
            let word = |value: &Value| match value {
                Value::Null => "not there".to_owned(),
                Value::Object(_) => "there".to_owned(),
                Value::Number(number) => exact(number.as_f64().unwrap_or_default()),
                other => other.to_string(),
            };
            found.push(format!("{path} was {}, is {}", word(was), word(is)));
        }
    }
}

fn damaged(path: &Path, found: &str) -> Error {
    Error::format(
        path,
        format!("a damaged checkpoint ({found})"),
        format!("a whole Tomolith checkpoint of format {FORMAT}"),
    )
}

/// Size of the arrays.
fn bytes<F: Field>(saved: &Saved<'_, F>, contents: Contents) -> usize {
    let fields = 1 + usize::from(saved.best_patterns.is_some());
    let patterns = fields * saved.patterns.len() * size_of::<f32>();
    let memory = || saved.memory.arrays.iter().map(|(_, array)| array.size());
    match contents {
        Contents::All => {
            let model = saved.model.map_or(0, F::len);
            patterns + (saved.dose.len() + model) * size_of::<f32>() + memory().sum::<usize>()
        }
        Contents::Patterns => patterns,
    }
}

/// FNV-1a over words of 8 bytes: any change of one word changes it.
fn checksum(bytes: &[u8]) -> u64 {
    let (words, rest) = bytes.as_chunks::<8>();
    let mut last = [0; 8];
    last[..rest.len()].copy_from_slice(rest);
    let last = (!rest.is_empty()).then_some(&last);
    words
        .iter()
        .chain(last)
        .fold(0xcbf2_9ce4_8422_2325, |sum, word| {
            (sum ^ u64::from_le_bytes(*word)).wrapping_mul(0x0000_0100_0000_01b3)
        })
}

fn read_checksums(
    path: &Path,
    file: &mut File,
    metadata: &Metadata,
    data_begin: u64,
) -> Result<Vec<u64>> {
    let info = metadata.info(CHECKSUMS);
    let info = info.ok_or_else(|| damaged(path, "no checksums"))?;
    let (begin, end) = info.data_offsets;
    let mut bytes = vec![0; end - begin];
    file.seek(SeekFrom::Start(data_begin + begin as u64))
        .and_then(|_| file.read_exact(&mut bytes))
        .map_err(|e| Error::io(path, e))?;
    let words = bytes.as_chunks().0.iter();
    Ok(words.map(|word| u64::from_le_bytes(*word)).collect())
}

/// Reads the header of a safetensors file, not the arrays, and its checksum.
fn read_header(path: &Path, file: &mut File) -> Result<(Metadata, u64, u64)> {
    let io = |e| Error::io(path, e);
    let size = file.metadata().map_err(io)?.len();
    let mut length = [0u8; 8];
    file.read_exact(&mut length)
        .map_err(|e| damaged(path, &e.to_string()))?;
    let length = u64::from_le_bytes(length);
    if length > size.saturating_sub(8) {
        return Err(damaged(path, "a file cut short"));
    }
    let mut text = Vec::new();
    file.take(length).read_to_end(&mut text).map_err(io)?;
    let metadata: Metadata =
        serde_json::from_slice(&text).map_err(|e| damaged(path, &e.to_string()))?;
    if metadata.data_len() as u64 != size - 8 - length {
        return Err(damaged(path, "a file cut short"));
    }
    Ok((metadata, 8 + length, checksum(&text)))
}

/// A checkpoint, opened.
pub struct Checkpoint {
    path: PathBuf,
    file: File,
    metadata: Metadata,
    data_begin: u64,
    sums: Vec<u64>,
    header: Header,
    shares: Option<Shares>,
}

impl Checkpoint {
    /// The numbers of the optimizer's memory.
    #[must_use]
    pub fn numbers(&self) -> &serde_json::Value {
        &self.header.numbers
    }

    /// Fills a buffer with the bytes of an array of the optimizer's memory.
    ///
    /// # Errors
    /// When there is no array of that name and size.
    pub fn array(&mut self, name: &str, bytes: &mut [u8]) -> Result<()> {
        self.read(&format!("memory.{name}"), bytes)
    }

    /// What of it a run goes on from: of ranks that share the patterns these alone.
    #[must_use]
    pub fn contents(&self) -> Contents {
        match self.shares {
            Some(_) => Contents::Patterns,
            None => self.header.contents,
        }
    }

    /// The level at which it was written.
    #[must_use]
    pub fn level(&self) -> usize {
        self.header.level
    }

    /// The tables of its job ([`Checkpoints::describing`]).
    #[must_use]
    pub fn job(&self) -> &Value {
        &self.header.job
    }

    /// What was found before the loop ([`Checkpoints::remember`]); null where nothing was said.
    #[must_use]
    pub fn found(&self) -> &Value {
        &self.header.found
    }

    /// Steps done when it was written.
    #[must_use]
    pub fn iteration(&self) -> usize {
        self.header.history.last().map_or(0, |row| row.iteration)
    }

    pub(super) fn history(&self) -> &[Row] {
        &self.header.history
    }

    pub(super) fn counters(&self) -> Counters {
        self.header.counters
    }

    pub(super) fn best(&self) -> Best {
        self.header.best.clone()
    }

    /// Fills a field from an array of the file; of ranks that share the patterns each takes its own elements.
    ///
    /// # Errors
    /// [`Error::Format`] when there is none of that name and length; [`Error::Io`].
    pub fn read_field<F: Field>(&mut self, name: &str, field: &mut F) -> Result<()> {
        let shares = self.shares.clone();
        let mut values = vec![0.0f32; shares.as_ref().map_or(field.len(), Shares::len)];
        let read = self.read(name, bytemuck::cast_slice_mut(&mut values));
        if let Some(shares) = shares {
            together(shares.ranks().as_ref(), read)?;
            values = shares.own(&values);
        } else {
            read?;
        }
        field.copy_from_host(&values);
        Ok(())
    }

    /// What [`SavedArray::of_flags`] wrote; nothing where it wrote nothing.
    pub(super) fn flags(&mut self, name: &str) -> Result<Vec<bool>> {
        let info = self.metadata.info(name);
        let len = info.map_or(0, |info| info.data_offsets.1 - info.data_offsets.0);
        let mut bytes = vec![0; len];
        if len > 0 {
            self.read(name, &mut bytes)?;
        }
        Ok(bytes.into_iter().map(|byte| byte != 0).collect())
    }

    pub(super) fn has(&self, name: &str) -> bool {
        self.metadata.info(name).is_some()
    }

    fn read(&mut self, name: &str, bytes: &mut [u8]) -> Result<()> {
        let info = self.metadata.info(name);
        let (begin, end) = info.map_or((0, usize::MAX), |info| info.data_offsets);
        if end - begin != bytes.len() {
            let found = info.map_or_else(
                || format!("no array `{name}`"),
                |_| format!("`{name}` has another size"),
            );
            return Err(damaged(&self.path, &found));
        }
        let read = self
            .file
            .seek(SeekFrom::Start(self.data_begin + begin as u64))
            .and_then(|_| self.file.read_exact(bytes));
        read.map_err(|e| Error::io(&self.path, e))?;
        // Arrays lie in the order of their checksums, which the header's comes before
        let names = self.metadata.offset_keys();
        let place = names.iter().position(|other| other == name);
        let sum = place.and_then(|place| self.sums.get(1 + place));
        if sum != Some(&checksum(bytes)) {
            let found = format!("`{name}` is not as it was written");
            return Err(damaged(&self.path, &found));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn an_interval_is_seconds_or_auto_and_is_written_out() {
        let read = |text: &str| toml::from_str::<Params>(text);
        assert_eq!(read("").unwrap().every_s, None);
        assert_eq!(read("every_s = \"auto\"").unwrap().every_s, None);
        assert_eq!(read("every_s = 2.5").unwrap().every_s, Some(2.5));
        assert_eq!(read("every_s = 3").unwrap().every_s, Some(3.0));
        assert!(read("every_s = \"often\"").is_err() && read("every_s = true").is_err());
        let written = toml::to_string(&Params::default()).unwrap();
        assert!(written.contains("every_s = \"auto\""), "{written}");
    }

    #[test]
    fn the_first_checkpoint_waits_as_its_bytes_say_and_later_ones_as_it_took() {
        let with = |every_s| {
            let params = Params {
                every_s,
                ..Params::default()
            };
            Checkpoints::new("nowhere", 0, &params).unwrap()
        };
        // 50 times 600 MB at 300 MB/s; ten seconds at least
        let mut auto = with(None);
        assert_eq!(auto.wait(600_000_000), Duration::from_secs(100));
        assert_eq!(auto.wait(1000), Duration::from_secs(10));
        auto.written = Some((Duration::from_secs(3), 600_000_000));
        assert_eq!(auto.wait(600_000_000), Duration::from_secs(150));
        // A finer level holds 900 MB more
        assert_eq!(auto.wait(1_500_000_000), Duration::from_secs(300));
        let asked = with(Some(2.5));
        assert_eq!(asked.wait(600_000_000), Duration::from_millis(2500));
    }

    #[test]
    fn a_full_disk_is_told_once_and_once_when_it_is_over() {
        let folder = tempfile::tempdir().unwrap();
        let mut checkpoints = Checkpoints::new(folder.path(), 0, &Params::default()).unwrap();
        let failed = |kind: std::io::ErrorKind| Err(Error::io("state", kind.into()));
        let full = || failed(std::io::ErrorKind::StorageFull);
        assert!(matches!(checkpoints.settle(Ok(())), Ok(None)));
        assert!(matches!(
            checkpoints.settle(full()),
            Ok(Some(DiskSpace::Full(_)))
        ));
        assert!(matches!(checkpoints.settle(full()), Ok(None)));
        assert!(matches!(
            checkpoints.settle(Ok(())),
            Ok(Some(DiskSpace::FreeAgain))
        ));
        assert!(matches!(checkpoints.settle(Ok(())), Ok(None)));
        // Anything else ends the run
        assert!(
            checkpoints
                .settle(failed(std::io::ErrorKind::PermissionDenied))
                .is_err()
        );
    }

    const VALUES: usize = 3 << 20;

    fn of_field<'a>(
        field: &'a HostField,
        history: &'a [Row],
        memory: Memory<'a>,
    ) -> Saved<'a, HostField> {
        Saved {
            patterns: field,
            best: Best::default(),
            best_patterns: None,
            dose: field,
            unknown: &[],
            model: None,
            memory,
            counters: Counters::default(),
            history,
        }
    }

    /// Writes a checkpoint whose values are the number of its iteration; the last array does something when its turn comes.
    fn write(checkpoints: &mut Checkpoints, work: &Work, iteration: usize, at_last: impl Fn()) {
        let history = [Row {
            loss: 1.0,
            ..Row::at(iteration)
        }];
        let values = vec![iteration as f32; VALUES];
        let field = HostField::from_slice(&values);
        let bytes = || {
            at_last();
            bytemuck::cast_slice(&values).into()
        };
        let array = SavedArray {
            dtype: safetensors::Dtype::F32,
            len: VALUES,
            bytes: Box::new(bytes),
        };
        let memory = Memory {
            numbers: Value::Null,
            arrays: vec![("pairs".to_owned(), array)],
        };
        let written = checkpoints.try_write(of_field(&field, &history, memory), work);
        assert!(matches!(written, Ok(None)));
    }

    /// Iteration and contents of the checkpoint that stands, which is whole and alone.
    fn standing(checkpoints: &Checkpoints) -> Option<(usize, Contents)> {
        let files = std::fs::read_dir(&checkpoints.folder).map_or(0, Iterator::count);
        let mut found = checkpoints.open().unwrap()?;
        assert_eq!(files, 1);
        let mut field = HostField::from_slice(&vec![0.0; VALUES]);
        found.read_field("patterns", &mut field).unwrap();
        assert!(
            field
                .as_slice()
                .iter()
                .all(|v| *v == found.iteration() as f32)
        );
        Some((found.iteration(), found.contents()))
    }

    #[test]
    fn a_request_to_stop_ends_the_writing_and_the_checkpoint_that_stands_stays() {
        let folder = tempfile::tempdir().unwrap();
        let new = || Checkpoints::new(folder.path(), 0, &Params::default()).unwrap();
        let mut checkpoints = new();
        let work = Work::with_patience(Duration::ZERO);
        work.set_patient(true);
        write(&mut checkpoints, &work, 1, || ());
        assert_eq!(standing(&checkpoints), Some((1, Contents::All)));
        // The request comes when two thirds of the arrays are on the disk
        write(&mut checkpoints, &work, 2, || {
            work.cancel();
        });
        assert_eq!(standing(&checkpoints), Some((1, Contents::All)));
        // There is no time for a last one, nor need: one stands
        write(&mut checkpoints, &work, 3, || ());
        assert_eq!(standing(&checkpoints), Some((1, Contents::All)));
        // What a killed run left behind goes with the next
        let left = format!(".{CHECKPOINT}.1-1.partial");
        std::fs::write(folder.path().join(left), "half").unwrap();
        write(&mut checkpoints, &Work::new(), 4, || ());
        assert_eq!(standing(&checkpoints), Some((4, Contents::All)));
    }

    #[test]
    fn the_last_checkpoint_is_whole_where_there_is_time_and_else_of_the_patterns() {
        let new = |folder: &tempfile::TempDir| {
            Checkpoints::new(folder.path(), 0, &Params::default()).unwrap()
        };
        let last = |patience: Duration| {
            let folder = tempfile::tempdir().unwrap();
            let mut checkpoints = new(&folder);
            let work = Work::with_patience(patience);
            work.set_patient(true);
            work.cancel();
            write(&mut checkpoints, &work, 1, || ());
            standing(&checkpoints)
        };
        assert_eq!(last(Duration::MAX), Some((1, Contents::All)));
        assert_eq!(last(Duration::ZERO), None);
        // 25 MB are expected to take 84 ms
        let folder = tempfile::tempdir().unwrap();
        let field = HostField::from_slice(&vec![0.0; VALUES]);
        let contents = |checkpoints: &Checkpoints, ms: u64| {
            let saved = of_field(&field, &[], Memory::default());
            checkpoints.contents_within(Duration::from_millis(ms), &saved)
        };
        let mut checkpoints = new(&folder);
        assert_eq!(contents(&checkpoints, 90), Some(Contents::All));
        assert_eq!(contents(&checkpoints, 80), Some(Contents::Patterns));
        checkpoints.written = Some((Duration::from_millis(70), 4 * 2 * VALUES));
        assert_eq!(contents(&checkpoints, 80), Some(Contents::All));
        assert_eq!(contents(&checkpoints, 60), None);
    }

    #[test]
    fn a_flipped_bit_is_found_wherever_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let mut checkpoints = Checkpoints::new(folder.path(), 0, &Params::default()).unwrap();
        write(&mut checkpoints, &Work::new(), 5, || ());
        let whole = std::fs::read(checkpoints.file()).unwrap();
        let read = || -> Result<()> {
            let mut found = checkpoints.open()?.unwrap();
            let mut field = HostField::from_slice(&vec![0.0; VALUES]);
            found.read_field("patterns", &mut field)?;
            found.read_field("dose", &mut field)?;
            let mut pairs = vec![0; 4 * VALUES];
            found.array("pairs", &mut pairs)
        };
        read().unwrap();
        let data = whole.len() - 3 * 4 * VALUES;
        // In a number of the header (the loss), and in every array
        let loss = whole
            .windows(6)
            .position(|text| text == b"loss\\\"")
            .unwrap()
            + 7;
        for at in [
            loss,
            data + 9,
            data + 4 * VALUES,
            data + 8 * VALUES,
            whole.len() - 1,
        ] {
            let mut bytes = whole.clone();
            bytes[at] ^= 1;
            std::fs::write(checkpoints.file(), bytes).unwrap();
            let text = read().unwrap_err().to_string();
            assert!(text.contains("damaged checkpoint"), "{at}: {text}");
        }
    }

    #[test]
    fn differences_are_named_by_their_keys() {
        let was =
            json!({ "resin": { "n": 1.5 }, "light": [{ "angles": 3 }, {}], "vial": { "a": {} } });
        let is =
            json!({ "resin": { "n": 1.6 }, "light": [{ "angles": 4 }, {}], "vial": { "b": {} } });
        let mut found = Vec::new();
        differences("", &was, &is, &mut found);
        assert_eq!(
            found,
            [
                "light[0].angles was 3, is 4",
                "resin.n was 1.5, is 1.6",
                "vial.a was there, is not there",
                "vial.b was not there, is there"
            ]
        );
    }
}
