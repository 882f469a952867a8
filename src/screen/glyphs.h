// Letters: DejaVu Sans, drawn at the size they are shown, kept in one texture's worth of bytes.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "view/picture.h"

namespace screen {

constexpr int atlas_side = 2048;  // texels

// A letter's place in the atlas and around the pen, which stands on the base line.
struct Glyph {
    int atlas_x = 0, atlas_y = 0;  // texels
    int width = 0, height = 0;     // pixels; 0 for a space
    int left = 0, top = 0;         // pixels from the pen to the upper left corner
};

// The n-th letter of a text, with the pen's place from the start of the text.
struct PlacedGlyph {
    Glyph glyph;
    int pen = 0;  // whole pixels
};

struct Line {
    std::vector<PlacedGlyph> glyphs;
    double width = 0;  // pixels
};

class Glyphs {
public:
    // Throws std::runtime_error when the fonts are not there.
    Glyphs();
    ~Glyphs();
    Glyphs(Glyphs&&) noexcept;
    Glyphs& operator=(Glyphs&&) noexcept;

    double width_of(std::string const& text, double height, view::Weight weight) const;  // pixels
    // Places the letters of a label, the pen starting `start` (0 to 1) into a pixel. None when the atlas is full.
    std::optional<Line> line(view::Label const& label, double start);
    // Forgets all letters.
    void clear();

    std::vector<std::uint8_t> const& atlas() const { return atlas_; }
    // The rows that have changed since the last mark_seen, the last one excluded; none where they are equal or less.
    int changed_top() const { return changed_top_; }
    int changed_bottom() const { return changed_bottom_; }
    void mark_seen() {
        changed_top_ = atlas_side;
        changed_bottom_ = 0;
    }

private:
    struct Font;
    struct Form {
        Font const* font = nullptr;
        int letter = 0;
        int height = 0, pen = 0, swell = 0;  // quarters of a pixel
        auto operator<=>(Form const&) const = default;
    };
    std::optional<Glyph> glyph(Form const& form);
    void paint(Form const& form, Glyph const& glyph);
    Font const& font_for(view::Weight weight) const;

    std::unique_ptr<Font> regular_, bold_;
    std::vector<std::uint8_t> atlas_;
    std::map<Form, Glyph> kept_;
    int shelf_x_ = 0, shelf_y_ = 0, shelf_height_ = 0;  // texels
    int changed_top_ = atlas_side, changed_bottom_ = 0;
};

}  // namespace screen
