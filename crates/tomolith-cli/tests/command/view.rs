//! `tomolith view`, as a browser and as a stranger on the same machine ask it.

use crate::bench::{Bench, contains};
use serde_json::Value;
use std::fs;
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::time::Duration;
use tomolith::report::page::{Page, blob};

/// A server that a test has started.
struct Served {
    child: Child,
    port: u16,
    token: String,
}

impl Served {
    fn start(bench: &Bench, line: &str) -> Self {
        let mut child = bench
            .command(line)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut address = String::new();
        let mut out = BufReader::new(child.stdout.take().unwrap());
        out.read_line(&mut address).unwrap();
        // Nobody else reads what it says, and a full pipe would stop it
        std::thread::spawn(move || out.read_to_end(&mut Vec::new()));
        let rest = address.trim().strip_prefix("http://127.0.0.1:");
        let (port, token) = rest
            .and_then(|rest| rest.split_once('/'))
            .unwrap_or_else(|| panic!("{address}"));
        Served {
            child,
            port: port.parse().unwrap(),
            token: token.trim_end_matches('/').to_owned(),
        }
    }

    /// Status and body of a request with these headers.
    fn ask(&self, method: &str, path: &str, headers: &str) -> (u16, Vec<u8>) {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream
            .set_read_timeout(Some(Duration::from_secs(60)))
            .unwrap();
        write!(
            stream,
            "{method} {path} HTTP/1.1\r\n{headers}Connection: close\r\nContent-Length: 0\r\n\r\n"
        )
        .unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        let end = answer
            .windows(4)
            .position(|four| four == b"\r\n\r\n")
            .unwrap();
        let head = String::from_utf8_lossy(&answer[..end]).into_owned();
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        if status == 200 {
            for guard in [
                "content-security-policy: default-src 'none'",
                "x-content-type-options: nosniff",
                "cache-control: no-store",
            ] {
                assert!(head.contains(guard), "{head}");
            }
        }
        (status, answer[end + 4..].to_vec())
    }

    fn get(&self, path: &str) -> (u16, Vec<u8>) {
        let host = format!("Host: 127.0.0.1:{}\r\n", self.port);
        self.ask("GET", &format!("/{}/{path}", self.token), &host)
    }

    fn post(&self, path: &str) -> u16 {
        let host = format!(
            "Host: localhost:{0}\r\nOrigin: http://localhost:{0}\r\n",
            self.port
        );
        self.ask("POST", &format!("/{}/{path}", self.token), &host)
            .0
    }

    /// Asks it to stop as Ctrl-C does; its exit code.
    fn interrupt(mut self) -> Option<i32> {
        let pid = self.child.id().to_string();
        assert!(
            Command::new("kill")
                .args(["-INT", &pid])
                .status()
                .unwrap()
                .success()
        );
        self.child.wait().unwrap().code()
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
    }
}

#[test]
fn the_page_its_arrays_and_slices_of_the_dose_are_served() {
    let bench = Bench::new();
    bench.done("run job.toml --quiet --output a");
    bench.done("run job.toml --quiet --output b --set stop.iterations=2");
    let served = Served::start(&bench, "view a b --no-browser");
    let (status, page) = served.get("");
    let page = String::from_utf8(page).unwrap();
    assert_eq!(status, 200);
    assert!(
        page.contains(&format!("\"served\":\"/{}/\"", served.token)),
        "{}",
        &page[..500]
    );
    let data: Value = serde_json::from_slice(&served.get("runs.json").1).unwrap();
    assert_eq!(
        (&data["runs"][0]["name"], &data["runs"][1]["name"]),
        (&"a".into(), &"b".into())
    );
    assert_eq!(
        data["compare"]["differing_keys"][0]["key"],
        "stop.iterations"
    );

    let file = Page::read(&bench.path("b/report.html")).unwrap();
    for info in data["runs"][1]["volumes"].as_array().unwrap() {
        let id = info["id"].as_str().unwrap();
        let (status, bytes) = served.get(&format!("run/1/volume/{id}"));
        let name = format!("blob-0-{id}");
        let (_, text) = file.blobs.iter().find(|(id, _)| *id == name).unwrap();
        assert_eq!((status, Some(bytes)), (200, blob::deflated(text)), "{id}");
        assert_eq!(info["full"] == true, info["kind"] == "response");
    }

    let (shape, dose) = tomolith::io::npy::read_volume(&bench.path("a/dose.npy")).unwrap();
    let [nz, ny, nx] = shape;
    let (status, bytes) = served.get(&format!("run/0/slice/response2?axis=0&index={}", nz / 2));
    assert_eq!(status, 200);
    let end = bytes.iter().position(|byte| *byte == b'\n').unwrap() + 1;
    let header: Value = serde_json::from_slice(&bytes[..end]).unwrap();
    assert_eq!(header["shape"], serde_json::json!([ny, nx]));
    let [low, high] = ["low", "high"].map(|end| header[end].as_f64().unwrap());
    let middle = (ny / 2 * nx + nx / 2) * 2;
    let code = u16::from_le_bytes([bytes[end + middle], bytes[end + middle + 1]]);
    let value = low + f64::from(code) / 65535.0 * (high - low);
    let expected = f64::from(dose[(nz / 2 * ny + ny / 2) * nx + nx / 2]);
    assert!((value - expected).abs() < 1e-4 * high, "{value} {expected}");
    assert_eq!(
        served
            .get(&format!("run/0/slice/response2?axis=0&index={nz}"))
            .0,
        404
    );
    for other in ["response2?axis=7&index=0", "target0?axis=0&index=0"] {
        assert_eq!(
            served.get(&format!("run/0/slice/{other}")).0,
            404,
            "{other}"
        );
    }
    assert_eq!(served.get("run/0/slice/response2").0, 400);

    // The dose is not what prints where the material has a response
    bench.done("run job.toml --quiet --toy --output c --set response={logistic={midpoint=0.5,steepness=20}}");
    let other = Served::start(&bench, "view c --no-browser");
    let data: Value = serde_json::from_slice(&other.get("runs.json").1).unwrap();
    let mut all = data["runs"][0]["volumes"].as_array().unwrap().iter();
    assert!(
        all.all(|info| info["full"] == false)
            && other.get("run/0/slice/response2?axis=0&index=0").0 == 404
    );

    // A run that vanishes: what was read stays, what was not says so
    fs::remove_dir_all(bench.path("b")).unwrap();
    assert_eq!(served.get("run/1/slice/response2?axis=0&index=0").0, 410);
    assert_eq!(served.get("run/1/volume/response2").0, 200);
    assert_eq!(served.interrupt(), Some(0));
}

#[test]
fn strangers_get_nothing() {
    let bench = Bench::new();
    bench.done("run job.toml --quiet --output a --toy");
    bench.write("secret.txt", "secret");
    let served = Served::start(&bench, "view a --no-browser");
    let (port, token) = (served.port, served.token.clone());
    assert_eq!(token.len(), 32);
    let here = format!("Host: 127.0.0.1:{port}\r\n");
    let ask = |path: &str, headers: &str| served.ask("GET", path, headers).0;
    assert_eq!(ask(&format!("/{token}/"), &here), 200);
    for path in [
        "/",
        "/runs.json",
        &format!("/{}/", "0".repeat(32)),
        &format!("/{token}"),
        &format!("//{token}/"),
    ] {
        assert_eq!(ask(path, &here), 404, "{path}");
    }
    // A name that somebody has pointed to this machine, and a page of another origin
    for headers in [
        format!("Host: attacker.example:{port}\r\n"),
        "Host: 127.0.0.1\r\n".to_owned(),
        format!("{here}Origin: http://attacker.example\r\n"),
        format!("{here}Origin: null\r\n"),
    ] {
        assert_eq!(
            ask(&format!("/{token}/runs.json"), &headers),
            403,
            "{headers}"
        );
    }
    for path in [
        "../secret.txt",
        "run/0/volume/..%2F..%2Fsecret.txt",
        "run/0/volume/%2e%2e/secret.txt",
        "run/9/volume/target0",
        "run/x/volume/target0",
        "run/0/film/",
    ] {
        let (status, body) = served.get(path);
        assert!([400, 404].contains(&status), "{path}: {status}");
        assert!(!String::from_utf8_lossy(&body).contains("secret"), "{path}");
    }
    // Nothing can be changed, and there is nothing to stop
    assert_eq!(served.post("runs.json"), 405);
    assert_eq!(served.post("cancel/0"), 404);
    assert_eq!(served.interrupt(), Some(0));
}

#[test]
fn what_cannot_be_served_is_refused_before() {
    let bench = Bench::new();
    bench.done("run job.toml --quiet --output a --toy");
    let listener = std::net::TcpListener::bind(("127.0.0.1", 0)).unwrap();
    let taken = listener.local_addr().unwrap().port();
    for (line, message) in [
        ("view missing", "there is no such folder"),
        (&format!("view a --port {taken}"), "--port"),
        ("run job.toml -o b --port 8080", "without `--open`"),
        ("run job.toml job.toml --open", "one job"),
    ] {
        bench.refuse(&format!("{line} --no-browser"), &[message]);
    }
    bench.write("a/report.html", "<html>an earlier version");
    bench.refuse(
        "view a --no-browser",
        &["report.html", "no page of Tomolith"],
    );
}

#[test]
fn a_row_of_a_sweep_opens_its_run() {
    let bench = Bench::new();
    let sweep = "job = \"job.toml\"\nfolder = \"map\"\nmetrics = [\"evaluation.iou\"]\n[[axes]]\nkey = \"stop.iterations\"\nvalues = [1, 3]\n";
    bench.write("sweep.toml", sweep);
    bench.done("sweep sweep.toml --quiet");
    let served = Served::start(&bench, "view map --no-browser");
    let data: Value = serde_json::from_slice(&served.get("runs.json").1).unwrap();
    let sweep = &data["sweep"];
    assert_eq!(
        (&sweep["name"], &sweep["axes"], &data["runs"]),
        (
            &"map".into(),
            &serde_json::json!(["iterations"]),
            &serde_json::json!([])
        )
    );
    assert_eq!(sweep["rows"][1]["values"][0], 3);
    let iou = &sweep["rows"][1]["values"][1];
    let opened: Value = serde_json::from_slice(&served.get("open/1").1).unwrap();
    assert_eq!(opened, serde_json::json!({ "run": 0 }));
    let data: Value = serde_json::from_slice(&served.get("runs.json").1).unwrap();
    assert_eq!(&data["runs"][0]["report"]["evaluation"]["iou"], iou);
    // Opened once, whoever asks; a row that is not there has no run
    assert_eq!(served.get("open/1").1, served.get("open/1").1);
    assert_eq!(served.get("open/2").0, 404);
    assert_eq!(served.interrupt(), Some(0));
    bench.write("map/table.json", "{}");
    bench.refuse("view map --no-browser", &["table.json"]);
}

fn events(served: &Served) -> impl Iterator<Item = Value> + Send + use<> {
    let mut stream = TcpStream::connect(("127.0.0.1", served.port)).unwrap();
    stream
        .set_read_timeout(Some(Duration::from_secs(120)))
        .unwrap();
    let (token, port) = (&served.token, served.port);
    write!(
        stream,
        "GET /{token}/events HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n"
    )
    .unwrap();
    let lines = BufReader::new(stream).lines().map_while(Result::ok);
    lines.filter_map(|line| serde_json::from_str(line.strip_prefix("data: ")?).ok())
}

fn until(events: &mut impl Iterator<Item = Value>, kind: &str) -> Vec<Value> {
    let mut seen = Vec::new();
    for event in events {
        let is_last = event["type"] == kind || event["states"][0] == kind;
        seen.push(event);
        if is_last {
            return seen;
        }
    }
    panic!("{kind} did not come: {seen:?}")
}

#[test]
fn a_run_is_watched_to_its_end_and_its_result_stays() {
    let bench = Bench::new();
    let served = Served::start(
        &bench,
        "run job.toml --open --no-browser --quiet -o a --set stop.iterations=200 --set stop.change=0",
    );
    let running: Value = serde_json::from_slice(&served.get("runs.json").1).unwrap();
    assert!(running["runs"][0]["state"] == "running" || running["runs"][0]["state"] == "done");
    let events = until(&mut events(&served), "done");
    let rows: Vec<&Value> = events
        .iter()
        .filter(|event| event["type"] == "iteration")
        .collect();
    assert!(
        rows.len() > 1 || events[0]["states"][0] == "done",
        "{events:?}"
    );
    for event in rows {
        let row = &event["row"];
        assert!(
            row["forward_calls"].as_u64() > Some(0) && row["adjoint_calls"].is_u64(),
            "{event}"
        );
    }
    let data: Value = serde_json::from_slice(&served.get("runs.json").1).unwrap();
    assert_eq!(
        (
            &data["runs"][0]["state"],
            &data["runs"][0]["report"]["part"]
        ),
        (&"done".into(), &"gear".into())
    );
    assert_eq!(served.interrupt(), Some(0));
}

#[test]
fn the_page_hears_why_a_run_failed() {
    let bench = Bench::new();
    let mut served = Served::start(
        &bench,
        "run job.toml --open --no-browser --quiet -o a --set stop.iterations=4000 --set stop.change=0",
    );
    let mut events = events(&served);
    let _ = until(&mut events, "iteration");
    fs::remove_dir_all(bench.path("a")).unwrap();
    bench.write("a", "no folder");
    let seen = until(&mut events, "failed");
    let message = seen.last().unwrap()["message"].as_str().unwrap();
    assert!(message.contains("a/"), "{message}");
    assert_eq!(events.next(), None, "nothing follows");
    assert_eq!(served.child.wait().unwrap().code(), Some(2));
}

#[test]
fn the_page_can_stop_a_run() {
    let bench = Bench::new();
    let mut served = Served::start(
        &bench,
        "run job.toml --open --no-browser --quiet -o a --set grid.pitch_mm=0.02 --set light.angles=600 --set stop.iterations=5000 --set stop.change=0 --set evaluate.refine=1",
    );
    let mut events = events(&served);
    let _ = until(&mut events, "snapshot");
    // The dose is shown against what is asked for, on the same voxels
    let data: Value = serde_json::from_slice(&served.get("runs.json").1).unwrap();
    let volumes = data["runs"][0]["volumes"].as_array().unwrap();
    let shape = |kind: &str| {
        let of_kind = volumes.iter().find(|info| info["kind"] == kind);
        of_kind.unwrap_or_else(|| panic!("{kind}: {volumes:?}"))["shape_zyx"].clone()
    };
    assert_eq!(
        (shape("target"), shape("labels")),
        (shape("response"), shape("response"))
    );
    assert_eq!(served.get("run/0/volume/labels0").0, 200);
    assert_eq!(served.post("cancel/0"), 202);
    let seen = until(&mut events, "canceled");
    let last = seen.last().unwrap()["message"].as_str().unwrap();
    contains(last, "", &["canceled", "--resume"]);
    assert_eq!(served.child.wait().unwrap().code(), Some(130));
    assert!(bench.path("a/checkpoint").is_dir() && !bench.path("a/report.html").exists());
}
