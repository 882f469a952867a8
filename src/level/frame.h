// The root of a drawing: its box, its scale, and the settings of the whole level.
#pragma once

#include <optional>

#include "level/attributes.h"
#include "level/document.h"
#include "level/reading.h"
#include "level/transform.h"

namespace level {

struct Frame {
    Affine to_world;           // from the drawing's units, y down, to metres, y up
    Vec2 size = Vec2::Zero();  // m
    ReferenceBox view_box;     // in the drawing's units; its corner is their origin, as SVG has it
};

// None where the root says neither viewBox nor width and height; reported.
std::optional<Frame> frame_of(Document const& document, Report& report);

// Gravity, limits and drag from the root's attributes, the title from its title element.
void read_settings(Document const& document, Reading& reading);

}  // namespace level
