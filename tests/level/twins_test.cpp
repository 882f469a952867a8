// Every way of drawing beside its plain twin: both must give the same terrain, balls and goals.
#include <doctest/doctest.h>

#include "drawing.h"

using namespace drawing;
using geometry::Arc;
using geometry::Segment;
using geometry::Vec2;

namespace {

constexpr double same_place = 1e-12;  // m

std::string shown(geometry::Curve const& curve) {
    std::ostringstream text;
    text.precision(17);
    if (auto const* s = std::get_if<Segment>(&curve))
        text << "segment " << s->start.x() << ' ' << s->start.y() << ' ' << s->end.x() << ' ' << s->end.y();
    else if (auto const* a = std::get_if<Arc>(&curve))
        text << "arc " << a->centre.x() << ' ' << a->centre.y() << ' ' << a->radius << ' ' << a->from << ' '
             << a->sweep;
    return text.str();
}

bool are_same(geometry::Curve const& a, geometry::Curve const& b) {
    if (a.index() != b.index()) return false;
    bool const ends_meet = distance(geometry::start_of(a), geometry::start_of(b)) <= same_place &&
                           distance(geometry::end_of(a), geometry::end_of(b)) <= same_place;
    auto const *arc = std::get_if<Arc>(&a), *twin = std::get_if<Arc>(&b);
    if (arc == nullptr) return ends_meet;
    return ends_meet && distance(arc->centre, twin->centre) <= same_place &&
           std::abs(arc->radius - twin->radius) <= same_place && std::abs(arc->sweep - twin->sweep) <= same_place;
}

// Empty where both levels are the same, else the first difference.
std::string difference(std::string const& text, std::string const& twin_text) {
    auto const level = read(text), twin = read(twin_text);
    auto const curves = curves_of(level), twins = curves_of(twin);
    if (curves.size() != twins.size())
        return std::to_string(curves.size()) + " pieces against " + std::to_string(twins.size());
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (!are_same(curves[i], twins[i])) return shown(curves[i]) + " against " + shown(twins[i]);
    if (level.scene.balls.size() != twin.scene.balls.size()) return "other balls";
    for (std::size_t i = 0; i < level.scene.balls.size(); ++i) {
        auto const &ball = level.scene.balls[i], &other = twin.scene.balls[i];
        if (distance(ball.start.position, other.start.position) > same_place) return "a ball elsewhere";
        if (std::abs(ball.radius - other.radius) > same_place) return "a ball of another size";
    }
    return level.meanings == twin.meanings && level.player == twin.player ? "" : "other sensors or another player";
}

std::string const hill = "<path class='terrain' fill='none' d='M1 8A3 3 0 0 0 7 8H9L12 7'/>";

std::string moved(std::string const& how) { return with("<g " + how + ">" + hill + "</g>"); }

// The terrain of a drawing under a transform against the same under a matrix.
std::string against_matrix(std::string const& how, std::string const& matrix) {
    return difference(moved(how), moved("transform='matrix(" + matrix + ")'"));
}

}  // namespace

TEST_CASE("transforms in a style and with units are those of the attribute") {
    CHECK(against_matrix("style='transform:translate(1px, 2px)'", "1 0 0 1 1 2") == "");
    CHECK(against_matrix("style='transform : translate(1px) /* x */ scale(.5) !important'", ".5 0 0 .5 1 0") == "");
    CHECK(against_matrix("transform='scale(9)' style='transform:translateX(1px) translateY(.5px)'", "1 0 0 1 1 .5") ==
          "");
    CHECK(against_matrix("transform='scale(9)' style='transform:none'", "1 0 0 1 0 0") == "");
    CHECK(against_matrix("style='transform:rotate(90deg)'", "0 1 -1 0 0 0") == "");
    CHECK(against_matrix("style='transform:rotate(.25turn)'", "0 1 -1 0 0 0") == "");
    CHECK(against_matrix("style='transform:rotate(100grad)'", "0 1 -1 0 0 0") == "");
    CHECK(against_matrix("transform='rotate(1.5707963267948966rad)'", "0 1 -1 0 0 0") == "");
    CHECK(against_matrix("style='transform:ROTATE(180DEG)'", "-1 0 0 -1 0 0") == "");
    CHECK(against_matrix("style='transform:scaleX(-1)'", "-1 0 0 1 0 0") == "");
    CHECK(against_matrix("style='transform:scaleY(-1)'", "1 0 0 -1 0 0") == "");
    CHECK(against_matrix("style='transform:skewX(45deg)'", "1 0 1 1 0 0") == "");
    CHECK(against_matrix("style='transform:matrix(0,1,-1,0,3,0)'", "0 1 -1 0 3 0") == "");
    CHECK(against_matrix("style='transform:translate(25.4mm)'", "1 0 0 1 96 0") == "");
    // Of the viewBox: 16 by 9.
    CHECK(against_matrix("style='transform:translate(50%, 50%)'", "1 0 0 1 8 4.5") == "");
    CHECK(against_matrix("style='translate:1px 2px; rotate:90deg; scale:2'", "0 2 -2 0 1 2") == "");
    CHECK(against_matrix("style='transform:scale(50%)'", ".5 0 0 .5 0 0") == "");
    CHECK(against_matrix("transform='scale(9)' style='transform:unset'", "1 0 0 1 0 0") == "");
    // The names that browsers still read with the prefix of old.
    CHECK(against_matrix("style='-webkit-transform:rotate(90deg)'", "0 1 -1 0 0 0") == "");
    CHECK(against_matrix("style='-WEBKIT-transform:scale(2);transform:scaleX(-1)'", "-1 0 0 1 0 0") == "");
    CHECK(against_matrix("style='transform:scale(2);-webkit-transform-origin:1px 1px'", "2 0 0 2 -1 -1") == "");
    CHECK(difference(with("<style>g{-webkit-transform:scaleX(-1)}</style><g>" + hill + "</g>"),
                     moved("transform='scale(-1,1)'")) == "");
    // Of the shape's own box: 2 by 1.
    CHECK(difference(with("<rect class='terrain' x='8' y='5' width='2' height='1' "
                          "style='transform-box:fill-box;transform:translate(50%,100%)'/>"),
                     with("<rect class='terrain' x='9' y='6' width='2' height='1'/>")) == "");
}

TEST_CASE("points without length count for the box of a path") {
    // A half turn about the middle of the box takes p to low + high - p; the box as Chromium has it.
    auto const turned = [](std::string const& points, std::string const& twin) {
        std::string const corner = "M2 2h4v4z";
        return difference(with("<path class='terrain' d='" + corner + points +
                               "' style='transform-box:fill-box;transform-origin:center;transform:rotate(180deg)'/>"),
                          with("<path class='terrain' d='" + twin + "'/>"));
    };
    CHECK(turned("", "M6 6h-4v-4z") == "");
    CHECK(turned("M20 20", "M6 6h-4v-4z") == "");
    CHECK(turned("zz", "M6 6h-4v-4z") == "");
    CHECK(turned("M10 8z", "M10 8h-4v-4z") == "");
    CHECK(turned("m8 6z", "M10 8h-4v-4z") == "");
    CHECK(turned("M10 8h0", "M10 8h-4v-4z") == "");
    CHECK(turned("M10 8l0 0z", "M10 8h-4v-4z") == "");
}

TEST_CASE("a transform's origin is where the style or attribute puts it") {
    // A half turn about (x, y) takes p to 2 (x, y) - p.
    CHECK(against_matrix("transform='rotate(180)' transform-origin='8 4.5'", "-1 0 0 -1 16 9") == "");
    CHECK(against_matrix("style='transform:rotate(180deg);transform-origin:8px 4.5px'", "-1 0 0 -1 16 9") == "");
    CHECK(against_matrix("transform='rotate(180)' style='transform-origin:50% 50%'", "-1 0 0 -1 16 9") == "");
    CHECK(against_matrix("transform='rotate(180)' transform-origin='center'", "-1 0 0 -1 16 9") == "");
    CHECK(against_matrix("transform='rotate(180)' transform-origin='Bottom Right'", "-1 0 0 -1 32 18") == "");
    CHECK(against_matrix("transform='rotate(180)' transform-origin='top'", "-1 0 0 -1 16 0") == "");
    CHECK(against_matrix("transform='rotate(180)' transform-origin='left'", "-1 0 0 -1 0 9") == "");
    CHECK(against_matrix("transform='rotate(180)' transform-origin='2'", "-1 0 0 -1 4 9") == "");
    CHECK(against_matrix("transform='rotate(180)' transform-origin='center left'", "-1 0 0 -1 0 9") == "");
    CHECK(against_matrix("transform='rotate(180)' transform-origin='1px 2px 0px'", "-1 0 0 -1 2 4") == "");
    CHECK(against_matrix("transform='scale(2)' transform-origin='1 1'", "2 0 0 2 -1 -1") == "");
    // No attribute: browsers measure from the viewBox all the same.
    CHECK(against_matrix("transform='scale(2)' transform-origin='1 1' transform-box='fill-box'", "2 0 0 2 -1 -1") ==
          "");
    // The box of the shape itself.
    CHECK(difference(with("<rect class='terrain' x='8' y='5' width='2' height='1' "
                          "style='transform-box:fill-box;transform-origin:center;transform:rotate(90deg)'/>"),
                     with("<path class='terrain' d='M9.5 4.5V6.5H8.5V4.5z'/>")) == "");
    CHECK(fault_of(moved("transform='scale(2)' transform-origin='1 2 3 4'"))
              .find(":3: g: transform-origin: two lengths were expected") == 0);
}

TEST_CASE("hidden in whatever way is not there") {
    std::string const plain = with(hill);
    auto const hidden = [&](std::string const& how) {
        return difference(with("<g " + how + "><path class='terrain' d='M0 3.5H16'/></g>" + hill), plain);
    };
    CHECK(hidden("display='NONE'") == "");
    CHECK(hidden("style='display:NONE'") == "");
    CHECK(hidden("style='DISPLAY : None ! important'") == "");
    CHECK(hidden("style='/* gone */display:none'") == "");
    CHECK(hidden("style='fill:red;/* ; */display:/**/none/* x'") == "");
    CHECK(hidden("style='background:url(\"data:a;display:inline\");display:none'") == "");
    CHECK(hidden("style='display:none;display:nonsense'") == "");
    CHECK(difference(with("<path class='terrain' style='display:contents' d='M0 3.5H16'/>" + hill), plain) == "");
    CHECK(difference(with("<g style='display:contents'>" + hill + "</g>"), plain) == "");
    CHECK(difference(with("<g display='none' style='display:inherit'>" + hill + "</g>"), plain) == "");
    CHECK(hidden("systemLanguage='de'") == "");
    CHECK(hidden("requiredExtensions='urn:x'") == "");
    CHECK(hidden("xmlns='urn:x'") == "");
    CHECK(hidden("xmlns=''") == "");
    CHECK(difference(with("<g display='none' style='display:inline'>" + hill + "</g>"), plain) == "");
    CHECK(difference(with("<g style='x:\"display:none\"'>" + hill + "</g>"), plain) == "");
}

TEST_CASE("style sheets with simple selectors count") {
    std::string const plain = with(hill);
    auto const sheet = [&](std::string const& css) {
        return difference(with("<style>" + css + "</style><path class='terrain st0' id='no' d='M0 3.5H16'/>" + hill),
                          plain);
    };
    CHECK(sheet(".st0{display:none}") == "");
    CHECK(sheet("#no { DISPLAY : none }") == "");
    CHECK(sheet("a, .b , #no{fill:red;display:none}") == "");
    CHECK(sheet("/* } */ .x{} .st0{display:none /* } */}") == "");
    CHECK(sheet("@font-face{font-family:x} .st0{display:none}") == "");
    CHECK(sheet("#no{display:none} .st0{display:inline}") == "");
    CHECK(sheet("@media screen{rect{} .st0{display:none}} .x{}") == "");
    CHECK(sheet("@Media print , all {} @media all{.x{}@media screen{.y{}}.st0{display:none}}") == "");
    CHECK(sheet("@media screen{.st0{display:inline}} .st0{display:none}") == "");
    CHECK(sheet("@media print{.st0{display:inline}} .st0{display:none} @media (width:1px){.st0{display:inline}}") ==
          "");
    CHECK(sheet(".st0{display:none!important} #no{display:inline}") == "");
    CHECK(sheet(".st0{display:inline} .st0{display:none}") == "");
    CHECK(sheet("path{display:inline} .st0{display:none}") == "");
    CHECK(difference(with("<style>rect{display:none}*{fill:red}</style><rect class='terrain' x='1' y='4' width='9' "
                          "height='1'/>" +
                          hill),
                     plain) == "");
    CHECK(difference(with("<style><![CDATA[.a>.b{x:y} .m{transform:translate(1px,2px)}]]></style><g class='m'>" + hill +
                          "</g>"),
                     moved("transform='translate(1 2)'")) == "");
    CHECK(difference(with("<style type='text/x'>.terrain{display:none}</style>" + hill), plain) == "");
    CHECK(difference(with("<style media='print'>.terrain{display:none}</style>" + hill), plain) == "");
    CHECK(difference(with("<style media='print, screen'>rect{display:none}</style><rect class='terrain' x='1' y='4' "
                          "width='9' height='1'/>" +
                          hill),
                     plain) == "");
    CHECK(warnings_of(with("<style>g .a{x:y} .b:hover{x:y} @media print{.c{}}</style>" + hill)) ==
          "3: style: the selector g .a is ignored, and 2 more");
    CHECK(warnings_of(with("<style>.a{fill:red; .b{display:none}}</style>" + hill)) ==
          "3: style: a rule within the rule of .a is ignored");
    CHECK(warnings_of(with("<style>.a{dis\\70lay:none}</style>" + hill)) ==
          "3: style: an escape, \\70lay:none}, is ignored");
}

TEST_CASE("a use is a copy of what it refers to") {
    std::string const xlink = "xmlns:xlink='http://www.w3.org/1999/xlink'";
    std::string const bar = "<path id='bar' class='terrain' d='M1 7H4'/>";
    auto const copy = [&](std::string const& use, std::string const& twin) {
        return difference(with(bar + use, xlink), with(bar + twin));
    };
    std::string const at_right = "<path class='terrain' d='M6 8H9'/>";
    CHECK(copy("<use href='#bar' x='5' y='1'/>", at_right) == "");
    CHECK(copy("<use xlink:href='#bar' transform='translate(5 1)'/>", at_right) == "");
    CHECK(copy("<use href='#bar' x='5' y='1' transform='rotate(180 5 4)'/>", "<path class='terrain' d='M4 0H1'/>") ==
          "");
    CHECK(copy("<g id='two'><use href='#bar' x='5'/></g><use href='#two' y='1'/>",
               "<path class='terrain' d='M6 7H9'/>" + at_right) == "");
    CHECK(copy("<use href='#bar' style='display:none'/>", "") == "");
    CHECK(difference(with("<defs><path id='s' d='M1 7H4'/></defs><use class='terrain' href='#s'/>"),
                     with("<path class='terrain' d='M1 7H4'/>")) == "");
    CHECK(difference(with("<symbol id='s' viewBox='0 0 2 2'><path class='terrain' d='M0 1H2'/></symbol>"
                          "<use href='#s' x='6' y='4' width='4' height='4'/>"),
                     with("<path class='terrain' d='M6 6H10'/>")) == "");
    // The copy of a svg turns about the middle of the page, the svg itself about its corner.
    CHECK(difference(with("<defs><svg id='s' transform='rotate(180)'><path class='terrain' d='M1 7H4'/></svg></defs>"
                          "<use href='#s'/>"),
                     with("<path class='terrain' d='M15 2H12'/>")) == "");
    CHECK(difference(with("<svg transform='rotate(180)'><path class='terrain' d='M-1 -7H-4'/></svg>"),
                     with("<path class='terrain' d='M1 7H4'/>")) == "");
    CHECK(difference(with("<circle id='b' class='ball' cx='6' cy='4' r='.5'/><use href='#b' x='3'/>"),
                     with("<circle class='ball' cx='6' cy='4' r='.5'/><circle class='ball' cx='9' cy='4' r='.5'/>")) ==
          "");
    auto const level =
        read(with("<defs><path id='s' class='terrain' d='M1 7H4'/></defs>"
                  "<g data-friction='.1'><use id='here' href='#s' data-restitution='.2'/></g>"));
    CHECK(level.scene.terrain.pieces[0].material.friction == 0.1);
    CHECK(level.scene.terrain.pieces[0].material.restitution == 0.2);
    CHECK(level.surface_names == std::vector<std::string>{"here"});
    // A copy of the player's ball is another ball.
    auto const two = read(with("<circle id='player' class='ball' cx='6' cy='4' r='.5'/><use href='#player' x='3'/>"));
    CHECK(two.player == 1);
    CHECK(two.scene.balls.size() == 3);
}

TEST_CASE("what a use cannot copy") {
    CHECK(fault_of(with("<g id='a'><use href='#a'/></g>")) == ":3: use: is part of what it copies, #a");
    CHECK(fault_of(with("<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>"))
              .find(":3: use: is part of what it copies") == 0);
    CHECK(fault_of(with("<use id='a' href='#a'/>")) == ":3: use: is part of what it copies, #a");
    CHECK(warnings_of(with("<use href='other.svg#a'/>")) ==
          "3: use: is ignored: only elements of the same file are copied, got other.svg#a");
    CHECK(warnings_of(with("<use href='#nobody'/>")) == "3: use: is ignored: there is no element #nobody");
    std::string many = "<path id='c0' class='terrain' d='M1 7h1'/>";
    for (int i = 1; i < 7; ++i) {
        many += "<g id='c" + std::to_string(i) + "'>";
        for (int k = 0; k < 10; ++k) many += "<use href='#c" + std::to_string(i - 1) + "'/>";
        many += "</g>";
    }
    std::string const full = fault_of(with(many));
    CHECK(full.find("a level must have at most 100000 elements, copies by use included") != std::string::npos);
    std::string const long_path = "<path id='p' class='terrain' d='M0 7" + std::string(2'000'000, ' ') + "H1'/>";
    std::string uses;
    for (int i = 0; i < 40; ++i) uses += "<use href='#p'/>";
    CHECK(fault_of(with(long_path + uses)) == ":3: path: copies by use must have at most 64 MB, got more");
}

TEST_CASE("a switch shows its first child that applies") {
    std::string const plain = with(hill);
    std::string const other = "<path class='terrain' d='M0 3.5H16'/>";
    auto const chosen = [&](std::string const& children) {
        return difference(with("<switch>" + children + "</switch>"), plain);
    };
    CHECK(chosen(hill + other) == "");
    CHECK(chosen("<g systemLanguage='de, fr'>" + other + "</g><g systemLanguage='fr, en-GB'>" + hill + "</g>" +
                 other) == "");
    CHECK(chosen("<x xmlns='urn:x'/><foreignObject requiredExtensions='urn:x'/><g>" + hill + "</g>") == "");
    // As Chromium: whatever is an element of SVG is a child to choose.
    for (std::string const tag : {"title", "desc", "defs", "metadata", "style", "clipPath", "symbol"}) {
        CAPTURE(tag);
        std::string const first = "<switch><" + tag + "/>" + other + "</switch>";
        CHECK(difference(with(first + hill), plain) == "");
        CHECK(warnings_of(with(first + hill)) ==
              "3: switch: shows nothing: the first of its children that applies is " + tag);
    }
    CHECK(difference(with("<switch><g display='none'/>" + other + "</switch>" + hill), plain) == "");
    // What browsers do not copy is not there to be chosen in a copy; a title is.
    auto const copied = [&](std::string const& first) {
        return difference(with("<defs><switch id='s'>" + first + hill + "</switch></defs><use href='#s'/>"), plain);
    };
    CHECK(copied("<foreignObject width='4' height='4'/>") == "");
    CHECK(copied("<defs/><style/><clipPath/><marker/><unknown/>") == "");
    CHECK(difference(with("<defs><switch id='s'><title/>" + other + "</switch></defs><use href='#s'/>" + hill),
                     plain) == "");
    // What every browser says to know, and a list with what none does.
    std::string const xhtml = "http://www.w3.org/1999/xhtml", mathml = "http://www.w3.org/1998/Math/MathML";
    CHECK(chosen("<g requiredExtensions='" + xhtml + "'>" + hill + "</g>" + other) == "");
    CHECK(chosen("<g requiredExtensions=' " + mathml + " " + xhtml + "'>" + hill + "</g>" + other) == "");
    CHECK(chosen("<g requiredExtensions='" + xhtml + " urn:x'>" + other + "</g>" + hill) == "");
    CHECK(chosen("<g requiredExtensions=''>" + other + "</g>" + hill) == "");
}

TEST_CASE("a link that is the child of a link shows nothing") {
    std::string const plain = with(hill);
    std::string const other = "<path class='terrain' d='M0 3.5H16'/>";
    CHECK(difference(with("<a><a>" + other + "</a>" + hill + "</a>"), plain) == "");
    CHECK(warnings_of(with("<a><a>" + other + "</a>" + hill + "</a>")) ==
          "3: a: shows nothing: it is the child of another a");
    CHECK(difference(with("<a><g><a>" + hill + "</a></g></a>"), plain) == "");
    CHECK(difference(with("<a><switch><a>" + hill + "</a></switch></a>"), plain) == "");
    CHECK(difference(with("<defs><a><a id='s'>" + hill + "</a></a></defs><a><use href='#s'/></a>"), plain) == "");
    CHECK(difference(with("<defs><g id='s'><a><a>" + other + "</a>" + hill + "</a></g></defs><use href='#s'/>"),
                     plain) == "");
}

TEST_CASE("a nested svg shows its viewBox in its place") {
    std::string const line = "<path class='terrain' d='M0 1H4'/>";
    auto const nested = [&](std::string const& how, std::string const& twin) {
        return difference(with("<svg " + how + ">" + line + "</svg>"),
                          with("<path class='terrain' d='" + twin + "'/>"));
    };
    CHECK(nested("x='5' y='4'", "M5 5H9") == "");
    CHECK(nested("x='5' y='4' width='8' height='4' viewBox='0 0 4 2'", "M5 6H13") == "");
    // Twice as wide as high: the picture stands in the middle, or as it is told.
    CHECK(nested("x='4' y='4' width='8' height='4' viewBox='0 0 4 4'", "M6 5H10") == "");
    CHECK(nested("x='4' y='4' width='8' height='4' viewBox='0 0 4 4' preserveAspectRatio='xMinYMin'", "M4 5H8") == "");
    CHECK(nested("x='4' y='4' width='8' height='4' viewBox='0 0 4 4' preserveAspectRatio='xMaxYMid meet'", "M8 5H12") ==
          "");
    CHECK(nested("x='4' y='4' width='8' height='4' viewBox='0 0 4 4' preserveAspectRatio='none'", "M4 5H12") == "");
    CHECK(nested("x='4' y='4' width='8' height='4' viewBox='0 0 4 4' preserveAspectRatio='xMidYMid slice' "
                 "overflow='visible'",
                 "M4 4H12") == "");
    CHECK(nested("x='25%' width='50%' height='4' viewBox='0 0 8 4'", "M4 1H8") == "");
    CHECK(warnings_of(with("<svg x='9' y='5' width='2' height='2'>" + line + "</svg>")) ==
          "3: terrain: reaches out of its svg, where browsers cut it off; it counts whole");
    // Seen is the place of the svg, not its viewBox, as it is turned, and within the place of every svg around it.
    auto const is_cut = [&](std::string const& how, std::string const& shape) {
        return warnings_of(with("<svg " + how + "><path class='terrain' d='" + shape + "'/></svg>"))
                   .find("reaches out of its svg") != std::string::npos;
    };
    std::string const wide = "x='4' y='4' width='8' height='4' viewBox='0 0 4 4' ";
    CHECK(!is_cut(wide, "M-2 1H6"));
    CHECK(is_cut(wide, "M-2.1 1H6"));
    CHECK(!is_cut(wide + "preserveAspectRatio='xMidYMid slice'", "M0 1.1H4"));
    CHECK(is_cut(wide + "preserveAspectRatio='xMidYMid slice'", "M0 .9H4"));
    std::string const turned = "x='8' y='4' width='2' height='2' transform='rotate(45 9 5)'";
    CHECK(!is_cut(turned, "M0 0H2V2H0z"));
    CHECK(is_cut(turned, "M1 1L2 0L2.1 -.1"));
    CHECK(!is_cut(turned, "M0 1A1 1 0 0 1 2 1"));
    CHECK(is_cut(turned, "M0 1A1 1.1 0 0 1 2 1"));
    auto const within_two = [&](std::string const& shape) {
        return warnings_of(with("<svg width='4' height='4'><svg x='3' width='4' height='2'><path class='terrain' d='" +
                                shape + "'/></svg></svg>"));
    };
    CHECK(within_two("M0 1H1") == "");
    CHECK(within_two("M0 1H1.1") == "3: terrain: reaches out of its svg, where browsers cut it off; it counts whole");
    CHECK(fault_of(with("<svg viewBox='0 0 1'/>")) == ":3: svg: viewBox must be four finite numbers, got 0 0 1");
}

TEST_CASE("a class on a group gives its role to the shapes within, the nearest wins") {
    CHECK(difference(with("<g class='terrain'><path d='M1 8H9'/><g><line x1='1' x2='9' y1='7' y2='7'/></g></g>"),
                     with("<path class='terrain' d='M1 8H9'/><path class='terrain' d='M1 7H9'/>")) == "");
    CHECK(difference(with("<g class='terrain'><path d='M1 8H9'/><circle class='ball' cx='6' cy='2' r='.5'/></g>"),
                     with("<path class='terrain' d='M1 8H9'/><circle class='ball' cx='6' cy='2' r='.5'/>")) == "");
    CHECK(difference(with("<g class='ball'><circle cx='6' cy='2' r='.5'/></g>"),
                     with("<circle class='ball' cx='6' cy='2' r='.5'/>")) == "");
}

TEST_CASE("balls, bananas and goals of any shape that is a circle") {
    std::string const plain = with("<circle class='ball' cx='6' cy='3' r='.5'/>");
    auto const ball = [&](std::string const& shape) { return difference(with(shape), plain); };
    CHECK(ball("<ellipse class='ball' cx='6' cy='3' rx='.5' ry='.5'/>") == "");
    CHECK(ball("<ellipse class='ball' cx='3' cy='3' rx='.25' ry='.5' transform='scale(2 1)'/>") == "");
    CHECK(ball("<path class='ball' d='M6.5 3a.5.5 0 0 1-.5.5.5.5 0 0 1-.5-.5.5.5 0 0 1 .5-.5.5.5 0 0 1 .5.5z'/>") ==
          "");
    CHECK(ball("<path class='ball' d='M5.5 3a.5.5 0 1 0 1 0a.5.5 0 1 0-1 0'/>") == "");
    CHECK(ball("<rect class='ball' x='5.5' y='2.5' width='1' height='1' rx='.5'/>") == "");
    // Four cubic curves leave a circle by 2.7e-4 of its radius at most.
    auto const cubic =
        read(with("<path class='banana' d='M10.552285 5c-.5522847 0-1 .4477153-1 1s.4477153 1 1 1 1-.4477153 "
                  "1-1-.4477153-1-1-1z'/>"));
    auto const disc = std::get<physics::DiscRegion>(cubic.scene.sensors[0].region);
    CHECK(distance(disc.centre, {10.552285, 3}) < 1e-3);
    CHECK(disc.radius == doctest::Approx(1).epsilon(1e-3));
    CHECK(fault_of(with("<path class='ball' d='M6.5 3a.5.5 0 0 1-.5.502.5.5 0 0 1-.5-.502.5.5 0 0 1 1 0z'/>"))
              .find("it is not a circle to 1e-3 of its radius") != std::string::npos);
    CHECK(fault_of(with("<path class='ball' d='M5 5h1v1h-1z'/>"))
              .find(":3: ball: path cannot be ball: it is not a circle") == 0);
    auto const goal = read(with("<path class='goal' d='M9 3a1 1 0 1 0 2 0a1 1 0 1 0-2 0z'/>"));
    CHECK(std::get<physics::DiscRegion>(goal.scene.sensors[0].region).radius == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("terrain of ellipses and of rects with round corners") {
    auto const ellipse = curves_of(read(with("<ellipse class='terrain' cx='8' cy='5' rx='4' ry='2' fill='none'/>")));
    REQUIRE(ellipse.size() > 4);
    for (int i = 0; i < 360; ++i) {
        double const angle = i * 3.14159265358979 / 180;
        Vec2 const point(8 + 4 * std::cos(angle), 4 + 2 * std::sin(angle));
        double nearest = 1e9;
        for (auto const& curve : ellipse) nearest = std::min(nearest, geometry::nearest_point(curve, point).distance);
        CHECK(nearest <= 1e-3);
    }
    CHECK(
        difference(with("<rect class='terrain' x='8' y='5' width='4' height='2' rx='.5'/>"),
                   with("<path class='terrain' d='M8.5 5H11.5A.5.5 0 0 1 12 5.5V6.5A.5.5 0 0 1 11.5 7H8.5A.5.5 0 0 1 8 "
                        "6.5V5.5A.5.5 0 0 1 8.5 5z'/>")) == "");
}

TEST_CASE("lengths with units and in per cent") {
    auto const same = [](std::string const& shape, std::string const& twin) {
        return difference(with(shape), with(twin));
    };
    // Per cent of the viewBox, 16 by 9; of sqrt((16^2 + 9^2) / 2) = 12.9807549857 for what is neither across nor down.
    CHECK(same("<rect class='terrain' x='25%' y='50%' width='50%' height='100%'/>",
               "<rect class='terrain' x='4' y='4.5' width='8' height='9'/>") == "");
    CHECK(same("<line class='terrain' x1='50%' y1='4.5px' x2='100%' y2='100%'/>",
               "<line class='terrain' x1='8' y1='4.5' x2='16' y2='9'/>") == "");
    CHECK(same("<circle class='terrain' cx='.0635cm' cy='1.5875mm' r='.03125in'/>",
               "<circle class='terrain' cx='2.4' cy='6' r='3'/>") == "");
    CHECK(same("<circle class='ball' cx='9pt' cy='.125pc' r='.75PT'/>",
               "<circle class='ball' cx='12' cy='2' r='1'/>") == "");
    auto const share = read(with("<circle class='banana' cx='8' cy='5' r='10%'/>")).scene.sensors.at(0).region;
    CHECK(std::get<physics::DiscRegion>(share).radius == doctest::Approx(1.29807549857).epsilon(1e-11));
    CHECK(same("<ellipse class='terrain' cx='50%' cy='5' rx='25%' ry='4'/>",
               "<circle class='terrain' cx='8' cy='5' r='4'/>") == "");
    CHECK(same("<ellipse class='terrain' cx='8' cy='5' ry='2'/>", "<circle class='terrain' cx='8' cy='5' r='2'/>") ==
          "");
    CHECK(same("<rect class='goal' x='50%' y='4' width='2' height='1'/>",
               "<rect class='goal' x='8' y='4' width='2' height='1'/>") == "");
    CHECK(same("<svg x='4' y='1' width='8' height='4' viewBox='0 0 4 2'><rect class='terrain' x='25%' width='50%' "
               "height='50%'/></svg>",
               "<rect class='terrain' x='6' y='1' width='4' height='2'/>") == "");
}

TEST_CASE("a circle of Bezier curves that are rounded to a grid is a ball") {
    // As LibreOffice writes circles: twelve curves in whole hundredths of mm. Handles are 4/3 tan(angle / 4) long.
    auto const circle = [](double radius, double squeeze) {
        constexpr double part = 3.14159265358979323846 / 6;
        double const handle = 4.0 / 3 * std::tan(part / 4);
        std::ostringstream path;
        auto const point = [&](double x, double y) {
            path << ' ' << std::lround(4000 + radius * x) << ',' << std::lround(2000 + radius * y * squeeze);
        };
        path << "<path class='ball' transform='scale(.002)' d='M";
        point(1, 0);
        for (int i = 0; i < 12; ++i) {
            double const from = i * part, to = from + part;
            path << " C";
            point(std::cos(from) - handle * std::sin(from), std::sin(from) + handle * std::cos(from));
            point(std::cos(to) + handle * std::sin(to), std::sin(to) - handle * std::cos(to));
            point(std::cos(to), std::sin(to));
        }
        path << "Z'/>";
        return with(path.str());
    };
    auto const level = read(circle(250, 1));
    REQUIRE(level.scene.balls.size() == 2);
    CHECK(distance(level.scene.balls[1].start.position, {8, 5}) <= 1e-3);
    CHECK(level.scene.balls[1].radius == doctest::Approx(0.5).epsilon(2e-3));
    CHECK(fault_of(circle(250, .98)) ==
          ":3: ball: path cannot be ball: it is not a circle to 5e-3 of its radius; draw a circle, or a path that is "
          "one");
}

TEST_CASE("a goal of any closed shape covers what is drawn") {
    // By the even-odd rule on a grid that avoids the edges.
    auto const covers = [](level::Level const& level, Vec2 const& point) {
        for (auto const& sensor : level.scene.sensors) {
            if (sensor.outside) continue;
            auto const& corners = std::get<physics::PolygonRegion>(sensor.region).corners;
            bool inside = true;
            for (std::size_t i = 0; i < corners.size(); ++i) {
                Vec2 const &a = corners[i], &b = corners[(i + 1) % corners.size()];
                inside = inside && geometry::cross(b - a, point - a) > -1e-9;  // on a seam of two parts as well
            }
            if (inside) return true;
        }
        return false;
    };
    // A U with arms one metre wide, open upwards, and a star of eight corners.
    auto const u = read(with("<path class='goal' d='M2 1H3V5H6V1H7V6H2z'/>"));
    for (double x = 1.55; x < 8; x += 0.1)
        for (double y = 0.55; y < 7; y += 0.1) {
            bool const drawn = x > 2 && x < 7 && y > 1 && y < 6 && !(x > 3 && x < 6 && y < 5);
            CHECK(covers(u, {x, 9 - y}) == drawn);
        }
    auto const star = read(with("<polygon class='goal' points='8,1 8.5,3.5 11,4 8.5,4.5 8,7 7.5,4.5 5,4 7.5,3.5'/>"));
    CHECK(star.sensor_elements.size() == star.scene.sensors.size());
    for (double x = 4.55; x < 12; x += 0.1)
        for (double y = 0.55; y < 8; y += 0.1) {
            double const across = std::abs(x - 8), down = std::abs(y - 4);
            // The edge from (0, 3) to (0.5, 0.5) and its mirror image.
            bool const drawn = across < 0.5 ? down < 3 - 5 * across : across < 3 && down < (3 - across) / 5;
            if (std::abs(down - (3 - 5 * across)) > 1e-6 && std::abs(down - (3 - across) / 5) > 1e-6)
                CHECK(covers(star, {x, 9 - y}) == drawn);
        }
    auto const oval = read(with("<ellipse class='goal' cx='9' cy='4' rx='2' ry='1'/>"));
    CHECK(oval.scene.sensors.size() == 2);
    CHECK(covers(oval, {10.98, 5}));
    CHECK(!covers(oval, {10.7, 5.7}));
}
