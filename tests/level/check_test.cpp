#include <doctest/doctest.h>

#include "drawing.h"
#include "level/notes.h"

using namespace drawing;

TEST_CASE("a sound level gives nothing to say") {
    CHECK(
        warnings_of(with(
            "<path class='terrain' fill='none' d='M0 3H2A3 3 0 0 0 8 3H16'/><circle class='goal' cx='12' cy='2' r='1'/>"
            "<circle class='banana' cx='10' cy='2' r='0.2'/><rect width='16' height='9' fill='skyblue'/>")) == "");
}

TEST_CASE("gaps under a millimetre") {
    auto const gap = [](std::string const& x) {
        return warnings_of(with("<line class='terrain' x1='0' y1='8' x2='5' y2='8'/>\n<line class='terrain' x1='" + x +
                                "' y1='8' x2='9' y2='8'/>"));
    };
    CHECK(gap("5.0000005") == "");
    CHECK(gap("5.0005") == "3: terrain: a gap of 0.0005 m at (5, 1)\n4: terrain: a gap of 0.0005 m at (5.0005, 1)");
    CHECK(gap("5.002") == "");
    // An end that just misses the middle of a line.
    CHECK(warnings_of(with("<line class='terrain' x1='0' y1='8' x2='9' y2='8'/>\n<line class='terrain' x1='5' "
                           "y1='7.9998' x2='5' y2='6'/>")) == "4: terrain: a gap of 0.0002 m at (5, 1.0002)");
    // A ring that does not close.
    CHECK(warnings_of(path("M5 5A1 1 0 1 1 5.0005 5.00001")).find("3: terrain: a gap of 0.0005") == 0);
}

TEST_CASE("tangent breaks under two degrees") {
    auto const turn = [](std::string const& y) { return warnings_of(path("M0 8L5 8L10 " + y)); };
    CHECK(turn("7.9") == "3: terrain: a tangent break of 1.14576 degrees at (5, 1)");
    CHECK(turn("7.996") == "");  // 0.8 mrad: a joint
    CHECK(turn("7.8") == "");    // 2.3 degrees: a corner
    CHECK(warnings_of(path("M0 8L5 8L10 7.9L15 7.7")) ==
          "3: terrain: a tangent break of 1.14576 degrees at (5, 1), and 1 more");
}

TEST_CASE("concave arcs tighter than the ball") {
    CHECK(warnings_of(path("M0 8H5A.3 .3 0 0 0 5.6 8H16")) ==
          "3: terrain: a concave arc of radius 0.3 m is tighter than a ball of radius 0.5 m");
    CHECK(warnings_of(path("M0 8H5A.3 .3 0 0 1 5.6 8H16")) == "");
    CHECK(warnings_of(path("M0 8H5A.6 .6 0 0 0 6.2 8H16")) == "");
    CHECK(warnings_of(with("<circle class='terrain' cx='8' cy='6' r='0.3'/>")) == "");
    // A closed box round the ball with one corner too round, and a block with round corners outside of which it is.
    CHECK(warnings_of(path("M1 .5H9V6A.3 .3 0 0 1 8.7 6.3H1z")) ==
          "3: terrain: a concave arc of radius 0.3 m is tighter than a ball of radius 0.5 m");
    CHECK(warnings_of(path("M1 5H9V6A.3 .3 0 0 1 8.7 6.3H1z")) == "");
}

TEST_CASE("a ball that starts inside terrain") {
    std::string const block = "<rect class='terrain' x='1' y='1' width='5' height='3'";
    CHECK(warnings_of(with(block + "/>")) == "2: ball: starts inside the terrain of line 3");
    CHECK(warnings_of(with(block + " fill='none'/>")) == "");
    CHECK(warnings_of(with(block + " fill='none'/><circle class='goal' cx='9' cy='4' r='1'/>")) ==
          "2: ball: starts inside the terrain of line 3");
    CHECK(warnings_of(with("<g style='fill:none'>" + block + "/></g>")) == "");
    CHECK(warnings_of(with("<circle class='terrain' cx='3' cy='2' r='1.5'/>")) ==
          "2: ball: starts inside the terrain of line 3");
    // A cave in solid rock: the inner ring runs the other way round.
    CHECK(warnings_of(with("<path class='terrain' d='M0 0H16V9H0zM1 1V8H15V1z'/>")) == "");
}

TEST_CASE("slight overlaps are told") {
    CHECK(warnings_of(with("<line class='terrain' x2='16' y1='2.49' y2='2.49'/>")) ==
          "2: ball: overlaps terrain by 0.01 m and is moved out");
}

TEST_CASE("words and attributes that were perhaps meant otherwise") {
    std::string const line = " x2='16' y1='8' y2='8'/>";
    CHECK(warnings_of(with("<line class='terrian' stroke='red'" + line)) ==
          "3: line: class terrian is a letter away from terrain");
    CHECK(warnings_of(with("<line class='Terrain'" + line)) == "3: line: class Terrain is a letter away from terrain");
    CHECK(warnings_of(with("<line class='TERRAIN'" + line)) ==
          "3: line: class TERRAIN gives no role, in small letters it is terrain");
    CHECK(warnings_of(with("<circle class='balls' r='1'/>")) == "3: circle: class balls is a letter away from ball");
    CHECK(warnings_of(with("<circle class='banan' r='1'/>")) == "3: circle: class banan is a letter away from banana");
    CHECK(warnings_of(with("<line class='terrain grass st0'" + line)) == "");
    CHECK(warnings_of(with("<line class='terrain' data-fricton='1'" + line)) ==
          "3: terrain: unknown attribute data-fricton");
    CHECK(warnings_of(with("<line class='terrain' data-mass='1'" + line)) ==
          "3: terrain: data-mass has no effect here");
    CHECK(warnings_of(with("<circle data-name='x' r='1'/>")) == "");
}

TEST_CASE("what is ignored, empty or out of view") {
    CHECK(warnings_of(with("<text>hi</text><image href='http://nowhere/x.png'/>")) ==
          "3: text: is ignored\n3: image: is ignored");
    CHECK(warnings_of(with("<g class='terrain'><text>hi</text></g>")) ==
          "3: text: is ignored; make it a path first (Inkscape: Path > Object to Path)");
    CHECK(warnings_of(with("<rect width='2em' height='1'/>")) ==
          "3: rect: is ignored: width must be a number, or one with px, mm, cm, in, pt, pc, Q or %, got 2em");
    CHECK(warnings_of(with("<rect width='1' height='1' fill='url(#sky)'/>")) ==
          "3: rect: is ignored: the paint url(#sky)");
    CHECK(warnings_of(with("<path class='terrain'/>")) == "3: terrain: is empty");
    CHECK(warnings_of(with("<line class='terrain' x1='5' x2='5'/>")) == "3: terrain: is empty");
    CHECK(warnings_of(path("M0 8H4H4H9")) == "3: terrain: pieces without length are dropped, 1 of them");
    CHECK(warnings_of(with("<circle class='banana' cx='20' cy='3' r='1'/>")) == "3: banana: lies outside the viewBox");
    CHECK(warnings_of(with("<line class='terrain' x1='-5' x2='-6'/>")) == "3: terrain: lies outside the viewBox");
    CHECK(warnings_of("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><circle class='ball' cx='-1' cy='3' "
                      "r='1'/></svg>") == "1: ball: starts outside the viewBox");
}

TEST_CASE("roles typed where they have no effect") {
    std::string const how = " gives no role; set its attribute class to ";
    CHECK(warnings_of(with("<path id='terrain' fill='none' d='M0 8H9'/>")) ==
          "3: path: the id terrain" + how + "terrain (Inkscape: Edit > XML Editor)");
    CHECK(warnings_of(with("<g xmlns:inkscape='i' inkscape:label='Terrain 2'/>")) ==
          "3: g: the label Terrain 2" + how + "terrain (Inkscape: Edit > XML Editor)");
    CHECK(warnings_of(with("<circle r='1'><title>ball</title></circle>")) ==
          "3: circle: the title ball" + how + "ball (Inkscape: Edit > XML Editor)");
    CHECK(warnings_of(with("<g id='ball-holder'/>")) == "");
}

TEST_CASE("what a browser shows otherwise is told") {
    std::string const line = "x2='16' y1='8' y2='8'/>";
    CHECK(warnings_of(with("<line class='terrain' visibility='hidden' " + line)) ==
          "3: terrain: is hidden and takes part all the same");
    CHECK(warnings_of(with("<g style='clip-path:url(#c)'><line class='terrain' " + line + "</g>")) ==
          "3: terrain: a clip path or mask has no effect on it: it counts whole");
    CHECK(warnings_of(with("<line class='terrain' mask='url(#m)' " + line)) ==
          "3: terrain: a clip path or mask has no effect on it: it counts whole");
    CHECK(warnings_of(with("<line class='terrain' style='-webkit-mask-image:url(#m)' " + line)) ==
          "3: terrain: a clip path or mask has no effect on it: it counts whole");
    for (std::string const property : {"offset", "offset-path", "-webkit-transform-origin-x", "content-visibility"})
        CHECK(warnings_of(with("<g style='" + property + ":x'><line class='terrain' " + line + "</g>")) ==
              "3: g: the style property " + property + " has no effect; make it an attribute");
    for (std::string const size : {"width='0'", "height='-2'", "viewBox='0 0 0 9'"})
        CHECK(warnings_of(with("<svg " + size + "><line class='terrain' " + line + "</svg>")) ==
              "3: svg: shows nothing: its width, height and viewBox must be greater than 0");
    CHECK(warnings_of(with("<path class='terrain' style='d:path(\"M0 0\")' d='M0 8H9'/>")) ==
          "3: terrain: the style property d has no effect; make it an attribute");
    CHECK(warnings_of(with("<line class='terrain' opacity='0' " + line)) ==
          "3: terrain: is hidden and takes part all the same");
    // LibreOffice puts such a rect around each shape.
    CHECK(
        warnings_of(with("<g class='terrain'><rect class='BoundingBox' stroke='none' fill='none' x='1' y='6' width='3' "
                         "height='2'/></g>")) ==
        "3: terrain: has no paint that is seen, and takes part all the same, as grass and soil");
    CHECK(warnings_of(with("<g class='terrain grass' fill='none'><line " + line + "</g>")) == "");
    CHECK(warnings_of(with("<style>use{x:5px}</style><defs><path id='p' class='terrain' d='M0 8H9'/></defs>"
                           "<use href='#p'/>")) == "3: use: the style property x has no effect; make it an attribute");
    CHECK(warnings_of(with("<g style='display:var(--shown)'><line class='terrain' " + line + "</g>")) ==
          "3: g: the style property display has no effect; make it an attribute");
    CHECK(warnings_of(with("<line class='terrain' " + line, "style='rotate:9deg'")) ==
          "1: svg: a transform has no effect on the root");
    CHECK(warnings_of("<?xml-stylesheet href='a.css'?>\n" + with("")) ==
          "1: xml-stylesheet: is ignored: nothing is fetched; put its rules into a style element");
    CHECK(warnings_of(with("<path class='terrain' d='M0 8H9'><animateTransform/></path>")) ==
          "3: terrain: animateTransform has no effect on it");
    CHECK(read(with("<rect visibility='hidden' width='1' height='1'/>")).decorations.empty());
    auto const painted = read(with("<g color='#123456'><rect width='1' height='1' fill='currentColor'/></g>"));
    CHECK(painted.decorations.at(0).fill == "#123456");
}

TEST_CASE("a transform that browsers do not read where it stands is told") {
    std::string const line = "<line class='terrain' x2='16' y1='4' y2='4'/></g>";
    std::string const in_style =
        "3: g: transform: browsers heed it in a style only with units (px, deg) and commas as CSS has them";
    std::string const in_attribute =
        "3: g: transform: browsers heed it as an attribute only without units and as SVG spells it";
    auto const style = [&](std::string const& text) {
        return warnings_of(with("<g style='transform:" + text + "'>" + line));
    };
    auto const attribute = [&](std::string const& text) {
        return warnings_of(with("<g transform='" + text + "'>" + line));
    };
    for (char const* const sound : {"translate(1px, 0)", "rotate(0)", "scale(2,1.5) skewX(1deg)", "none"})
        CHECK(style(sound) == "");
    for (char const* const broken :
         {"translate(1, 0)", "rotate(1)", "rotate(1deg, 8px, 4px)", "translate(1px 0)", "scale(1) , scale(1)"})
        CHECK(style(broken) == in_style);
    for (char const* const sound : {"translate(1 0)", "rotate(1, 8,4),scale(1)", "matrix(1 0 0 1 0 0)skewX(1)"})
        CHECK(attribute(sound) == "");
    for (char const* const broken : {"translate(1px)", "rotate(1deg)", "translateX(1)", "SCALE(1)", "skew(1)"})
        CHECK(attribute(broken) == in_attribute);
}

TEST_CASE("what browsers draw and this program does not is noted") {
    auto const remarks = [](std::string const& third_line) {
        std::string all;
        for (level::Finding const& remark : read(with(third_line)).remarks)
            all += std::to_string(remark.line) + ": " + remark.text + "\n";
        return all;
    };
    std::string const line = " class='terrain' x2='16' y1='8' y2='8'/>";
    CHECK(remarks("<line stroke-dasharray='none' style='marker:none;filter:none'" + line) == "");
    CHECK(remarks("<line stroke-dasharray='1 2'" + line) == "3: line: stroke-dasharray is not drawn\n");
    CHECK(remarks("<style>.a{mix-blend-mode:multiply}</style><g class='a'/><g class='a'/>") ==
          "3: g: mix-blend-mode is not drawn, and 1 more\n");
    CHECK(remarks("<g filter='url(#f)'><line style='marker-end:url(#m)'" + line + "</g>") ==
          "3: g: filter is not drawn\n3: line: marker-end is not drawn\n");
}

TEST_CASE("a sound level is told its scale, and whether it can be won") {
    auto const notes = [](std::string const& goal, std::string const& root) {
        return level::notes_on(read("<svg viewBox='0 0 210 297' " + root +
                                    "><circle class='ball' cx='9' cy='9' r='4'/>" + goal + "</svg>"));
    };
    std::string const goal = "<rect class='goal' x='99' y='9' width='9' height='9'/>";
    CHECK(notes(goal, "") == std::vector<std::string>{
                                 "the ball is 8 m across, the level 210 m by 297 m",
                                 "data-metres-per-unit=\"0.1\" on the svg element would make the ball 0.8 m across; at "
                                 "another scale gravity does not feel as in the levels that ship"});
    CHECK(notes(goal, "data-metres-per-unit='.1'") ==
          std::vector<std::string>{"the ball is 0.8 m across, the level 21 m by 29.7 m"});
    CHECK(notes("", "data-metres-per-unit='.1'").back() ==
          "there is no goal and no way to win: give a shape the class goal");
    CHECK(notes(goal, "data-metres-per-unit='.001'").back().find("data-metres-per-unit=\"0.1\"") == 0);
}
