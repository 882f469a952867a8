// What of the drawing's own paint a level keeps.
#include <doctest/doctest.h>

#include "drawing.h"

using namespace drawing;

namespace {

std::string const earth = "d='M0 5H9V9H0Z'";

// "#fill/#stroke/width/opacity" of all that the drawing paints itself, in its order.
std::string painted(std::string const& third_line) {
    std::ostringstream all;
    char const* between = "";
    for (level::Decoration const& part : read(with(third_line)).decorations) {
        all << between << part.fill.value_or("none") << '/' << part.stroke.value_or("none") << '/' << part.stroke_width
            << '/' << part.opacity;
        between = " ";
    }
    return all.str();
}

bool has_grass(std::string const& third_line) { return !read(with(third_line)).outlines.at(0).painted; }

std::string ball_colours(std::string const& attributes, std::string const& before = "") {
    auto const level =
        read("<svg viewBox='-9 -9 16 9'>" + before + "<circle class='ball' r='1' " + attributes + "/></svg>");
    level::Tint const& tint = level.ball_tints.at(0);
    return tint.fill.value_or("-") + " " + tint.stroke.value_or("-");
}

}  // namespace

TEST_CASE("terrain keeps the fill and stroke that the drawing gives it") {
    CHECK(painted("<path class='terrain' fill='#8a5' " + earth + "/>") == "#88aa55/none/0/1");
    CHECK(painted("<path class='terrain' style='fill:none;stroke:tomato;stroke-width:.1' " + earth + "/>") ==
          "none/#ff6347/0.1/1");
    CHECK(painted("<path class='terrain' stroke='red' stroke-width='0.2' " + earth + "/>") == "#000000/#ff0000/0.2/1");
    CHECK(painted("<g opacity='.5' class='terrain' fill='red' transform='scale(2)'><path stroke='blue' " + earth +
                  "/></g>") == "#ff0000/#0000ff/2/0.5");
    CHECK(painted("<style>.a{fill:currentColor}</style><path class='terrain a' color='lime' " + earth + "/>") ==
          "#00ff00/none/0/1");
    // As draw.io and Figma write colours.
    CHECK(painted("<path class='terrain' style='fill:light-dark(rgb(255, 0, 0), var(--edge, #121212))' " + earth +
                  "/>") == "#ff0000/none/0/1");
    CHECK(painted("<path class='terrain' fill='var(--fill-0, #88AA55)' " + earth + "/>") == "#88aa55/none/0/1");
    CHECK(painted("<path class='terrain' fill='VAR( --a , var(--b,hsl(0 100% 50%)) )' " + earth + "/>") ==
          "#ff0000/none/0/1");
    CHECK(has_grass("<path class='terrain' fill='var(--fill-0)' " + earth + "/>"));
    CHECK(painted("<line class='terrain' x1='1' y1='5' x2='9' y2='5' fill='red' stroke='red' stroke-width='1mm'/>") ==
          "none/#ff0000/3.77953/1");
    CHECK(!has_grass("<path class='terrain' fill='#8a5' " + earth + "/>"));
}

TEST_CASE("grass and soil come where the drawing paints nothing or asks by a class") {
    CHECK(has_grass("<path class='terrain' " + earth + "/>"));
    CHECK(has_grass("<path class='terrain' fill='none' " + earth + "/>"));
    CHECK(has_grass("<path class='grass terrain' fill='red' " + earth + "/>"));
    CHECK(has_grass("<g class='grass'><path class='terrain' fill='red' " + earth + "/></g>"));
    CHECK(has_grass("<path class='terrain' fill='url(#none)' " + earth + "/>"));
    CHECK(warnings_of(with("<path class='terrain' fill='url(#none)' " + earth + "/>")) ==
          "3: terrain: is shown as grass and soil: the paint url(#none)");
    CHECK(painted("<path class='grass terrain' fill='red' " + earth + "/>") == "");
}

TEST_CASE("hidden terrain is neither grass nor paint") {
    CHECK(!has_grass("<path class='terrain' visibility='hidden' " + earth + "/>"));
    CHECK(painted("<path class='terrain' visibility='hidden' fill='red' " + earth + "/>") == "");
    CHECK(!has_grass("<path class='terrain' opacity='0' fill='red' " + earth + "/>"));
}

TEST_CASE("painted terrain lies over the grass that comes before it") {
    std::string const plain = "<path class='terrain' " + earth + "/>", red = "<rect width='1' height='1' fill='red'/>";
    std::string const slab = "<path class='terrain' fill='blue' d='M2 5H3V6H2Z'/>";
    CHECK(!read(with(red + slab + plain)).in_front);
    CHECK(read(with(red + plain + slab)).in_front == 1);
}

TEST_CASE("a gradient stands for its mean colour") {
    std::string const stops = "<stop offset='0' stop-color='#000'/><stop offset='100%' style='stop-color:#f80'/>";
    auto const of = [&](std::string const& defs) {
        return painted("<defs>" + defs + "</defs><path class='terrain' fill='url(#a)' " + earth + "/>");
    };
    CHECK(of("<linearGradient id='a'>" + stops + "</linearGradient>") == "#804400/none/0/1");
    // The outer half of a disc's radius is three quarters of its area.
    CHECK(of("<radialGradient id='a'><stop offset='.5' stop-color='#000'/><stop offset='.5' "
             "stop-color='#fc8'/></radialGradient>") == "#bf9966/none/0/1");
    CHECK(of("<linearGradient id='b'><stop stop-color='#123456'/></linearGradient><linearGradient id='a' "
             "href='#b'/>") == "#123456/none/0/1");
    CHECK(of("<linearGradient id='a'><stop stop-color='red'/><stop offset='1' stop-color='red' "
             "stop-opacity='0'/></linearGradient>") == "#ff0000/none/0/0.5");
    CHECK(of("<linearGradient id='a' href='#b'/><linearGradient id='b' href='#a'/>") == "");
    // Two that share their stops, each with its own mean of them.
    auto const two =
        read(with("<linearGradient id='s'><stop offset='.5' stop-color='#000'/><stop offset='.5' "
                  "stop-color='#fc8'/></linearGradient><radialGradient id='r' href='#s'/>"
                  "<linearGradient id='l' href='#s'/><rect width='1' height='1' fill='url(#r)'/>"
                  "<rect width='1' height='1' fill='url(#l)'/>"));
    CHECK(two.decorations.at(0).fill == "#bf9966");
    CHECK(two.decorations.at(1).fill == "#806644");
    CHECK(painted("<path class='terrain' fill='url(#none) #abc' " + earth + "/>") == "#aabbcc/none/0/1");
    auto const level = read(with("<radialGradient id='a'>" + stops +
                                 "</radialGradient><rect fill='url(#a)' width='1' "
                                 "height='1'/>"));
    REQUIRE(level.remarks.size() == 1);
    CHECK(level.remarks[0].text == "svg: gradients are shown as their mean colour");
}

TEST_CASE("a gradient straight down is kept, all others stand for their means") {
    std::string const stops = "<stop stop-color='#123456' stop-opacity='0'/><stop offset='1' stop-color='#f80'/>";
    auto const of = [](std::string const& attributes, std::string const& given, std::string const& shape = "") {
        auto const level = read(with("<linearGradient id='a' " + attributes + ">" + given + "</linearGradient><rect " +
                                     shape + " fill='url(#a)' fill-opacity='.5' width='1' height='8'/>"));
        CHECK(level.remarks.empty() == level.decorations.at(0).fade.has_value());
        return level.decorations.at(0).fade;
    };
    std::string const user_space = "gradientUnits='userSpaceOnUse' ";
    auto const down = of(user_space + "x1='3' y1='2' x2='3' y2='6'", stops);
    REQUIRE(down);
    CHECK(down->top == "#123456");
    CHECK(down->bottom == "#ff8800");
    CHECK(down->top_opacity == 0);
    CHECK(down->bottom_opacity == 0.5);
    CHECK(down->top_y == 7);  // the page is 9 m high
    CHECK(down->bottom_y == 3);

    auto const up = of(user_space + "x1='3' y1='6' x2='3' y2='2'", stops, "transform='translate(0 1)'");
    REQUIRE(up);
    CHECK(up->top == "#ff8800");
    CHECK(up->top_y == 6);
    CHECK(up->bottom_y == 2);

    std::string const half = "<stop offset='.5' stop-color='red'/><stop offset='1' stop-color='blue'/>";
    auto const late = of(user_space + "x1='0' y1='2' x2='0' y2='6'", half);
    REQUIRE(late);
    CHECK(late->top_y == 5);
    CHECK(late->bottom_y == 3);

    CHECK(!of("x1='0' y1='0' x2='0' y2='1'", stops));  // of the shape's box
    CHECK(!of(user_space + "x1='3' y1='2' x2='4' y2='6'", stops));
    CHECK(!of(user_space + "x1='3' y1='2' x2='3' y2='2'", stops));
    CHECK(!of(user_space + "y1='2' y2='6'", stops));
    CHECK(!of(user_space + "x1='3' y1='20%' x2='3' y2='6'", stops));
    CHECK(!of(user_space + "x1='3' y1='2' x2='3' y2='6' spreadMethod='reflect'", stops));
    CHECK(!of(user_space + "x1='3' y1='2' x2='3' y2='6' gradientTransform='rotate(9)'", stops));
    CHECK(!of(user_space + "x1='3' y1='2' x2='3' y2='6'", stops, "transform='rotate(30)'"));
    CHECK(!of(user_space + "x1='3' y1='2' x2='3' y2='6'", stops + "<stop offset='1' stop-color='red'/>"));
}

TEST_CASE("a mean is told, whatever is met after it") {
    std::string const defs =
        "<radialGradient id='a'><stop stop-color='red'/></radialGradient>"
        "<linearGradient id='b' gradientUnits='userSpaceOnUse' x1='0' y1='0' x2='0' y2='1'>"
        "<stop stop-color='red'/><stop offset='1' stop-color='blue'/></linearGradient>";
    std::string const rect = "<rect width='1' height='1' fill='url(#";
    for (std::string const later : {"b", "none"}) {
        int told = 0;
        for (level::Finding const& remark : read(with(defs + rect + "a)'/>" + rect + later + ")'/>")).remarks)
            told += remark.text == "svg: gradients are shown as their mean colour" ? 1 : 0;
        CHECK(told == 1);
    }
}

TEST_CASE("colours in every notation of CSS") {
    auto const of = [](std::string const& colour) {
        return painted("<path class='terrain' fill='" + colour + "' " + earth + "/>");
    };
    CHECK(of("#ABC") == "#aabbcc/none/0/1");
    CHECK(of("#abc8") == "#aabbcc/none/0/0.533333");  // 8/15
    CHECK(of("#12345633") == "#123456/none/0/0.2");
    CHECK(of("rgb(18, 52, 86)") == "#123456/none/0/1");
    CHECK(of("RGB(100% 0% 20%)") == "#ff0033/none/0/1");
    CHECK(of("rgba(18,52,86,.5)") == "#123456/none/0/0.5");
    CHECK(of("rgb(18 52 86 / 25%)") == "#123456/none/0/0.25");
    CHECK(of("hsl(120, 100%, 50%)") == "#00ff00/none/0/1");
    CHECK(of("hsl(-120deg 100% 25%)") == "#000080/none/0/1");
    CHECK(of("hsla(.5turn,50%,50%,0.5)") == "#40bfbf/none/0/0.5");
    CHECK(of("LightGoldenRodYellow") == "#fafad2/none/0/1");
    CHECK(of("rgba(0,0,0,0)") == "");
    for (char const* const broken : {"#12345", "#12", "rgb(1,2)", "rgb(1,2,3,4,5)", "hsl(x,1%,1%)", "hwb(1 2% 3%)"})
        CHECK(warnings_of(with("<path class='terrain' fill='" + std::string(broken) + "' " + earth + "/>"))
                  .find("3: terrain: is shown as grass and soil: the paint ") == 0);
    CHECK(painted("<linearGradient id='a'><stop stop-color='rgba(255,0,0,.5)' stop-opacity='.5'/></linearGradient>"
                  "<path class='terrain' fill='url(#a)' " +
                  earth + "/>") == "#ff0000/none/0/0.25");
}

TEST_CASE("a fill has the rule that the drawing gives it, nonzero where it gives none") {
    auto const rule = [](std::string const& attributes) {
        auto const level = read(with("<path class='terrain' fill='red' " + attributes + " " + earth + "/>"));
        CHECK(level.remarks.empty());
        return level.decorations.at(0).fill_rule;
    };
    CHECK(rule("") == geometry::FillRule::nonzero);
    CHECK(rule("fill-rule='nonzero'") == geometry::FillRule::nonzero);
    CHECK(rule("fill-rule='evenodd'") == geometry::FillRule::even_odd);
    CHECK(rule("style='fill-rule: evenodd'") == geometry::FillRule::even_odd);
}

TEST_CASE("balls and goals have the drawing's colours") {
    CHECK(ball_colours("fill='tomato'") == "#ff6347 -");
    CHECK(ball_colours("style='fill:none;stroke:#123456'") == "- #123456");
    CHECK(ball_colours("") == "- -");
    CHECK(ball_colours("fill='url(#a)'", "<radialGradient id='a'><stop stop-color='#39f'/></radialGradient>") ==
          "#3399ff -");
    CHECK(ball_colours("fill='url(#pattern)'") == "- -");
    auto const level = read(with("<rect class='goal' width='1' height='1' fill='none' stroke='red'/>"));
    CHECK(!level.sensor_tints.at(0).fill);
    CHECK(level.sensor_tints.at(0).stroke == "#ff0000");
}

TEST_CASE("a stroke wider than 2 % of the ball is remarked on") {
    auto const remarks = [](std::string const& width, std::string const& more = "") {
        auto const level =
            read(with("<path class='terrain' stroke='red' stroke-width='" + width + "' " + earth + "/>\n" + more));
        return level.remarks.empty() ? "" : std::to_string(level.remarks[0].line) + ": " + level.remarks[0].text;
    };
    CHECK(remarks("0.02") == "");  // the ball is 1 m across
    CHECK(remarks("0.021") ==
          "3: terrain: a stroke of 0.021 m is wider than 2 % of the ball, which touches its middle");
    CHECK(remarks("0.1", "<line class='terrain' x2='9' stroke='red'/>") ==
          "3: terrain: a stroke of 0.1 m is wider than 2 % of the ball, which touches its middle, and 1 more");
}
