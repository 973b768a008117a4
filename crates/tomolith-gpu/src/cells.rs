//! Fields on cells of scattered light: the sharpening stencil, sums of fields, the way to larger cells, to voxels, and back.
//!
//! Fields are `[y][x][z]` with padded rows, several one after the other in one array. Formulas: [`tomolith_core::dose::scattered`].

use crate::device::{Buffer, Gpu};
use crate::passes::ENTRY;
use std::ops::Range;
use tomolith_core::dose::scattered::CellGrid;

/// Cells of one size.
pub(crate) struct DeviceCells {
    gpu: Gpu,
    /// Along x, y, z, and elements of a row.
    shape: [u32; 4],
    is_full: Buffer,
    /// Along x, y, z one after the other: of each voxel the cell below its middle and the weight of the next one.
    places: Buffer,
    /// Along x, y, z one after the other: of each cell the first voxel that it is interpolated to, and the one behind the last.
    ranges: Buffer,
    /// Along x, y, z, and elements of a row.
    voxels: [u32; 4],
}

/// A field of an array, or the first of several.
pub(crate) type At<'a> = (&'a Buffer, usize);

/// Numbers that fields are weighted with, as a matrix.
pub(crate) struct Matrix<'a> {
    pub(crate) buffer: &'a Buffer,
    /// The first of its numbers.
    pub(crate) first: usize,
    pub(crate) rows: usize,
    pub(crate) columns: usize,
}

impl DeviceCells {
    /// Cells on a card; `row` is that of voxels.
    pub(crate) fn new(gpu: &Gpu, grid: &CellGrid, row: usize) -> Self {
        let [nz, ny, nx] = grid.layout.grid.shape;
        let is_full: Vec<u32> = grid.is_full.iter().map(|&full| u32::from(full)).collect();
        let places = grid.places.iter().flatten();
        let places: Vec<[u32; 2]> = places
            .map(|&(i, next)| [i as u32, next.to_bits()])
            .collect();
        let axes = grid.places.iter().zip([nx, ny, nz]);
        let ranges =
            axes.flat_map(|(places, cells)| (0..cells).map(|cell| voxels_of(places, cell)));
        let ranges: Vec<[u32; 2]> = ranges.collect();
        let [vx, vy, vz] = grid.places.each_ref().map(|places| places.len() as u32);
        DeviceCells {
            gpu: gpu.clone(),
            shape: [nx, ny, nz, grid.layout.row].map(|n| n as u32),
            is_full: gpu.upload(&is_full),
            places: gpu.upload(&places),
            ranges: gpu.upload(&ranges),
            voxels: [vx, vy, vz, row as u32],
        }
    }

    pub(crate) fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    fn cells(&self) -> usize {
        self.shape[..3].iter().map(|&n| n as usize).product()
    }

    /// Elements of a field.
    fn len(&self) -> usize {
        let [nx, ny, _, row] = self.shape.map(|n| n as usize);
        nx * ny * row
    }

    /// So many fields, of any content.
    pub(crate) fn fields(&self, count: usize) -> Buffer {
        self.gpu.buffer((4 * count * self.len()) as u64)
    }

    /// So many dark fields.
    pub(crate) fn dark(&self, count: usize) -> Buffer {
        self.gpu.zeros((4 * count * self.len()) as u64)
    }

    /// Runs a kernel with a thread for each cell of so many fields.
    fn run(
        &self,
        name: &str,
        body: &dyn Fn() -> String,
        numbers: &[u32],
        buffers: &[&Buffer],
        count: usize,
    ) {
        let parameters = [&self.shape[..], numbers].concat();
        self.gpu
            .run(name, body, &parameters, buffers, count * self.cells());
    }

    /// So many sharper fields.
    pub(crate) fn sharpen(&self, strength: [f32; 3], count: usize, from: At<'_>, to: At<'_>) {
        let [x, y, z] = strength.map(f32::to_bits);
        let numbers = [count as u32, from.1 as u32, to.1 as u32, x, y, z];
        let buffers = [to.0, from.0, &self.is_full];
        self.run("sharpen", &sharpen, &numbers, &buffers, count);
    }

    pub(crate) fn sharper(&self, strength: [f32; 3], field: &Buffer) -> Buffer {
        let out = self.fields(1);
        self.sharpen(strength, 1, (field, 0), (&out, 0));
        out
    }

    /// So many fields, each times its number and that of the (y, x) of a cell.
    pub(crate) fn scale(&self, count: usize, fields: &Buffer, of_field: &Buffer, of_line: &Buffer) {
        let numbers = [count as u32];
        let buffers = [fields, of_field, of_line];
        self.run("scale cells", &scale, &numbers, &buffers, count);
    }

    /// out = (out +) matrix·fields
    pub(crate) fn mix(&self, matrix: &Matrix<'_>, fields: &Buffer, out: &Buffer, adds: bool) {
        let numbers = [matrix.rows, matrix.columns, matrix.first, usize::from(adds)];
        let buffers = [out, fields, matrix.buffer];
        let numbers = numbers.map(|n| n as u32);
        self.run("mix", &mix, &numbers, &buffers, matrix.rows);
    }

    /// A field = means over smaller cells, `factor` along an edge.
    pub(crate) fn restrict(&self, near: (&DeviceCells, &Buffer), factor: usize, to: At<'_>) {
        let [near_nx, _, _, near_row] = near.0.shape;
        let numbers = [near_nx, near_row, factor as u32, to.1 as u32];
        self.run("restrict", &restrict, &numbers, &[to.0, near.1], 1);
    }

    /// Transpose of [`restrict`](Self::restrict), added to a field of smaller cells.
    pub(crate) fn prolong(&self, from: At<'_>, factor: usize, near: (&DeviceCells, &Buffer)) {
        let [nx, ny, _, row] = self.shape;
        let numbers = [nx, ny, row, factor as u32, from.1 as u32];
        near.0
            .run("prolong", &prolong, &numbers, &[near.1, from.0], 1);
    }

    fn of_voxels(&self) -> Vec<u32> {
        [self.shape, self.voxels].concat()
    }

    /// Voxels of a piece of a dose += interpolated cells, times the share of each (y, x) of voxels.
    pub(crate) fn spread(
        &self,
        field: &Buffer,
        shares: &Buffer,
        (columns, piece): &(Range<usize>, &Buffer),
    ) {
        let numbers = [columns.start, columns.len()].map(|n| n as u32);
        let parameters = [self.of_voxels(), numbers.to_vec()].concat();
        let threads = columns.len() * self.voxels[2] as usize;
        let buffers = [piece, field, &self.places, shares];
        self.gpu
            .run("spread", &spread, &parameters, &buffers, threads);
        self.gpu.submit();
    }

    /// Transpose of [`spread`](Self::spread), added to a field: along z, then along x and y.
    pub(crate) fn gather(
        &self,
        field: &Buffer,
        shares: &Buffer,
        (columns, piece): &(Range<usize>, &Buffer),
    ) {
        let nz = self.shape[2] as usize;
        let most = (self.gpu.binding_bytes() as usize / (4 * nz)).max(1);
        for begin in columns.clone().step_by(most) {
            let part = begin..(begin + most).min(columns.end);
            let lines = self.gpu.buffer((4 * nz * part.len()) as u64);
            let numbers = [part.start, part.len(), part.start - columns.start].map(|n| n as u32);
            let parameters = [self.of_voxels(), numbers.to_vec()].concat();
            let buffers = [&lines, piece, &self.places, &self.ranges];
            let threads = nz * part.len();
            self.gpu
                .run("gather along z", &gather_z, &parameters, &buffers, threads);
            let buffers = [field, &lines, &self.places, &self.ranges, shares];
            let threads = self.cells();
            self.gpu
                .run("gather across", &gather_xy, &parameters, &buffers, threads);
            self.gpu.submit();
        }
    }
}

/// The voxels whose two cells have this one among them.
fn voxels_of(places: &[(usize, f32)], cell: usize) -> [u32; 2] {
    let first = places.partition_point(|&(below, _)| below + 1 < cell);
    let end = places.partition_point(|&(below, _)| below <= cell);
    [first as u32, end as u32]
}

/// The place of a thread's cell: its field, its (y, x) line, its element in a field.
fn head(parameters: &str, buffers: &[&str]) -> String {
    let mut text = format!(
        "struct Parameters {{ nx: u32, ny: u32, nz: u32, row: u32, {parameters} }}
@group(0) @binding(0) var<uniform> p: Parameters;\n"
    );
    for (binding, buffer) in (1..).zip(buffers) {
        let access = if binding == 1 { "read_write" } else { "read" };
        text += &format!("@group(0) @binding({binding}) var<storage, {access}> {buffer};\n");
    }
    text
}

/// What each thread begins with.
const CELL: &str = "
    let t = group * 256u + thread;
    let z = t % p.nz;
    let line = t / p.nz % (p.nx * p.ny);
    let number = t / (p.nz * p.nx * p.ny);
    let cell = line * p.row + z;
    let size = p.nx * p.ny * p.row;
";

fn sharpen() -> String {
    let head = head(
        "count: u32, first: u32, to: u32, x: f32, y: f32, z: f32",
        &["out: array<f32>", "fields: array<f32>", "full: array<u32>"],
    );
    format!(
        "{head}
fn given(own: f32, field: u32, cell: u32, strength: f32) -> f32 {{
    if (full[cell] == 0u) {{ return 0.0; }}
    return strength * (own - fields[field + cell]);
}}
{ENTRY}{CELL}
    if (number >= p.count) {{ return; }}
    let field = (p.first + number) * size;
    let own = fields[field + cell];
    var sum = own;
    if (full[cell] == 1u) {{
        let x = line % p.nx;
        let y = line / p.nx;
        if (x > 0u) {{ sum += given(own, field, cell - p.row, p.x); }}
        if (x + 1u < p.nx) {{ sum += given(own, field, cell + p.row, p.x); }}
        if (y > 0u) {{ sum += given(own, field, cell - p.nx * p.row, p.y); }}
        if (y + 1u < p.ny) {{ sum += given(own, field, cell + p.nx * p.row, p.y); }}
        if (z > 0u) {{ sum += given(own, field, cell - 1u, p.z); }}
        if (z + 1u < p.nz) {{ sum += given(own, field, cell + 1u, p.z); }}
    }}
    out[(p.to + number) * size + cell] = sum;
}}"
    )
}

fn scale() -> String {
    let head = head(
        "count: u32",
        &[
            "fields: array<f32>",
            "of_field: array<f32>",
            "of_line: array<f32>",
        ],
    );
    format!(
        "{head}{ENTRY}{CELL}
    if (number >= p.count) {{ return; }}
    fields[number * size + cell] *= of_field[number] * of_line[line];
}}"
    )
}

fn mix() -> String {
    let head = head(
        "rows: u32, columns: u32, first: u32, adds: u32",
        &[
            "out: array<f32>",
            "fields: array<f32>",
            "matrix: array<f32>",
        ],
    );
    format!(
        "{head}{ENTRY}{CELL}
    if (number >= p.rows) {{ return; }}
    var sum = 0.0;
    if (p.adds == 1u) {{ sum = out[number * size + cell]; }}
    for (var k = 0u; k < p.columns; k++) {{
        let weight = matrix[p.first + number * p.columns + k];
        if (weight != 0.0) {{ sum += weight * fields[k * size + cell]; }}
    }}
    out[number * size + cell] = sum;
}}"
    )
}

fn restrict() -> String {
    let head = head(
        "near_nx: u32, near_row: u32, factor: u32, to: u32",
        &["out: array<f32>", "near: array<f32>"],
    );
    format!(
        "{head}{ENTRY}{CELL}
    if (number > 0u) {{ return; }}
    var sum = 0.0;
    for (var y = 0u; y < p.factor; y++) {{
        for (var x = 0u; x < p.factor; x++) {{
            let from_line = (p.factor * (line / p.nx) + y) * p.near_nx + p.factor * (line % p.nx) + x;
            for (var k = 0u; k < p.factor; k++) {{ sum += near[from_line * p.near_row + p.factor * z + k]; }}
        }}
    }}
    out[p.to * size + cell] = sum / f32(p.factor * p.factor * p.factor);
}}"
    )
}

fn prolong() -> String {
    let head = head(
        "far_nx: u32, far_ny: u32, far_row: u32, factor: u32, first: u32",
        &["near: array<f32>", "far: array<f32>"],
    );
    format!(
        "{head}{ENTRY}{CELL}
    if (number > 0u) {{ return; }}
    let far_line = line / p.nx / p.factor * p.far_nx + line % p.nx / p.factor;
    let field = p.first * p.far_nx * p.far_ny * p.far_row;
    near[cell] += far[field + far_line * p.far_row + z / p.factor] / f32(p.factor * p.factor * p.factor);
}}"
    )
}

/// Parameters of the ways between cells and voxels.
const VOXELS: &str = "vx: u32, vy: u32, vz: u32, voxel_row: u32, first: u32, count: u32";

fn spread() -> String {
    let buffers = [
        "voxels: array<f32>",
        "cells: array<f32>",
        "places: array<vec2<u32>>",
        "shares: array<f32>",
    ];
    let head = head(VOXELS, &buffers);
    format!(
        "{head}
fn along_z(line: u32, below: u32, next: f32) -> f32 {{
    return (1.0 - next) * cells[line * p.row + below] + next * cells[line * p.row + below + 1u];
}}
{ENTRY}
    let t = group * 256u + thread;
    let number = t / p.vz;
    if (number >= p.count) {{ return; }}
    let column = p.first + number;
    let x = places[column % p.vx];
    let y = places[p.vx + column / p.vx];
    let z = places[p.vx + p.vy + t % p.vz];
    let next = vec3(bitcast<f32>(x.y), bitcast<f32>(y.y), bitcast<f32>(z.y));
    let line = y.x * p.nx + x.x;
    let low = (1.0 - next.x) * along_z(line, z.x, next.z) + next.x * along_z(line + 1u, z.x, next.z);
    let high = (1.0 - next.x) * along_z(line + p.nx, z.x, next.z) + next.x * along_z(line + p.nx + 1u, z.x, next.z);
    voxels[number * p.voxel_row + t % p.vz] += shares[column] * ((1.0 - next.y) * low + next.y * high);
}}"
    )
}

/// The weight of a cell in a voxel's place.
const WEIGHT: &str = "
fn weight(place: vec2<u32>, cell: u32) -> f32 {
    return select(bitcast<f32>(place.y), 1.0 - bitcast<f32>(place.y), place.x == cell);
}
";

fn gather_z() -> String {
    let buffers = [
        "lines: array<f32>",
        "voxels: array<f32>",
        "places: array<vec2<u32>>",
        "ranges: array<vec2<u32>>",
    ];
    let head = head(&format!("{VOXELS}, skipped: u32"), &buffers);
    format!(
        "{head}{WEIGHT}{ENTRY}
    let t = group * 256u + thread;
    let number = t / p.nz;
    let cell = t % p.nz;
    if (number >= p.count) {{ return; }}
    let range = ranges[p.nx + p.ny + cell];
    var sum = 0.0;
    for (var z = range.x; z < range.y; z++) {{
        sum += weight(places[p.vx + p.vy + z], cell) * voxels[(p.skipped + number) * p.voxel_row + z];
    }}
    lines[t] = sum;
}}"
    )
}

fn gather_xy() -> String {
    let buffers = [
        "cells: array<f32>",
        "lines: array<f32>",
        "places: array<vec2<u32>>",
        "ranges: array<vec2<u32>>",
        "shares: array<f32>",
    ];
    let head = head(&format!("{VOXELS}, skipped: u32"), &buffers);
    format!(
        "{head}{WEIGHT}{ENTRY}{CELL}
    if (number > 0u) {{ return; }}
    let of_x = ranges[line % p.nx];
    let of_y = ranges[p.nx + line / p.nx];
    // Rows of voxels of which some columns are here
    let begin = max(of_y.x, p.first / p.vx);
    let end = min(of_y.y, (p.first + p.count + p.vx - 1u) / p.vx);
    var sum = cells[cell];
    for (var y = begin; y < end; y++) {{
        var of_row = 0.0;
        for (var x = of_x.x; x < of_x.y; x++) {{
            let column = y * p.vx + x;
            if (column < p.first || column >= p.first + p.count) {{ continue; }}
            of_row += weight(places[x], line % p.nx) * shares[column] * lines[(column - p.first) * p.nz + z];
        }}
        sum += weight(places[p.vx + y], line / p.nx) * of_row;
    }}
    cells[cell] = sum;
}}"
    )
}
