// Numbers in attributes, path data and transform lists, in the same notation wherever the program runs.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace level {

// Walks over text that consists of numbers, letters and separators.
class Cursor {
public:
    explicit Cursor(std::string_view text) : text_(text) {}

    bool at_end() const { return at_ >= text_.size(); }
    char peek() const { return at_end() ? '\0' : text_[at_]; }
    char next() { return at_end() ? '\0' : text_[at_++]; }
    std::string_view rest() const { return text_.substr(at_); }

    void skip_spaces();
    void skip_separator();  // spaces with at most one comma among them
    bool begins_number() const;

    // Throws Broken where there is no number or one that is not finite.
    double number();
    std::string_view word();  // letters

private:
    std::string_view text_;
    std::size_t at_ = 0;
};

enum class Syntax { good, not_a_number, not_finite };
struct Parsed {
    double value = 0;
    Syntax syntax = Syntax::good;
};
// The whole text, spaces around it aside, as one number. "inf" and "nan" are not finite.
Parsed parsed_number(std::string_view text);

// Numbers between separators; none where the text holds anything else or one that is not finite.
std::optional<std::vector<double>> parsed_list(std::string_view text);

std::string_view trimmed(std::string_view text);

// Text in words at white space.
std::vector<std::string_view> words_of(std::string_view text);

}  // namespace level
