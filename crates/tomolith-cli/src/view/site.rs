//! What the server shows: the data of the page, and arrays by name.

use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::broadcast;
use tomolith::io::read_text;
use tomolith::models::Work;
use tomolith::report::compare::{ComparedRun, comparison, read_runs};
use tomolith::report::page::{Page, PageKind, Served, VolumeSlices, bare_run, blob, page_data};
use tomolith::{Error, Result};
use tomolith_sweep::TABLE_SCHEMA;

/// Events that a page may be behind.
const BACKLOG: usize = 256;

/// The rows of a sweep, in its folder.
const TABLE: &str = "table.json";

/// The text of the sweep file whose results a folder holds, where it is still there.
fn sweep_file(folder: &Path) -> Option<String> {
    let owner: Value = serde_json::from_str(&read_text(folder.join("sweep.json")).ok()?).ok()?;
    read_text(owner["sweep"].as_str()?).ok()
}

/// A run that is shown.
struct Shown {
    /// As the page knows it.
    data: Value,
    /// Arrays by name, deflated.
    arrays: BTreeMap<String, Arc<Vec<u8>>>,
    /// All voxels of one of its volumes.
    full: Option<Arc<Full>>,
}

/// A volume of which slices with all voxels are served.
struct Full {
    id: String,
    path: PathBuf,
    /// Once somebody has asked for it.
    read: Mutex<Option<Arc<VolumeSlices>>>,
}

/// A sweep that is shown.
struct SweepFolder {
    folder: PathBuf,
    /// Its rows, as `table.json` has them.
    table: Value,
    /// Where in the list of runs a row stands that was opened.
    opened: Mutex<BTreeMap<usize, usize>>,
}

/// See the [module page](self).
pub(super) struct Site {
    title: String,
    kind: PageKind,
    compare: Value,
    /// A sweep: its folder, and which run of the list a row is once it was opened.
    sweep: Option<SweepFolder>,
    runs: Mutex<Vec<Shown>>,
    /// None once nothing more will be said.
    events: Mutex<Option<broadcast::Sender<String>>>,
    /// What stops the run that goes on.
    work: Option<Arc<Work>>,
}

impl Site {
    /// Runs that have ended.
    pub(super) fn of_runs(folders: &[PathBuf]) -> Result<Self> {
        if let [folder] = folders
            && folder.join(TABLE).is_file()
        {
            return Self::of_sweep(folder);
        }
        let read = read_runs(folders)?;
        let compare = match read.len() {
            1 => Value::Null,
            _ => comparison(&read),
        };
        let title = match read.as_slice() {
            [run] => run.name.clone(),
            _ => format!("{} runs", read.len()),
        };
        let runs = read.into_iter().zip(folders);
        let runs = runs.map(|(run, folder)| Shown::of(run, folder));
        let runs = runs.collect::<Result<_>>()?;
        Ok(Site {
            compare,
            ..Site::new(&title, runs)
        })
    }

    /// A sweep that has ended, or what there is of it.
    fn of_sweep(folder: &Path) -> Result<Self> {
        let path = folder.join(TABLE);
        let bad =
            |found: String| Error::format(&path, found, "the table of a sweep of this version");
        let table: Value =
            serde_json::from_str(&read_text(&path)?).map_err(|e| bad(e.to_string()))?;
        if table["schema"] != TABLE_SCHEMA || !table["rows"].is_array() {
            return Err(bad(format!("schema {}", table["schema"])));
        }
        let name = folder.file_name().unwrap_or(folder.as_os_str());
        let mut table = table;
        table["name"] = name.to_string_lossy().into();
        table["toml"] = sweep_file(folder).unwrap_or_default().into();
        let sweep = SweepFolder {
            folder: folder.to_owned(),
            table,
            opened: Mutex::default(),
        };
        Ok(Site {
            sweep: Some(sweep),
            ..Site::new(&name.to_string_lossy(), Vec::new())
        })
    }

    fn new(title: &str, runs: Vec<Shown>) -> Self {
        Site {
            title: title.to_owned(),
            kind: PageKind::View,
            compare: Value::Null,
            sweep: None,
            runs: Mutex::new(runs),
            events: Mutex::new(Some(broadcast::channel(BACKLOG).0)),
            work: None,
        }
    }

    /// Loads the run of a row of a sweep; its place in the list of runs, None where the row has no run.
    pub(super) fn open(&self, row: usize) -> Result<Option<usize>> {
        let Some(sweep) = &self.sweep else {
            return Ok(None);
        };
        let mut opened = sweep.opened.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(run) = opened.get(&row) {
            return Ok(Some(*run));
        }
        let known = &sweep.table["rows"][row];
        let id = known["id"]
            .as_str()
            .filter(|id| id.chars().all(|c| c.is_ascii_alphanumeric()));
        let Some(id) = id.filter(|_| known["state"] == "done") else {
            return Ok(None);
        };
        let folder = sweep.folder.join("runs").join(id);
        let mut shown = Shown::of(ComparedRun::read(&folder)?, &folder)?;
        shown.data["name"] = format!("run {}", row + 1).into();
        let run = self.with_runs(|runs| {
            runs.push(shown);
            runs.len() - 1
        });
        opened.insert(row, run);
        Ok(Some(run))
    }

    /// A run that begins.
    pub(super) fn of_job(part: &str, job: &str, work: &Arc<Work>) -> Self {
        let shown = Shown::with(bare_run(part, "running", job), BTreeMap::new());
        Site {
            work: Some(Arc::clone(work)),
            ..Site::new(part, vec![shown])
        }
    }

    pub(super) fn data(&self, served: &str) -> Value {
        let program = concat!("Tomolith ", env!("CARGO_PKG_VERSION"));
        let runs = self.with_runs(|runs| runs.iter().map(|run| run.data.clone()).collect());
        let mut data = page_data(self.kind, &self.title, program, runs);
        data["served"] = served.into();
        data["compare"] = self.compare.clone();
        data["sweep"] = json!(self.sweep.as_ref().map(|sweep| &sweep.table));
        data
    }

    /// The page itself, without arrays.
    pub(super) fn page(&self, served: &str) -> String {
        let page = Page {
            data: self.data(served),
            blobs: Vec::new(),
            plain: "<p>This page needs a script.</p>".to_owned(),
        };
        page.html()
    }

    pub(super) fn array(&self, run: usize, id: &str) -> Option<Arc<Vec<u8>>> {
        self.with_runs(|runs| runs.get(run)?.arrays.get(id).cloned())
    }

    /// A slice of the dose on the job's voxels across an array axis; None where there is none.
    /// The first slice reads the dose.
    pub(super) fn slice(
        &self,
        run: usize,
        id: &str,
        axis: usize,
        index: usize,
    ) -> Result<Option<Vec<u8>>> {
        let known = self.with_runs(|runs| runs.get(run)?.full.clone());
        let Some(full) = known.filter(|full| full.id == id) else {
            return Ok(None);
        };
        // Pages ask for three planes at once: one of them reads, the others wait
        let mut read = full.read.lock().unwrap_or_else(PoisonError::into_inner);
        let slices = match &*read {
            Some(slices) => Arc::clone(slices),
            None => Arc::clone(read.insert(Arc::new(VolumeSlices::read(&full.path)?))),
        };
        drop(read);
        Ok(slices.cut(axis, index))
    }

    /// Tells all pages.
    pub(super) fn tell(&self, event: &Value) {
        if let Some(events) = &*self.events() {
            // Without pages nobody hears it
            let _ = events.send(event.to_string());
        }
    }

    /// The first event that a page hears: the state of every run.
    pub(super) fn states(&self) -> Value {
        let states: Vec<Value> =
            self.with_runs(|runs| runs.iter().map(|run| run.data["state"].clone()).collect());
        json!({ "type": "states", "states": states })
    }

    /// None once nothing more will be said.
    pub(super) fn listen(&self) -> Option<broadcast::Receiver<String>> {
        self.events().as_ref().map(broadcast::Sender::subscribe)
    }

    /// Asks the run to stop; whether there is one.
    pub(super) fn stop(&self, run: usize) -> bool {
        let is_running = self.with_runs(|runs| {
            runs.get(run)
                .is_some_and(|run| run.data["state"] == "running")
        });
        let work = self.work.as_ref().filter(|_| is_running);
        work.is_some_and(|work| {
            work.cancel();
            true
        })
    }

    /// Adds a row to the history of the run that goes on.
    pub(super) fn add_row(&self, row: &Value) {
        let Some(row) = row.as_object() else { return };
        self.with_runs(|runs| {
            let history = &mut runs[0].data["history"];
            for (name, value) in row {
                match history[name].as_array_mut() {
                    Some(column) => column.push(value.clone()),
                    None => history[name] = json!([value]),
                }
            }
        });
    }

    /// Shows volumes of the run that goes on in place of earlier ones of the same names.
    pub(super) fn show(&self, volumes: Served) {
        self.with_runs(|runs| {
            let run = &mut runs[0];
            for (info, packed) in volumes {
                let id = info["id"].as_str().unwrap_or_default().to_owned();
                if let Some(all) = run.data["volumes"].as_array_mut() {
                    all.retain(|other| other["id"] != info["id"]);
                    all.push(info);
                }
                run.arrays.insert(id, Arc::new(packed));
            }
        });
    }

    /// Says of the run that goes on by how much gray values may be off.
    pub(super) fn set_band(&self, half_width: f64) {
        self.with_runs(|runs| runs[0].data["band"] = json!(half_width));
    }

    /// Puts the finished run in the place of the one that went on.
    pub(super) fn finish(&self, folder: &Path) -> Result<()> {
        let read = ComparedRun::read(folder)?;
        let shown = Shown::of(read, folder)?;
        self.with_runs(|runs| runs[0] = shown);
        self.tell(&json!({ "type": "done", "run": 0 }));
        Ok(())
    }

    /// Says that the run has ended without a result, and why, and that nothing more will be said.
    pub(super) fn fail(&self, state: &'static str, message: &str) {
        self.with_runs(|runs| runs[0].data["state"] = state.into());
        self.tell(&json!({ "type": state, "run": 0, "message": message }));
        self.events().take();
    }

    fn events(&self) -> MutexGuard<'_, Option<broadcast::Sender<String>>> {
        self.events.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn with_runs<T>(&self, work: impl FnOnce(&mut Vec<Shown>) -> T) -> T {
        work(&mut self.runs.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Shown {
    fn with(data: Value, arrays: BTreeMap<String, Arc<Vec<u8>>>) -> Self {
        Shown {
            data,
            arrays,
            full: None,
        }
    }

    /// # Errors
    /// Those of reading a page that is there and cannot be read.
    fn of(run: ComparedRun, folder: &Path) -> Result<Self> {
        let path = folder.join("report.html");
        let page = match run.page {
            // A run may leave its numbers alone
            None if !path.exists() => return Ok(Self::with(run.bare(), BTreeMap::new())),
            None => Page::read(&path)?,
            Some(page) => page,
        };
        let mut data = page.data["runs"][0].clone();
        data["name"] = run.name.into();
        // What the page shows is the response: slices of the dose serve where that is the dose itself
        let mut keys = run.job.keys();
        let is_dose = run.job.contains_key("response.identity")
            && !keys.any(|key| key.starts_with("species[0].response"));
        let mut volumes = data["volumes"].as_array_mut().into_iter().flatten();
        let response = volumes.find(|info| info["kind"] == "response");
        let full = response
            .zip(run.dose.filter(|_| is_dose))
            .map(|(info, path)| {
                info["full"] = true.into();
                let id = info["id"].as_str().unwrap_or_default().to_owned();
                Arc::new(Full {
                    id,
                    path,
                    read: Mutex::default(),
                })
            });
        let arrays = page.blobs.into_iter().filter_map(|(id, text)| {
            let id = id.strip_prefix("blob-0-")?.to_owned();
            Some((id, Arc::new(blob::deflated(&text)?)))
        });
        let arrays = arrays.collect();
        Ok(Shown {
            full,
            ..Self::with(data, arrays)
        })
    }
}
