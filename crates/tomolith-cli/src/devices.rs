//! `tomolith devices`: the graphics cards of this machine.

use crate::arguments::Manner;
use crate::screen::{done, say};
use serde_json::json;

/// Lists what `--device` can name.
#[cfg(feature = "gpu")]
pub(crate) fn devices(json: bool) {
    let all = tomolith::gpu::adapters();
    let list: Vec<_> = all.iter().map(line).collect();
    done(Manner::with_json(json), json!({ "devices": list }), || {
        say("cpu  this processor: the default");
        for adapter in &all {
            let memory = adapter.memory_bytes.map_or_else(
                || "memory not known".to_owned(),
                |bytes| format!("{:.1} GB", bytes as f64 * 1e-9),
            );
            let remark = if adapter.is_software {
                "; software: it must be named, and is slower than the processor"
            } else {
                ""
            };
            say(&format!(
                "gpu:{}  {}, {}, {memory}{remark}",
                adapter.name, adapter.interface, adapter.driver
            ));
        }
        if all.iter().all(|adapter| adapter.is_software) {
            say("no graphics card: a driver with Vulkan, Metal or DX12 is needed");
        }
    });
}

#[cfg(feature = "gpu")]
fn line(adapter: &tomolith::gpu::Adapter) -> serde_json::Value {
    json!({
        "name": adapter.name,
        "interface": adapter.interface,
        "driver": adapter.driver,
        "is_software": adapter.is_software,
        "memory_bytes": adapter.memory_bytes,
        "binding_bytes": adapter.binding_bytes,
    })
}

/// Says that there are none to list.
#[cfg(not(feature = "gpu"))]
pub(crate) fn devices(json: bool) {
    done(Manner::with_json(json), json!({ "devices": [] }), || {
        say(
            "cpu  this processor: the default\nthis program was built without graphics cards: add `--features gpu` to the `cargo install` that builds it (docs/cards.md)",
        );
    });
}
