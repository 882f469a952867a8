// File names for frames, from a pattern such as frames/%05d.png.
#pragma once

#include <optional>
#include <string>

namespace app {

class FrameNames {
public:
    // A pattern has at most one conversion, %d with an optional 0 and width; %% is a percent sign. Throws UsageError.
    explicit FrameNames(std::string const& pattern);

    bool has_number() const { return has_number_; }
    bool numbers_folders() const { return after_.find('/') != std::string::npos; }
    std::string name_of(long long number) const;
    // The frame whose file bears this name; its folder is not compared.
    std::optional<long long> number_in(std::string const& name) const;

private:
    std::string before_, after_;
    bool has_number_ = false;
    bool zeros_ = false;
    std::size_t width_ = 0;
};

}  // namespace app
