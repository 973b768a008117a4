//! Long work of a call: it runs in a thread next to Python's, sends events to an observer, and ends at Ctrl-C or when its `cancel` is set.

use crate::arrays::{of_patterns, of_volume, one_or_list};
use pyo3::exceptions::PyTypeError;
use pyo3::import_exception;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyModule};
use serde::Serialize;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;
use tomolith::Error;
use tomolith::job::{Event, Progress, Snapshot, Wants};
use tomolith::work::Work;
use tomolith_sweep::{SweepEvent, Watch};

import_exception!(tomolith._errors, TomolithError);
import_exception!(tomolith._errors, Canceled);

/// How often a call looks whether Python wants it to end.
const PAUSE: Duration = Duration::from_millis(50);

/// Whether this process has computed anything; and whether it is a fork of one that had, whose threads it lacks.
static HAS_COMPUTED: AtomicBool = AtomicBool::new(false);
static IS_FORK: AtomicBool = AtomicBool::new(false);

/// Called in a forked child.
#[pyfunction(name = "_forked")]
pub(crate) fn forked() {
    IS_FORK.store(HAS_COMPUTED.load(Ordering::SeqCst), Ordering::SeqCst);
}

/// Refuses a fork: whatever computes with several threads would wait forever.
pub(crate) fn must_have_threads() -> PyResult<()> {
    if IS_FORK.load(Ordering::SeqCst) {
        return Err(TomolithError::new_err(
            "this process is a fork of one that has computed before, and lacks its threads; accepted: processes that are \
             spawned, as by multiprocessing.get_context(\"spawn\")",
        ));
    }
    Ok(())
}

/// Does work without Python's lock, in a separate thread, while this one listens to signals.
pub(crate) fn interruptible<T: Send>(
    py: Python<'_>,
    action: impl FnOnce(&Work) -> Result<T, Error> + Send,
) -> PyResult<T> {
    until(py, None, action)
}

/// Works until `cancel`, such as a `threading.Event`, is set.
fn until<T: Send>(
    py: Python<'_>,
    cancel: Option<&Py<PyAny>>,
    action: impl FnOnce(&Work) -> Result<T, Error> + Send,
) -> PyResult<T> {
    must_have_threads()?;
    if let Some(token) = cancel
        && !token.bind(py).hasattr("is_set")?
    {
        return Err(PyTypeError::new_err(format!(
            "cancel: found {}; accepted: a threading.Event",
            token.bind(py).get_type()
        )));
    }
    HAS_COMPUTED.store(true, Ordering::SeqCst);
    let work = &Work::new();
    let (done, interrupted) = py.detach(|| {
        thread::scope(|scope| {
            let (tell, ended) = channel();
            let worker = scope.spawn(move || {
                let result = action(work);
                // Nobody listens when this thread has panicked
                let _ = tell.send(());
                result
            });
            let mut interrupted = None;
            while let Err(RecvTimeoutError::Timeout) = ended.recv_timeout(PAUSE) {
                if interrupted.is_none() {
                    let found = Python::try_attach(|py| must_go_on(py, cancel));
                    interrupted = found.unwrap_or_else(|| end_with_python(work)).err();
                    if interrupted.is_some() {
                        work.cancel();
                    }
                }
            }
            let done = worker
                .join()
                .unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            if Python::try_attach(|_| ()).is_none() {
                end_with_python(work);
            }
            (done, interrupted)
        })
    });
    match interrupted {
        Some(error) => Err(error),
        None => done.map_err(raised),
    }
}

/// Waits for the end of the process, in a thread that Python left behind: what takes its lock then crashes.
fn end_with_python(work: &Work) -> ! {
    work.cancel();
    loop {
        thread::park();
    }
}

/// What a signal raises, or that the work is canceled.
fn must_go_on(py: Python<'_>, cancel: Option<&Py<PyAny>>) -> PyResult<()> {
    py.check_signals()?;
    match cancel {
        Some(token) if token.call_method0(py, "is_set")?.is_truthy(py)? => {
            Err(raised(Error::Canceled))
        }
        _ => Ok(()),
    }
}

/// An error as Python sees it.
pub(crate) fn raised(error: Error) -> PyErr {
    Python::attach(|py| {
        of_error(py, error)
            .map(PyErr::from_value)
            .unwrap_or_else(|e| e)
    })
}

/// A call that was canceled, with how to go on; other errors stay as they are.
pub(crate) fn advising(py: Python<'_>, error: PyErr, advice: &str) -> PyErr {
    match error.is_instance_of::<Canceled>(py) {
        true => Canceled::new_err(format!("canceled; {advice}")),
        false => error,
    }
}

/// A value that cannot be used: of a key of a job, or of an argument.
pub(crate) fn refused(
    key: impl Into<String>,
    found: impl std::fmt::Display,
    accepted: impl Into<String>,
) -> PyErr {
    raised(Error::refused(key, found, accepted))
}

/// Options of the command, and what they are here.
const OPTIONS: [(&str, &str); 5] = [
    ("--output DIR", "folder=DIR"),
    ("--overwrite", "overwrite=True"),
    ("`--resume`", "`resume=True`"),
    ("--resume", "resume"),
    ("--set ", "set: "),
];

/// A text of the library without the options of the command.
fn in_python(text: &str) -> String {
    let replaced = |text: String, (option, here): &(&str, &str)| text.replace(option, here);
    OPTIONS.iter().fold(text.to_owned(), replaced)
}

/// The exception with its attributes.
fn of_error(py: Python<'_>, error: Error) -> PyResult<Bound<'_, PyAny>> {
    let text = in_python(&error.to_string());
    let attributes = PyDict::new(py);
    let set = |name: &str, value: &str| attributes.set_item(name, in_python(value));
    match error {
        Error::Canceled => {
            return Ok(Canceled::new_err(text)
                .into_value(py)
                .into_bound(py)
                .into_any());
        }
        Error::Several(errors) => {
            let errors = errors.into_iter().map(|error| of_error(py, error));
            let errors = errors.collect::<PyResult<Vec<_>>>()?;
            if let Some(first) = errors.first() {
                for name in ["key", "found", "accepted", "file", "line"] {
                    attributes.set_item(name, first.getattr(name)?)?;
                }
            }
            attributes.set_item("errors", errors)?;
        }
        Error::Config {
            key,
            found,
            accepted,
            place,
            ..
        } => {
            if !key.is_empty() {
                set("key", &key)?;
            }
            // The text says "found -1", the attribute what that is
            set("found", found.strip_prefix("found ").unwrap_or(&found))?;
            set("accepted", &accepted)?;
            if let Some(place) = place {
                attributes.set_item("file", place.file)?;
                attributes.set_item("line", place.line)?;
            }
        }
        Error::Shape {
            what,
            expected,
            found,
        } => {
            set("key", &what)?;
            set("found", &format!("shape {found:?}"))?;
            set("accepted", &format!("shape {expected:?}"))?;
        }
        Error::Mesh {
            path,
            found,
            accepted,
        }
        | Error::Format {
            path,
            found,
            accepted,
        } => {
            attributes.set_item("file", path)?;
            set("found", &found)?;
            set("accepted", &accepted)?;
        }
        Error::Io { path, source } => {
            attributes.set_item("file", path)?;
            set("found", &source.to_string())?;
        }
        _ => {}
    }
    let kind = py.get_type::<TomolithError>();
    kind.call((text,), Some(&attributes))
}

/// Anything that serializes, as dicts, lists, numbers and strings.
pub(crate) fn plain<'py>(py: Python<'py>, value: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    let text = serde_json::to_string(value).map_err(|e| TomolithError::new_err(e.to_string()))?;
    PyModule::import(py, "json")?.call_method1("loads", (text,))
}

/// Brings events and copies, as dicts, to an object of Python; what that raises ends the work.
pub(crate) struct Observer<'a> {
    /// A callable, or an object with the methods `event` and `snapshot`, and `wants`.
    object: Option<Py<PyAny>>,
    raised: &'a Mutex<Option<PyErr>>,
    work: &'a Work,
}

impl Observer<'_> {
    fn call<T: Default>(
        &self,
        call: impl FnOnce(Python<'_>, &Bound<'_, PyAny>) -> PyResult<T>,
    ) -> T {
        let Some(object) = &self.object else {
            return T::default();
        };
        let called = Python::try_attach(|py| call(py, object.bind(py)));
        let raised = match called {
            Some(Ok(value)) => return value,
            Some(Err(error)) => Some(error),
            // Python has ended
            None => None,
        };
        if let (Some(error), Ok(mut first)) = (raised, self.raised.lock()) {
            first.get_or_insert(error);
        }
        self.work.cancel();
        T::default()
    }

    pub(crate) fn tell(&self, event: &impl Serialize) {
        self.call(|py, object| {
            let event = (plain(py, event)?,);
            match object.hasattr("event")? {
                true => object.call_method1("event", event),
                false => object.call1(event),
            }
            .map(drop)
        });
    }
}

impl Progress for Observer<'_> {
    fn event(&mut self, event: &Event) {
        self.tell(event);
    }

    fn wants(&self) -> Wants {
        self.call(|_, object| match object.getattr_opt("wants")? {
            Some(wants) => wants_of(&wants),
            None => Ok(Wants::default()),
        })
    }

    fn snapshot(&mut self, snapshot: Snapshot) {
        self.call(|py, object| {
            let copies = copies(py, snapshot)?;
            object.call_method1("snapshot", (copies,)).map(drop)
        });
    }
}

/// Names of copies, as those of `Observer.wants`.
fn wants_of(names: &Bound<'_, PyAny>) -> PyResult<Wants> {
    let mut wants = Wants::default();
    for name in names.try_iter()? {
        match name?.extract::<String>()?.as_str() {
            "patterns" => wants.patterns = true,
            "dose" => wants.dose = true,
            "print" => wants.print = true,
            "target" => wants.target = true,
            other => {
                return Err(refused(
                    "wants",
                    format!("`{other}`"),
                    "\"patterns\", \"dose\", \"print\", \"target\" in a list",
                ));
            }
        }
    }
    Ok(wants)
}

/// The iteration, and those copies that the observer wants.
fn copies(py: Python<'_>, snapshot: Snapshot) -> PyResult<Bound<'_, PyDict>> {
    let copies = PyDict::new(py);
    copies.set_item("iteration", snapshot.iteration)?;
    if !snapshot.patterns.is_empty() {
        let images = snapshot.patterns.into_iter().map(|p| of_patterns(py, p));
        copies.set_item("patterns", one_or_list(py, images)?)?;
    }
    let target = snapshot
        .target
        .into_iter()
        .map(|target| target.inside)
        .collect();
    let all = [
        ("dose", snapshot.dose),
        ("print", snapshot.print),
        ("target", target),
    ];
    for (name, volumes) in all {
        if !volumes.is_empty() {
            let volumes = volumes.into_iter().map(|volume| of_volume(py, volume));
            copies.set_item(name, one_or_list(py, volumes)?)?;
        }
    }
    Ok(copies)
}

impl Watch for Observer<'_> {
    fn event(&mut self, event: &SweepEvent) {
        self.tell(event);
    }
}

/// As [`interruptible`], for work that sends events to an observer and may be canceled.
pub(crate) fn interruptible_observed<T: Send>(
    py: Python<'_>,
    object: Option<Py<PyAny>>,
    cancel: Option<Py<PyAny>>,
    action: impl FnOnce(&mut Observer<'_>, &Work) -> Result<T, Error> + Send,
) -> PyResult<T> {
    let raised = Mutex::new(None);
    let done = until(py, cancel.as_ref(), |work| {
        let raised = &raised;
        action(
            &mut Observer {
                object,
                raised,
                work,
            },
            work,
        )
    });
    match raised.into_inner().ok().flatten() {
        Some(error) => Err(error),
        None => done,
    }
}
