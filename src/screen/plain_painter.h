// Pictures painted by plain loops, ready at once and without OpenGL: for the first moments, until a renderer is there.
#pragma once

#include <optional>

#include "screen/glyphs.h"
#include "screen/painter.h"
#include "screen/pixels.h"

namespace screen {

// What Painter paints, to the eye: ground has no grain, and of the ball only what tells it from others.
class PlainPainter {
public:
    explicit PlainPainter(ChannelOrder order) : order_(order) {}

    // Throws std::runtime_error when the picture's size cannot be painted, or a font is missing. What comes back holds
    // until the next call.
    Pixels const& paint(view::Picture const& picture);

private:
    void add(view::Sky const& sky);
    void add(view::Area const& area);
    void add(view::Disc const& disc);
    void add(view::Stroke const& stroke);
    void add(view::ArcStroke const& arc);
    void add(view::Shell const& shell);
    void add(view::Panel const& panel);
    void add(view::Label const& label);

    // One row of one colour, clipped; to the right of `right` excluded.
    void fill_row(int y, int left, int right, view::Colour const& colour);
    // Over what is there; coverage 0 to 1, within the frame.
    void blend(int x, int y, view::Colour const& colour, double coverage);
    // coverage(pixel's middle) for all pixels of a box, clipped.
    template <class Coverage>
    void blend_box(view::Vec2 const& low, view::Vec2 const& high, view::Colour const& colour, Coverage const& coverage);

    ChannelOrder order_;
    Pixels pixels_;
    std::optional<Glyphs> glyphs_;
};

}  // namespace screen
