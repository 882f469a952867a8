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

// Text in words at white space, found one by one: a list of them may be larger than the text.
class Words {
public:
    class Iterator {
    public:
        explicit Iterator(std::string_view rest);
        std::string_view operator*() const { return word_; }
        Iterator& operator++();
        bool operator!=(Iterator const& other) const { return word_.data() != other.word_.data(); }

    private:
        std::string_view word_, rest_;  // both without data at the end
    };
    explicit Words(std::string_view text) : text_(text) {}
    Iterator begin() const { return Iterator(text_); }
    Iterator end() const { return Iterator({}); }

private:
    std::string_view text_;
};
inline Words words_of(std::string_view text) { return Words(text); }
std::vector<std::string_view> word_list(std::string_view text);

}  // namespace level
