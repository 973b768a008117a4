//! `tomolith view`: runs on a page that one can look into, served from this machine alone; `tomolith run --open` shows a run while it goes on.
//!
//! The server listens on the loopback, answers only addresses that begin with a random token, only to requests that name this machine as their
//! host, and reads nothing but what it was given: the runs' pages and doses. The one thing that it does is to stop the run that it shows.

mod live;
mod server;
mod site;

use crate::arguments::Manner;
use crate::screen::{mutter, say};
use clap::Args;
pub(crate) use live::Live;
use server::Server;
use site::Site;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::Arc;
use tomolith::Result;
use tomolith::models::Work;

const EXAMPLES: &str = "\
Examples:
  tomolith view out/01-gear
  tomolith view out/gear-lbfgs out/gear-osmo       several runs side by side
  tomolith view out/threshold-map                  a sweep: maps, and a click opens a run
  tomolith view out/01-gear --port 8080            over SSH: ssh -L 8080:127.0.0.1:8080 HOST, then open the address here

Ctrl-C ends it.";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct ViewArguments {
    /// Folders of `run` and `simulate`, or the one of a `sweep`
    #[arg(required = true)]
    runs: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) address: Address,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

/// Where a page is served.
#[derive(Clone, Copy, Debug, Default, Args)]
pub(crate) struct Address {
    /// Port of the loopback; 0: a free one
    #[arg(long, value_name = "PORT", default_value_t = 0)]
    port: u16,
    /// Print the address, and leave the browser alone
    #[arg(long)]
    no_browser: bool,
}

impl Address {
    /// Whether anything else is asked for than a free port and the browser.
    pub(crate) fn is_set(self) -> bool {
        self.port != 0 || self.no_browser
    }
}

pub(crate) fn view(given: &ViewArguments, work: &Arc<Work>) -> Result<()> {
    let site = Arc::new(Site::of_runs(&given.runs)?);
    let server = Server::start(&site, given.address.port)?;
    tell(&server, given.address, given.manner);
    server.serve_until(work);
    Ok(())
}

/// Says where the page is, and asks the system to open it.
fn tell(server: &Server, address: Address, manner: Manner) {
    let page = server.address();
    if manner.json {
        say(&serde_json::json!({ "event": "serving", "address": page }).to_string());
    } else {
        say(&page);
    }
    if address.no_browser || manner.json {
        return;
    }
    let opener = if cfg!(target_os = "macos") {
        "open"
    } else if cfg!(windows) {
        "explorer"
    } else {
        "xdg-open"
    };
    let started = Command::new(opener)
        .arg(&page)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    if started.is_err() && !manner.quiet {
        mutter(&format!(
            "`{opener}` is not there: open the address in a browser"
        ));
    }
}
