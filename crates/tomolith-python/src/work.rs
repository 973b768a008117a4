//! Long work of a call: it runs beside Python, tells its events to a callable, and ends at Ctrl-C.

use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyKeyboardInterrupt};
use pyo3::prelude::*;
use pyo3::types::PyModule;
use serde::Serialize;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;
use tomolith::Error;
use tomolith::job::{Event, Progress};
use tomolith::run::Run;
use tomolith_sweep::{SweepEvent, Watch};

create_exception!(
    tomolith,
    TomolithError,
    PyException,
    "What was found, where, and what is accepted."
);

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

/// Does work without Python's lock, in a thread of its own, while this one listens to signals.
pub(crate) fn beside<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&Run) -> Result<T, Error> + Send,
) -> PyResult<T> {
    if IS_FORK.load(Ordering::SeqCst) {
        return Err(TomolithError::new_err(
            "this process is a fork of one that has computed before, and lacks its threads; accepted: processes that are \
             spawned, as by multiprocessing.get_context(\"spawn\")",
        ));
    }
    HAS_COMPUTED.store(true, Ordering::SeqCst);
    let run = &Run::new();
    let (done, interrupted) = py.detach(|| {
        thread::scope(|scope| {
            let (tell, ended) = channel();
            let worker = scope.spawn(move || {
                let result = work(run);
                // Nobody listens when this thread has panicked
                let _ = tell.send(());
                result
            });
            let mut interrupted = None;
            while let Err(RecvTimeoutError::Timeout) = ended.recv_timeout(PAUSE) {
                if interrupted.is_none() {
                    interrupted = Python::attach(|py| py.check_signals()).err();
                    if interrupted.is_some() {
                        run.cancel();
                    }
                }
            }
            let done = worker
                .join()
                .unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            (done, interrupted)
        })
    });
    match interrupted {
        Some(error) => Err(error),
        None => done.map_err(raised),
    }
}

/// An error as Python sees it.
pub(crate) fn raised(error: Error) -> PyErr {
    match error {
        Error::Canceled => PyKeyboardInterrupt::new_err("canceled"),
        error => TomolithError::new_err(error.to_string()),
    }
}

/// Anything that serializes, as dicts, lists, numbers and strings.
pub(crate) fn plain<'py>(py: Python<'py>, value: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    let text = serde_json::to_string(value).map_err(|e| TomolithError::new_err(e.to_string()))?;
    PyModule::import(py, "json")?.call_method1("loads", (text,))
}

/// Brings events, as dicts, to a callable; what it raises is kept, and ends the work.
pub(crate) struct Told<'a> {
    callable: Option<Py<PyAny>>,
    raised: &'a Mutex<Option<PyErr>>,
    run: &'a Run,
}

impl<'a> Told<'a> {
    pub(crate) fn to(
        callable: Option<Py<PyAny>>,
        raised: &'a Mutex<Option<PyErr>>,
        run: &'a Run,
    ) -> Self {
        Told {
            callable,
            raised,
            run,
        }
    }

    fn tell(&self, event: &impl Serialize) {
        let Some(callable) = &self.callable else {
            return;
        };
        let told = Python::attach(|py| callable.call1(py, (plain(py, event)?,)).map(drop));
        if let (Err(error), Ok(mut raised)) = (told, self.raised.lock()) {
            raised.get_or_insert(error);
            self.run.cancel();
        }
    }
}

impl Progress for Told<'_> {
    fn event(&mut self, event: &Event) {
        self.tell(event);
    }
}

impl Watch for Told<'_> {
    fn event(&mut self, event: &SweepEvent) {
        self.tell(event);
    }
}

/// As [`beside`], for work that tells its events.
pub(crate) fn beside_telling<T: Send>(
    py: Python<'_>,
    callable: Option<Py<PyAny>>,
    work: impl FnOnce(&mut Told<'_>, &Run) -> Result<T, Error> + Send,
) -> PyResult<T> {
    let raised = Mutex::new(None);
    let done = beside(py, |run| work(&mut Told::to(callable, &raised, run), run));
    match raised.into_inner().ok().flatten() {
        Some(error) => Err(error),
        None => done,
    }
}
