    // A thread is a slot
    let slot = group * 256u + thread;
    if (slot >= p.rows) { return; }
    begin(slot);
    for (var k = slots[p.first_slot + slot]; k < slots[p.first_slot + slot + 1u]; k++) {
        let entry = by_slot[k];
        let strip = strips[entry.x];
        if (strip.is_lit == 0u) { continue; }
        let along_y = entry.y == 1u;
        let along = select(p.nx, p.ny, along_y);
        let across = select(p.ny, p.nx, along_y);
        let first = u32(clamp(floor(strip.span.x), 0.0, f32(along)));
        let end = u32(clamp(ceil(strip.span.y), 0.0, f32(along)));
        for (var row = first; row < end; row++) {
            let resin = resin_rows[select(row, p.nx + row, along_y)];
            // Ends as a voxel sees them: from its own corner, which rounds as there
            let middle = 0.5 * (max(f32(row), strip.span.x) + min(f32(row) + 1.0, strip.span.y));
            let a = strip.edges.x + strip.edges.y * middle;
            let b = strip.edges.z + strip.edges.w * middle;
            let low = max(min(a, b), resin.x) - 1.0;
            let high = min(max(a, b), resin.y) + 1.0;
            let i0 = u32(clamp(floor(low), 0.0, f32(across)));
            let i1 = u32(clamp(ceil(high), 0.0, f32(across)));
            for (var i = i0; i < i1; i++) {
                let found = in_row(strip, f32(row), resin, f32(i));
                let cover = min(found.y, 1.0) - max(found.x, 0.0);
                if (cover > 0.0 && found.z != 0.0) {
                    let voxel = select(i * p.nx + row, row * p.nx + i, along_y);
                    emit(voxel, cover * found.z);
                }
            }
        }
    }
    finish(slot);
