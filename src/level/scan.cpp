#include "level/scan.h"

#include "level/faults.h"
#include "level/numbers.h"

namespace level {

namespace {

constexpr auto nowhere = std::string_view::npos;

class Scan {
public:
    explicit Scan(std::string_view text) : text_(text) {}

    std::optional<Objection> objection() {
        if (trimmed(text_).empty()) return Objection{0, "not XML: the file is empty"};
        if (auto const nul = text_.find('\0'); nul != nowhere) return at(nul, "not XML: it holds a NUL byte");
        while (!found_ && at_ < text_.size()) {
            std::size_t const tag = std::min(text_.find('<', at_), text_.size());
            look_at_text(tag);
            at_ = tag;
            if (!found_ && at_ < text_.size()) look_at_markup();
        }
        return found_;
    }

private:
    Objection at(std::size_t offset, std::string what) const {
        return {static_cast<std::ptrdiff_t>(offset), std::move(what)};
    }
    void object(std::size_t offset, std::string what) { found_ = at(offset, std::move(what)); }

    bool comes(std::string_view mark) const { return text_.compare(at_, mark.size(), mark) == 0; }

    void look_at_text(std::size_t end) {
        std::size_t const first = text_.find_first_not_of(" \t\r\n", at_);
        if (depth_ == 0 && first < end)
            object(first, "not XML: text outside the root element: " + quoted(text_.substr(first, end - first)));
    }

    void look_at_markup() {
        if (comes("<!--")) return skip_past("-->", 4, "a comment");
        if (comes("<![CDATA[")) return skip_past("]]>", 9, "a CDATA section");
        if (comes("<?")) return skip_past("?>", 2, "a processing instruction");
        if (comes("<!DOCTYPE")) return look_at_doctype();
        look_at_tag();
    }

    void skip_past(std::string_view mark, std::size_t opening, char const* name) {
        std::size_t const end = text_.find(mark, at_ + opening);
        if (end == nowhere) return object(at_, std::string("not XML: ") + name + " has no end");
        at_ = end + mark.size();
    }

    void look_at_doctype() {
        std::size_t const start = at_;
        int brackets = 0;
        for (; at_ < text_.size(); ++at_) {
            if (comes("<!--")) {
                skip_past("-->", 4, "a comment");
                if (found_) return;
                --at_;
            } else if (comes("<!ENTITY")) {
                return object(at_,
                              "DOCTYPE: must not declare entities; save the drawing without them, as Inkscape does");
            } else if (text_[at_] == '"' || text_[at_] == '\'') {
                at_ = text_.find(text_[at_], at_ + 1);
                if (at_ == nowhere) break;
            } else if (text_[at_] == '[') {
                ++brackets;
            } else if (text_[at_] == ']') {
                --brackets;
            } else if (text_[at_] == '>' && brackets <= 0) {
                ++at_;
                return;
            }
        }
        object(start, "not XML: the DOCTYPE has no end");
    }

    void look_at_tag() {
        std::size_t const start = at_;
        bool const closes = text_.substr(at_ + 1, 1) == "/";
        std::size_t const name_end = std::min(text_.find_first_of(" \t\r\n/>", at_ + 1), text_.size());
        std::string const name = quoted(text_.substr(at_ + 1, name_end - at_ - 1));
        std::size_t const end = end_of_tag();
        if (found_) return;
        at_ = end + 1;
        if (closes) {
            --depth_;
            return;
        }
        if (depth_ == 0 && ++roots_ > 1) return object(start, "not XML: a second root element, " + name);
        if (++elements_ > most_elements) return object(start, name + ": a level must have at most 100000 elements");
        if (text_[end - 1] != '/') ++depth_;
    }

    std::size_t end_of_tag() {
        for (std::size_t i = at_ + 1; i < text_.size(); ++i) {
            char const c = text_[i];
            if (c == '>') return i;
            if (c == '<') break;
            if (c != '"' && c != '\'') continue;
            std::size_t const end = text_.find(c, i + 1);
            if (end == nowhere) break;
            if (++attributes_ > most_attributes) {
                object(i, "a level must have at most 1000000 attributes");
                return i;
            }
            if (auto const inside = text_.substr(i, end - i).find('<'); inside != nowhere) {
                object(i + inside, "not XML: < in the value of an attribute");
                return i;
            }
            i = end;
        }
        object(at_, "not XML: a tag has no end");
        return at_;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0, roots_ = 0, elements_ = 0, attributes_ = 0;
    std::optional<Objection> found_;
};

}  // namespace

std::optional<Objection> objection_to(std::string_view text) { return Scan(text).objection(); }

}  // namespace level
