//! Every shader, parsed and validated without a device; and what it shares with Rust against Rust's side of it.

use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{Binding, Module, ScalarKind, StructMember, TypeInner};
use relativity_render::mirrors::{self, Mirror, Shader};
use wgpu::VertexFormat;

#[test]
fn every_shader_is_valid() {
    for shader in mirrors::shaders() {
        let validated = Validator::new(ValidationFlags::all(), Capabilities::MULTISAMPLED_SHADING)
            .validate(&module(&shader));
        assert!(validated.is_ok(), "{}: {:?}", shader.name, validated.err());
    }
}

#[test]
fn every_constant_comes_from_rust() {
    for shader in mirrors::shaders() {
        let module = module(&shader);
        let mut declared = Vec::new();
        for (_, constant) in module.overrides.iter() {
            let name = constant.name.clone().expect("constants have names");
            assert!(constant.init.is_none(), "{name} has a default of its own in {}", shader.name);
            declared.push(name);
        }
        let mut given: Vec<_> = shader.constants.iter().map(|(name, _)| (*name).to_owned()).collect();
        declared.sort();
        given.sort();
        assert_eq!(declared, given, "{}", shader.name);
    }
}

#[test]
fn blocks_match_their_rust_mirrors() {
    for mirror in mirrors::BLOCKS {
        for_each_like(&mirror, |_, members, span, shader| {
            let fields: Vec<_> =
                members.iter().map(|member| (name(member), member.offset as usize)).collect();
            assert_eq!(fields, mirror.fields, "{} in {shader}", mirror.name);
            assert_eq!(span as usize, mirror.size, "size of {} in {shader}", mirror.name);
        });
    }
}

#[test]
fn vertices_match_their_rust_mirrors() {
    for vertex in mirrors::VERTICES {
        let Mirror { name: struct_name, fields, size } = vertex.mirror;
        assert_eq!(vertex.layout.array_stride as usize, size, "stride of {struct_name}");
        let read: Vec<_> = vertex
            .layout
            .attributes
            .iter()
            .zip(fields)
            .map(|(attribute, (name, offset))| {
                assert_eq!(attribute.offset as usize, *offset, "{struct_name}.{name}");
                (*name, attribute.shader_location, attribute.format)
            })
            .collect();
        assert_eq!(read.len(), fields.len(), "{struct_name}");
        for_each_like(&vertex.mirror, |module, members, _, shader| {
            let declared: Vec<_> = members
                .iter()
                .map(|member| (name(member), location(member), format(module, member)))
                .collect();
            assert_eq!(declared, read, "{struct_name} in {shader}");
        });
    }
}

/// Calls `check` with the members and the span of every struct of the shaders with the mirror's name.
fn for_each_like(mirror: &Mirror, check: impl Fn(&Module, &[StructMember], u32, &str)) {
    let mut found = 0;
    for shader in mirrors::shaders() {
        let module = module(&shader);
        let Some((_, ty)) = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(mirror.name))
        else {
            continue;
        };
        let TypeInner::Struct { members, span } = &ty.inner else { panic!("{} is no struct", mirror.name) };
        check(&module, members, *span, &shader.name);
        found += 1;
    }
    assert!(found > 0, "no shader has a {}", mirror.name);
}

fn name(member: &StructMember) -> &str {
    member.name.as_deref().unwrap_or("")
}

fn location(member: &StructMember) -> u32 {
    match member.binding {
        Some(Binding::Location { location, .. }) => location,
        _ => panic!("{} has no location", name(member)),
    }
}

/// The format of what fills `member`: floats.
fn format(module: &Module, member: &StructMember) -> VertexFormat {
    let (size, scalar) = match module.types[member.ty].inner {
        TypeInner::Scalar(scalar) => (1, scalar),
        TypeInner::Vector { size, scalar } => (size as u32, scalar),
        _ => panic!("{} is no number", name(member)),
    };
    assert_eq!((scalar.kind, scalar.width), (ScalarKind::Float, 4), "{}", name(member));
    match size {
        1 => VertexFormat::Float32,
        2 => VertexFormat::Float32x2,
        3 => VertexFormat::Float32x3,
        _ => VertexFormat::Float32x4,
    }
}

fn module(shader: &Shader) -> Module {
    match naga::front::wgsl::parse_str(shader.source) {
        Ok(module) => module,
        Err(error) => panic!("{}: {}", shader.name, error.emit_to_string(shader.source)),
    }
}
