//! Whether kernels can be run by other interfaces than the one of the tests.

/// Asserts that kernels are what WebGPU guarantees, and can be had in the languages of Metal and DX12.
pub(crate) fn assert_portable<'a>(sources: impl IntoIterator<Item = (&'a String, &'a String)>) {
    for (name, text) in sources {
        let module = naga::front::wgsl::parse_str(text);
        let module = module.unwrap_or_else(|e| panic!("{name}: {}", e.emit_to_string(text)));
        let flags = naga::valid::ValidationFlags::all();
        let capabilities = naga::valid::Capabilities::empty();
        let info = naga::valid::Validator::new(flags, capabilities).validate(&module);
        let info = info.unwrap_or_else(|e| panic!("{name}: {e:?}"));
        let storage = module
            .global_variables
            .iter()
            .filter(|(_, variable)| matches!(variable.space, naga::AddressSpace::Storage { .. }));
        assert!(
            storage.count() <= 8,
            "{name} has more than eight storage buffers"
        );
        let (options, pipeline) = Default::default();
        let metal = naga::back::msl::write_string(&module, &info, &options, &pipeline);
        metal.unwrap_or_else(|e| panic!("{name}: {e}"));
        let (mut text, options, pipeline) = (String::new(), Default::default(), Default::default());
        let mut writer = naga::back::hlsl::Writer::new(&mut text, &options, &pipeline);
        writer
            .write(&module, &info, None)
            .unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(text.contains("numthreads(256, 1, 1)"), "{name}");
    }
}
