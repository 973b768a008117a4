//! Memory of large arrays in pages of 2 MB, where Linux gives them to who asks.
//!
//! The kernels read lanes that lie far apart, and the processor looks up the page of each. With pages of 4 kB its table of pages is too small for that: the
//! published boat takes 3 to 6 % longer (docs/speed.md). Linux joins pages by itself where `/sys/kernel/mm/transparent_hugepage/enabled` is `always`, and never where it is `never`; where it is
//! `madvise`, as on Ubuntu, it waits to be asked. An array of which a program touches a part only may then take up to 2 MB more.
#![expect(
    unsafe_code,
    reason = "an allocator is unsafe to write; this one hands everything to the system's"
)]

use rustix::mm::{Advice, madvise};
use std::alloc::{GlobalAlloc, Layout, System};

/// Bytes from which on an array is large: below, what is at its ends counts more.
const LARGE: usize = 4 << 20;
/// A multiple of the bytes of a small page on every machine.
const PAGE: usize = 1 << 16;

#[global_allocator]
static ALLOCATOR: LargePages = LargePages;

/// The system's allocator, which asks for large pages.
struct LargePages;

// SAFETY: all memory comes from the system's allocator and goes back to it, with the layouts that the caller names.
unsafe impl GlobalAlloc for LargePages {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promise.
        asked(unsafe { System.alloc(layout) }, layout.size())
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promise.
        asked(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    unsafe fn realloc(&self, memory: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: the caller's promise.
        asked(unsafe { System.realloc(memory, layout, size) }, size)
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        // SAFETY: the caller's promise.
        unsafe { System.dealloc(memory, layout) }
    }
}

/// The same memory; where it is large, its whole pages may become large ones.
fn asked(memory: *mut u8, size: usize) -> *mut u8 {
    if size >= LARGE && !memory.is_null() {
        let before = memory.align_offset(PAGE);
        let whole = (size - before) / PAGE * PAGE;
        // SAFETY: the range lies within memory that was just allocated; the advice changes no content. Where the system cannot follow it, small pages serve.
        let _ = unsafe { madvise(memory.add(before).cast(), whole, Advice::LinuxHugepage) };
    }
    memory
}
