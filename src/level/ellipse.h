// Elliptical arcs: from SVG's end points and flags to a centre and two axes, and circles among them.
#pragma once

#include "geometry/biarc.h"
#include "level/svg_path.h"
#include "level/transform.h"

namespace level {

// SVG 1.1 appendix F.6.5; radii too small for the chord grow until they reach (F.6.6). The radii are positive and the
// end points differ.
geometry::EllipticArc elliptical_arc(Vec2 const& start, ArcTo const& arc);

geometry::EllipticArc mapped(Affine const& map, geometry::EllipticArc const& arc);

bool is_circular(geometry::EllipticArc const& arc);

enum class Way { shorter, longer };
enum class Turn { left, right };  // counter-clockwise, clockwise

// The circular arc between two points; a radius that does not reach is half their distance.
geometry::Arc arc_between(Vec2 const& start, Vec2 const& end, double radius, Way way, Turn turn);

}  // namespace level
