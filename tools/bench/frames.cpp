// How long a frame takes: shipped runs drawn off the screen, frame by frame, at 1280x720 on one thread.
// usage: frames RUN...    a line each and one for all: median, 99th percentile and worst, ms; what of it is not
// painting
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "game/method_choice.h"
#include "game/run_file.h"
#include "screen/offscreen.h"
#include "view/scene_picture.h"
#include "view/turning.h"

namespace {

constexpr int stride = 7;  // frames

double processor_milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Costs {
    std::vector<double> whole, laid_out;  // ms by frame: all of it, and until the picture is ready to be painted
};

void append(Costs& costs, Costs const& more) {
    costs.whole.insert(costs.whole.end(), more.whole.begin(), more.whole.end());
    costs.laid_out.insert(costs.laid_out.end(), more.laid_out.begin(), more.laid_out.end());
}

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

Costs costs_of(std::string const& file) {
    game::Run const run = game::read_run(file);
    auto const level = std::make_shared<level::Level const>(level::read_level(run.level_file));
    view::Stage const stage = view::stage_of(level);
    game::Session session =
        game::session_of(level, game::method_for({run.method_name, run.rate}, level->scene), run.inputs);
    screen::Offscreen offscreen;
    Costs costs;
    double const end = run.duration.value_or(10);
    for (int frame = 0; frame / 60.0 < end; frame += stride) {
        double const start = processor_milliseconds();
        double const time = frame / 60.0;
        game::advance(session, time);
        view::Moment const moment = view::moment_of(session, time, view::Recall::nothing);
        view::Picture const picture =
            view::picture_of(stage, moment, view::camera_of(session, time, view::Vec2(1280, 720)));
        double const laid_out = processor_milliseconds() - start;
        offscreen.paint(picture);
        if (frame == 0) continue;  // which compiles the programs
        costs.whole.push_back(processor_milliseconds() - start);
        costs.laid_out.push_back(laid_out);
    }
    return costs;
}

void tell(std::string const& name, Costs const& costs) {
    std::printf("%-24s %6zu  %6.2f %6.2f %6.2f   %6.2f\n", name.c_str(), costs.whole.size(), quantile(costs.whole, 0.5),
                quantile(costs.whole, 0.99), quantile(costs.whole, 1), quantile(costs.laid_out, 0.5));
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    Costs all;
    std::printf("%-24s %6s  %6s %6s %6s   %6s\n", "run", "frames", "median", "99 %", "worst", "layout");
    for (int i = 1; i < argc; ++i) {
        Costs const costs = costs_of(argv[i]);
        if (costs.whole.empty()) continue;
        tell(std::filesystem::path(argv[i]).stem().string(), costs);
        append(all, costs);
    }
    if (!all.whole.empty()) tell("all", all);
}
