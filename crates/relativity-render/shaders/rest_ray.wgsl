// The rest-frame ray of a pixel, and where along it things lie.

// 0 as seen, 1 contracted only, 2 at rest.
override GEOMETRY: u32;
// Whether there are other groups, among which depths must be told.
override HAS_OTHERS: bool;
// Whether this group is the reference of depths, and the GEOMETRY of that.
override IS_REFERENCE: bool;
override REFERENCE_GEOMETRY: u32;

// Whether groups of the picture move past the camera otherwise than along x.
override OBLIQUE: bool;

// A vector before the camera, in axes along the group's motion; and back.
fn motion_from_sight(v: vec3f) -> vec3f {
    if OBLIQUE {
        return v;
    }
    return reflected(v, frame.motion.x);
}

// A vector of the group's frame, in axes along the group's motion.
fn motion_from_group(v: vec3f) -> vec3f {
    if OBLIQUE {
        return v * frame.group_axes;
    }
    return reflected(v, frame.motion.x);
}

// And back.
fn group_from_motion(v: vec3f) -> vec3f {
    if OBLIQUE {
        return frame.group_axes * v;
    }
    return reflected(v, frame.motion.x);
}

// How a line of sight passes the group.
fn own_passage(sight: vec3f, geometry: u32) -> Passage {
    let seen = passage(sight, geometry, frame.speed, frame.motion.x);
    if OBLIQUE {
        return Passage(frame.group_axes * seen.direction, seen.ground_per_rest, seen.doppler);
    }
    return seen;
}

// A line of sight before the camera of the reference.
fn reference_sight(sight: vec3f) -> vec3f {
    if OBLIQUE {
        return frame.reference_axes * sight;
    }
    return sight;
}

// A place from the middle of the group as it is from the camera's event.
fn from_camera_event(place: vec3f) -> vec3f {
    return frame.middle.xyz + (frame.middle_fine.xyz + place);
}

// The height on the ground, from the camera, of what is at this `height` in the group's frame, at `place`
// from its middle.
fn height_on_ground(height: f32, place: vec3f) -> f32 {
    if OBLIQUE {
        let from_camera = frame.middle.xyz + place;
        return height + dot(frame.rising.xyz, from_camera) + frame.rising.w * sqrt(dot(from_camera, from_camera));
    }
    return height;
}

struct Ray {
    // Unit vector towards the source, in the ground frame.
    sight: vec3f,
    // 1/length of the unnormalised line of sight.
    scale: f32,
    // Unit vector towards the source in the rest frame.
    direction: vec3f,
    // Ground distance per rest-frame distance.
    ground_per_rest: f32,
    doppler: f32,
    // Of the group's middle: its moment about the ray, and its distance along it.
    moment: vec3f,
    to_centre: f32,
}

fn rest_ray(pixel: vec2f) -> Ray {
    let sight = line_of_sight(pixel);
    let n = sight.xyz;
    let own = own_passage(n, GEOMETRY);
    let centre = frame.middle.xyz;
    let moment = cross(centre, own.direction) + cross(frame.middle_fine.xyz, own.direction);
    let to_centre = dot(centre, own.direction);
    return Ray(n, sight.w, own.direction, own.ground_per_rest, own.doppler, moment, to_centre);
}

// How far the ray's direction (rest frame) moves along the unit vector `across`, perpendicular to it, from
// one pixel to the next, to the right and down.
fn movement(ray: Ray, across: vec3f) -> vec2f {
    var ground = across;
    if GEOMETRY == 0u {
        // The transpose of the differential of aberration, which is conformal with scale D.
        let aside = motion_from_group(across);
        let direction = motion_from_group(ray.direction);
        let along = frame.speed.x * frame.speed.w * dot(aside.yz, direction.yz);
        ground = motion_from_sight(ray.doppler * vec3f(ray.doppler * aside.x - along, aside.yz));
    } else if GEOMETRY == 1u {
        let aside = motion_from_group(across);
        ground = motion_from_sight(vec3f(aside.x * frame.speed.w, aside.yz) * ray.ground_per_rest);
    } else if OBLIQUE {
        ground = motion_from_group(across);
    }
    let turned = (ground - ray.sight * dot(ray.sight, ground)) * ray.scale;
    return vec2f(dot(turned, step_right(ray.sight)), dot(turned, step_down(ray.sight)));
}

// Where the ray comes closest to `anchor` (from the group's middle), from there. The double cross product
// keeps its digits however far the camera is; |c|^2 - (c.n)^2 would not.
fn nearest_to(anchor: vec3f, ray: Ray) -> vec3f {
    return -cross(ray.direction, ray.moment + cross(anchor, ray.direction));
}

// Depth of what lies `beyond` the group's middle along its ray: 1 is nearest, 0 is nothing.
//
// Measured from the middle, since distances from a camera far away in the rest frame (gamma times as far as
// on the ground, abreast) differ by less than f32 resolves. That orders the bodies of one group at any speed,
// but counts for it alone. Of several groups the fastest, which would lose most, keeps that order: it is the
// reference. All others are told by ground distance, and placed where the reference would show a body of its
// own at that distance. f32 holds their distances to about 1e-7: two of their surfaces that are nearer to
// each other than this part of the way to the camera in their own rest frame may come out in either order.
// For slow groups that is nothing; what it is for a second fast one says `Method::Rays`, and
// `tests/gpu_rays.rs` measures it.
fn depth(ray: Ray, beyond: f32) -> f32 {
    if !HAS_OTHERS {
        return 0.5 - beyond * frame.middle.w;
    }
    if IS_REFERENCE {
        return depth_in_reference(beyond);
    }
    return depth_of_distance((ray.to_centre + beyond) * ray.ground_per_rest, ray.sight);
}

// The reference group has the middle half of all depths, from 3/4 to 1/4 over twice its reach.
fn depth_in_reference(beyond: f32) -> f32 {
    return 0.5 - 0.5 * beyond * frame.reference_middle.w;
}

// Where one light cone for both eyes puts the line of sight at `distance`, from the straight one through the
// reference's middle event: the limit's origin, as `GroupView::one_cone_ray` has it, and by what a curve is
// off its limit.
fn reference_origin(sight: vec3f, distance: f32, doppler: f32) -> vec3f {
    let eye = frame.reference_eye.xyz;
    let n = reflected(reference_sight(sight), frame.motion.y);
    let sine = cross(n, eye);
    let off = dot(sine, sine) / max(length(n * distance + eye) + distance + dot(n, eye), 1e-30);
    let later = frame.reference_speed.w * frame.reference_speed.x * (dot(n.yz, eye.yz) + off);
    return reflected(vec3f(eye.x / doppler + later, eye.yz), frame.motion.y);
}

// Depth of what is seen at `distance` (ground frame) along `sight`, among that of the reference group: the
// nearest by light travel is seen. From 1 at the camera to 3/4 where the reference begins it falls evenly
// with distance, from 1/4 where that ends with the reciprocal.
fn depth_of_distance(distance: f32, sight: vec3f) -> f32 {
    let reference = passage(reference_sight(sight), REFERENCE_GEOMETRY, frame.reference_speed, frame.motion.y);
    let origin = reference_origin(sight, distance, reference.doppler);
    let to_centre = dot(frame.reference_middle.xyz, reference.direction) - dot(origin, reference.direction);
    let reach = 0.5 / frame.reference_middle.w;
    let near = (to_centre - reach) * reference.ground_per_rest;
    let far = (to_centre + reach) * reference.ground_per_rest;
    if distance < near {
        return 1.0 - 0.25 * distance / near;
    }
    if distance > far {
        let scale = max(far, 1.0);
        return 0.25 * scale / (scale + (distance - far));
    }
    return depth_in_reference(distance / reference.ground_per_rest - to_centre);
}
