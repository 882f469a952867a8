#include "app/frame_names.h"

#include <charconv>
#include <filesystem>

#include "app/command.h"

namespace app {

namespace {

constexpr std::size_t widest = 100;

}  // namespace

FrameNames::FrameNames(std::string const& pattern) {
    auto const refuse = [&](char const* why) { throw UsageError("--output: \"" + pattern + "\": " + why); };
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        std::string& text = has_number_ ? after_ : before_;
        if (pattern[i] != '%') {
            text += pattern[i];
        } else if (i + 1 < pattern.size() && pattern[i + 1] == '%') {
            text += pattern[i++];
        } else {
            if (has_number_) refuse("has more than one number");
            has_number_ = true;
            if (i + 1 < pattern.size() && pattern[i + 1] == '0') zeros_ = ++i > 0;
            while (i + 1 < pattern.size() && pattern[i + 1] >= '0' && pattern[i + 1] <= '9' && width_ <= widest)
                width_ = width_ * 10 + static_cast<std::size_t>(pattern[++i] - '0');
            if (width_ > widest) refuse("is too wide a number");
            if (i + 1 >= pattern.size() || (pattern[i + 1] != 'd' && pattern[i + 1] != 'i'))
                refuse("after % must come a whole number's conversion such as 05d");
            ++i;
        }
    }
}

std::string FrameNames::name_of(long long number) const {
    if (!has_number_) return before_;
    std::string digits = std::to_string(number);
    if (digits.size() < width_) digits.insert(0, width_ - digits.size(), zeros_ ? '0' : ' ');
    return before_ + digits + after_;
}

std::optional<long long> FrameNames::number_in(std::string const& name) const {
    std::string const file = std::filesystem::path(name).filename().string();
    std::string const lead = before_.substr(before_.rfind('/') + 1);
    if (file.size() <= lead.size() + after_.size()) return std::nullopt;
    std::string const digits = file.substr(lead.size(), file.size() - lead.size() - after_.size());
    std::size_t const first = digits.find_first_not_of(' ');
    long long number = 0;
    if (first == std::string::npos) return std::nullopt;
    char const* const end = digits.data() + digits.size();
    auto const [stopped, error] = std::from_chars(digits.data() + first, end, number);
    if (error != std::errc{} || stopped != end) return std::nullopt;
    bool const is_same = std::filesystem::path(name_of(number)).filename() == file;
    return is_same ? std::optional(number) : std::nullopt;
}

}  // namespace app
