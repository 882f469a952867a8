// Which points closed lines enclose, where they go round some more than once: SVG's two rules.
#pragma once

namespace geometry {

enum class FillRule { even_odd, nonzero };

}  // namespace geometry
