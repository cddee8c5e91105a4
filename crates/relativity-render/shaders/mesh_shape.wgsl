// What the pixels of a mesh show of a body with a shape of its own.

// Whether corners have normals, which turn with them.
const HAS_NORMALS = true;

fn prepare(fragment: Fragment, is_front: bool) {}

fn is_hole(fragment: Fragment, measure: Measure) -> bool {
    return false;
}

fn normal_in(fragment: Fragment) -> vec3f {
    return fragment.normal / max(length(fragment.normal), 1e-30);
}

fn paint_in(fragment: Fragment, measure: Measure) -> vec4f {
    return vec4f(1.0, 1.0, 1.0, -1.0);
}

fn part_in(fragment: Fragment) -> f32 {
    return 0.0;
}
