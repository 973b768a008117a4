    // A thread is a row of a column of pixels
    let t = group * 256u + thread;
    let number = t / p.rows;
    let row = t % p.rows;
    if (number >= p.runs) { return; }
    let run = runs[p.first_run + number];
    if (run.x < p.begin || run.x >= p.end || row < run.y || row - run.y >= run.z) { return; }
    let slot = slot_of[p.first_run + number] - p.first_slot;
    var sum = 0.0;
    for (var tap = 0u; tap < p.taps; tap++) {
        let lane = first[row] + tap;
        if (lane < p.lanes) { sum += weights[tap * p.rows + row] * lanes[slot * p.stride + lane]; }
    }
    let element = run.x + row - run.y;
    let is_lit = p.has_dark == 0u || ((lit[element / 32u] >> (element % 32u)) & 1u) == 1u;
    gradient[element - p.begin] = select(0.0, p.factor * sum, is_lit);
