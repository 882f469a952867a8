// A level as it comes out of its file: the level itself, where each part of it stands, and what was found on the way.
#pragma once

#include <string>
#include <vector>

#include "level/faults.h"
#include "level/level.h"

namespace level {

// The terrain element whose number is its place in Reading::surfaces.
struct Surface {
    int line = 0;
    int first_outline = 0, outlines = 0;  // in Level::outlines
    bool filled = false;                  // it is drawn with its inside painted
    double stroke_width = 0;              // m, as painted by the drawing
};

struct Reading {
    Level level;
    std::vector<Surface> surfaces;
    std::vector<int> ball_lines;    // by ball
    std::vector<int> sensor_lines;  // by sensor, without the last, which is the rim of the world
    Report report;
    bool in_place = true;  // false where a broken transform or frame, or too much of it, leaves open what is where
};

// Throws std::runtime_error where the file cannot be opened; all else that is wrong is in the report.
Reading reading_of(std::string const& file);

}  // namespace level
