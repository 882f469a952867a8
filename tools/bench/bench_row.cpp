#include "bench_row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bench {

namespace {

constexpr double wanted[] = {16.0 / 1280, 1e-6, 1e-10};  // m; the first is a pixel of a level 16 m wide at 1280

std::vector<std::string> scenes_of(std::vector<Row> const& rows) {
    std::vector<std::string> scenes;
    for (Row const& row : rows)
        if (scenes.empty() || scenes.back() != row.scene) scenes.push_back(row.scene);
    return scenes;
}

std::vector<std::string> engines_in(std::vector<Row> const& rows) {
    std::vector<std::string> engines;
    for (Row const& row : rows)
        if (std::find(engines.begin(), engines.end(), engine_of(row.contestant)) == engines.end())
            engines.push_back(engine_of(row.contestant));
    return engines;
}

bool is_chords_in_place_of_an_arc(Row const& row) { return row.contestant.method == "exact on pieces"; }

void write_or_never(double cost, std::ostream& to) { std::isinf(cost) ? to << "\tnever" : to << '\t' << cost; }

// Nothing when the table has no such row.
template <typename Condition>
Row const* first_row(std::vector<Row> const& rows, std::string const& scene, Condition const& condition) {
    auto const row = std::find_if(rows.begin(), rows.end(), [&](Row const& candidate) {
        return candidate.scene == scene && condition(candidate);
    });
    return row == rows.end() ? nullptr : &*row;
}

}  // namespace

std::string engine_of(Contestant const& contestant) {
    return contestant.method.substr(0, contestant.method.find(" on "));
}

void mark_the_best(std::vector<Row>& rows) {
    for (std::string const& scene : scenes_of(rows))
        for (std::string const& engine : engines_in(rows)) {
            Row* best = nullptr;
            for (Row& row : rows) {
                if (row.scene != scene || engine_of(row.contestant) != engine || std::isnan(row.errors.median))
                    continue;
                if (!best || std::make_pair(row.errors.median, row.costs.sampled) <
                                 std::make_pair(best->errors.median, best->costs.sampled))
                    best = &row;
            }
            if (best) best->best = true;
        }
}

void write_rows(std::vector<Row> const& rows, std::ostream& to) {
    to << "# errors in m over the jittered starts (nan: failed), costs in ns per simulated second\n"
       << "# scene\tmethod\tsetting\trate\trecommended\tmedian\tp95\tfailed\tsampled\tunsampled\tbest\n";
    for (Row const& row : rows)
        to << row.scene << '\t' << row.contestant.method << '\t' << row.contestant.setting << '\t'
           << row.contestant.rate << '\t' << row.contestant.recommended << '\t' << row.errors.median << '\t'
           << row.errors.high << '\t' << row.errors.failed << '\t' << row.costs.sampled << '\t' << row.costs.unsampled
           << '\t' << row.best << '\n';
}

void write_reach(std::vector<Row> const& rows, std::ostream& to) {
    to << "# ns per simulated second sampled at 60 Hz, to be within so many metres in 95 % of the starts\n"
       << "# scene\tmethod\t" << wanted[0] << '\t' << wanted[1] << '\t' << wanted[2] << '\n';
    for (std::string const& scene : scenes_of(rows))
        for (std::string const& engine : engines_in(rows)) {
            std::array<double, 3> least;
            least.fill(INFINITY);
            for (Row const& row : rows) {
                if (row.scene != scene || engine_of(row.contestant) != engine || is_chords_in_place_of_an_arc(row))
                    continue;
                for (int i = 0; i < 3; ++i)
                    if (row.errors.high <= wanted[i]) least[i] = std::min(least[i], row.costs.sampled);
            }
            to << scene << '\t' << engine;
            for (double const cost : least) write_or_never(cost, to);
            to << '\n';
        }
}

void write_front(std::vector<Row> const& rows, std::ostream& to) {
    to << "# what nobody beats in both: median error in m, cost in ns per simulated second sampled at 60 Hz\n"
       << "# scene\tmethod\tsetting\tmedian\tsampled\n";
    constexpr double beyond = 1e12;
    for (std::string const& scene : scenes_of(rows)) {
        std::vector<Row const*> front;
        for (Row const& row : rows)
            if (row.scene == scene && std::isfinite(row.errors.median)) front.push_back(&row);
        std::sort(front.begin(), front.end(), [](Row const* a, Row const* b) {
            return std::make_pair(a->errors.median, a->costs.sampled) <
                   std::make_pair(b->errors.median, b->costs.sampled);
        });
        if (front.empty()) continue;
        to << scene << "\t-\t-\t" << front.front()->errors.median << '\t' << beyond << '\n';
        double cheapest = INFINITY;
        for (Row const* const row : front) {
            if (!(row->costs.sampled < cheapest)) continue;
            cheapest = row->costs.sampled;
            to << scene << '\t' << row->contestant.method << '\t' << row->contestant.setting << '\t'
               << row->errors.median << '\t' << cheapest << '\n';
        }
        to << scene << "\t-\t-\t" << beyond << '\t' << cheapest << "\n\n";
    }
}

namespace {

constexpr double rounding = 1e-11;  // m: errors below are of rounding, not of the step
constexpr std::size_t fewest = 3;   // points that make a slope

// Least squares; not a number for too few points.
double slope_of(std::vector<std::pair<double, double>> const& points) {
    if (points.size() < fewest) return std::numeric_limits<double>::quiet_NaN();
    double x = 0, y = 0, xx = 0, xy = 0;
    for (auto const& [step, error] : points) {
        x += std::log(step), y += std::log(error);
        xx += std::log(step) * std::log(step), xy += std::log(step) * std::log(error);
    }
    double const n = static_cast<double>(points.size());
    return (n * xy - x * y) / (n * xx - x * x);
}

std::vector<std::string> stepping_methods() {
    std::vector<std::string> methods{"steps", "euler", "article"};
    for (Peer const& peer : known_peers()) methods.push_back(peer.name);
    return methods;
}

}  // namespace

void write_orders(std::vector<Row> const& rows, std::ostream& to) {
    to << "# slope of log(median error) against log(step), rounding and failures left out; the finest of its points\n"
       << "# scene\tmethod\torder\tstep\terror\n";
    for (std::string const& scene : scenes_of(rows))
        for (std::string const& method : stepping_methods()) {
            std::vector<std::pair<double, double>> points;
            for (Row const& row : rows)
                if (row.scene == scene && row.contestant.method == method && row.errors.median > rounding)
                    points.emplace_back(1 / row.contestant.rate, row.errors.median);
            double const slope = slope_of(points);
            if (std::isfinite(slope))
                to << scene << '\t' << method << '\t' << slope << '\t' << points.back().first << '\t'
                   << points.back().second << '\n';
        }
}

void write_against_peers(std::vector<Row> const& rows, std::ostream& to) {
    to << "# how many times cheaper the exact method is: than the peer as its makers advise, asked 60 times a second "
          "and\n"
       << "# asked once; and than the peer at its least error (nan: fails at every setting), asked 60 times; errors in "
          "m\n"
       << "# scene\tpeer\tadvised\tonce\tbest\texact error\tadvised error\tbest error\tbest setting\n";
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (std::string const& scene : scenes_of(rows))
        for (Peer const& engine : known_peers()) {
            std::string const& peer = engine.name;
            Row const* const exact =
                first_row(rows, scene, [](Row const& row) { return row.contestant.method == "exact"; });
            Row const* const advised = first_row(rows, scene, [&](Row const& row) {
                return row.contestant.method == peer && row.contestant.recommended;
            });
            Row const* const best =
                first_row(rows, scene, [&](Row const& row) { return engine_of(row.contestant) == peer && row.best; });
            if (!exact || !advised) continue;
            to << scene << '\t' << peer << '\t' << advised->costs.sampled / exact->costs.sampled << '\t'
               << advised->costs.unsampled / exact->costs.unsampled << '\t'
               << (best ? best->costs.sampled / exact->costs.sampled : none) << '\t' << exact->errors.median << '\t'
               << advised->errors.median << '\t' << (best ? best->errors.median : none) << '\t'
               << (best ? best->contestant.setting : "none") << '\n';
        }
}

}  // namespace bench
