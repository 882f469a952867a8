// The programs that run for each pixel, in GLSL 3.30: one for each kind of shape, all fed the same record.
#pragma once

namespace screen::shaders {

// A shape is a quad of four corners in pixels and numbers that its fragment shader knows the meaning of.
inline constexpr char const* vertex = R"(#version 330 core
layout(location = 0) in vec4 first_corners;
layout(location = 1) in vec4 last_corners;
layout(location = 2) in vec4 place_in;
layout(location = 3) in vec4 form_in;
layout(location = 4) in vec4 colour_in;
layout(location = 5) in vec4 second_colour_in;
layout(location = 6) in vec4 more_in;
uniform vec2 frame_size;
flat out vec4 place, form, colour, second_colour, more;
void main() {
    vec4 pair = gl_VertexID < 2 ? first_corners : last_corners;
    vec2 corner = (gl_VertexID & 1) == 0 ? pair.xy : pair.zw;
    gl_Position = vec4(corner / frame_size * 2.0 - 1.0, 0.0, 1.0);
    place = place_in;
    form = form_in;
    colour = colour_in;
    second_colour = second_colour_in;
    more = more_in;
}
)";

// What all fragment shaders begin with. Colours are blended with their alpha multiplied in.
inline constexpr char const* fragment_head = R"(#version 330 core
flat in vec4 place, form, colour, second_colour, more;
out vec4 pixel;
vec4 multiplied(vec4 c) { return vec4(c.rgb * c.a, c.a); }
)";

// place: centre, radius, softness; form: rim width.
inline constexpr char const* disc = R"(
void main() {
    float distance = length(gl_FragCoord.xy - place.xy) - place.z;
    float inside = clamp(0.5 - distance / max(place.w, 1.0), 0.0, 1.0);
    if (place.w > 1.0) inside = inside * inside * (3.0 - 2.0 * inside);
    float rim = form.x > 0.0 ? clamp(distance + form.x + 0.5, 0.0, 1.0) : 0.0;
    pixel = mix(multiplied(colour), multiplied(second_colour), rim) * inside;
}
)";

// A rounded box, a stroke being one without height. place: centre, direction; form: half length, half height, radius.
inline constexpr char const* box = R"(
void main() {
    vec2 d = gl_FragCoord.xy - place.xy;
    vec2 local = vec2(dot(d, place.zw), dot(d, vec2(-place.w, place.z)));
    vec2 q = abs(local) - form.xy;
    float distance = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - form.z;
    pixel = multiplied(colour) * clamp(0.5 - distance, 0.0, 1.0);
}
)";

// A stroke along a circle. place: centre, direction of the stroke's middle; form: radius, half width, cosine and sine
// of half its angle.
inline constexpr char const* arc = R"(
void main() {
    vec2 d = gl_FragCoord.xy - place.xy;
    vec2 local = vec2(dot(d, place.zw), abs(dot(d, vec2(-place.w, place.z))));
    bool beside = form.w * local.x >= form.z * local.y;
    float distance = beside ? abs(length(local) - form.x) : length(local - form.zw * form.x);
    pixel = multiplied(colour) * clamp(0.5 + form.y - distance, 0.0, 1.0);
}
)";

// All areas and the sky. more: the way down; place: the world's origin along right and down, in pixels, tiles of grain
// a pixel, level of detail; form: upper and lower end of the gradient along down, strength of the grain, number of the
// edge tile in its atlas.
inline constexpr char const* area = R"(
uniform sampler2D coverage, grain;
vec4 smooth_paint() {
    return mix(colour, second_colour, clamp((dot(gl_FragCoord.xy, more.xy) - form.x) / (form.y - form.x), 0.0, 1.0));
}
vec4 grained_paint() {
    vec4 paint = smooth_paint();
    vec2 texel = (vec2(dot(gl_FragCoord.xy, vec2(more.y, -more.x)), dot(gl_FragCoord.xy, more.xy)) - place.xy) * place.z;
    paint.rgb *= 1.0 + form.z * (textureLod(grain, texel, place.w).r - 0.502);
    return vec4(min(paint.rgb, 1.0), paint.a);
}
float edge() {
    const int side = 16, across = 64;
    int tile = int(form.w);
    ivec2 corner = side * ivec2(tile % across, tile / across);
    return texelFetch(coverage, corner + (ivec2(gl_FragCoord.xy) & (side - 1)), 0).r;
}
)";
// A gradient costs half as much again as a colour.
inline constexpr char const* plain_area = "void main() { pixel = multiplied(colour); }";
inline constexpr char const* smooth_area = "void main() { pixel = multiplied(smooth_paint()); }";
inline constexpr char const* smooth_edge = "void main() { pixel = multiplied(smooth_paint()) * edge(); }";
inline constexpr char const* grained_area = "void main() { pixel = multiplied(grained_paint()); }";
inline constexpr char const* grained_edge = "void main() { pixel = multiplied(grained_paint()) * edge(); }";

// place: what to add to a pixel's place to get its texel.
inline constexpr char const* glyph = R"(
uniform sampler2D atlas;
void main() {
    pixel = multiplied(colour) * texelFetch(atlas, ivec2(gl_FragCoord.xy) + ivec2(place.xy), 0).r;
}
)";

// The ball. place: centre, radius in pixels, how far the monkey's eyes are closed; form: cosine and sine of its angle,
// direction of the light; more: cosine and sine of the monkey's lean, its stride in cycles, how far it runs; the
// colours' alpha: where it looks, 0.5 being straight ahead. Points are in radii, y up.
inline constexpr char const* shell = R"(
float pixels;  // of the unit in which distances are given
float sharp(float distance) { return clamp(0.5 - distance * pixels, 0.0, 1.0); }
float disc(vec2 p, vec2 centre, float radius) { return sharp(length(p - centre) - radius); }
float oval(vec2 p, vec2 centre, vec2 radii) {
    vec2 q = (p - centre) / radii;
    return sharp((length(q) - 1.0) * min(radii.x, radii.y));
}
float limb(vec2 p, vec2 from, vec2 to, float radius) {
    vec2 d = p - from, way = to - from;
    return sharp(length(d - way * clamp(dot(d, way) / dot(way, way), 0.0, 1.0)) - radius);
}
vec4 over(vec4 under, vec3 top, float amount) { return mix(under, vec4(top, 1.0), amount); }

const vec3 fur = vec3(0.43, 0.25, 0.13), skin = vec3(0.99, 0.83, 0.63), dark = vec3(0.13, 0.07, 0.05);

vec4 head(vec4 base, vec2 p, vec2 gaze) {
    vec2 q = vec2(abs(p.x), p.y);
    vec4 c = over(base, fur, max(disc(q, vec2(0.58, 0.06), 0.185), disc(p, vec2(0.0, 0.02), 0.56)));
    c = over(c, fur, oval(p, vec2(0.0, 0.55), vec2(0.10, 0.16)));
    c = over(c, vec3(0.93, 0.62, 0.50), disc(q, vec2(0.595, 0.055), 0.105));
    p -= 0.06 * gaze;  // the face turns a little the way it looks
    q = vec2(abs(p.x), p.y);
    float face = max(oval(q, vec2(0.19, 0.11), vec2(0.245, 0.28)), oval(p, vec2(0.0, -0.22), vec2(0.42, 0.28)));
    c = over(c, skin, face);
    c = over(c, vec3(0.99, 0.60, 0.48), 0.55 * oval(q, vec2(0.31, -0.17), vec2(0.10, 0.07)));
    float open = 1.0 - 0.92 * place.w;
    c = over(c, vec3(1.0), oval(q, vec2(0.175, 0.14), vec2(0.125, 0.165 * open)));
    vec2 eye = p - 0.055 * gaze, pupil = vec2(p.x < 0.0 ? -eye.x : eye.x, eye.y);
    c = over(c, dark, oval(pupil, vec2(0.165, 0.125), vec2(0.082, 0.12 * open)));
    vec2 glint = vec2(eye.x + (p.x < 0.0 ? 0.33 : 0.0), eye.y);
    c = over(c, vec3(1.0), disc(glint, vec2(0.195, 0.18), 0.036) * (1.0 - place.w));
    c = over(c, fur, place.w * oval(q, vec2(0.175, 0.13), vec2(0.14, 0.03)));
    c = over(c, fur, oval(q, vec2(0.045, -0.125), vec2(0.026, 0.020)));
    float smile = min(oval(p, vec2(0.0, -0.26), vec2(0.225, 0.17)), 1.0 - oval(p, vec2(0.0, -0.17), vec2(0.29, 0.13)));
    return over(c, vec3(0.55, 0.13, 0.11), smile);
}

// A foot on its way round: on the ground it stays behind, in the air it comes forward.
vec2 foot(float cycle, float side) {
    float turn = 6.2831853 * cycle;
    vec2 running = vec2(0.25 * cos(turn), -0.62 + 0.17 * max(0.0, sin(turn)));
    return mix(vec2(0.17 * side, -0.62), running, more.w);
}
vec2 hand(float cycle, float side) {
    float turn = 6.2831853 * cycle;
    return mix(vec2(0.36 * side, -0.40), vec2(0.34 * cos(turn), -0.27 + 0.10 * sin(turn)), more.w);
}

vec4 monkey(vec4 base, vec2 p, vec2 gaze) {
    vec4 c = base;
    float near = more.z, far = near + 0.5;
    vec2 near_foot = foot(near, -1.0), far_foot = foot(far, 1.0);
    vec2 near_hand = hand(far, -1.0), far_hand = hand(near, 1.0);
    c = over(c, 0.8 * fur, limb(p, vec2(0.17, -0.22), far_hand, 0.055));
    c = over(c, 0.85 * skin, disc(p, far_hand, 0.075));
    c = over(c, 0.8 * fur, limb(p, vec2(0.10, -0.40), far_foot, 0.07));
    c = over(c, 0.85 * skin, oval(p, far_foot, vec2(0.125, 0.07)));
    c = over(c, fur, oval(p, vec2(0.0, -0.31), vec2(0.25, 0.24)));
    c = over(c, fur, limb(p, vec2(-0.10, -0.42), near_foot, 0.07));
    c = over(c, skin, oval(p, near_foot, vec2(0.125, 0.07)));
    c = over(c, skin, oval(p, vec2(0.0, -0.34), vec2(0.155, 0.16)));
    const vec2 neck = vec2(0.0, 0.22);
    const float scale = 0.74;
    pixels *= scale;
    c = head(c, (p - neck) / scale, gaze);
    pixels = place.z;
    c = over(c, fur, limb(p, vec2(-0.17, -0.22), near_hand, 0.055));
    return over(c, skin, disc(p, near_hand, 0.075));
}

void main() {
    pixels = place.z;
    vec2 d = (gl_FragCoord.xy - place.xy) / place.z;
    float from_centre = length(d);
    float inside = sharp(from_centre - 1.0);
    vec2 p = vec2(form.x * d.x - form.y * d.y, -form.y * d.x - form.x * d.y);
    float depth = sqrt(max(0.0, 1.0 - from_centre * from_centre));
    float edge = 1.0 - depth;

    // The back of the shell: two halves, meridian stripes, the seam.
    float upper = sharp(-p.y);
    vec3 tint = mix(second_colour.rgb, colour.rgb, upper), other = mix(colour.rgb, second_colour.rgb, upper);
    vec4 c = vec4(tint, 1.0) * mix(0.62, 1.0, edge * edge);
    float around = abs(p.x) / max(sqrt(max(0.0, 1.0 - p.y * p.y)), 0.05);
    float stripe = sharp((abs(around - 0.80) - 0.085) * max(depth, 0.25)) * 0.9;
    c = over(c, mix(tint, other, 0.8), stripe);
    c = over(c, tint * 0.45, sharp(abs(p.y) - 0.105) * 0.8);
    c = over(c, vec3(1.0, 0.97, 0.88), sharp(abs(p.y) - 0.065));

    vec2 m = vec2(more.x * d.x - more.y * d.y, -more.y * d.x - more.x * d.y);
    vec2 looks = 2.0 * vec2(colour.a, second_colour.a) - 1.0;
    vec2 gaze = vec2(more.x * looks.x - more.y * looks.y, -more.y * looks.x - more.x * looks.y);
    c = monkey(c, m, gaze);

    // The front of it, seen through: the same halves and stripes, going the same way round.
    c = over(c, tint, 0.26 + 0.30 * edge * edge);
    c = over(c, other, 0.35 * stripe);
    c = over(c, tint * 0.45, 0.22 * sharp(abs(p.y) - 0.105));
    c = over(c, vec3(1.0, 0.97, 0.88), 0.34 * sharp(abs(p.y) - 0.065));
    float stud = length(vec2(abs(p.x) - 0.88, p.y));
    c = over(c, vec3(0.98, 0.74, 0.22), sharp(stud - 0.062));

    // Glass: shade away from the light, glow where the light leaves, two highlights that stay with the light.
    vec3 normal = vec3(d, depth), light = normalize(vec3(form.zw, 0.75));
    float lit = dot(normal, light);
    c.rgb *= 0.74 + 0.32 * clamp(lit * 0.75 + 0.35, 0.0, 1.0);
    float leaving = clamp(-dot(d, normalize(form.zw)), 0.0, 1.0) * edge;
    c.rgb += tint * 0.30 * leaving * leaving * c.a;
    float outline = smoothstep(1.0 - max(0.075, 1.6 / place.z), 1.0, from_centre);
    c = mix(c, vec4(tint * 0.32, 1.0), outline * 0.75);
    float mirror = max(dot(normal, normalize(light + vec3(0.0, 0.0, 1.0))), 0.0);
    float m2 = mirror * mirror, m4 = m2 * m2, m8 = m4 * m4, m16 = m8 * m8, m32 = m16 * m16;
    vec2 gleam = vec2(dot(d, normalize(form.zw)), dot(d, normalize(vec2(-form.w, form.z))));
    float window = 1.0 - smoothstep(0.75, 1.0, length((gleam - vec2(0.70, 0.0)) / vec2(0.11, 0.30)));
    c = over(c, vec3(1.0), clamp(0.16 * m16 + 0.30 * m32 * m32 + 0.72 * window, 0.0, 0.92));
    pixel = c * inside;
}
)";

}  // namespace screen::shaders
