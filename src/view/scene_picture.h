// What a level looks like at one moment: the whole picture, as data.
#pragma once

#include <memory>
#include <vector>

#include "view/camera.h"
#include "view/contrast.h"
#include "view/ending.h"
#include "view/ground.h"
#include "view/moment.h"
#include "view/overlay.h"
#include "view/picture.h"

namespace view {

// A level made ready for pictures: what its look needs and no camera changes is found once.
struct Stage {
    std::shared_ptr<level::Level const> level;
    LazyGround ground;
};
Stage stage_of(std::shared_ptr<level::Level const> level);

// heading: no card at the end, which would shine through what lies over it; none: the scene alone, behind the title.
enum class Lettering { game, heading, none };
struct Dressing {
    Overlays overlays;
    EndingNote ending;
    Lettering lettering = Lettering::game;
    std::optional<Vec2> pointer;  // pixels, the window's own: the player's monkey looks there
    std::vector<Shape> ghosts;    // pixels, the window's own: behind the balls, that none is paler for its ghost
    Motion motion = Motion::full;
    Contrast contrast = Contrast::usual;
};

// The same arguments give the same picture, shape by shape.
Picture picture_of(Stage const& stage, Moment const& moment, Camera const& camera, Dressing const& dressing = {});

}  // namespace view
