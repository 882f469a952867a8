#include "screen/glyphs.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "screen/swollen.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb_truetype.h>
#pragma GCC diagnostic pop

namespace screen {
namespace {

constexpr double highest_text = 400;  // pixels: a letter must fit the atlas

std::vector<unsigned char> font_file(std::string const& name) {
    for (char const* folder :
         {"/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/dejavu-sans-fonts/", "/usr/share/fonts/TTF/"}) {
        std::ifstream file(folder + name, std::ios::binary | std::ios::ate);
        if (!file || file.tellg() <= 0) continue;
        std::vector<unsigned char> bytes(static_cast<std::size_t>(file.tellg()));
        file.seekg(0);
        if (file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()))) return bytes;
    }
    throw std::runtime_error("the font " + name + " is missing (Debian's package fonts-dejavu-core)");
}

int next_letter(std::string const& text, std::size_t& at) {
    auto const lead = static_cast<unsigned char>(text[at++]);
    int const more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : 0;
    int letter = more == 0 ? lead : lead & (0x3F >> more);
    for (int i = 0; i < more && at < text.size(); ++i) letter = letter << 6 | (text[at++] & 0x3F);
    return letter;
}

std::vector<int> letters_of(std::string const& text) {
    std::vector<int> letters;
    for (std::size_t at = 0; at < text.size();) letters.push_back(next_letter(text, at));
    return letters;
}

int quarters_of(double height) { return static_cast<int>(std::lround(std::clamp(height, 4.0, highest_text) * 4)); }

}  // namespace

struct Glyphs::Font {
    std::vector<unsigned char> bytes;
    stbtt_fontinfo info{};

    explicit Font(std::string const& name) : bytes(font_file(name)) {
        if (!stbtt_InitFont(&info, bytes.data(), 0)) throw std::runtime_error("the font " + name + " is broken");
    }
    // The height of a label is from base line to base line.
    float scale(int quarters) const {
        int ascent = 0, descent = 0, gap = 0;
        stbtt_GetFontVMetrics(&info, &ascent, &descent, &gap);
        return static_cast<float>(quarters) / 4 / static_cast<float>(ascent - descent + gap);
    }
    double advance(int letter, int next) const {
        int advance = 0, bearing = 0;
        stbtt_GetCodepointHMetrics(&info, letter, &advance, &bearing);
        return advance + (next ? stbtt_GetCodepointKernAdvance(&info, letter, next) : 0);
    }
};

Glyphs::Glyphs()
    : regular_(std::make_unique<Font>("DejaVuSans.ttf")),
      bold_(std::make_unique<Font>("DejaVuSans-Bold.ttf")),
      atlas_(static_cast<std::size_t>(atlas_side) * atlas_side) {}
Glyphs::~Glyphs() = default;
Glyphs::Glyphs(Glyphs&&) noexcept = default;
Glyphs& Glyphs::operator=(Glyphs&&) noexcept = default;

Glyphs::Font const& Glyphs::font_for(view::Weight weight) const {
    return weight == view::Weight::bold ? *bold_ : *regular_;
}

double Glyphs::width_of(std::string const& text, double height, view::Weight weight) const {
    Font const& font = font_for(weight);
    auto const letters = letters_of(text);
    double width = 0;
    for (std::size_t i = 0; i < letters.size(); ++i)
        width += font.advance(letters[i], i + 1 < letters.size() ? letters[i + 1] : 0);
    return width * font.scale(quarters_of(height));
}

std::optional<Line> Glyphs::line(view::Label const& label, double start) {
    Font const& font = font_for(label.weight);
    int const quarters = quarters_of(label.height);
    int const swell = static_cast<int>(std::lround(std::clamp(label.swell, 0.0, highest_text / 4) * 4));
    double const scale = font.scale(quarters);
    auto const letters = letters_of(label.text);
    Line line;
    double pen = start;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        int const pen_quarters = static_cast<int>(std::floor(pen * 4 + 0.5));
        auto const placed = glyph({&font, letters[i], quarters, pen_quarters & 3, swell});
        if (!placed) return std::nullopt;
        line.glyphs.push_back({*placed, pen_quarters >> 2});
        pen += scale * font.advance(letters[i], i + 1 < letters.size() ? letters[i + 1] : 0);
    }
    line.width = pen - start;
    return line;
}

std::optional<Glyph> Glyphs::glyph(Form const& form) {
    if (auto const found = kept_.find(form); found != kept_.end()) return found->second;
    float const scale = form.font->scale(form.height), shift = static_cast<float>(form.pen) / 4;
    int left = 0, top = 0, right = 0, bottom = 0;
    stbtt_GetCodepointBitmapBoxSubpixel(&form.font->info, form.letter, scale, scale, shift, 0, &left, &top, &right,
                                        &bottom);
    bool const is_space = left == right || top == bottom;
    int const margin = form.swell > 0 && !is_space ? swell_margin(form.swell / 4.0) : 0;
    Glyph glyph{0, 0, right - left + 2 * margin, bottom - top + 2 * margin, left - margin, top - margin};
    if (shelf_x_ + glyph.width > atlas_side) {
        shelf_x_ = 0;
        shelf_y_ += std::exchange(shelf_height_, 0);
    }
    if (shelf_y_ + glyph.height > atlas_side) return std::nullopt;
    glyph.atlas_x = shelf_x_;
    glyph.atlas_y = shelf_y_;
    shelf_x_ += glyph.width;
    shelf_height_ = std::max(shelf_height_, glyph.height);
    if (glyph.width > 0 && glyph.height > 0) {
        paint(form, glyph);
        changed_top_ = std::min(changed_top_, glyph.atlas_y);
        changed_bottom_ = std::max(changed_bottom_, glyph.atlas_y + glyph.height);
    }
    kept_.emplace(form, glyph);
    return glyph;
}

void Glyphs::paint(Form const& form, Glyph const& glyph) {
    float const scale = form.font->scale(form.height), shift = static_cast<float>(form.pen) / 4;
    unsigned char* const corner = atlas_.data() + glyph.atlas_y * atlas_side + glyph.atlas_x;
    auto const draw = [&](unsigned char* at, int width, int height, int stride) {
        stbtt_MakeCodepointBitmapSubpixel(&form.font->info, at, width, height, stride, scale, scale, shift, 0,
                                          form.letter);
    };
    if (form.swell == 0) return draw(corner, glyph.width, glyph.height, atlas_side);
    int const margin = swell_margin(form.swell / 4.0);
    Bitmap letter{glyph.width, glyph.height, {}};
    letter.shares.resize(static_cast<std::size_t>(glyph.width) * static_cast<std::size_t>(glyph.height));
    draw(letter.shares.data() + margin * glyph.width + margin, glyph.width - 2 * margin, glyph.height - 2 * margin,
         glyph.width);
    letter = swollen(letter, form.swell / 4.0);
    for (int row = 0; row < glyph.height; ++row)
        std::copy_n(letter.shares.data() + row * glyph.width, glyph.width, corner + row * atlas_side);
}

void Glyphs::clear() {
    kept_.clear();
    shelf_x_ = shelf_y_ = shelf_height_ = 0;
    std::fill(atlas_.begin(), atlas_.end(), std::uint8_t{0});
}

}  // namespace screen
