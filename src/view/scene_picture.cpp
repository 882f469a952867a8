#include "view/scene_picture.h"

#include <cmath>
#include <utility>

#include "view/actors.h"
#include "view/backdrop.h"
#include "view/effects.h"
#include "view/ending.h"
#include "view/hud.h"

namespace view {

namespace {

constexpr double ground_margin = 0.5;  // m: grass and signs are drawn beyond the place that they stand at

void append(std::vector<Shape>& shapes, std::vector<Shape> more) {
    for (Shape& shape : more) shapes.emplace_back(std::move(shape));
}

}  // namespace

Stage stage_of(std::shared_ptr<level::Level const> level) {
    LazyGround ground(*level);
    return {std::move(level), std::move(ground)};
}

Picture picture_of(Stage const& stage, Moment const& moment, Camera const& camera, Dressing const& dressing) {
    level::Level const& level = *stage.level;
    Picture picture;
    picture.width = static_cast<int>(std::lround(camera.size.x()));
    picture.height = static_cast<int>(std::lround(camera.size.y()));
    Ground const ground = stage.ground.within(geometry::grown(sight_of(camera), ground_margin));
    picture.backdrop = backdrop_shapes(level, ground, camera);
    picture.backdrop_key = backdrop_key_of(level, camera);
    std::vector<Shape>& shapes = picture.shapes;
    bool const is_high = dressing.contrast == Contrast::high;
    if (is_high) append(shapes, terrain_outlines(level.scene.terrain, camera));
    append(shapes, goal_shapes(level, moment, camera));
    append(shapes, banana_shapes(level, moment, camera));
    append(shapes, shadow_shapes(level, moment, camera));
    for (TrajectoryPreview const& preview : moment.coming) {
        std::vector<Shape> way = trajectory_shapes(preview, camera);
        append(shapes, is_high && preview.premise == Premise::held ? dashed(std::move(way)) : std::move(way));
    }
    append(shapes, is_high ? in_high_contrast(dressing.ghosts) : dressing.ghosts);
    bool const moves = dressing.motion == Motion::full;
    if (moves) append(shapes, trail_shapes(level, moment, camera));
    if (moves) append(shapes, dust_shapes(moment, camera));
    append(shapes, ball_shapes(level, moment, camera, dressing.pointer));
    if (moves) append(shapes, spark_shapes(moment, camera));
    if (is_high) append(shapes, actor_outlines(level, moment, camera));
    append(shapes, pick_shapes(level, moment, camera));
    append(shapes, spring_shapes(level, moment, camera));
    std::vector<Shape> overlays = overlay_shapes(level, moment, camera, dressing.overlays, dressing.ending.language);
    append(shapes, is_high ? in_high_contrast(std::move(overlays), Hue::kept) : std::move(overlays));
    if (dressing.lettering == Lettering::none) return picture;
    auto const append_written = [&](std::vector<Shape> more) {
        append(shapes, is_high ? in_high_contrast(std::move(more)) : std::move(more));
    };
    append_written(heading_shapes(level, moment, camera.size));
    append_written(tilt_shapes(level, moment.forces.tilt, camera.size));
    if (dressing.lettering == Lettering::heading) return picture;
    append_written(ending_shapes(level, moment, camera.size, dressing.ending));
    return picture;
}

}  // namespace view
