#include <limits>
#include <memory>

#include <doctest/doctest.h>
#include <libdeflate.h>

#include "drawing.h"
#include "level/hash.h"

using namespace drawing;
using geometry::Arc;
using geometry::Segment;
using geometry::Vec2;
using level::Meaning;

TEST_CASE("the lower left corner of the viewBox is the origin, y points up") {
    auto const level = read(R"svg(<svg viewBox="10 20 16 9"><circle class="ball" cx="13" cy="27" r="0.5"/>
        <line class="terrain" x1="10" y1="29" x2="26" y2="28"/></svg>)svg");
    CHECK(level.scene.balls[0].start.position == Vec2(3, 2));
    auto const segment = std::get<Segment>(level.scene.terrain.pieces[0].curve);
    CHECK(segment.start == Vec2(0, 0));
    CHECK(segment.end == Vec2(16, 1));
    CHECK(level.size == Vec2(16, 9));
}

TEST_CASE("width and height in plain numbers stand for a viewBox") {
    auto const level = read(R"svg(<svg width="20" height="10"><circle class="ball" cx="3" cy="4" r="1"/></svg>)svg");
    CHECK(level.size == Vec2(20, 10));
    CHECK(level.scene.balls[0].start.position == Vec2(3, 6));
    CHECK(fault_of("<svg width=\"20mm\" height=\"10\"><circle class=\"ball\" r=\"1\"/></svg>") ==
          ":1: svg: without a viewBox, width must be a plain number greater than 0, got 20mm");
    CHECK(fault_of("<svg><circle class=\"ball\" r=\"1\"/></svg>") ==
          ":1: svg: there must be a viewBox, or width and height in plain numbers");
}

TEST_CASE("metres per unit scale places and radii, but neither velocity nor reach") {
    auto const level = read(R"svg(<svg viewBox="0 0 1600 900" data-metres-per-unit="0.01" data-drag-reach="7">
        <circle class="ball" cx="300" cy="200" r="50" data-velocity="2 -3" data-spin="4"/></svg>)svg");
    auto const& ball = level.scene.balls[0];
    CHECK(distance(ball.start.position, {3, 7}) < 1e-14);
    CHECK(ball.radius == doctest::Approx(0.5).epsilon(1e-15));
    CHECK(ball.start.velocity == Vec2(2, -3));
    CHECK(ball.start.spin == 4);
    CHECK(level.drag_reach == 7);
    CHECK(distance(level.size, {16, 9}) < 1e-14);
}

TEST_CASE("what is not said is as the contract has it") {
    auto const level = read(with(R"svg(<line class="terrain" x2="16" y1="8" y2="8"/>)svg"));
    auto const& ball = level.scene.balls[0];
    CHECK(ball.mass == 1);
    CHECK(ball.inertia == 0.5);
    CHECK(ball.friction == 0.3);
    CHECK(ball.restitution == 0.5);
    CHECK(ball.start.velocity == Vec2(0, 0));
    auto const& material = level.scene.terrain.pieces[0].material;
    CHECK(material.friction == 0.9);
    CHECK(material.restitution == 0);
    CHECK(material.rolling_resistance == 0);
    CHECK(level.scene.gravity == 9.81);
    CHECK(!level.time_limit);
    CHECK(level.scene.drag.frequency == 3);
    CHECK(level.scene.drag.damping == 0.7);
    CHECK(level.drag_reach == 4);
    CHECK(level.tilt_limit == 0.4);
}

TEST_CASE("the root sets gravity, limits and drag") {
    auto const level = read(with("", R"svg(data-gravity="1.62" data-time-limit="30" data-drag-frequency="2"
        data-drag-damping="0.5" data-tilt-limit="0.2")svg"));
    CHECK(level.scene.gravity == 1.62);
    CHECK(level.time_limit == 30);
    CHECK(level.scene.drag.frequency == 2);
    CHECK(level.scene.drag.damping == 0.5);
    CHECK(level.tilt_limit == 0.2);
}

TEST_CASE("the root says what is asked for and what lies behind") {
    auto const level = read(with("<desc> Roll\n over </desc>", R"svg(data-par-time="12.5" data-pulls="3"
        data-sky="#123 rgb(255,0,0)" data-hills="red #00ff00 blue" data-sun="none" data-clouds="white")svg"));
    CHECK(level.hint == "Roll over");
    CHECK(level.pars.time == 12.5);
    CHECK(level.pars.pulls == 3);
    CHECK(level.look.sky == std::vector<std::string>{"#112233", "#ff0000"});
    CHECK(level.look.hills == std::vector<std::string>{"#ff0000", "#00ff00", "#0000ff"});
    CHECK(level.look.sun == level::no_colour);
    CHECK(level.look.clouds == "#ffffff");
    CHECK(fault_of(with("", "data-pulls=\"1.5\"")).find("data-pulls must be a whole number") != std::string::npos);
    CHECK(fault_of(with("", "data-sky=\"red\"")).find("data-sky must be 2 colours, got red") != std::string::npos);
    CHECK(fault_of(with("", "data-sun=\"bright\"")).find("data-sun must be 1 colour, got bright") != std::string::npos);
}

TEST_CASE("the title is the level's name, else the file's") {
    CHECK(read(with("<title> A  hill\n</title>")).title == "A hill");
    File const file(with(""), "slope.svg");
    CHECK(level::read_level(file.path()).title == "slope");
    CHECK(level::read_level(file.path()).file == file.path());
}

TEST_CASE("attributes are inherited through groups and the nearest wins") {
    auto const level = read(R"svg(<svg viewBox="0 0 16 9" data-friction="0.7">
        <g data-restitution="0.2" data-mass="5"><g data-friction="0.1">
        <line class="terrain" x2="16" y1="8" y2="8"/>
        <line class="terrain" x2="16" y1="7" y2="7" data-friction="inf" data-rolling-resistance="0.01"/></g>
        <line class="terrain" x2="16" y1="6" y2="6"/></g>
        <line class="terrain" x2="16" y1="5" y2="5"/>
        <g data-mass="3" data-velocity="1,2"><circle class="ball" cx="3" cy="2" r="0.5"/></g></svg>)svg");
    auto const& pieces = level.scene.terrain.pieces;
    CHECK(pieces[0].material.friction == 0.1);
    CHECK(pieces[0].material.restitution == 0.2);
    CHECK(pieces[1].material.friction == std::numeric_limits<double>::infinity());
    CHECK(pieces[1].material.rolling_resistance == 0.01);
    CHECK(pieces[2].material.friction == 0.7);
    CHECK(pieces[3].material.restitution == 0);
    CHECK(level.scene.balls[0].mass == 3);
    CHECK(level.scene.balls[0].start.velocity == Vec2(1, 2));
}

TEST_CASE("the player is the first ball, or the one with the id") {
    std::string const two = R"svg(<svg viewBox="0 0 16 9"><circle class="ball" cx="3" cy="2" r="0.5"/>
        <circle class="ball" cx="6" cy="2" r="0.5"%/><circle class="goal" cx="9" cy="2" r="0.5"/></svg>)svg";
    auto const named = [&](std::string const& id) { return std::string(two).replace(two.find('%'), 1, id); };
    CHECK(read(named("")).player == 0);
    CHECK(read(named("")).scene.sensors[0].ball == 0);
    CHECK(read(named(" id=\"player\"")).player == 1);
    CHECK(read(named(" id=\"player\"")).scene.sensors[0].ball == 1);
}

TEST_CASE("goals, bananas and the rim of the world are sensors") {
    auto const level =
        read(with(R"svg(<rect class="goal" x="10" y="2" width="2" height="1" transform="rotate(90 10 2)"/>
        <circle class="banana" cx="8" cy="3" r="0.25"/><line class="goal" x1="1" y1="1" x2="1" y2="4"/>)svg"));
    auto const& sensors = level.scene.sensors;
    REQUIRE(sensors.size() == 4);
    CHECK(level.meanings == std::vector{Meaning::goal, Meaning::banana, Meaning::goal, Meaning::fall});
    // Turned by a quarter clockwise on the page the rect covers x in [9, 10] and Y in [2, 4].
    auto const& corners = std::get<physics::PolygonRegion>(sensors[0].region).corners;
    REQUIRE(corners.size() == 4);
    double area = 0;
    Vec2 middle = Vec2::Zero();
    for (int i = 0; i < 4; ++i) {
        area += geometry::cross(corners[i], corners[(i + 1) % 4]) / 2;
        middle += corners[i] / 4;
    }
    CHECK(area == doctest::Approx(2).epsilon(1e-14));
    CHECK(distance(middle, {9.5, 6}) < 1e-14);
    CHECK(std::get<physics::DiscRegion>(sensors[1].region).centre == Vec2(8, 6));
    CHECK(sensors[1].rim);
    CHECK(sensors[1].ball == -1);
    CHECK(std::get<physics::LineRegion>(sensors[2].region).from == Vec2(1, 8));
    auto const& rim = std::get<physics::PolygonRegion>(sensors[3].region).corners;
    CHECK(rim == std::vector<Vec2>{{-8, -4.5}, {24, -4.5}, {24, 13.5}, {-8, 13.5}});
    CHECK(sensors[3].outside);
    CHECK(sensors[3].each_ball);
    CHECK(sensors[3].ball == -1);
}

TEST_CASE("surfaces are named by id, else by their number in the file") {
    auto const level = read(with(R"svg(<line class="terrain" x2="16" y1="8" y2="8"/>
        <rect class="terrain" id="box" x="8" y="6" width="1" height="1"/><circle class="terrain" cx="12" cy="6" r="1"/>)svg"));
    CHECK(level.surface_names == std::vector<std::string>{"0", "box", "2"});
    CHECK(level.scene.terrain.pieces.back().surface == 2);
    CHECK(level.outlines.size() == 3);
    CHECK(!level.outlines[0].closed);
    CHECK(level.outlines[1].closed);
    CHECK(level.outlines[1].curves.size() == 4);
    CHECK(level.outlines[2].closed);
}

TEST_CASE("hidden elements, definitions and foreign ones count for nothing") {
    auto const level = read(R"svg(<?xml version="1.0"?><!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "svg11.dtd">
        <svg:svg xmlns:svg="http://www.w3.org/2000/svg" xmlns:i="http://inkscape" viewBox="0 0 16 9">
        <svg:defs><svg:circle class="ball" r="-1"/></svg:defs><i:circle class="ball" r="-1"/>
        <svg:g display="none"><svg:circle class="ball" r="-1"/></svg:g>
        <svg:g style="fill:red; display : none ;"><svg:circle class="ball" r="-1"/></svg:g>
        <svg:circle class="goal" r="-2" style="display:none"/><svg:desc>a<svg:circle class="ball"/></svg:desc>
        <!-- <circle class="ball" r="nan"/> -->
        <svg:circle class="ball first" cx="3" cy="2" r="0.5" display="inline"/></svg:svg>)svg");
    CHECK(level.scene.balls.size() == 1);
    CHECK(level.meanings.size() == 1);
}

TEST_CASE("elements without a role are drawn behind the scene") {
    auto const level =
        read(with(R"svg(<g fill="#abc" opacity="0.5"><rect width="2" height="1" stroke="Red" stroke-width="0.1"/>
        <ellipse cx="4" cy="4" rx="2" ry="1" style="fill:rgb(0, 128,255)" fill="none" transform="scale(2)"/></g>
        <line x1="1" x2="2" stroke="#00FF00"/><path d="M0 0h1v1z" fill="none"/><text>hello</text>)svg"));
    REQUIRE(level.decorations.size() == 3);
    CHECK(level.decorations[0].fill == "#aabbcc");
    CHECK(level.decorations[0].stroke == "#ff0000");
    CHECK(level.decorations[0].stroke_width == doctest::Approx(0.1));
    CHECK(level.decorations[0].opacity == 0.5);
    CHECK(level.decorations[1].fill == "#0080ff");
    CHECK(!level.decorations[1].stroke);
    CHECK(!level.decorations[2].fill);
    CHECK(level.decorations[2].stroke == "#00ff00");
    CHECK(level.scene.terrain.pieces.empty());
}

// As in a page, from which drawings are cut out; browsers show no such file.
TEST_CASE("a prefix that is bound to nothing is read") {
    auto const level = read(with(R"svg(<defs><path id="a" d="M0 8H16"/></defs><use xlink:href="#a" class="terrain"/>
        <g inkscape:label="sky"><line class="terrain" x2="16" y1="1" y2="1"/></g>)svg"));
    CHECK(level.scene.terrain.pieces.size() == 2);
}

TEST_CASE("files in UTF-16 and Latin-1 are read as well") {
    std::string const text = with("<title>h</title>\n");
    std::string wide = "\xff\xfe";
    for (char const c : text) wide += {c, '\0'};
    CHECK(read(wide).title == "h");
    auto const latin = read("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>" + with("<title>H\xfcgel</title>"));
    CHECK(latin.title == "H\xc3\xbcgel");
    CHECK(read("\xef\xbb\xbf" + text).title == "h");
}

TEST_CASE("bytes that are not in the declared encoding are a fault with their line") {
    std::string const bad = "<svg xmlns='http://www.w3.org/2000/svg'>\n\n<g id='H\xfcgel'/></svg>";
    CHECK(fault_of(bad) == ":3: not XML: the byte 0xfc is not UTF-8");
    CHECK(fault_of("<?xml version='1.0' encoding='utf-8'?>" + bad) == ":3: not XML: the byte 0xfc is not UTF-8");
    CHECK(fault_of("<?xml version='1.0' encoding='us-ascii'?>" + bad) == ":3: not XML: the byte 0xfc is not US-ASCII");
    CHECK(fault_of("<?xml version='1.0' encoding='klingon'?>" + bad) ==
          ":1: not XML: the encoding KLINGON is not known");
    CHECK(fault_of("<?xml version='1.0' encoding='utf-16'?>" + bad) ==
          ":1: not XML: it is not in the encoding that it declares, UTF-16");
    // Longer than need be, a surrogate, beyond Unicode, cut short.
    for (char const* wrong :
         {"\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82", "\x80", "\xff"})
        CHECK(fault_of(with("<g id='" + std::string(wrong) + "'/>")).substr(0, 22) == ":3: not XML: the byte ");
    CHECK(fault_of(with("<g id='\xe2\x82\xac\xf0\x9f\x8d\x8c\xed\x9f\xbf'/>")) == "");
    auto const windows = read("<?xml version='1.0' encoding='windows-1252'?>" + with("<title>\x80</title>"));
    CHECK(windows.title == "\xe2\x82\xac");
}

TEST_CASE("what is no SVG is no terrain, whatever its prefix") {
    std::string const ball = "<circle class='ball' cx='3' cy='3' r='1'/>";
    CHECK(fault_of("<svg xmlns='urn:x' viewBox='0 0 9 9'>" + ball + "</svg>") ==
          ":1: svg: the root element is of a namespace that is not SVG's");
    CHECK(warnings_of("<svg viewBox='0 0 9 9'>" + ball + "</svg>") ==
          "1: svg: without xmlns=\"http://www.w3.org/2000/svg\" browsers show nothing");
    CHECK(warnings_of(with("<g xmlns='urn:x'><path class='terrain' d='M0 3H16'/></g>")) ==
          "3: path: is of another namespace and counts for nothing");
    CHECK(read(with("<g xmlns='urn:x'><s:path xmlns:s='http://www.w3.org/2000/svg' class='terrain' d='M0 3H16'/></g>"))
              .scene.terrain.pieces.empty());
    // The prefix of one element is another's on the next.
    auto const level = read(
        "<a:svg xmlns:a='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><a:circle class='ball' cx='3' "
        "cy='3' r='1'/><a:line xmlns:a='urn:x' class='terrain' x2='9'/>"
        "<b:line xmlns:b='http://www.w3.org/2000/svg' class='terrain' x2='9' y1='8' y2='8'/>"
        "<line class='terrain' x2='5'/></a:svg>");
    CHECK(level.scene.terrain.pieces.size() == 1);
}

TEST_CASE("files packed with gzip are read, bombs are not") {
    auto const packed = [](std::string const& text) {
        std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> const packer(
            libdeflate_alloc_compressor(6), libdeflate_free_compressor);
        std::string bytes(libdeflate_gzip_compress_bound(packer.get(), text.size()), '\0');
        bytes.resize(libdeflate_gzip_compress(packer.get(), text.data(), text.size(), bytes.data(), bytes.size()));
        return bytes;
    };
    std::string const text = with("<title>packed</title>");
    std::string const bytes = packed(text);
    CHECK(read(bytes).title == "packed");
    CHECK(read(packed(text.substr(0, 50)) + packed(text.substr(50))).title == "packed");
    CHECK(read(bytes).hash == level::fnv1a_hex(std::as_bytes(std::span(bytes.data(), bytes.size()))));
    CHECK(fault_of(bytes.substr(0, bytes.size() - 9)) == ":1: svgz: the packed data is damaged or cut short");
    CHECK(fault_of(bytes + "x") == ":1: svgz: the packed data is damaged or cut short");
    CHECK(fault_of(packed(std::string(64'000'001, ' '))) == ":1: svg: the file must unpack to at most 64 MB, got more");
}

TEST_CASE("the hash of a level is FNV-1a of its bytes") {
    // From the reference tables of Fowler, Noll and Vo.
    auto const of = [](std::string const& text) {
        return level::fnv1a_hex(std::as_bytes(std::span(text.data(), text.size())));
    };
    CHECK(of("") == "cbf29ce484222325");
    CHECK(of("a") == "af63dc4c8601ec8c");
    CHECK(of("foobar") == "85944171f73967e8");
    std::string const text = with("");
    CHECK(read(text).hash == of(text));
}

TEST_CASE("a ball that overlaps slightly is moved out along the normal") {
    // Ground at y = 0, wall at x = 0, two balls sunk in by 2 % and 1 % of their radius.
    auto const level = read(R"svg(<svg viewBox="0 0 16 9"><path class="terrain" fill="none" d="M0 0V9H16"/>
        <circle class="ball" cx="0.49" cy="8.51" r="0.5"/><circle class="ball" cx="5" cy="8.505" r="0.5"/>
        <circle class="ball" cx="9" cy="8.4999999995" r="0.5"/></svg>)svg");
    auto const& balls = level.scene.balls;
    CHECK(distance(balls[0].start.position, {0.5, 0.5}) < 1e-9);
    CHECK(distance(balls[1].start.position, {5, 0.5}) < 1e-9);
    // Half a nanometre over the ground is contact, and stays as drawn.
    CHECK(balls[2].start.position.y() == doctest::Approx(9 - 8.4999999995).epsilon(1e-15));
}

TEST_CASE("balls that overlap slightly are moved apart and stay on the ground") {
    auto const level = read(R"svg(<svg viewBox="0 0 16 9"><line class="terrain" x2="16" y1="9" y2="9"/>
        <circle class="ball" cx="5" cy="8.5" r="0.5"/><circle class="ball" cx="5.98" cy="8.5" r="0.5"/></svg>)svg");
    auto const& balls = level.scene.balls;
    CHECK(distance(balls[0].start.position, balls[1].start.position) == doctest::Approx(1).epsilon(1e-9));
    CHECK(distance(balls[0].start.position, {4.99, 0.5}) < 1e-9);
}
