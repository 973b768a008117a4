//! The server: the loopback alone, one random token, read-only.

use super::site::Site;
use axum::Router;
use axum::body::Body;
use axum::extract::{Path, RawQuery, Request, State};
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::middleware::{Next, from_fn_with_state};
use axum::response::sse::{Event, KeepAlive, Sse};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use futures_util::StreamExt as _;
use futures_util::future::ready;
use futures_util::stream::{Stream, once, unfold};
use std::convert::Infallible;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::runtime::{Builder, Runtime};
use tokio::sync::broadcast::error::RecvError;
use tokio::sync::oneshot;
use tokio::task::JoinHandle;
use tomolith::models::Work;
use tomolith::{Error, Result};

/// How long the end of a command waits for a look at the request to stop.
const PAUSE: Duration = Duration::from_millis(100);

/// How long the end of a run without a result waits for pages to hear of it.
const LONGEST: Duration = Duration::from_secs(1);

/// Where a page may load what: from itself alone.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline' blob:; worker-src blob:; style-src 'unsafe-inline'; img-src data: blob:; connect-src 'self'; \
    base-uri 'none'; form-action 'none'; frame-ancestors 'self'";

/// What every answer knows.
#[derive(Clone)]
struct Known {
    site: Arc<Site>,
    token: Arc<str>,
    port: u16,
}

/// See the [module page](self).
pub(super) struct Server {
    runtime: Runtime,
    serving: JoinHandle<()>,
    /// Asks it to end when pages have heard all.
    end: oneshot::Sender<()>,
    known: Known,
}

impl Server {
    pub(super) fn start(site: &Arc<Site>, port: u16) -> Result<Self> {
        let refused = |e: std::io::Error| {
            Error::config(
                "--port",
                format!("{port}: {e}"),
                "a port of this machine that is free; 0 takes any",
            )
        };
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(refused)?;
        listener.set_nonblocking(true).map_err(refused)?;
        let port = listener.local_addr().map_err(refused)?.port();
        let known = Known {
            site: Arc::clone(site),
            token: token()?.into(),
            port,
        };
        let runtime = Builder::new_multi_thread()
            .worker_threads(1)
            .enable_all()
            .build()
            .map_err(refused)?;
        let router = router(known.clone());
        let (end, ended) = oneshot::channel();
        let serving = runtime.spawn(async move {
            if let Ok(listener) = tokio::net::TcpListener::from_std(listener) {
                let served = axum::serve(listener, router);
                let ended = served.with_graceful_shutdown(async { drop(ended.await) });
                let _ = ended.await;
            }
        });
        Ok(Server {
            runtime,
            serving,
            end,
            known,
        })
    }

    pub(super) fn address(&self) -> String {
        let here = SocketAddr::from((Ipv4Addr::LOCALHOST, self.known.port));
        format!("http://{here}/{}/", self.known.token)
    }

    /// Serves until the command is asked to stop.
    pub(super) fn serve_until(self, work: &Work) {
        while !work.is_canceled() {
            std::thread::sleep(PAUSE);
        }
        self.runtime.shutdown_background();
    }

    /// Ends when the pages have heard what was said last, or after a while.
    pub(super) fn end(self) {
        let _ = self.end.send(());
        let begin = Instant::now();
        while !self.serving.is_finished() && begin.elapsed() < LONGEST {
            std::thread::sleep(PAUSE / 10);
        }
        self.runtime.shutdown_background();
    }
}

/// 128 random bits.
fn token() -> Result<String> {
    let mut bytes = [0u8; 16];
    getrandom::fill(&mut bytes)
        .map_err(|e| Error::config("view", e.to_string(), "a system that has random numbers"))?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}

fn router(known: Known) -> Router {
    Router::new()
        .route("/{token}/", get(page))
        .route("/{token}/runs.json", get(data))
        .route("/{token}/open/{row}", get(open))
        .route("/{token}/events", get(events))
        .route("/{token}/cancel/{run}", post(cancel))
        .route("/{token}/run/{run}/slice/{id}", get(slice))
        .route("/{token}/run/{run}/{kind}/{id}", get(array))
        .fallback(|| async { StatusCode::NOT_FOUND })
        .layer(from_fn_with_state(known.clone(), guard))
        .with_state(known)
}

/// Answers only who knows the token and asks this machine by its own name, from a page of its own.
async fn guard(State(known): State<Known>, request: Request, next: Next) -> Response {
    let headers = request.headers();
    let names = ["127.0.0.1", "localhost", "[::1]"].map(|name| format!("{name}:{}", known.port));
    let is_here = |value: &HeaderValue| {
        value
            .to_str()
            .is_ok_and(|host| names.iter().any(|name| name == host))
    };
    if !headers.get(header::HOST).is_some_and(is_here) {
        return (
            StatusCode::FORBIDDEN,
            "this page is for the machine that serves it",
        )
            .into_response();
    }
    let is_own = |origin: &HeaderValue| {
        let host = origin
            .to_str()
            .ok()
            .and_then(|origin| origin.strip_prefix("http://"));
        host.is_some_and(|host| names.iter().any(|name| name == host))
    };
    if headers
        .get(header::ORIGIN)
        .is_some_and(|origin| !is_own(origin))
    {
        return StatusCode::FORBIDDEN.into_response();
    }
    let begins = request.uri().path().split('/').nth(1);
    if begins != Some(&known.token) {
        return StatusCode::NOT_FOUND.into_response();
    }
    let mut response = next.run(request).await;
    let headers: &mut HeaderMap = response.headers_mut();
    for (name, value) in [
        (header::CACHE_CONTROL, "no-store"),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::REFERRER_POLICY, "no-referrer"),
        (header::CONTENT_SECURITY_POLICY, POLICY),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    response
}

impl Known {
    fn served(&self) -> String {
        format!("/{}/", self.token)
    }
}

async fn page(State(known): State<Known>) -> Response {
    let text = known.site.page(&known.served());
    ([(header::CONTENT_TYPE, "text/html; charset=utf-8")], text).into_response()
}

async fn data(State(known): State<Known>) -> Response {
    let text = known.site.data(&known.served()).to_string();
    ([(header::CONTENT_TYPE, "application/json")], text).into_response()
}

async fn open(State(known): State<Known>, Path((_, row)): Path<(String, usize)>) -> Response {
    let site = Arc::clone(&known.site);
    match tokio::task::spawn_blocking(move || site.open(row)).await {
        Ok(Ok(Some(run))) => {
            let text = serde_json::json!({ "run": run }).to_string();
            ([(header::CONTENT_TYPE, "application/json")], text).into_response()
        }
        Ok(Ok(None)) => StatusCode::NOT_FOUND.into_response(),
        Ok(Err(error)) => (StatusCode::GONE, error.to_string()).into_response(),
        Err(_) => StatusCode::INTERNAL_SERVER_ERROR.into_response(),
    }
}

async fn array(
    State(known): State<Known>,
    Path((_, run, _, id)): Path<(String, usize, String, String)>,
) -> Response {
    match known.site.array(run, &id) {
        Some(bytes) => binary(bytes.as_ref().clone()),
        None => StatusCode::NOT_FOUND.into_response(),
    }
}

async fn slice(
    State(known): State<Known>,
    Path((_, run, id)): Path<(String, usize, String)>,
    RawQuery(query): RawQuery,
) -> Response {
    let query = query.unwrap_or_default();
    let number = |name: &str| {
        let pairs = query.split('&').filter_map(|pair| pair.split_once('='));
        pairs
            .filter(|(key, _)| *key == name)
            .find_map(|(_, value)| value.parse::<usize>().ok())
    };
    let Some((axis, index)) = number("axis").zip(number("index")) else {
        return (
            StatusCode::BAD_REQUEST,
            "axis (0, 1 or 2) and index are missing",
        )
            .into_response();
    };
    let site = Arc::clone(&known.site);
    // Reading a file may take a while
    let cut = tokio::task::spawn_blocking(move || site.slice(run, &id, axis, index)).await;
    match cut {
        Ok(Ok(Some(bytes))) => binary(bytes),
        Ok(Ok(None)) => StatusCode::NOT_FOUND.into_response(),
        Ok(Err(error)) => (StatusCode::GONE, error.to_string()).into_response(),
        Err(_) => StatusCode::INTERNAL_SERVER_ERROR.into_response(),
    }
}

fn binary(bytes: Vec<u8>) -> Response {
    (
        [(header::CONTENT_TYPE, "application/octet-stream")],
        Body::from(bytes),
    )
        .into_response()
}

async fn cancel(State(known): State<Known>, Path((_, run)): Path<(String, usize)>) -> StatusCode {
    match known.site.stop(run) {
        true => StatusCode::ACCEPTED,
        false => StatusCode::NOT_FOUND,
    }
}

async fn events(State(known): State<Known>) -> Sse<impl Stream<Item = Result<Event, Infallible>>> {
    let next = |heard: Option<tokio::sync::broadcast::Receiver<String>>| async move {
        let mut heard = heard?;
        loop {
            match heard.recv().await {
                Ok(text) => return Some((Ok(Event::default().data(text)), Some(heard))),
                // Who is behind goes on with what is new
                Err(RecvError::Lagged(_)) => {}
                Err(RecvError::Closed) => return None,
            }
        }
    };
    // Whoever comes late knows at once whether there is anything to wait for
    let (heard, states) = (known.site.listen(), known.site.states());
    let first = once(ready(Ok(Event::default().data(states.to_string()))));
    Sse::new(first.chain(unfold(heard, next))).keep_alive(KeepAlive::default())
}
