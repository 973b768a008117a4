    // A group is a tile, a thread a voxel
    if (group >= p.tiles) { return; }
    let tile = tiles[group];
    let place = vec2(thread % 16u, thread / 16u);
    if (place.x >= tile.z || place.y >= tile.w) { return; }
    let voxel = tile.xy + place;
    let number = voxel.y * p.nx + voxel.x;
    begin(number);
    for (var b = p.first_beam; b < p.end_beam; b++) {
        let meeting = meetings[group * p.beams + b];
        let first = meeting & 0xffffu;
        let end = meeting >> 16u;
        if (first == end) { continue; }
        let beam = beams[b];
        let row = select(voxel.x, voxel.y, beam.z == 1u);
        let origin = f32(select(voxel.y, voxel.x, beam.z == 1u));
        let resin = resin_rows[select(row, p.nx + row, beam.z == 1u)];
        var is_met = false;
        for (var s = beam.x + first; s < beam.x + end; s++) {
            let strip = strips[s];
            if (strip.is_lit == 0u) { continue; }
            let found = in_row(strip, f32(row), resin, origin);
            let cover = min(found.y, 1.0) - max(found.x, 0.0);
            if (cover > 0.0 && found.z != 0.0) {
                emit(beam.y + strip.column - p.first_slot, cover * found.z);
                is_met = true;
            }
        }
        end_beam(is_met);
    }
    finish(number);
