//! A graphics card: what there is, which one is taken, buffers, kernels, and what comes back.
//!
//! **Order of work.** Kernels are recorded into a command list that is submitted when something is read back, when it has grown to
//! [`MOST_RECORDED`] kernels, or when a model says that what it recorded takes long ([`Gpu::submit`]). At most [`MOST_IN_FLIGHT`] lists wait
//! on the card, so that a run that is canceled stops within a few of them.
//!
//! **Errors.** The first error of the card (lost, out of memory, a refused command) is stored; from then on nothing is recorded, reads give zeros, and
//! [`Gpu::check`] says what happened. Models call it, so a run ends with that error and not with the zeros.
//!
//! **Limits.** A binding is never larger than the adapter allows ([`Gpu::binding_bytes`]); a field is cut into pieces that fit. Of everything else
//! a card is asked for what WebGPU guarantees and no more, so a kernel that needs 9 storage buffers, 512 threads a group, 32 kB of shared memory, or a type or operation
//! that WebGPU leaves optional, is refused on every card alike.

use std::any::Any;
use std::collections::HashMap;
use std::fmt;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};
use tomolith_core::error::{Error, Result};
use tomolith_core::parallel::InParallel;

/// Threads of a group.
pub(crate) const THREADS: u32 = 256;
/// Kernels of a command list.
const MOST_RECORDED: usize = 64;
/// Command lists on their way.
const MOST_IN_FLIGHT: usize = 2;
/// Bytes of a kernel's parameters, and how many such places there are: more than a command list has kernels.
const PARAMETERS: u64 = 256;
const PLACES: u64 = 512;
/// Bytes that are copied at once between the card and the host.
const COPIED: u64 = 64 << 20;
/// Bytes of a copy that is small: partial sums.
const SMALL_COPY: u64 = 1 << 20;
/// Copies on their way to the host.
const COPIES: usize = 3;
/// Part of a card's memory that models may store between calls.
const STORED_SHARE: f64 = 0.4;
/// Part of it that is in use at most when a model begins to store.
const MOST_STORED: f64 = 0.7;
/// What is stored where the card does not say how much it has, bytes.
const STORED: u64 = 2_100_000_000;
/// Bytes that free buffers may take while they wait for reuse.
const MOST_KEPT: u64 = 4 << 30;

/// What a graphics card is called, for people.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Adapter {
    /// The card's name.
    pub name: String,
    /// The interface it is used through: Vulkan, Metal or DX12.
    pub interface: String,
    /// The driver and its version.
    pub driver: String,
    /// Whether it is a program that computes on the processor.
    pub is_software: bool,
    /// Largest piece of memory that a kernel may see at once, bytes.
    pub binding_bytes: u64,
    /// Memory of the card, bytes; None where it does not say.
    pub memory_bytes: Option<u64>,
}

/// Every graphics card that this machine shows, real ones first.
#[must_use]
pub fn adapters() -> Vec<Adapter> {
    found().iter().map(|(_, adapter)| adapter.clone()).collect()
}

fn found() -> Vec<(wgpu::Adapter, Adapter)> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends: wgpu::Backends::PRIMARY,
        flags: wgpu::InstanceFlags::empty(),
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    });
    let all = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::PRIMARY));
    let described = |adapter: wgpu::Adapter| {
        let info = adapter.get_info();
        let described = Adapter {
            name: info.name,
            interface: format!("{:?}", info.backend),
            driver: format!("{} {}", info.driver, info.driver_info)
                .trim()
                .to_owned(),
            is_software: info.device_type == wgpu::DeviceType::Cpu,
            binding_bytes: largest_binding(&adapter.limits()),
            memory_bytes: memory_of(&adapter),
        };
        (adapter, described)
    };
    let mut all: Vec<_> = all.into_iter().map(described).collect();
    all.sort_by_key(|(adapter, described)| {
        let kind = adapter.get_info().device_type;
        (described.is_software, kind != wgpu::DeviceType::DiscreteGpu)
    });
    all
}

/// Bytes of a binding: whole pages, and nothing near what a 32-bit index reaches.
fn largest_binding(limits: &wgpu::Limits) -> u64 {
    let most = limits
        .max_storage_buffer_binding_size
        .min(limits.max_buffer_size)
        .min(1 << 31);
    // A binding of 2³¹ − 1 bytes holds no whole pages more
    most / 65536 * 65536
}

/// Which graphics card a user asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Asked<'a> {
    /// The best real card.
    Any,
    /// The first whose name contains this, in any case; the only way to a software adapter.
    Named(&'a str),
}

/// A graphics card at work; clones are the same card.
#[derive(Clone)]
pub struct Gpu(Arc<Inner>);

struct Inner {
    device: wgpu::Device,
    queue: wgpu::Queue,
    adapter: Adapter,
    /// By name, each with its source.
    kernels: Mutex<HashMap<String, (wgpu::ComputePipeline, String)>>,
    parameters: wgpu::Buffer,
    recorder: Mutex<Recorder>,
    idle: Mutex<Idle>,
    /// Memory that the host sees and nobody uses at present: small, large.
    staging: Mutex<[Vec<wgpu::Buffer>; 2]>,
    failure: Arc<Mutex<Option<String>>>,
    /// What models of this card share.
    shared: Mutex<Vec<Weak<dyn Any + Send + Sync>>>,
}

#[derive(Default)]
struct Recorder {
    encoder: Option<wgpu::CommandEncoder>,
    recorded: usize,
    place: u64,
    in_flight: Vec<wgpu::SubmissionIndex>,
}

/// Buffers that nobody uses at present, by size; and the bytes of those that somebody uses, now and at most.
#[derive(Default)]
struct Idle {
    buffers: HashMap<u64, Vec<wgpu::Buffer>>,
    bytes: u64,
    used: u64,
    most_used: u64,
}

/// A copy on its way to the host: where it arrives, its bytes, and the commands that make it.
type Fetch = (wgpu::Buffer, u64, Option<wgpu::SubmissionIndex>);

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl fmt::Debug for Gpu {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Gpu").field(&self.0.adapter).finish()
    }
}

impl Gpu {
    /// Takes a graphics card.
    ///
    /// # Errors
    /// [`Error::Device`] when the named card does not exist, or cannot be used.
    pub fn open(asked: &Asked<'_>) -> Result<Self> {
        Self::smaller(asked, u64::MAX, u64::MAX)
    }

    /// As [`open`](Self::open), with bindings of at most so many bytes and with so much memory: as if it were a smaller card.
    ///
    /// # Errors
    /// As [`open`](Self::open).
    pub fn smaller(asked: &Asked<'_>, binding_bytes: u64, memory_bytes: u64) -> Result<Self> {
        let all = found();
        let is_asked = |(_, described): &&(wgpu::Adapter, Adapter)| match asked {
            Asked::Any => !described.is_software,
            Asked::Named(name) => {
                let full_name = described.name.to_lowercase();
                full_name.contains(&name.to_lowercase())
            }
        };
        let Some((adapter, described)) = all.iter().find(is_asked) else {
            return Err(missing(asked, &all));
        };
        let available = adapter.limits();
        let limits = wgpu::Limits {
            max_storage_buffer_binding_size: available.max_storage_buffer_binding_size,
            max_buffer_size: available.max_buffer_size,
            ..wgpu::Limits::default()
        }
        .or_worse_values_from(&available);
        let device = adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("tomolith"),
            required_limits: limits,
            ..wgpu::DeviceDescriptor::default()
        });
        let failed = |found: String| Error::Device {
            name: described.name.clone(),
            found,
        };
        let (device, queue) = pollster::block_on(device).map_err(|e| failed(e.to_string()))?;
        let failure = Arc::new(Mutex::new(None));
        let keep = |failure: &Mutex<Option<String>>, text: String| {
            locked(failure).get_or_insert(text);
        };
        let (of_errors, of_loss) = (failure.clone(), failure.clone());
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            let text = match &error {
                wgpu::Error::OutOfMemory { .. } => "its memory is full; fewer voxels or angles take less, a smaller optimizer.lbfgs.memory too, and --device cpu takes none".to_owned(),
                other => other.to_string(),
            };
            keep(&of_errors, text);
        }));
        device.set_device_lost_callback(move |reason, text| {
            if reason != wgpu::DeviceLostReason::Destroyed {
                keep(&of_loss, format!("the card was lost: {text}"));
            }
        });
        let parameters = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("parameters"),
            size: PARAMETERS * PLACES,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        Ok(Gpu(Arc::new(Inner {
            adapter: Adapter {
                binding_bytes: described.binding_bytes.min(binding_bytes),
                memory_bytes: described.memory_bytes.map(|bytes| bytes.min(memory_bytes)),
                ..described.clone()
            },
            device,
            queue,
            kernels: Mutex::default(),
            parameters,
            recorder: Mutex::default(),
            idle: Mutex::default(),
            staging: Mutex::default(),
            failure,
            shared: Mutex::default(),
        })))
    }

    /// Which card it is.
    #[must_use]
    pub fn adapter(&self) -> &Adapter {
        &self.0.adapter
    }

    /// Largest binding, bytes.
    #[must_use]
    pub fn binding_bytes(&self) -> u64 {
        self.0.adapter.binding_bytes
    }

    /// Name and WGSL of every kernel that ran so far.
    #[must_use]
    pub fn sources(&self) -> Vec<(String, String)> {
        let kernels = locked(&self.0.kernels);
        let sources = kernels
            .iter()
            .map(|(name, (_, text))| (name.clone(), text.clone()));
        sources.collect()
    }

    /// Memory of the card, bytes; None where it does not say.
    #[must_use]
    pub fn memory_bytes(&self) -> Option<u64> {
        self.0.adapter.memory_bytes
    }

    /// Bytes that what a model stores between calls may take: less where others have taken much.
    pub(crate) fn stored_bytes(&self) -> u64 {
        let share = |share: f64, bytes: u64| (share * bytes as f64) as u64;
        let used = locked(&self.0.idle).used;
        self.memory_bytes().map_or(STORED, |bytes| {
            share(STORED_SHARE, bytes).min(share(MOST_STORED, bytes).saturating_sub(used))
        })
    }

    /// The card with so much of something in its memory, for people.
    pub(crate) fn with(&self, bytes: u64, what: &str) -> String {
        let gigabytes = |bytes: u64| bytes as f64 * 1e-9;
        let all = self.memory_bytes().map(gigabytes);
        let of_all = all.map_or_else(String::new, |all| format!(" of {all:.1} GB"));
        let (name, size) = (&self.0.adapter.name, gigabytes(bytes));
        format!("on {name}; {size:.2} GB{of_all} are {what}")
    }

    /// The most memory that was in use at a time since this was asked last, bytes.
    #[must_use]
    pub fn most_used(&self) -> u64 {
        let mut idle = locked(&self.0.idle);
        let most = idle.most_used;
        idle.most_used = idle.used;
        most
    }

    /// What a model in use has already, as `is_same` finds it; else it is made.
    pub(crate) fn shared<T: Any + Send + Sync>(
        &self,
        is_same: impl Fn(&T) -> bool,
        make: impl FnOnce() -> Result<T>,
    ) -> Result<Arc<T>> {
        let in_use = |all: &mut Vec<Weak<dyn Any + Send + Sync>>| {
            all.retain(|thing| thing.strong_count() > 0);
            let mut alive = all
                .iter()
                .filter_map(|thing| thing.upgrade()?.downcast().ok());
            alive.find(|thing: &Arc<T>| is_same(thing))
        };
        if let Some(found) = in_use(&mut locked(&self.0.shared)) {
            return Ok(found);
        }
        let made = Arc::new(make()?);
        let weak: Weak<T> = Arc::downgrade(&made);
        locked(&self.0.shared).push(weak);
        Ok(made)
    }

    /// Whether two are the same card.
    #[must_use]
    pub(crate) fn is(&self, other: &Gpu) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// The first error of the card, if there was one.
    ///
    /// # Errors
    /// [`Error::Device`]
    pub fn check(&self) -> Result<()> {
        match &*locked(&self.0.failure) {
            None => Ok(()),
            Some(found) => Err(Error::Device {
                name: self.0.adapter.name.clone(),
                found: found.clone(),
            }),
        }
    }

    /// Takes the card away, as a driver does that fails: whatever comes next ends with an error. For tests.
    pub fn destroy(&self) {
        self.0.device.destroy();
    }

    fn has_failed(&self) -> bool {
        locked(&self.0.failure).is_some()
    }

    fn fail(&self, text: &str) {
        locked(&self.0.failure).get_or_insert_with(|| text.to_owned());
    }

    /// A buffer of at least so many bytes, of any content.
    pub(crate) fn buffer(&self, bytes: u64) -> Buffer {
        let size = bytes.max(16).next_multiple_of(256);
        let mut idle = locked(&self.0.idle);
        let reused = idle.buffers.get_mut(&size).and_then(Vec::pop);
        let raw = reused.inspect(|_| idle.bytes -= size);
        idle.used += size;
        idle.most_used = idle.most_used.max(idle.used);
        drop(idle);
        let raw = raw.unwrap_or_else(|| {
            self.0.device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size,
                usage: wgpu::BufferUsages::STORAGE
                    | wgpu::BufferUsages::COPY_SRC
                    | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        });
        Buffer {
            gpu: self.clone(),
            raw: Some(raw),
            size,
        }
    }

    /// A buffer of so many zero bytes.
    pub(crate) fn zeros(&self, bytes: u64) -> Buffer {
        let buffer = self.buffer(bytes);
        self.clear(&buffer, bytes);
        buffer
    }

    pub(crate) fn upload<T: bytemuck::NoUninit>(&self, values: &[T]) -> Buffer {
        let bytes: &[u8] = bytemuck::cast_slice(values);
        let buffer = self.buffer(bytes.len() as u64);
        self.write(&buffer, 0, bytes);
        buffer
    }

    /// Overwrites a part of a buffer; offset and length are multiples of 4.
    pub(crate) fn write(&self, buffer: &Buffer, offset: u64, bytes: &[u8]) {
        if bytes.is_empty() || self.has_failed() {
            return;
        }
        // What was recorded before comes first
        self.submit();
        for (i, part) in bytes.chunks(COPIED as usize).enumerate() {
            let at = offset + i as u64 * COPIED;
            self.0.queue.write_buffer(buffer.raw(), at, part);
            if bytes.len() as u64 > COPIED {
                self.0.queue.submit([]);
            }
        }
    }

    /// Fills the first bytes of a buffer with zero bits.
    pub(crate) fn clear(&self, buffer: &Buffer, bytes: u64) {
        self.clear_part(buffer, 0, bytes);
    }

    /// Fills a part of a buffer, which begins at a multiple of 4, with zero bits.
    pub(crate) fn clear_part(&self, buffer: &Buffer, begin: u64, bytes: u64) {
        self.record(|encoder, _| {
            encoder.clear_buffer(buffer.raw(), begin, Some(bytes.next_multiple_of(4)));
        });
    }

    /// Copies the first bytes of a buffer.
    pub(crate) fn copy(&self, from: &Buffer, to: &Buffer, bytes: u64) {
        self.record(|encoder, _| {
            encoder.copy_buffer_to_buffer(from.raw(), 0, to.raw(), 0, bytes.next_multiple_of(4));
        });
    }

    /// Reads the first bytes of buffers (multiples of 4), one after the other; zeros after an error.
    pub(crate) fn read(&self, parts: &[(&Buffer, u64)]) -> Vec<u8> {
        let all: u64 = parts.iter().map(|part| part.1).sum();
        let mut found = vec![0; all as usize];
        self.read_into(parts, &mut found);
        found
    }

    /// Reads into memory that is there; after an error it keeps what it holds.
    pub(crate) fn read_into(&self, parts: &[(&Buffer, u64)], mut found: &mut [u8]) {
        // Parts that fit are copied at once; the host takes one such copy while the card makes the next
        let mut copies = Vec::new();
        let mut together: Vec<(&Buffer, u64, u64)> = Vec::new();
        let mut size = 0;
        for &(buffer, bytes) in parts {
            for begin in (0..bytes).step_by(COPIED as usize) {
                let len = COPIED.min(bytes - begin);
                if size + len > COPIED {
                    copies.push(self.begin_copy(&std::mem::take(&mut together), size));
                    size = 0;
                }
                if copies.len() == COPIES {
                    let (taken, rest) = found.split_at_mut(copies[0].1 as usize);
                    self.end_copy(copies.remove(0), taken);
                    found = rest;
                }
                together.push((buffer, begin, len));
                size += len;
            }
        }
        if size > 0 {
            copies.push(self.begin_copy(&together, size));
        }
        for copy in copies {
            let (taken, rest) = found.split_at_mut(copy.1 as usize);
            self.end_copy(copy, taken);
            found = rest;
        }
    }

    /// Begins to copy some parts, so many bytes, to memory that the host sees.
    fn begin_copy(&self, parts: &[(&Buffer, u64, u64)], size: u64) -> Fetch {
        let is_large = size > SMALL_COPY;
        let reused = locked(&self.0.staging)[usize::from(is_large)].pop();
        let staging = reused.unwrap_or_else(|| {
            self.0.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("staging"),
                size: if is_large { COPIED } else { SMALL_COPY },
                usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        });
        self.record(|encoder, _| {
            let mut at = 0;
            for &(buffer, begin, bytes) in parts {
                encoder.copy_buffer_to_buffer(buffer.raw(), begin, &staging, at, bytes);
                at += bytes;
            }
        });
        let index = self.submit();
        if index.is_some() && size > 0 {
            staging.map_async(wgpu::MapMode::Read, ..size, |_| {});
        }
        (staging, size, index)
    }

    /// Waits for a copy and takes it.
    fn end_copy(&self, (staging, size, index): Fetch, found: &mut [u8]) {
        if size == 0 || index.is_none() || self.has_failed() {
            return;
        }
        let wait = wgpu::PollType::Wait {
            submission_index: index,
            timeout: None,
        };
        if let Err(error) = self.0.device.poll(wait) {
            self.fail(&error.to_string());
        }
        if self.has_failed() {
            return;
        }
        match staging.get_mapped_range(..size) {
            Ok(view) => found
                .chunks_mut(1 << 20)
                .zip(view.chunks(1 << 20))
                .par_each(|(to, part)| to.copy_from_slice(part)),
            Err(error) => self.fail(&error.to_string()),
        }
        staging.unmap();
        locked(&self.0.staging)[usize::from(size > SMALL_COPY)].push(staging);
    }

    /// Records commands, unless the card has failed.
    fn record(&self, commands: impl FnOnce(&mut wgpu::CommandEncoder, u64)) {
        if self.has_failed() {
            return;
        }
        let mut recorder = locked(&self.0.recorder);
        let place = recorder.place;
        recorder.place = (place + 1) % PLACES;
        let encoder = recorder.encoder.get_or_insert_with(|| {
            let descriptor = wgpu::CommandEncoderDescriptor::default();
            self.0.device.create_command_encoder(&descriptor)
        });
        commands(encoder, place * PARAMETERS);
        recorder.recorded += 1;
        if recorder.recorded >= MOST_RECORDED {
            let _ = self.send(&mut recorder);
        }
    }

    /// Sends what is recorded to the card, and waits where too much is on its way; what was sent, if anything was.
    pub(crate) fn submit(&self) -> Option<wgpu::SubmissionIndex> {
        self.send(&mut locked(&self.0.recorder))
    }

    fn send(&self, recorder: &mut Recorder) -> Option<wgpu::SubmissionIndex> {
        let encoder = recorder.encoder.take()?;
        recorder.recorded = 0;
        let index = self.0.queue.submit([encoder.finish()]);
        recorder.in_flight.push(index.clone());
        if recorder.in_flight.len() > MOST_IN_FLIGHT {
            let oldest = recorder.in_flight.remove(0);
            let wait = wgpu::PollType::Wait {
                submission_index: Some(oldest),
                timeout: None,
            };
            if let Err(error) = self.0.device.poll(wait) {
                self.fail(&error.to_string());
            }
        }
        Some(index)
    }

    /// Runs a kernel in so many groups. Its group 0 has the parameters (32-bit words, at most 64) at binding 0 and the buffers from binding 1 on;
    /// `source` is its WGSL, the same for the same name.
    pub(crate) fn run_groups(
        &self,
        name: &str,
        source: &dyn Fn() -> String,
        parameters: &[u32],
        buffers: &[&Buffer],
        groups: u64,
    ) {
        if groups == 0 || self.has_failed() {
            return;
        }
        let kernel = self.kernel(name, source);
        self.record(|encoder, place| {
            let bytes: &[u8] = bytemuck::cast_slice(parameters);
            self.0.queue.write_buffer(&self.0.parameters, place, bytes);
            let uniform = wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                buffer: &self.0.parameters,
                offset: place,
                size: wgpu::BufferSize::new(PARAMETERS),
            });
            let first = std::iter::once(uniform);
            let others = buffers.iter().map(|b| b.raw().as_entire_binding());
            let entries: Vec<_> = (0..)
                .zip(first.chain(others))
                .map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource })
                .collect();
            let bindings = self.0.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some(name),
                layout: &kernel.get_bind_group_layout(0),
                entries: &entries,
            });
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
                label: Some(name),
                timestamp_writes: None,
            });
            pass.set_pipeline(&kernel);
            pass.set_bind_group(0, &bindings, &[]);
            // A dimension has at most 65,535 groups; kernels find their number from both
            let across = groups.min(32768) as u32;
            let down = groups.div_ceil(u64::from(across)) as u32;
            pass.dispatch_workgroups(across, down, 1);
        });
    }

    /// Runs a kernel with a thread for each of so many elements, in groups of [`THREADS`]; otherwise as [`run_groups`](Self::run_groups).
    pub(crate) fn run(
        &self,
        name: &str,
        source: &dyn Fn() -> String,
        parameters: &[u32],
        buffers: &[&Buffer],
        threads: usize,
    ) {
        let groups = (threads as u64).div_ceil(u64::from(THREADS));
        self.run_groups(name, source, parameters, buffers, groups);
    }

    fn kernel(&self, name: &str, source: &dyn Fn() -> String) -> wgpu::ComputePipeline {
        let mut kernels = locked(&self.0.kernels);
        if let Some((kernel, _)) = kernels.get(name) {
            return kernel.clone();
        }
        let text = source();
        let module = self.module(name, &text);
        let kernel = self
            .0
            .device
            .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some(name),
                layout: None,
                module: &module,
                entry_point: Some("main"),
                compilation_options: wgpu::PipelineCompilationOptions {
                    // Every kernel writes its shared memory before it reads it
                    zero_initialize_workgroup_memory: false,
                    ..wgpu::PipelineCompilationOptions::default()
                },
                cache: None,
            });
        kernels.insert(name.to_owned(), (kernel.clone(), text));
        kernel
    }

    #[expect(
        unsafe_code,
        reason = "bounds checks cost a fifth to two fifths of a kernel's time"
    )]
    fn module(&self, name: &str, text: &str) -> wgpu::ShaderModule {
        let descriptor = wgpu::ShaderModuleDescriptor {
            label: Some(name),
            source: wgpu::ShaderSource::Wgsl(text.into()),
        };
        if self.0.adapter.is_software || cfg!(debug_assertions) {
            return self.0.device.create_shader_module(descriptor);
        }
        // SAFETY: the kernels are this crate's own. Their indices come from lengths that the host checks, they read nothing that was not
        // written, and their loops end. The tests run all of them with the checks, on a software adapter.
        unsafe {
            self.0
                .device
                .create_shader_module_trusted(descriptor, wgpu::ShaderRuntimeChecks::unchecked())
        }
    }
}

/// The card's memory as Vulkan tells it; other interfaces do not.
#[cfg(not(target_vendor = "apple"))]
#[expect(unsafe_code, reason = "wgpu does not tell the memory of a card")]
fn memory_of(adapter: &wgpu::Adapter) -> Option<u64> {
    // SAFETY: the handle is only read, while the adapter lives.
    let properties = unsafe {
        let hal = adapter.as_hal::<wgpu::hal::api::Vulkan>()?;
        let instance = hal.shared_instance().raw_instance();
        instance.get_physical_device_memory_properties(hal.raw_physical_device())
    };
    let heaps = &properties.memory_heaps[..properties.memory_heap_count as usize];
    // Bit 0: on the card
    let local = heaps.iter().filter(|heap| heap.flags.as_raw() & 1 == 1);
    local.map(|heap| heap.size).max()
}

#[cfg(target_vendor = "apple")]
fn memory_of(_: &wgpu::Adapter) -> Option<u64> {
    None
}

/// The error for a card that does not exist, with the cards that do.
fn missing(asked: &Asked<'_>, all: &[(wgpu::Adapter, Adapter)]) -> Error {
    let names: Vec<String> = all
        .iter()
        .map(|(_, adapter)| match adapter.is_software {
            true => format!("{:?} (software, must be named)", adapter.name),
            false => format!("{:?}", adapter.name),
        })
        .collect();
    let there = if names.is_empty() {
        "this machine shows none (a driver with Vulkan, Metal or DX12 is needed)".to_owned()
    } else {
        format!("this machine shows {}", names.join(", "))
    };
    let name = match asked {
        Asked::Any => "gpu".to_owned(),
        Asked::Named(name) => format!("gpu:{name}"),
    };
    Error::Device {
        name,
        found: format!("no such graphics card; {there}"),
    }
}

/// Memory of the card. A dropped buffer waits for the next request of its size.
pub(crate) struct Buffer {
    gpu: Gpu,
    raw: Option<wgpu::Buffer>,
    size: u64,
}

impl Buffer {
    fn raw(&self) -> &wgpu::Buffer {
        self.raw
            .as_ref()
            .unwrap_or_else(|| unreachable!("taken when it is dropped"))
    }
}

impl Drop for Buffer {
    fn drop(&mut self) {
        let mut idle = locked(&self.gpu.0.idle);
        idle.used -= self.size;
        if idle.bytes + self.size <= MOST_KEPT
            && let Some(raw) = self.raw.take()
        {
            idle.bytes += self.size;
            idle.buffers.entry(self.size).or_default().push(raw);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_webgpu_does_not_guarantee_is_refused_on_every_card() {
        for (threads, is_taken) in [(256, true), (512, false)] {
            let named = |_| Gpu::open(&Asked::Named("llvmpipe"));
            let Ok(gpu) = Gpu::open(&Asked::Any).or_else(named) else {
                return;
            };
            let source = || {
                format!(
                    "@group(0) @binding(0) var<uniform> p: vec4<u32>;
                    @group(0) @binding(1) var<storage, read_write> out: array<u32>;
                    @compute @workgroup_size({threads}) fn main() {{ out[0] = p.x; }}"
                )
            };
            let out = gpu.buffer(4);
            gpu.run_groups("large", &source, &[7], &[&out], 1);
            let found = gpu.read(&[(&out, 4)]);
            assert_eq!(gpu.check().is_ok(), is_taken, "{:?}", gpu.check());
            assert_eq!(found[0] == 7, is_taken);
        }
    }
}
