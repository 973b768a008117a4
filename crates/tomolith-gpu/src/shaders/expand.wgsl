    // A thread is a lane of a slot
    let t = group * 256u + thread;
    let slot = t / p.lanes;
    let lane = t % p.lanes;
    if (slot >= p.slots || lane >= p.count) { return; }
    let sides = sources[p.first_slot + slot];
    var sum = 0.0;
    if (sides.x != 0xffffffffu) { sum += light(runs[sides.x], lane); }
    if (sides.y != 0xffffffffu) { sum += light(runs[sides.y], lane); }
    lanes[t] += p.factor * sum;
