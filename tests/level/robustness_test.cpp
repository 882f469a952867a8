#include <random>

#include <doctest/doctest.h>

#include "drawing.h"

using namespace drawing;

namespace {

std::string const whole = R"svg(<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE svg>
<!-- a level -->
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 9" data-gravity="9.81" data-time-limit="60">
  <title>Whole</title>
  <g transform="translate(1 2) rotate(-3 1 1)" data-friction="0.5" style="fill:none;stroke:#123">
    <path class="terrain" id="hill" d="M-1 5 h3 a1 1 0 0 1 2,0 l2-1 c1 0 1 2 3 1 q1 1 2 0 t2 0 z" data-curve-tolerance="1e-2"/>
    <polyline class="terrain" points="0,6 3,6.5 7 6"/>
  </g>
  <circle class="ball" id="player" cx="3" cy="2" r="0.5" data-mass="2" data-velocity="1 0" data-spin="3"/>
  <circle class="banana" cx="8" cy="3" r="0.3"/>
  <rect class="goal" x="13" y="3" width="1" height="2" transform="scale(1 1)"/>
  <ellipse cx="5" cy="1" rx="2" ry="0.5" fill="white" opacity="0.5"/>
</svg>
)svg";

// One line, with the file's name, or nothing.
bool is_well_behaved(std::string const& text) {
    File const file(text);
    std::string what;
    try {
        level::read_level(file.path());
    } catch (std::runtime_error const& error) {
        what = error.what();
    }
    bool faulty = false;
    for (auto const& finding : level::checked_level(file.path()).findings) {
        faulty = faulty || finding.fault;
        if (finding.line < 1 || finding.text.find('\n') != std::string::npos) return false;
    }
    bool const told =
        what.empty() || (what.find('\n') == std::string::npos && what.substr(0, file.path().size()) == file.path());
    return told && faulty == !what.empty();
}

}  // namespace

TEST_CASE("the level of these tests is sound") { CHECK(fault_of(whole) == ""); }

TEST_CASE("a level cut off anywhere is a fault on one line") {
    for (std::size_t size = 0; size < whole.size(); size += 3) {
        CAPTURE(size);
        CHECK(is_well_behaved(whole.substr(0, size)));
    }
}

TEST_CASE("a level with flipped bytes is a level or a fault on one line") {
    std::mt19937 random(1);
    for (int i = 0; i < 1500; ++i) {
        std::string text = whole;
        for (int flips = 1 + i % 4; flips > 0; --flips)
            text[random() % text.size()] = static_cast<char>(random() % 256);
        CAPTURE(text);
        CHECK(is_well_behaved(text));
    }
}

TEST_CASE("a level with exchanged pieces is a level or a fault on one line") {
    std::mt19937 random(2);
    std::string const pieces[] = {"1e999",    "-", "nan", "1e-400", "\"",  "<",    ">",   "&",
                                  "99999999", "M", "a",   "0",      "<g>", "</g>", "]]>", "<!--"};
    for (int i = 0; i < 1500; ++i) {
        std::string text = whole;
        text.replace(random() % text.size(), random() % 3, pieces[random() % std::size(pieces)]);
        CAPTURE(text);
        CHECK(is_well_behaved(text));
    }
}

TEST_CASE("bytes at random are no level") {
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        std::string text(random() % 300, ' ');
        for (char& c : text) c = static_cast<char>(random() % 256);
        CHECK(is_well_behaved(text));
        CHECK(is_well_behaved("<svg viewBox='0 0 1 1'>" + text));
    }
}

TEST_CASE("what a small file would make large is a fault on one line") {
    auto const nested = [](std::string const& element) {
        std::string text = element;
        for (int i = 1; i < 8; ++i) {
            std::string const copy = "<use href='#c" + std::to_string(i - 1) + "'/>";
            text += "<g id='c" + std::to_string(i) + "'>";
            for (int j = 0; j < 10; ++j) text += copy;
            text += "</g>";
        }
        return with(text);
    };
    CHECK(fault_of(nested("<path id='c0' class='terrain' d='M0 5H9'/>")) ==
          ":3: use: a level must have at most 100000 elements, copies by use included");
    std::string data = "M0 5";
    for (int i = 0; i < 3000; ++i) data += "l.001 0 0 .001";
    CHECK(fault_of(nested("<path id='c0' class='terrain' d='" + data + "'/>")) ==
          ":3: terrain: all shapes together must have at most 1000000 pieces");
    auto const repeated = [](std::string const& before, std::string const& what, int times, std::string const& after) {
        std::string text = before;
        for (int i = 0; i < times; ++i) text += what;
        return with(text + after);
    };
    CHECK(fault_of(repeated("<style>", ".a{fill:red}", 90'000, "</style>")) ==
          ":3: style: style sheets must have at most 1 MB together, got more");
    CHECK(fault_of(repeated("<path class='terrain' style='", "fill:red;", 120'000, "' d='M0 5H9'/>")) ==
          ":3: path: a style must have at most 1 MB, got more");
    CHECK(fault_of(repeated("<path class='terrain'", " a='1'", 1'000'001, " d='M0 5H9'/>")) ==
          ":3: a level must have at most 1000000 attributes");
}
