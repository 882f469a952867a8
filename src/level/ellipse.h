// Elliptical arcs: from SVG's end points and flags to a centre and two axes, and circles among them.
#pragma once

#include "geometry/curve.h"
#include "level/svg_path.h"
#include "level/transform.h"

namespace level {

// centre + cosine_axis cos t + sine_axis sin t, for t from `from` to from + sweep. The axes are conjugate half
// diameters: they need not be at right angles.
struct EllipticalArc {
    Vec2 centre = Vec2::Zero();
    Vec2 cosine_axis = Vec2::UnitX(), sine_axis = Vec2::UnitY();
    double from = 0, sweep = 0;  // rad
};

// SVG 1.1 appendix F.6.5; radii too small for the chord grow until they reach (F.6.6). The radii are positive and the
// end points differ.
EllipticalArc elliptical_arc(Vec2 const& start, ArcTo const& arc);

EllipticalArc mapped(Affine const& map, EllipticalArc const& arc);

bool is_circular(EllipticalArc const& arc);

enum class Way { shorter, longer };
enum class Turn { left, right };  // counter-clockwise, clockwise

// The circular arc between two points; a radius that does not reach is half their distance.
geometry::Arc arc_between(Vec2 const& start, Vec2 const& end, double radius, Way way, Turn turn);

}  // namespace level
