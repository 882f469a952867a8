#include "view/ground.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include "view/surface_look.h"
#include "view/surface_signs.h"

namespace view {

namespace {

constexpr double turf_depth = 0.17;                                        // m, where the ground is level
constexpr double rim_depth = 0.05, shade_depth = 0.22, lit_depth = 0.045;  // m

double smooth_step(double low, double high, double x) {
    double const t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// Fixed to the place, so that the grass does not crawl: a number in [0, 1).
double noise_at(double x, double y, double salt) {
    double const wave = std::sin(x * 12.9898 + y * 78.233 + salt * 37.719) * 43758.5453;
    return wave - std::floor(wave);
}

Patch patch_of(std::vector<Ring> rings, Cover cover) {
    Patch patch{std::move(rings), {}, cover};
    for (Ring const& ring : patch.rings) patch.box = geometry::united(patch.box, box_of_ring(ring));
    return patch;
}

// Bands are painted piece by piece, so that no piece covers much of a picture and those out of sight are left out.
constexpr std::size_t band_piece = 32;  // edges

// The pieces of a band along points that are an open line. `overlap` edges are shared by neighbours, so that no seam
// is seen where the paint is opaque.
void add_band(Ground& ground, Cover cover, Ring const& points, std::vector<Vec2> const& into,
              std::function<double(std::size_t)> const& width) {
    std::size_t const overlap = cover == Cover::shade ? 0 : 1;
    for (std::size_t first = 0; first + 1 < points.size(); first += band_piece) {
        std::size_t const end = std::min(first + band_piece + overlap + 1, points.size());
        std::span const piece = std::span(points).subspan(first, end - first);
        std::span const ways = std::span(into).subspan(first, end - first);
        auto const shifted = [&](std::size_t i) { return width(first + i); };
        ground.patches.push_back(patch_of(band_along(piece, ways, Closing::open, shifted), cover));
    }
}

// Along all of the edge: shade, and the rim over it.
void add_edge_bands(Ground& ground, Body const& body) {
    std::size_t const count = body.edge.size() + (body.closing == Closing::closed ? 1 : 0);
    Ring points(count);
    std::vector<Vec2> into(count);
    for (std::size_t i = 0; i < count; ++i) {
        points[i] = body.edge[i % body.edge.size()];
        into[i] = body.into[i % body.edge.size()];
    }
    double const shade = std::min(shade_depth, 0.5 * body.girth), rim = std::min(rim_depth, 0.25 * body.girth);
    add_band(ground, Cover::shade, points, into, [shade](std::size_t) { return shade; });
    add_band(ground, Cover::rim, points, into, [rim](std::size_t) { return rim; });
}

// Edge i runs from point i to the next; its unit normal into the earth.
Vec2 into_at_edge(Body const& body, std::size_t i) {
    std::size_t const count = body.edge.size();
    Vec2 const way = body.edge[(i + 1) % count] - body.edge[i % count];
    double const length = geometry::length(way);
    if (length == 0) return Vec2::Zero();
    Vec2 const left = geometry::turned_left(way) / length;
    return geometry::dot(left, body.into[i % count]) >= 0 ? left : Vec2(-left);
}

// The runs of edges that are of one kind, as ranges that may pass the end of a closed outline.
using IsOfKind = std::function<bool(std::size_t edge)>;
std::vector<std::pair<std::size_t, std::size_t>> runs_of(Body const& body, IsOfKind const& is_of_kind) {
    bool const closed = body.closing == Closing::closed;
    std::size_t const count = closed ? body.edge.size() : body.edge.size() - 1;
    auto const has = [&](std::size_t i) { return is_of_kind(i % count); };
    std::size_t first = 0;
    if (closed)
        while (first < count && has(first)) ++first;
    std::vector<std::pair<std::size_t, std::size_t>> runs;
    for (std::size_t i = first; i < first + count;) {
        std::size_t end = i;
        while (end < first + count && has(end)) ++end;
        if (end > i) runs.push_back({i, end});
        i = end + 1;
    }
    return runs;
}

bool is_plain(physics::Terrain const& terrain) {
    return std::all_of(terrain.pieces.begin(), terrain.pieces.end(),
                       [](physics::Piece const& piece) { return look_of(piece.material) == SurfaceLook{}; });
}

// By edge: the look of the terrain that lies there.
std::vector<SurfaceLook> looks_along(Body const& body, physics::Terrain const& terrain) {
    std::vector<SurfaceLook> looks;
    constexpr double reach = 0.01;  // m: chords lie so near to what they are chords of
    std::size_t const edges = body.edge.size() - (body.closing == Closing::closed ? 0 : 1);
    for (std::size_t i = 0; i < edges; ++i) {
        Vec2 const middle = (body.edge[i] + body.edge[(i + 1) % body.edge.size()]) / 2;
        double nearest = reach;
        looks.emplace_back();
        terrain.tree.each_overlapping(geometry::grown({middle, middle}, reach), [&](int index) {
            physics::Piece const& piece = terrain.pieces[static_cast<std::size_t>(index)];
            double const distance = geometry::nearest_point(piece.curve, middle).distance;
            if (distance >= nearest) return;
            nearest = distance;
            looks.back() = look_of(piece.material);
        });
    }
    return looks;
}

// A run of the edge, with the ends of its grass upright to it even where the outline turns a corner there.
struct Sward {
    Ring edge;
    std::vector<Vec2> into;
    std::vector<double> up;  // 0 steep to 1 level
};

Sward sward_of(Body const& body, std::pair<std::size_t, std::size_t> run) {
    std::size_t const count = body.edge.size();
    Sward sward;
    for (std::size_t i = run.first; i <= run.second; ++i) {
        sward.edge.push_back(body.edge[i % count]);
        sward.into.push_back(body.into[i % count]);
    }
    sward.into.front() = into_at_edge(body, run.first);
    sward.into.back() = into_at_edge(body, run.second - 1);
    for (Vec2 const& into : sward.into) sward.up.push_back(smooth_step(0.15, 0.8, -into.y() / geometry::length(into)));
    return sward;
}

void add_turf(Ground& ground, Body const& body, std::pair<std::size_t, std::size_t> run) {
    Sward const sward = sward_of(body, run);
    double const depth = std::min(turf_depth, 0.45 * body.girth);
    auto const ragged = [&](std::size_t i) {
        double const wave = 0.75 + 0.5 * noise_at(sward.edge[i].x(), sward.edge[i].y(), 1);
        return depth * (0.25 + 0.75 * sward.up[i]) * wave;
    };
    add_band(ground, Cover::turf, sward.edge, sward.into, ragged);
    double const lit = std::min(lit_depth, 0.2 * body.girth);
    auto const thin = [&](std::size_t i) { return lit * (0.5 + 0.5 * sward.up[i]); };
    add_band(ground, Cover::lit, sward.edge, sward.into, thin);
    for (std::size_t i = 1; i + 1 < sward.edge.size(); ++i) {
        double const luck = noise_at(sward.edge[i].x(), sward.edge[i].y(), 2);
        if (sward.up[i] < 0.7 || body.girth < 0.1 || luck > 0.3) continue;
        int const kind = static_cast<int>(luck * 1000) % 24;
        double const height = 0.06 + 0.09 * noise_at(sward.edge[i].x(), sward.edge[i].y(), 3);
        ground.tufts.push_back({sward.edge[i], -sward.into[i], height, kind});
    }
}

// What is not grass: a band along the run and signs on it, on whatever side of the ground it is.
void add_surface(Ground& ground, Body const& body, std::pair<std::size_t, std::size_t> run, SurfaceLook const& look) {
    Sward const sward = sward_of(body, run);
    double const depth = std::min(turf_depth, 0.45 * body.girth);
    auto const even = [depth](std::size_t) { return depth; };
    if (look.base == Base::ice) add_band(ground, Cover::ice, sward.edge, sward.into, even);
    if (look.base == Base::mud) add_band(ground, Cover::mud, sward.edge, sward.into, even);
    if (look.base == Base::tread) add_band(ground, Cover::tread, sward.edge, sward.into, even);
    if (look.base == Base::grass && look.bouncy) add_band(ground, Cover::rubber, sward.edge, sward.into, even);
    add_signs(ground.marks, {sward.edge, sward.into, depth}, look);
}

// Bands reach into the earth by their depth times the length of `into`, at most 2; marks lie in them.
constexpr double paint_reach = 0.5;  // m

geometry::Box box_of_paint(Body const& body) {
    geometry::Box box = box_of_ring(body.edge);
    for (Ring const& ring : body.rings) box = geometry::united(box, box_of_ring(ring));
    return geometry::grown(box, paint_reach);
}

// Of one body, in the order of its layers.
Ground ground_of(Body const& body, std::vector<SurfaceLook> const& looks) {
    Ground ground;
    if (!body.rings.empty()) ground.patches.push_back(patch_of(body.rings, Cover::earth));
    add_edge_bands(ground, body);
    auto const look_at = [&](std::size_t edge) { return looks.empty() ? SurfaceLook{} : looks[edge]; };
    auto const is_sunny = [&](std::size_t edge) {
        return look_at(edge) == SurfaceLook{} && -into_at_edge(body, edge).y() > 0.2;
    };
    for (std::pair<std::size_t, std::size_t> const& run : runs_of(body, is_sunny)) add_turf(ground, body, run);
    if (looks.empty()) return ground;
    for (Base const base : {Base::grass, Base::ice, Base::mud, Base::tread})
        for (bool const bouncy : {false, true}) {
            SurfaceLook const look{base, bouncy};
            if (look == SurfaceLook{}) continue;
            auto const is_so = [&](std::size_t edge) { return look_at(edge) == look; };
            for (std::pair<std::size_t, std::size_t> const& run : runs_of(body, is_so))
                add_surface(ground, body, run, look);
        }
    return ground;
}

// The earth of all bodies is painted first, then the edges of all, then what grows or lies on them.
constexpr int layers = 3;
int layer_of(Cover cover) {
    if (cover == Cover::earth) return 0;
    return cover == Cover::shade || cover == Cover::rim ? 1 : 2;
}

}  // namespace

LazyGround::LazyGround(level::Level const& level)
    : level_(&level),
      plain_(is_plain(level.scene.terrain)),
      bodies_(bodies_of(level)),
      painted_(std::make_unique<Painted[]>(bodies_.size())) {
    boxes_.reserve(bodies_.size());
    for (Body const& body : bodies_) boxes_.push_back(box_of_paint(body));
}

Ground const& LazyGround::painted(std::size_t body) const {
    Painted& place = painted_[body];
    std::call_once(place.once, [&] {
        auto const looks = plain_ ? std::vector<SurfaceLook>{} : looks_along(bodies_[body], level_->scene.terrain);
        place.ground = std::make_unique<Ground const>(ground_of(bodies_[body], looks));
    });
    return *place.ground;
}

Ground LazyGround::within(geometry::Box const& sight) const {
    std::vector<Ground const*> parts;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        if (geometry::overlap(sight, boxes_[i])) parts.push_back(&painted(i));
    Ground ground;
    for (int layer = 0; layer < layers; ++layer)
        for (Ground const* const part : parts)
            for (Patch const& patch : part->patches)
                if (layer_of(patch.cover) == layer && geometry::overlap(sight, patch.box))
                    ground.patches.push_back(patch);
    for (Ground const* const part : parts) {
        for (Mark const& mark : part->marks)
            if (geometry::overlap(sight, {mark.from, mark.from})) ground.marks.push_back(mark);
        for (Tuft const& tuft : part->tufts)
            if (geometry::overlap(sight, {tuft.root, tuft.root})) ground.tufts.push_back(tuft);
    }
    return ground;
}

Ground ground_of(level::Level const& level) {
    constexpr double everywhere = std::numeric_limits<double>::max();
    return LazyGround(level).within({Vec2::Constant(-everywhere), Vec2::Constant(everywhere)});
}

}  // namespace view
