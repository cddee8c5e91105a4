//! Every shader, parsed and validated without a device; and its blocks against their Rust mirrors.

use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{Module, TypeInner};
use relativity_render::shaders::{self, Mirror};

#[test]
fn every_shader_is_valid() {
    for (name, source) in shaders::SOURCES {
        let module = module(name, source);
        let validated =
            Validator::new(ValidationFlags::all(), Capabilities::MULTISAMPLED_SHADING).validate(&module);
        assert!(validated.is_ok(), "{name}: {:?}", validated.err());
    }
}

#[test]
fn blocks_match_their_rust_mirrors() {
    for mirror in shaders::MIRRORS {
        let mut found = 0;
        for (name, source) in shaders::SOURCES {
            let module = module(name, source);
            found += usize::from(agrees(&module, name, &mirror));
        }
        assert!(found > 0, "no shader has a {}", mirror.name);
    }
}

/// Whether `module` has the mirrored struct; panics if it differs.
fn agrees(module: &Module, shader: &str, mirror: &Mirror) -> bool {
    let Some((_, ty)) = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(mirror.name)) else {
        return false;
    };
    let TypeInner::Struct { members, span } = &ty.inner else { panic!("{} is no struct", mirror.name) };
    let fields: Vec<_> =
        members.iter().map(|member| (member.name.as_deref().unwrap_or(""), member.offset as usize)).collect();
    assert_eq!(fields, mirror.fields, "{} in {shader}", mirror.name);
    assert_eq!(*span as usize, mirror.size, "size of {} in {shader}", mirror.name);
    true
}

fn module(name: &str, source: &str) -> Module {
    match naga::front::wgsl::parse_str(source) {
        Ok(module) => module,
        Err(error) => panic!("{name}: {}", error.emit_to_string(source)),
    }
}
