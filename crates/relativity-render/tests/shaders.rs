//! Every shader, parsed and validated without a device; and what it shares with Rust against Rust's side of
//! it.

use naga::back::PipelineConstants;
use naga::back::glsl;
use naga::back::pipeline_constants::process_overrides;
use naga::proc::BoundsCheckPolicies;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{
    AddressSpace, Binding, Block, EntryPoint, Expression, Function, Handle, Module, ScalarKind, Statement,
    StructMember, TypeInner,
};
use relativity_render::gpu::mirrors::{self, Mirror, Shader};
use wgpu::VertexFormat;

#[test]
fn every_shader_is_valid() {
    for shader in mirrors::shaders() {
        let validated = Validator::new(ValidationFlags::all(), Capabilities::MULTISAMPLED_SHADING)
            .validate(&module(&shader));
        assert!(validated.is_ok(), "{}: {:?}", shader.name, validated.err());
    }
}

/// A browser's WebGL 2 has neither sample masks nor indices of samples.
#[test]
fn all_but_what_chooses_samples_can_be_said_in_webgl() {
    for shader in mirrors::shaders().iter().filter(|shader| !shader.name.starts_with("impostor of")) {
        let module = module(shader);
        let validated = Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module);
        let info = validated.unwrap_or_else(|error| panic!("{}: {error:?}", shader.name));
        let constants = shader.constants.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
        for entry in &module.entry_points {
            let said = webgl(&module, &info, &constants, entry);
            assert!(said.is_ok(), "{} of {}: {:?}", entry.name, shader.name, said.err());
        }
    }
}

fn webgl(
    module: &Module,
    info: &ModuleInfo,
    constants: &PipelineConstants,
    entry: &EntryPoint,
) -> Result<String, String> {
    let point = Some((entry.stage, entry.name.as_str()));
    let (module, info) =
        process_overrides(module, info, point, constants).map_err(|error| error.to_string())?;
    let options = glsl::Options {
        version: glsl::Version::Embedded { version: 300, is_webgl: true },
        ..glsl::Options::default()
    };
    let pipeline =
        glsl::PipelineOptions { shader_stage: entry.stage, entry_point: entry.name.clone(), multiview: None };
    let mut text = String::new();
    let policies = BoundsCheckPolicies::default();
    glsl::Writer::new(&mut text, &module, &info, &options, &pipeline, policies)
        .and_then(|mut writer| writer.write())
        .map_err(|error| error.to_string())?;
    Ok(text)
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

/// Mesa's lavapipe recompiles a shader for every new value of a uniform that decides a branch by itself. Each
/// compilation takes milliseconds, and its result is never freed.
#[test]
fn no_shader_branches_on_what_only_uniforms_say() {
    for shader in mirrors::shaders() {
        let module = module(&shader);
        let entry_points = module.entry_points.iter().map(|entry_point| &entry_point.function);
        for function in module.functions.iter().map(|(_, function)| function).chain(entry_points) {
            let mut conditions = Vec::new();
            collect_conditions(&function.body, &mut conditions);
            for condition in conditions {
                let sources = sources(&module, function, condition);
                assert!(
                    !sources.uniforms || sources.others,
                    "{} of {}: {:?}",
                    function.name.as_deref().unwrap_or("?"),
                    shader.name,
                    function.expressions[condition]
                );
            }
        }
    }
}

/// Collects the conditions of all branches in `block`.
fn collect_conditions(block: &Block, conditions: &mut Vec<Handle<Expression>>) {
    for statement in block {
        match statement {
            Statement::If { condition, accept, reject } => {
                conditions.push(*condition);
                collect_conditions(accept, conditions);
                collect_conditions(reject, conditions);
            }
            Statement::Switch { selector, cases } => {
                conditions.push(*selector);
                for case in cases {
                    collect_conditions(&case.body, conditions);
                }
            }
            Statement::Loop { body, continuing, break_if } => {
                conditions.extend(break_if);
                collect_conditions(body, conditions);
                collect_conditions(continuing, conditions);
            }
            Statement::Block(block) => collect_conditions(block, conditions),
            _ => {}
        }
    }
}

/// The origins of a value, constants aside.
#[derive(Clone, Copy, Default)]
struct Sources {
    uniforms: bool,
    others: bool,
}

fn sources(module: &Module, function: &Function, expression: Handle<Expression>) -> Sources {
    let of = |parts: &[Handle<Expression>]| {
        parts.iter().fold(Sources::default(), |sum, &part| {
            let part = sources(module, function, part);
            Sources { uniforms: sum.uniforms || part.uniforms, others: sum.others || part.others }
        })
    };
    match function.expressions[expression] {
        Expression::Literal(_)
        | Expression::Constant(_)
        | Expression::Override(_)
        | Expression::ZeroValue(_) => Sources::default(),
        Expression::GlobalVariable(variable) => {
            let uniforms = module.global_variables[variable].space == AddressSpace::Uniform;
            Sources { uniforms, others: !uniforms }
        }
        Expression::AccessIndex { base: part, .. }
        | Expression::Load { pointer: part }
        | Expression::Splat { value: part, .. }
        | Expression::Swizzle { vector: part, .. }
        | Expression::Unary { expr: part, .. }
        | Expression::As { expr: part, .. } => of(&[part]),
        Expression::Access { base, index } => of(&[base, index]),
        Expression::Binary { left, right, .. } => of(&[left, right]),
        Expression::Select { condition, accept, reject } => of(&[condition, accept, reject]),
        Expression::Compose { ref components, .. } => of(components),
        _ => Sources { uniforms: false, others: true },
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
    match naga::front::wgsl::parse_str(&shader.source) {
        Ok(module) => module,
        Err(error) => panic!("{}: {}", shader.name, error.emit_to_string(&shader.source)),
    }
}
