#include "level/level.h"

#include <algorithm>
#include <stdexcept>

#include "level/check.h"
#include "level/reading.h"

namespace level {

Level read_level(std::string const& file) {
    Reading reading = reading_of(file);
    for (Finding const& finding : reading.report.by_line())
        if (finding.fault) throw std::runtime_error(file + ":" + std::to_string(finding.line) + ": " + finding.text);
    reading.level.misspellings = reading.report.misspellings();
    return std::move(reading.level);
}

Checked checked_level(std::string const& file) {
    Reading reading = reading_of(file);
    if (reading.in_place) add_suspicions(reading);
    Checked checked{reading.report.by_line(), std::nullopt};
    bool const is_sound = std::none_of(checked.findings.begin(), checked.findings.end(),
                                       [](Finding const& finding) { return finding.fault; });
    if (is_sound) checked.level = std::move(reading.level);
    return checked;
}

}  // namespace level
