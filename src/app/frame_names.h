// File names for frames, from a pattern such as frames/%05d.png.
#pragma once

#include <string>

namespace app {

class FrameNames {
public:
    // A pattern has at most one conversion, %d with an optional 0 and width; %% is a percent sign. Throws UsageError.
    explicit FrameNames(std::string const& pattern);

    bool has_number() const { return has_number_; }
    std::string name_of(long long number) const;

private:
    std::string before_, after_;
    bool has_number_ = false;
    bool zeros_ = false;
    std::size_t width_ = 0;
};

}  // namespace app
