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
layout(location = 6) in vec4 axes_in;
uniform vec2 frame_size;
flat out vec4 place, form, colour, second_colour, axes;
void main() {
    vec4 pair = gl_VertexID < 2 ? first_corners : last_corners;
    vec2 corner = (gl_VertexID & 1) == 0 ? pair.xy : pair.zw;
    gl_Position = vec4(corner / frame_size * 2.0 - 1.0, 0.0, 1.0);
    place = place_in;
    form = form_in;
    colour = colour_in;
    second_colour = second_colour_in;
    axes = axes_in;
}
)";

// What all fragment shaders begin with. Colours are blended with their alpha multiplied in.
inline constexpr char const* fragment_head = R"(#version 330 core
flat in vec4 place, form, colour, second_colour, axes;
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

// All areas and the sky. axes: the way down; place: the world's origin along right and down, in pixels, tiles of grain
// a pixel, level of detail; form: upper and lower end of the gradient along down, strength of the grain, number of the
// edge tile in its atlas.
inline constexpr char const* area = R"(
uniform sampler2D coverage, grain;
vec4 smooth_paint() {
    return mix(colour, second_colour, clamp((dot(gl_FragCoord.xy, axes.xy) - form.x) / (form.y - form.x), 0.0, 1.0));
}
vec4 grained_paint() {
    vec4 paint = smooth_paint();
    vec2 texel = (vec2(dot(gl_FragCoord.xy, vec2(axes.y, -axes.x)), dot(gl_FragCoord.xy, axes.xy)) - place.xy) * place.z;
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

// The ball. place: centre, radius, size of a pixel in radii; form: cosine and sine of its angle, direction of the
// light. Its own x runs to the monkey's left ear, its own y up, its rim is at 1.
inline constexpr char const* shell = R"(
float sharp(float distance) { return clamp(0.5 - distance / place.w, 0.0, 1.0); }
float disc(vec2 p, vec2 centre, float radius) { return sharp(length(p - centre) - radius); }
float oval(vec2 p, vec2 centre, vec2 radii) {
    vec2 q = (p - centre) / radii;
    return sharp((length(q) - 1.0) * min(radii.x, radii.y));
}
vec4 over(vec4 under, vec3 top, float amount) { return mix(under, vec4(top, 1.0), amount); }

vec4 monkey(vec4 base, vec2 p) {
    const vec3 fur = vec3(0.43, 0.25, 0.13), skin = vec3(0.99, 0.83, 0.63), dark = vec3(0.13, 0.07, 0.05);
    vec2 q = vec2(abs(p.x), p.y);
    vec4 c = over(base, fur, max(disc(q, vec2(0.58, 0.06), 0.185), disc(p, vec2(0.0, 0.02), 0.56)));
    c = over(c, fur, oval(p, vec2(0.0, 0.55), vec2(0.10, 0.16)));
    c = over(c, vec3(0.93, 0.62, 0.50), disc(q, vec2(0.595, 0.055), 0.105));
    float face = max(oval(q, vec2(0.19, 0.11), vec2(0.245, 0.28)), oval(p, vec2(0.0, -0.22), vec2(0.42, 0.28)));
    c = over(c, skin, face);
    c = over(c, vec3(0.99, 0.60, 0.48), 0.55 * oval(q, vec2(0.31, -0.17), vec2(0.10, 0.07)));
    c = over(c, vec3(1.0), oval(q, vec2(0.175, 0.14), vec2(0.125, 0.165)));
    c = over(c, dark, oval(q, vec2(0.155, 0.12), vec2(0.082, 0.12)));
    c = over(c, vec3(1.0), disc(vec2(p.x + (p.x < 0.0 ? 0.32 : 0.0), p.y), vec2(0.185, 0.175), 0.036));
    c = over(c, fur, oval(q, vec2(0.045, -0.125), vec2(0.026, 0.020)));
    float smile = min(oval(p, vec2(0.0, -0.26), vec2(0.225, 0.17)), 1.0 - oval(p, vec2(0.0, -0.17), vec2(0.29, 0.13)));
    return over(c, vec3(0.55, 0.13, 0.11), smile);
}

void main() {
    vec2 d = (gl_FragCoord.xy - place.xy) / place.z;
    float from_centre = length(d);
    float inside = sharp(from_centre - 1.0);
    vec2 p = vec2(form.x * d.x - form.y * d.y, -form.y * d.x - form.x * d.y);
    float depth = sqrt(max(0.0, 1.0 - from_centre * from_centre));
    float edge = 1.0 - depth;

    // The back of the shell: two halves, meridian stripes, the seam.
    float upper = sharp(-p.y);
    vec3 tint = mix(second_colour.rgb, colour.rgb, upper);
    vec4 c = vec4(tint, 1.0) * mix(0.62, 1.0, edge * edge);
    float around = abs(p.x) / max(sqrt(max(0.0, 1.0 - p.y * p.y)), 0.05);
    float stripe = sharp((abs(around - 0.80) - 0.085) * max(depth, 0.25)) * 0.9;
    c = over(c, mix(tint, mix(colour.rgb, second_colour.rgb, upper), 0.8), stripe);
    c = over(c, tint * 0.45, sharp(abs(p.y) - 0.105) * 0.8);
    c = over(c, vec3(1.0, 0.97, 0.88), sharp(abs(p.y) - 0.065));
    float stud = length(vec2(abs(p.x) - 0.88, p.y));
    c = over(c, vec3(0.98, 0.74, 0.22), sharp(stud - 0.062));

    c = monkey(c, p);
    c.rgb = mix(c.rgb, tint * c.a, 0.10 + 0.45 * edge * edge);

    // Glass: shade away from the light, glow where the light leaves, two highlights that stay with the light.
    vec3 normal = vec3(d, depth), light = normalize(vec3(form.zw, 0.75));
    float lit = dot(normal, light);
    c.rgb *= 0.74 + 0.32 * clamp(lit * 0.75 + 0.35, 0.0, 1.0);
    float leaving = clamp(-dot(d, normalize(form.zw)), 0.0, 1.0) * edge;
    c.rgb += tint * 0.30 * leaving * leaving * c.a;
    float outline = smoothstep(1.0 - max(0.075, 1.6 * place.w), 1.0, from_centre);
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
