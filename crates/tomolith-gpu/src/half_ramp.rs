//! The half ramp of patterns on the card: one thread a row of pixels of a frame, through all columns and back.
//!
//! What M leaves at pixels that are no elements matters for Mᵀ, so a pass works in a rectangle of columns and rows in addition to the field, a
//! few frames at a time.

use crate::device::{Buffer, Gpu};
use crate::field::GpuField;
use crate::passes::ENTRY;
use tomolith_core::field::half_ramp::SECTIONS;
use tomolith_core::field::{ColumnRun, Field as _, HalfRamp, HalfRampKernel};

/// Bytes of the rectangles of a pass.
const MOST_SCRATCH: u64 = 256 << 20;

/// [`HalfRampKernel`] on a graphics card.
pub struct GpuHalfRamp {
    gpu: Gpu,
    runs: Buffer,
    batches: Vec<Batch>,
    scratch: Buffer,
}

/// Neighboring frames of one piece of the field.
struct Batch {
    piece: usize,
    frames: Buffer,
    count: usize,
    /// Rows of the highest.
    rows: usize,
}

/// A frame: its runs, its lowest row, its rows, and where its rectangle begins.
#[derive(Clone, Copy)]
struct Frame {
    runs: [u32; 2],
    bottom: u32,
    rows: u32,
}

impl Frame {
    /// Elements of its rectangle.
    fn rectangle(&self) -> u64 {
        u64::from(self.runs[1] - self.runs[0]) * u64::from(self.rows)
    }
}

impl HalfRampKernel<GpuField> for GpuHalfRamp {
    fn new(ramp: HalfRamp, like: &GpuField) -> Self {
        let gpu = like.gpu();
        let ranges: Vec<_> = like.ranges().collect();
        let mut table: Vec<[u32; 4]> = Vec::new();
        let mut batches: Vec<(usize, Vec<Frame>)> = Vec::new();
        let most = MOST_SCRATCH.min(gpu.binding_bytes()) / 4;
        let (mut element, mut piece, mut size) = (0, 0, 0);
        for runs in &ramp.frames {
            let begin = element;
            element += runs.iter().map(|run| run.count).sum::<usize>();
            if begin == element {
                continue;
            }
            while ranges[piece].end <= begin {
                piece += 1;
            }
            assert!(
                element <= ranges[piece].end,
                "a frame in two pieces of a field"
            );
            let frame = framed(runs, ranges[piece].start, &mut table);
            match batches.last_mut() {
                Some((last, frames)) if *last == piece && size + frame.rectangle() <= most => {
                    frames.push(frame);
                    size += frame.rectangle();
                }
                _ => {
                    size = frame.rectangle();
                    batches.push((piece, vec![frame]));
                }
            }
        }
        assert_eq!(element, like.len(), "runs of another field");
        let largest = |(_, frames): &(usize, Vec<Frame>)| frames.iter().map(Frame::rectangle).sum();
        let scratch = batches.iter().map(largest).max().unwrap_or(0u64);
        GpuHalfRamp {
            gpu: gpu.clone(),
            runs: gpu.upload(&table),
            batches: batches
                .into_iter()
                .map(|(piece, frames)| Batch::new(gpu, piece, frames))
                .collect(),
            scratch: gpu.buffer(4 * scratch),
        }
    }

    fn apply(&self, x: &GpuField, out: &mut GpuField) {
        for batch in &self.batches {
            let [[b1, a1], [b2, a2]] = SECTIONS.map(|section| section.map(f32::to_bits));
            let parameters = [batch.count as u32, batch.rows as u32, 0, 0, b1, a1, b2, a2];
            let buffers = [
                &batch.frames,
                &self.runs,
                &x.pieces()[batch.piece],
                &out.pieces()[batch.piece],
                &self.scratch,
            ];
            let threads = batch.count * batch.rows;
            self.gpu
                .run("half ramp", &source, &parameters, &buffers, threads);
        }
    }
}

/// The frame of some runs, from the first to the last that has rows; adds these to the table, counted from a first element.
fn framed(runs: &[ColumnRun], first: usize, table: &mut Vec<[u32; 4]>) -> Frame {
    let is_lit = |run: &ColumnRun| run.count > 0;
    let begin = runs.iter().position(is_lit).unwrap_or(0);
    let end = runs.iter().rposition(is_lit).map_or(begin, |last| last + 1);
    let lit = || runs[begin..end].iter().filter(|run| run.count > 0);
    let bottom = lit().map(|run| run.bottom).min().unwrap_or(0);
    let top = lit().map(|run| run.bottom + run.count).max().unwrap_or(0);
    let from = table.len() as u32;
    table.extend(runs[begin..end].iter().map(|run| {
        let element = run.first.saturating_sub(first);
        [element, run.bottom, run.count, 0].map(|v| v as u32)
    }));
    Frame {
        runs: [from, table.len() as u32],
        bottom: bottom as u32,
        rows: (top - bottom) as u32,
    }
}

impl Batch {
    fn new(gpu: &Gpu, piece: usize, frames: Vec<Frame>) -> Self {
        let mut at = 0;
        let words = |frame: &Frame| {
            let begin = at;
            at += frame.rectangle();
            let [from, end] = frame.runs;
            [from, end, frame.bottom, frame.rows, begin as u32, 0, 0, 0]
        };
        let words: Vec<[u32; 8]> = frames.iter().map(words).collect();
        Batch {
            piece,
            frames: gpu.upload(&words),
            count: frames.len(),
            rows: frames
                .iter()
                .map(|frame| frame.rows as usize)
                .max()
                .unwrap_or(0),
        }
    }
}

fn source() -> String {
    format!(
        "struct Parameters {{ frames: u32, rows: u32, u0: u32, u1: u32, b1: f32, a1: f32, b2: f32, a2: f32 }}
struct Frame {{ first: u32, end: u32, bottom: u32, rows: u32, place: u32, u0: u32, u1: u32, u2: u32 }}
@group(0) @binding(0) var<uniform> p: Parameters;
@group(0) @binding(1) var<storage, read> frames: array<Frame>;
@group(0) @binding(2) var<storage, read> runs: array<vec4<u32>>;
@group(0) @binding(3) var<storage, read> x: array<f32>;
@group(0) @binding(4) var<storage, read_write> out: array<f32>;
@group(0) @binding(5) var<storage, read_write> rectangle: array<f32>;
{ENTRY}
    let t = group * 256u + thread;
    if (t >= p.frames * p.rows) {{ return; }}
    let frame = frames[t / p.rows];
    let above = t % p.rows;
    if (above >= frame.rows) {{ return; }}
    let row = frame.bottom + above;
    var first = 0.0;
    var second = 0.0;
    for (var k = frame.first; k < frame.end; k++) {{
        let run = runs[k];
        var v = 0.0;
        if (row >= run.y && row - run.y < run.z) {{ v = x[run.x + row - run.y]; }}
        let y = v + first;
        first = p.a1 * y - p.b1 * v;
        let z = y + second;
        second = p.a2 * z - p.b2 * y;
        rectangle[frame.place + (k - frame.first) * frame.rows + above] = z;
    }}
    first = 0.0;
    second = 0.0;
    for (var k = frame.end; k > frame.first; k--) {{
        let run = runs[k - 1u];
        let v = rectangle[frame.place + (k - 1u - frame.first) * frame.rows + above];
        let y = v + first;
        first = p.a1 * y - p.b1 * v;
        let z = y + second;
        second = p.a2 * z - p.b2 * y;
        if (row >= run.y && row - run.y < run.z) {{ out[run.x + row - run.y] = z; }}
    }}
}}"
    )
}
