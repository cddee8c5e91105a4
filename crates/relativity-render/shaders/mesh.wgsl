// Triangles whose corners go through the apparent position: where the light cone of the aperture meets the
// worldline of each corner.

// As GEOMETRY; 3 is the published model's right eye, 4 one light cone for both eyes.
override MAP: u32;

struct Corner {
    // Place on the unit shape; see the shape's `corner_place`.
    @location(0) profile: vec4f,
    @location(1) turn: vec2f,
}

struct MeshInstance {
    // The `Body`.
    @location(2) place_radius: vec4f,
    @location(3) form: vec4f,
    @location(4) turn: vec4f,
    // As `received_colour` takes it.
    @location(5) light: vec4f,
    // Half the least width that the body is seen with, its brightness, and its number.
    @location(6) width_brightness_index: vec3f,
    // As `mark` reads it.
    @location(7) pattern: vec3f,
    // The `Spin`.
    @location(8) spin: vec4f,
    @location(9) rim: vec2f,
    // As `BodyCopy`: the angle by which this copy is turned, and whether it draws only the triangles across
    // the cut.
    @location(10) copy: vec2f,
}

struct Fragment {
    @builtin(position) position: vec4f,
    // From the body's middle, rest frame.
    @location(0) place: vec3f,
    @location(1) normal: vec3f,
    // From the aperture.
    @location(2) apparent: vec3f,
    @location(3) doppler: f32,
    @location(4) @interpolate(flat) light: vec4f,
    @location(5) @interpolate(flat) width_brightness_index: vec3f,
    @location(6) @interpolate(flat) place_radius: vec4f,
    @location(7) @interpolate(flat) form: vec4f,
    @location(8) @interpolate(flat) turn: vec4f,
    @location(9) @interpolate(flat) pattern: vec3f,
    @location(10) @interpolate(flat) spin: vec4f,
    @location(11) @interpolate(flat) rim: vec2f,
    // How much of the corners is behind the baseline and below, and how much behind it and above; and whether
    // this copy is of triangles across the cut.
    @location(12) ends: vec3f,
    // Half the width that the corners are drawn with: that of a pixel at least, if the body may be thinner.
    @location(13) drawn_half_width: f32,
}

// The paper's Delta T (eq. 5): how much longer the light that the left eye sees takes to the right eye.
fn delay(left: vec3f) -> f32 {
    let separation = frame.ground.w;
    let event_x = left.x - 0.5 * separation;
    let to_right = left - vec3f(separation, 0.0, 0.0);
    return -2.0 * event_x * separation / (sqrt(dot(left, left)) + sqrt(dot(to_right, to_right)));
}

fn mapped(from_camera: vec3f) -> Sighting {
    let seen = mapped_along_x(motion_from_group(from_camera));
    return Sighting(motion_from_sight(seen.position), seen.doppler);
}

// The same for motion along +x.
fn mapped_along_x(c: vec3f) -> Sighting {
    switch MAP {
        case 0u: { return sighting(c); }
        case 1u: { return Sighting(vec3f(c.x * frame.speed.z, c.yz), 1.0); }
        case 2u: { return Sighting(c, 1.0); }
        case 3u: {
            // The left eye's sighting at T - Delta T, as Appendix A prints it.
            let shift = frame.speed.x * frame.speed.w * delay(sighting(c).position);
            return sighting(c - vec3f(shift, 0.0, 0.0));
        }
        default: {
            // What the middle between the eyes receives, from where the camera is.
            let seen = sighting(c);
            return Sighting(seen.position - frame.eye.xyz, seen.doppler);
        }
    }
}

// The camera's event from the middle of `body`, along the body's own axes.
fn camera_from_body(body: Body) -> vec3f {
    return body_from_rest(-from_camera_event(middle(body)), body);
}

// Beyond this many halves of a body's length it is divided evenly; and nearer than this the camera counts as
// no nearer.
const FAR_OFF = 30.0;
const NEAREST = 1e-3;

fn inverse_sinh(x: f32) -> f32 {
    return sign_of(x) * log(abs(x) + sqrt(x * x + 1.0));
}

// Where the grid's corner `t` is along a body, from -1 at one end to 1 at the other: at even steps of the
// rapidity of the line of sight along the body, which motion along it only shifts, so that the image bends as
// little between corners at every speed. The camera is `along` from the middle and `off` the body, in halves
// of the body's length.
fn spaced(t: f32, along: f32, off: f32) -> f32 {
    if abs(t) == 1.0 || max(abs(along), off) > FAR_OFF {
        return t;
    }
    let scale = max(off, NEAREST);
    let rapidity = mix(inverse_sinh((-1.0 - along) / scale), inverse_sinh((1.0 - along) / scale), 0.5 + 0.5 * t);
    return along + 0.5 * scale * (exp(rapidity) - exp(-rapidity));
}

// The same along each own axis of a body with these `halves`.
fn all_spaced(place: vec3f, halves: vec3f, body: Body) -> vec3f {
    let camera = camera_from_body(body);
    let off = length(max(abs(camera) - halves, vec3f(0.0)));
    return halves * vec3f(
        spaced(place.x, camera.x / halves.x, off / halves.x),
        spaced(place.y, camera.y / halves.y, off / halves.y),
        spaced(place.z, camera.z / halves.z, off / halves.z),
    );
}

// A corner of `body` from the group's middle, when it is shown.
fn shown_corner(corner: Corner, body: Body, spin: Spin) -> Shape {
    let own = corner_place(corner, body);
    return corner_when_shown(middle(body) + own.place, own.normal, spin);
}

fn sighting_from_middle(place: vec3f) -> Sighting {
    return mapped(from_camera_event(place));
}

// Half the size of a pixel at what appears at `position`: away from the axis of a flat picture nothing is
// smaller than on it, as deep; in a conformal one, as far from the baseline.
fn half_pixel_at(position: vec3f) -> f32 {
    let depth = dot(position, frame.forward.xyz);
    if CONFORMAL {
        let rise = dot(position, frame.clip_up.xyz);
        let largest = max(max(abs(depth), abs(rise)), 1e-30);
        return 0.5 * frame.base.w * largest * length(vec2f(depth, rise) / largest);
    }
    return 0.5 * length(frame.right.xyz) * max(depth, 0.0);
}

// The body that has half this width where it is drawn wider than it is: a long one may be thinner than a
// pixel at one end alone.
fn widened(body: Body, half_width: f32, drawn_half_width: f32) -> Body {
    let radius = select(body.radius, drawn_half_width, half_width < drawn_half_width);
    return Body(body.place, radius, body.form, body.turn);
}

@vertex
fn corner(corner: Corner, instance: MeshInstance) -> Fragment {
    var body = Body(instance.place_radius.xyz, instance.place_radius.w, instance.form, instance.turn);
    let spin = spin_of(instance.spin, instance.rim);
    var shape = shown_corner(corner, body, spin);
    var seen = sighting_from_middle(shape.place);
    var drawn_half_width = instance.width_brightness_index.x;
    if THIN {
        drawn_half_width = max(drawn_half_width, half_pixel_at(seen.position));
        body = widened(body, instance.width_brightness_index.x, drawn_half_width);
        shape = shown_corner(corner, body, spin);
        seen = sighting_from_middle(shape.place);
    }
    let place = shape.place - middle(body);
    if TURNS != 0u && MAP == 3u {
        let earlier = corner_seen_earlier(shape.place, spin);
        seen = sighting(reflected(earlier.from_camera, frame.motion.x));
        seen.position = reflected(seen.position, frame.motion.x);
        let sight = seen.position / max(length(seen.position), 1e-30);
        seen.doppler = doppler_of(body, earlier.place - middle(body), shape.normal, sight, seen.doppler, spin);
    }
    var place_in_picture: Place;
    if CONFORMAL {
        place_in_picture = conformal_place(seen.position, instance.copy);
    } else {
        place_in_picture = flat_place(seen.position);
    }
    return Fragment(
        place_in_picture.clip,
        place,
        shape.normal,
        seen.position,
        seen.doppler,
        exposed(instance.light),
        instance.width_brightness_index,
        instance.place_radius,
        instance.form,
        instance.turn,
        instance.pattern,
        instance.spin,
        instance.rim,
        place_in_picture.ends,
        drawn_half_width,
    );
}

// Nothing nearer than this is drawn.
const NEAR = 1e-4;

// Where a corner is in the picture, in clip coordinates, and `Fragment.ends`.
struct Place {
    clip: vec4f,
    ends: vec3f,
}

// Of what appears there.
fn flat_place(position: vec3f) -> Place {
    let clip = vec4f(
        dot(position, frame.clip_right.xyz),
        dot(position, frame.clip_up.xyz),
        NEAR,
        dot(position, frame.forward.xyz),
    );
    return Place(clip, vec3f(0.0));
}

// The same in a conformal picture, for this copy of the body.
fn conformal_place(position: vec3f, copy: vec2f) -> Place {
    let seen = coordinates_of(position);
    var v = seen.v;
    if copy.y > 0.0 && v < 0.0 {
        v += 6.2831853;
    }
    v += copy.x;
    let clip = vec4f((seen.u - frame.forward.w) * frame.clip_right.w, v * frame.clip_up.w, 0.5, 1.0);
    let is_below = seen.v < 0.0;
    let ends = vec2f(select(0.0, 1.0, seen.is_behind && is_below), select(0.0, 1.0, seen.is_behind && !is_below));
    return Place(clip, vec3f(ends, copy.y));
}

// Whether another copy of the body draws this fragment: those across the cut draw the triangles with corners
// behind the baseline both below and above.
fn is_of_other_copy(fragment: Fragment) -> bool {
    // At a triangle's edge what is interpolated may be slightly below 0.
    let is_across = fragment.ends.x != 0.0 && fragment.ends.y != 0.0;
    return CONFORMAL && is_across != (fragment.ends.z > 0.5);
}

struct Measure {
    depth: f32,
    doppler: f32,
    ray: Ray,
    // Where on the body: from its middle, and its normal there, rest frame.
    place: vec3f,
    normal: vec3f,
    // On the ground.
    distance: f32,
}

// From the pixel's own ray, which is better than what is interpolated between corners: the Doppler factor
// depends on the line of sight alone, in the rest frame depth is not contracted, and the body itself is
// nearer or farther than the triangle by what may be more than the gap to the next body. Where two walls of a
// body lie behind each other, as a ring's do, triangles of both have the depth of the nearer, and either may
// be drawn: so both show the nearer. Where the ray misses the body, there is the triangle alone.
fn measure(fragment: Fragment) -> Measure {
    let ray = rest_ray(pixel_at(fragment.position));
    let normal = normal_in(fragment);
    if MAP == 3u {
        let distance = length(fragment.apparent);
        var depth = 1.0 / (1.0 + distance);
        if HAS_OTHERS {
            depth = depth_of_distance(distance, ray.sight);
        }
        return Measure(depth, fragment.doppler, ray, fragment.place, normal, distance);
    }
    if MAP == 4u {
        return measure_in_one_cone(fragment, ray, normal);
    }
    let body = body_of(fragment);
    let spin = spin_of(fragment.spin, fragment.rim);
    let hit = surface_when_shown(body, ray, spin);
    let distance = (ray.to_centre + hit.beyond) * ray.ground_per_rest;
    let depth = depth(ray, hit.beyond);
    if hit.clearance > 0.0 {
        let doppler = doppler_of(body, hit.place, hit.normal, ray.sight, ray.doppler, spin);
        return Measure(depth, doppler, ray, hit.place, hit.normal, distance);
    }
    let doppler = doppler_of(body, fragment.place, normal, ray.sight, ray.doppler, spin);
    return Measure(depth, doppler, ray, fragment.place, normal, length(fragment.apparent));
}

// The same where both eyes have one light cone, from the ray that touches the curve of events where the
// fragment appears. Depths are told along the ray's limit at great distances, which all fragments of a pixel
// share.
fn measure_in_one_cone(fragment: Fragment, straight: Ray, normal: vec3f) -> Measure {
    let body = body_of(fragment);
    let spin = spin_of(fragment.spin, fragment.rim);
    // The triangle may be off in depth by more than in the picture.
    let near = touching_ray(straight, length(fragment.apparent));
    let ray = touching_ray(straight, (near.to_centre + surface_when_shown(body, near, spin).beyond) * near.ground_per_rest);
    let hit = surface_when_shown(body, ray, spin);
    let distance = (ray.to_centre + hit.beyond) * ray.ground_per_rest;
    let from_middle = straight.sight * distance + motion_from_sight(frame.eye.xyz);
    let sight = from_middle / max(length(from_middle), 1e-30);
    let beyond = dot(middle(body) + hit.place, straight.direction);
    var depth = 0.5 - beyond * frame.middle.w;
    if HAS_OTHERS {
        depth = depth_in_reference(beyond);
        if !IS_REFERENCE {
            depth = depth_of_distance(distance, ray.sight);
        }
    }
    if hit.clearance > 0.0 {
        let doppler = doppler_of(body, hit.place, hit.normal, sight, ray.doppler, spin);
        return Measure(depth, doppler, ray, hit.place, hit.normal, distance);
    }
    let doppler = doppler_of(body, fragment.place, normal, sight, ray.doppler, spin);
    return Measure(depth, doppler, ray, fragment.place, normal, length(fragment.apparent));
}

// As `GroupView::rest_ray_at`, from the `straight` ray through the middle's event.
fn touching_ray(straight: Ray, distance: f32) -> Ray {
    let n = motion_from_sight(straight.sight);
    let eye = frame.eye.xyz;
    let place = n * distance + eye;
    let reach = max(length(place), 1e-30);
    let along = place / reach;
    let cosine = dot(n, along);
    // Not out of a difference of both.
    let sine = cross(n, eye) / reach;
    let gap = select(1.0 - cosine, dot(sine, sine) / (1.0 + cosine), cosine > 0.0);
    let received = own_passage(motion_from_sight(along), 0u);
    // The tangent, times D along the line of sight.
    let bend = frame.speed.x * (frame.speed.w * straight.doppler) * gap;
    let tangent = straight.direction - group_from_motion(vec3f(bend, 0.0, 0.0));
    let largest = max(abs(tangent.x), max(abs(tangent.y), abs(tangent.z)));
    let scaled = tangent / largest;
    let reciprocal = 1.0 / sqrt(dot(scaled, scaled));
    let direction = scaled * reciprocal;
    let later = frame.speed.w * frame.speed.x * dot(eye.yz, along.yz);
    let origin = group_from_motion(vec3f(eye.x / received.doppler + later, eye.yz));
    let centre = frame.middle.xyz;
    let moment = cross(centre, direction) + cross(frame.middle_fine.xyz, direction) - cross(origin, direction);
    let to_centre = dot(centre - origin, direction);
    let ground_per_rest = straight.doppler * (reciprocal / largest);
    return Ray(
        straight.sight,
        straight.scale,
        direction,
        ground_per_rest,
        received.doppler,
        moment,
        to_centre,
    );
}

fn body_of(fragment: Fragment) -> Body {
    let body = Body(fragment.place_radius.xyz, fragment.place_radius.w, fragment.form, fragment.turn);
    if THIN {
        return widened(body, fragment.width_brightness_index.x, fragment.drawn_half_width);
    }
    return body;
}

// How much of a pixel a body covers that is thinner than one.
fn cover(fragment: Fragment) -> f32 {
    if THIN {
        return min(fragment.width_brightness_index.x / max(fragment.drawn_half_width, 1e-30), 1.0);
    }
    return 1.0;
}

// Height of what appears, above the camera's event on the ground.
fn height_of(fragment: Fragment) -> f32 {
    if OBLIQUE {
        let place = middle(body_of(fragment)) + fragment.place;
        return height_on_ground(frame.middle.z + place.z, place);
    }
    return fragment.apparent.z;
}

struct Picture {
    @location(0) colour: vec4f,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn picture(fragment: Fragment, @builtin(front_facing) is_front: bool) -> Picture {
    prepare(fragment, is_front);
    let measure = measure(fragment);
    let turning = spin_of(fragment.spin, fragment.rim);
    let facing = facing_of(body_of(fragment), measure.place, measure.normal, turning);
    let paint = paint_in(fragment, measure);
    let pixel = pixel_at(fragment.position);
    var colour = received_colour(fragment.light, paint, measure.doppler, measure.normal, facing, pixel)
        * fragment.width_brightness_index.y;
    if PATTERNS {
        let spin = spin_of(fragment.spin, fragment.rim);
        let there = standing(body_of(fragment), measure.place, spin);
        colour *= mark(
            there.body,
            fragment.pattern,
            there.place,
            measure.normal,
            measure.ray,
            measure.distance,
        );
    }
    if height_of(fragment) < frame.ground.z || is_of_other_copy(fragment) || is_hole(fragment, measure) {
        discard;
    }
    return Picture(vec4f(colour, 1.0) * cover(fragment), measure.depth);
}

// Floats as their bits: OpenGL ES does not draw to 32-bit floats.
struct Hit {
    // As the impostors'.
    @location(0) measures: vec4u,
    @location(1) place: vec4u,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn hits(fragment: Fragment, @builtin(front_facing) is_front: bool) -> Hit {
    prepare(fragment, is_front);
    if is_of_other_copy(fragment) {
        discard;
    }
    let measure = measure(fragment);
    if is_hole(fragment, measure) {
        discard;
    }
    return Hit(
        bitcast<vec4u>(
            vec4f(fragment.width_brightness_index.z, measure.distance, measure.doppler, 1.0),
        ),
        bitcast<vec4u>(vec4f(
            place_of_hit(body_of(fragment), measure.place, spin_of(fragment.spin, fragment.rim)),
            part_in(fragment),
        )),
        measure.depth,
    );
}
