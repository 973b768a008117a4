//! Kernels of waves in WGSL: what transforms read and write, light at samples, and what is sent back.

use crate::mask::IS_LIT;
use crate::passes::ENTRY;
use crate::transforms::Lines;

pub(super) const PIXELS_ALONG_Z: Lines = Lines {
    name: "pixels along z",
    functions: pixels_along_z,
    are_neighbors: false,
};
pub(super) const PIXELS_ALONG_U: Lines = Lines {
    name: "pixels along u",
    functions: pixels_along_u,
    are_neighbors: true,
};
pub(super) const BACK_ALONG_U: Lines = Lines {
    name: "spectra back along u",
    functions: back_along_u,
    are_neighbors: true,
};
pub(super) const BACK_TO_PIXELS: Lines = Lines {
    name: "spectra back to pixels",
    functions: back_to_pixels,
    are_neighbors: false,
};
pub(super) const FIELD_ALONG_Z: Lines = Lines {
    name: "field along z",
    functions: field_along_z,
    are_neighbors: false,
};
pub(super) const FIELD_ALONG_U: Lines = Lines {
    name: "field along u",
    functions: field_along_u,
    are_neighbors: true,
};
pub(super) const FIELD_BACK_ALONG_U: Lines = Lines {
    name: "field back along u",
    functions: field_back_along_u,
    are_neighbors: true,
};
pub(super) const FIELD_BACK_ALONG_Z: Lines = Lines {
    name: "field back along z",
    functions: field_back_along_z,
    are_neighbors: false,
};

const COMPLEX: &str = "vec2<f32>";

/// Name and element of a buffer.
type Named = (&'static str, &'static str);

/// Parameters, and buffers from binding `first` on: those that are written, those that are read.
fn declared(parameters: &str, first: usize, buffers: [&[Named]; 2]) -> String {
    let mut text = format!(
        "struct Parameters {{ {parameters} }}\n@group(0) @binding(0) var<uniform> p: Parameters;\n"
    );
    let access = ["read_write", "read"].into_iter().zip(buffers);
    let all = access.flat_map(|(access, names)| names.iter().map(move |named| (access, named)));
    for (binding, (access, (name, element))) in (first..).zip(all) {
        text += &format!(
            "@group(0) @binding({binding}) var<storage, {access}> {name}: array<{element}>;\n"
        );
    }
    text
}

/// A kernel of lines: what number i of a line is, and what is done with number i of its transform.
fn lines(written: Named, read: &[Named], load: &str, store: &str) -> String {
    let parameters = "lines: u32, first: u32, n: u32, band: u32, comb_first: u32, comb_stride: u32, comb_count: u32, \
        nu: u32, nz: u32, columns: u32, width: u32, heights: u32, begin: u32, first_run: u32, place: u32, has_dark: u32, factor: f32";
    let declared = declared(parameters, 2, [&[written], read]);
    format!(
        "{declared}
fn times(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {{ return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }}
fn times_conjugate(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {{ return vec2(a.x * b.x + a.y * b.y, a.y * b.x - a.x * b.y); }}
fn load(line: u32, i: u32) -> vec2<f32> {{
    var sum = vec2(0.0);
{load}
    return sum;
}}
fn store(line: u32, i: u32, value: vec2<f32>) {{
{store}
}}"
    )
}

/// Does something with each frequency k, counted from the lowest of the band, that a transform holds at i.
fn in_band(body: &str) -> String {
    format!(
        "    if (i <= p.band) {{ let k = p.band + i; {body} }}
    if (i + p.band >= p.n) {{ let k = i + p.band - p.n; {body} }}"
    )
}

/// Does something with each sample k of the comb that lies at i.
fn in_comb(body: &str) -> String {
    format!(
        "    for (var d = (i + p.n - p.comb_first) % p.n; d < p.comb_count * p.comb_stride; d += p.n) {{
        if (d % p.comb_stride == 0u) {{ let k = d / p.comb_stride; {body} }}
    }}"
    )
}

/// An active pixel of row i, as `element`.
fn of_pixel(body: &str) -> String {
    format!(
        "    let run = runs[p.first_run + line];
    if (i >= run.y && i - run.y < run.z) {{
        let element = run.x + i - run.y;
        if (is_lit(element)) {{ {body} }}
    }}"
    )
}

fn pixels_along_z() -> String {
    lines(
        ("out", COMPLEX),
        &[
            ("x", "f32"),
            ("runs", "vec4<u32>"),
            ("shifts", COMPLEX),
            ("lit", "u32"),
        ],
        &of_pixel("sum.x = p.factor * x[element - p.begin];"),
        &in_band("out[line * p.nz + k] = times(value, shifts[k]);"),
    ) + IS_LIT
}

fn pixels_along_u() -> String {
    lines(
        ("spectra", COMPLEX),
        &[("columns", COMPLEX)],
        "    if (i < p.columns) { sum = columns[(line / p.nz * p.columns + i) * p.nz + line % p.nz]; }",
        &in_band("spectra[(line / p.nz * p.nu + k) * p.nz + line % p.nz] = value;"),
    )
}

fn back_along_u() -> String {
    lines(
        ("columns", COMPLEX),
        &[("spectra", COMPLEX)],
        &in_band("sum += spectra[(line / p.nz * p.nu + k) * p.nz + line % p.nz];"),
        "    if (i < p.columns) { columns[(line / p.nz * p.columns + i) * p.nz + line % p.nz] = value; }",
    )
}

fn back_to_pixels() -> String {
    let store = of_pixel("asked = p.factor * value.x;");
    lines(
        ("x", "f32"),
        &[
            ("columns", COMPLEX),
            ("runs", "vec4<u32>"),
            ("shifts", COMPLEX),
            ("lit", "u32"),
        ],
        &in_band("sum += times_conjugate(columns[line * p.nz + k], shifts[k]);"),
        &format!(
            "    var asked = 0.0;
{store}
    if (i >= run.y && i - run.y < run.z) {{ x[run.x + i - run.y - p.begin] = asked; }}"
        ),
    ) + IS_LIT
}

fn field_along_z() -> String {
    lines(
        ("mixed", COMPLEX),
        &[("spectra", COMPLEX), ("power", COMPLEX)],
        &in_band("sum += times(spectra[line * p.nz + k], power[line % p.nu * p.nz + k]);"),
        &in_comb("mixed[line * p.heights + k] = value;"),
    )
}

fn field_along_u() -> String {
    lines(
        ("field", COMPLEX),
        &[("mixed", COMPLEX)],
        &in_band("sum += mixed[(line / p.heights * p.nu + k) * p.heights + line % p.heights];"),
        &in_comb(
            "field[p.place + (line / p.heights * p.width + k) * p.heights + line % p.heights] = value;",
        ),
    )
}

fn field_back_along_u() -> String {
    lines(
        ("mixed", COMPLEX),
        &[("field", COMPLEX)],
        &in_comb("sum += field[(line / p.heights * p.width + k) * p.heights + line % p.heights];"),
        &in_band("mixed[(line / p.heights * p.nu + k) * p.heights + line % p.heights] = value;"),
    )
}

fn field_back_along_z() -> String {
    lines(
        ("spectra", COMPLEX),
        &[("mixed", COMPLEX), ("power", COMPLEX)],
        &in_comb("sum += mixed[line * p.heights + k];"),
        &in_band(
            "spectra[line * p.nz + k] += times_conjugate(value, power[line % p.nu * p.nz + k]);",
        ),
    )
}

pub(super) fn transfer() -> String {
    let head = declared(
        "all: u32, nz: u32, depth: u32",
        1,
        [
            &[("power", COMPLEX)],
            &[
                ("start", COMPLEX),
                ("step", COMPLEX),
                ("passing", "vec2<u32>"),
            ],
        ],
    );
    format!(
        "{head}{ENTRY}
    let t = group * 256u + thread;
    if (t >= p.all) {{ return; }}
    let passes = passing[p.depth * p.nz + t % p.nz];
    var value = start[t];
    if (p.depth > 0u) {{
        let a = power[t];
        let b = step[t];
        value = vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
    }}
    if (t / p.nz < passes.x || t / p.nz >= passes.y) {{ value = vec2(0.0); }}
    power[t] = value;
}}"
    )
}

/// A kernel of the samples of a depth: `body` for sample `at` and number `t` of a field.
fn samples(written: &[Named], read: &[Named], functions: &str, body: &str) -> String {
    let parameters = "count: u32, first_entry: u32, end_entry: u32, of_field: u32, heights: u32, row: u32, width: u32, depths: u32, \
            depth: u32, place: u32, weight: f32";
    let head = declared(parameters, 1, [written, read]);
    format!(
        "{head}{functions}{ENTRY}
    let t = group * 256u + thread;
    if (t >= p.count) {{ return; }}
    let j = t % p.of_field / p.heights;
    let at = ((t / p.of_field * p.depths + p.depth) * p.width + j) * p.row + t % p.heights;
    {body}
}}"
    )
}

/// The sum at t of the fields in a ring.
fn sum_in(ring: &str) -> String {
    format!(
        "
fn sum_in_{ring}(t: u32) -> vec2<f32> {{
    var sum = vec2(0.0);
    for (var e = p.first_entry; e < p.end_entry; e++) {{
        let entry = entries[e];
        sum += bitcast<vec2<f32>>(entry.yz) * {ring}[entry.x * p.count + t];
    }}
    return sum;
}}
"
    )
}

const ENTRIES: Named = ("entries", "vec4<u32>");
const SAMPLES: Named = ("samples", "f32");

pub(super) fn waves() -> String {
    samples(
        &[SAMPLES],
        &[ENTRIES, ("psi", COMPLEX)],
        &sum_in("psi"),
        "let psi_here = sum_in_psi(t);
    samples[at] += p.weight * dot(psi_here, psi_here);",
    )
}

pub(super) fn light() -> String {
    samples(
        &[SAMPLES],
        &[ENTRIES, ("psi", COMPLEX)],
        &sum_in("psi"),
        "samples[at] += p.weight * sum_in_psi(t).x;",
    )
}

pub(super) fn two_waves() -> String {
    samples(
        &[SAMPLES, ("squares", "f32")],
        &[ENTRIES, ("psi", COMPLEX), ("chi", COMPLEX)],
        &(sum_in("psi") + &sum_in("chi")),
        "let chi_here = sum_in_chi(t);
    samples[at] += 2.0 * p.weight * dot(sum_in_psi(t), chi_here);
    squares[at] += p.weight * dot(chi_here, chi_here);",
    )
}

pub(super) fn sent_of_waves() -> String {
    samples(
        &[("sent", COMPLEX)],
        &[SAMPLES, ENTRIES, ("psi", COMPLEX)],
        &sum_in("psi"),
        "sent[p.place + t] = 2.0 * p.weight * samples[at] * sum_in_psi(t);",
    )
}

pub(super) fn sent_of_light() -> String {
    samples(
        &[("sent", COMPLEX)],
        &[SAMPLES],
        "",
        "sent[p.place + t] = vec2(p.weight * samples[at], 0.0);",
    )
}

pub(super) fn sum_of_fields() -> String {
    let head = declared(
        "count: u32, first_entry: u32, end_entry: u32",
        1,
        [&[("field", COMPLEX)], &[ENTRIES, ("sent", COMPLEX)]],
    );
    let sum = sum_in("sent");
    format!(
        "{head}{sum}{ENTRY}
    let t = group * 256u + thread;
    if (t >= p.count) {{ return; }}
    field[t] = sum_in_sent(t);
}}"
    )
}

pub(super) fn rows() -> String {
    let head = declared(
        "outer: u32, inner: u32, inputs: u32, outputs: u32",
        1,
        [
            &[("out", "vec4<f32>")],
            &[
                ("source", "vec4<f32>"),
                ("starts", "u32"),
                ("entries", "vec2<u32>"),
            ],
        ],
    );
    format!(
        "{head}{ENTRY}
    let t = group * 256u + thread;
    let outer = t / p.inner / p.outputs;
    if (outer >= p.outer) {{ return; }}
    let i = t / p.inner % p.outputs;
    var sum = vec4(0.0);
    for (var e = starts[i]; e < starts[i + 1u]; e++) {{
        let entry = entries[e];
        sum += bitcast<f32>(entry.y) * source[(outer * p.inputs + entry.x) * p.inner + t % p.inner];
    }}
    out[t] = sum;
}}"
    )
}
