#include <clocale>
#include <cmath>

#include <doctest/doctest.h>

#include "drawing.h"

using namespace drawing;

TEST_CASE("the fault of the contract, to the letter") {
    File const file("<svg viewBox=\"0 0 9 9\">\n\n\n<circle class=\"ball\"\n data-mass=\"-1\" r=\"1\"/></svg>");
    CHECK_THROWS_WITH(level::read_level(file.path()),
                      (file.path() + ":4: ball: data-mass must be greater than 0, got -1").c_str());
}

TEST_CASE("T16: every number out of its range is a fault that names it") {
    auto const ball = [](std::string const& attribute) {
        return fault_of("<svg viewBox='0 0 9 9'>\n<circle class='ball' cx='3' cy='3' r='1' " + attribute + "/></svg>");
    };
    CHECK(ball("") == "");
    CHECK(ball("data-mass='0'") == ":2: ball: data-mass must be greater than 0, got 0");
    CHECK(ball("data-mass='nan'") == ":2: ball: data-mass must be finite, got nan");
    CHECK(ball("data-mass='1e999'") == ":2: ball: data-mass must be finite, got 1e999");
    CHECK(ball("data-mass='heavy'") == ":2: ball: data-mass must be a number, got heavy");
    CHECK(ball("data-mass='1,5'") == ":2: ball: data-mass must be a number, got 1,5");
    CHECK(ball("data-mass=''") == ":2: ball: data-mass must be a number, got nothing");
    CHECK(ball("data-inertia='0'") == ":2: ball: data-inertia must be greater than 0 and at most 1, got 0");
    CHECK(ball("data-inertia='1.01'") == ":2: ball: data-inertia must be greater than 0 and at most 1, got 1.01");
    CHECK(ball("data-inertia='1'") == "");
    CHECK(ball("data-inertia='1e-6'") == "");
    CHECK(ball("data-restitution='1.1'") == ":2: ball: data-restitution must be from 0 to 1, got 1.1");
    CHECK(ball("data-restitution='-0.1'") == ":2: ball: data-restitution must be from 0 to 1, got -0.1");
    CHECK(ball("data-friction='-1'") == ":2: ball: data-friction must be at least 0, got -1");
    CHECK(ball("data-friction='inf'") == ":2: ball: data-friction must be finite, got inf");
    CHECK(ball("data-velocity='1'") == ":2: ball: data-velocity must be two finite numbers, vx vy, got 1");
    CHECK(ball("data-velocity='1 x'") == ":2: ball: data-velocity must be two finite numbers, vx vy, got 1 x");
    CHECK(ball("data-velocity='1 inf'") == ":2: ball: data-velocity must be two finite numbers, vx vy, got 1 inf");
    CHECK(ball("data-velocity='0 1000001'") == ":2: ball: data-velocity must be at most 1e6 m/s, got 0 1000001");
    CHECK(ball("data-velocity='0 1000000'") == "");
    CHECK(ball("data-spin='-inf'") == ":2: ball: data-spin must be finite, got -inf");
    CHECK(ball("data-spin='1e7'") == ":2: ball: data-spin must move the rim with at most 1e6 m/s, got 1e+07 rad/s");
    CHECK(ball("id='player'/><circle class='ball' cx='6' cy='3' r='1' id='player'") ==
          ":2: ball: a second ball with the id player");
    auto const radius = [](std::string const& r) {
        return fault_of("<svg viewBox='0 0 9 9'>\n<circle class='ball' cx='3' cy='3' " + r + "/></svg>");
    };
    CHECK(radius("r='0'") == ":2: ball: r must be greater than 0, got 0");
    CHECK(radius("r='-2'") == ":2: ball: r must be greater than 0, got -2");
    CHECK(radius("") == ":2: ball: r must be greater than 0, got nothing");
    std::string const or_units = ":2: ball: r must be a number, or one with px, mm, cm, in, pt, pc, Q or %, got ";
    CHECK(radius("r='1em'") == or_units + "1em");
    CHECK(radius("r='1 cm'") == or_units + "1 cm");
    CHECK(radius("r='1e308in'") == or_units + "1e308in");
    CHECK(radius("r='1px'") == "");
    CHECK(radius("r='1' transform='scale(0)'") == ":2: ball: the radius must be greater than 0, got 0");
    CHECK(radius("r='1' transform='scale(2 1)'") ==
          ":2: ball: transform must keep a circle a circle; make width and height the same");
    CHECK(radius("r='2e6'") == ":2: ball: r: a radius must be at most 1e6 m, got 2e+06");
    CHECK(radius("r='1' transform='scale(1e7)'") == ":2: ball: cx, cy: a coordinate must be at most 1e6 m, got 3e+07");
}

TEST_CASE("faults of surfaces, bananas and goals") {
    CHECK(fault_of(with("<line class='terrain' x2='1' data-friction='-0.1'/>")) ==
          ":3: terrain: data-friction must be at least 0, got -0.1");
    CHECK(fault_of(with("<line class='terrain' x2='1' data-restitution='2'/>")) ==
          ":3: terrain: data-restitution must be from 0 to 1, got 2");
    CHECK(fault_of(with("<line class='terrain' x2='1' data-rolling-resistance='inf'/>")) ==
          ":3: terrain: data-rolling-resistance must be finite, got inf");
    CHECK(fault_of(with("<line class='terrain' x2='1' data-curve-tolerance='0'/>")) ==
          ":3: terrain: data-curve-tolerance must be at least 1e-6 m, got 0");
    CHECK(fault_of(with("<line class='terrain' x2='1000001'/>")) ==
          ":3: terrain: x2: a coordinate must be at most 1e6 m, got 1e+06");
    CHECK(fault_of(with("<ellipse class='terrain' rx='3e6' ry='2'/>")) ==
          ":3: terrain: rx: a radius must be at most 1e6 m, got 3e+06");
    CHECK(fault_of(with("<line class='terrain' x2='inf'/>")) == ":3: terrain: x2 must be finite, got inf");
    CHECK(fault_of(with("<circle class='banana' cx='5' cy='5' r='-1'/>")) ==
          ":3: banana: r must be greater than 0, got -1");
    CHECK(fault_of(with("<circle class='goal' r='1' transform='skewX(10)'/>")) ==
          ":3: goal: transform must keep a circle a circle; make width and height the same");
    CHECK(fault_of(with("<rect class='goal' width='-1' height='1'/>")) ==
          ":3: goal: width must not be negative, got -1");
    // Stars of 100 corners: fifty have 5000. Any number may be convex.
    auto const goals = [](int count, double inner) {
        std::string text;
        for (int i = 0; i < 100; ++i) {
            double const radius = i % 2 == 0 ? 3 : inner, angle = 2 * 3.14159265358979 * i / 100;
            text +=
                std::to_string(8 + radius * std::cos(angle)) + " " + std::to_string(4 + radius * std::sin(angle)) + " ";
        }
        std::string all;
        for (int i = 0; i < count; ++i) all += "<polygon class='goal' points='" + text + "'/>";
        return with(all);
    };
    CHECK(fault_of(goals(50, 2)) == "");
    CHECK(fault_of(goals(51, 2)) ==
          ":3: goal: all goals that are not convex must have at most 5000 corners together; draw simpler ones");
    CHECK(fault_of(goals(80, 3)) == "");
    CHECK(fault_of(with("<rect class='terrain' width='3' height='1' rx='-1' ry='.2'/>")) ==
          ":3: terrain: rx must not be negative, got -1");
    CHECK(fault_of(with("<g data-friction='-1'><line class='terrain' x2='1'/></g>")) ==
          ":3: g: data-friction must be at least 0, got -1");
    CHECK(fault_of(with("<g data-friction='inf'><line class='terrain' x2='1'/></g>")) == "");
}

TEST_CASE("a coordinate over the limit names its attribute") {
    std::string const what = ": a coordinate must be at most 1e6 m, got ";
    auto const far = [](std::string const& element) { return fault_of(with(element)); };
    CHECK(far("<circle class='banana' cx='2e6' cy='5' r='1'/>") == ":3: banana: cx" + what + "2e+06");
    CHECK(far("<circle class='banana' cx='5' cy='-3e6' r='1'/>") == ":3: banana: cy" + what + "3.00001e+06");
    CHECK(far("<circle class='terrain' cx='5' cy='3e6' r='1'/>") == ":3: terrain: cy" + what + "-2.99999e+06");
    CHECK(far("<path class='terrain' d='M0 0L4e6 0'/>") == ":3: terrain: d" + what + "4e+06");
    CHECK(far("<polyline class='terrain' points='0,0 4e6,0'/>") == ":3: terrain: points" + what + "4e+06");
    CHECK(far("<line class='goal' x1='5e6' x2='1' y2='1'/>") == ":3: goal: x1" + what + "5e+06");
    CHECK(far("<rect class='goal' width='6e6' height='1'/>") == ":3: goal: width" + what + "6e+06");
    CHECK(far("<ellipse cx='7e6' rx='1' ry='1'/>") == ":3: ellipse: cx" + what + "7e+06");
    // Neither is beyond the limit by itself: what is said is all that places the element.
    CHECK(far("<rect class='goal' x='6e5' width='6e5' height='1'/>") ==
          ":3: goal: x, y, width, height" + what + "1.2e+06");
}

TEST_CASE("a tolerance of curves below what a piece may measure is a fault, and the least one ends") {
    auto const curve = [](std::string const& tolerance) {
        return fault_of(with("<path class='terrain' d='M1 5c2 -4 6 3 8 0' data-curve-tolerance='" + tolerance + "'/>"));
    };
    CHECK(curve("1e-300") == ":3: terrain: data-curve-tolerance must be at least 1e-6 m, got 1e-300");
    CHECK(curve("9.9e-7") == ":3: terrain: data-curve-tolerance must be at least 1e-6 m, got 9.9e-7");
    CHECK(curve("1e-6") == "");
}

TEST_CASE("a misspelt ball is told with the fault that there is none") {
    CHECK(fault_of("<svg viewBox='0 0 9 9'>\n<circle class='bal' cx='3' cy='3' r='1'/></svg>") ==
          ":1: svg: there must be a ball; line 2: circle: class bal is a letter away from ball");
    CHECK(fault_of("<svg viewBox='0 0 9 9'>\n<circle class='goa' cx='3' cy='3' r='1'/></svg>") ==
          ":1: svg: there must be a ball; give a circle the class ball");
}

TEST_CASE("faults of roles") {
    CHECK(fault_of(with("<circle class='ball banana' r='1'/>")) ==
          ":3: circle: has two roles, ball and banana; keep one of them");
    CHECK(fault_of(with("<rect class='ball' width='1' height='1'/>")) ==
          ":3: ball: rect cannot be ball: it is not a circle to 1e-3 of its radius; draw a circle, or a path that is "
          "one");
    CHECK(
        fault_of(with("<rect class='terrain' x='4.' width='3' height='1'/>")).find(":3: terrain: x must be a number") ==
        0);
    CHECK(warnings_of(with("<rect class='terrain' x='4' y='6' width='3' height='1' rx='Auto' ry='.2'/>")) ==
          "3: terrain: rx: some browsers take auto as 0; leave it out, which means the same");
    CHECK(fault_of(with("<ellipse class='ball' cx='9' cy='4' rx='1' ry='.9'/>")) ==
          ":3: ball: its radii must be equal to 1e-3, got 1 m and 0.9 m; make width and height the same");
    CHECK(fault_of(with("<path class='goal' d='M0 0h1'/>")) ==
          ":3: goal: path cannot be goal: it is open; close it, or draw a line element");
    CHECK(fault_of(with("<path class='goal' d='M5 5L9 5L5 8L9 8z'/>")) ==
          ":3: goal: its outline crosses itself; make it one without crossings (Inkscape: Path > Union)");
    CHECK(fault_of(with("<g class='terrain ball'/>")) == ":3: g: has two roles, terrain and ball; keep one of them");
    CHECK(fault_of(with("", "class='terrain'")) == ":1: svg: cannot be terrain");
    CHECK(fault_of(with("<text class='banana'/>")) ==
          ":3: banana: text cannot be banana; make it a path first (Inkscape: Path > Object to Path)");
    CHECK(fault_of(with("<image class='terrain'/>")) ==
          ":3: terrain: image cannot be terrain; draw its outline, or trace it (Inkscape: Path > Trace Bitmap)");
    CHECK(fault_of(with("<line class='terrain' x2='9' transform='scale(1 0)'/>")) ==
          ":3: terrain: its transform flattens it to nothing");
    CHECK(fault_of(with("<rect class='goal' width='1' height='1' transform='scale(0)'/>")) ==
          ":3: goal: its transform flattens it to nothing");
    CHECK(fault_of("<svg viewBox='0 0 1 1'/>") == ":1: svg: there must be a ball; give a circle the class ball");
}

TEST_CASE("broken paths") {
    auto const broken = [](std::string const& data) { return fault_of(path(data)); };
    CHECK(broken("L0 0") == ":3: terrain: d: must begin with M, got L");
    CHECK(broken("M0 0 X1 1") == ":3: terrain: d: unknown command X");
    CHECK(broken("M0") == ":3: terrain: d: a number was expected, got nothing");
    CHECK(broken("M0 0L1") == ":3: terrain: d: a number was expected, got nothing");
    CHECK(broken("M0 0L1 1,") == ":3: terrain: d: a number was expected, got nothing");
    CHECK(broken("M0 0L1,,1") == ":3: terrain: d: a number was expected, got ,1");
    CHECK(broken("M0 0L40. 40") == ":3: terrain: d: a number was expected, got 40. 40");
    CHECK(broken("M0 0H4.e1") == ":3: terrain: d: a number was expected, got 4.e1");
    CHECK(broken("M,0 0") == ":3: terrain: d: a number was expected, got ,0 0");
    CHECK(broken("M0 0A1 1 0 2 0 1 1") == ":3: terrain: d: a flag of an arc must be 0 or 1, got 2 0 1 1");
    CHECK(broken("M0 0L1e999 0") == ":3: terrain: d: a number must be finite, got 1e999");
    CHECK(broken("M0 0z1 1") == ":3: terrain: d: unknown command 1");
    CHECK(broken("M0 0L1 1 nan") == ":3: terrain: d: unknown command n");
    CHECK(fault_of(with("<polyline class='terrain' points='0 0 1'/>")) ==
          ":3: terrain: points: an odd number of coordinates");
    CHECK(fault_of(with("<polygon class='terrain' points='0 0 1 a'/>")) ==
          ":3: terrain: points: a number was expected, got a");
    CHECK(fault_of(with("<path d='M0 0L'/>")) == ":3: path: d: a number was expected, got nothing");
}

TEST_CASE("broken transforms") {
    auto const broken = [](std::string const& transform) {
        return fault_of(with("<g transform='" + transform + "'/>"));
    };
    CHECK(broken("rotate(1 2 3) , scale(2)") == "");
    CHECK(broken(" matrix( 1,0 0-1,.5.5 ) ") == "");
    CHECK(broken("turn(3)") == ":3: g: transform: unknown function turn");
    CHECK(broken("scale 2") == ":3: g: transform: ( was expected");
    CHECK(broken("scale(2") == ":3: g: transform: a number was expected, got nothing");
    CHECK(broken("scale(2.)") == ":3: g: transform: a number was expected, got 2.)");
    CHECK(broken("scale(2deg)") == ":3: g: transform: a number was expected, got deg)");
    CHECK(broken("matrix(1 2 3)") == ":3: g: transform: matrix has 3 numbers, which is not its number");
    CHECK(broken("rotate(1 2)") == ":3: g: transform: rotate has 2 numbers, which is not its number");
    CHECK(broken("translate()") == ":3: g: transform: translate has 0 numbers, which is not its number");
    CHECK(broken("scale(2))") == ":3: g: transform: a function was expected, got )");
    CHECK(broken("translate(1),") == ":3: g: transform: a function was expected after the comma");
    CHECK(broken("translate(1),,scale(2)") == ":3: g: transform: a function was expected, got ,scale(2)");
    CHECK(broken(",translate(1)") == ":3: g: transform: a function was expected, got ,translate(1)");
    CHECK(broken("translate(1,)") == ":3: g: transform: a number was expected, got )");
    CHECK(broken("translate(1em)") == ":3: g: transform: unknown unit em");
    CHECK(broken("rotate(1px)") == ":3: g: transform: unknown unit px");
    CHECK(broken("translate(nan)") == ":3: g: transform: a number was expected, got nan)");
    CHECK(broken("translate3d(1,2,3)") == ":3: g: transform: unknown function translate3d");
    CHECK(broken("scale(1e400)") == ":3: g: transform: a number must be finite, got 1e400");
}

TEST_CASE("what is not XML, or not a drawing") {
    CHECK(fault_of("") == ":1: not XML: the file is empty");
    CHECK(fault_of("  \n ") == ":1: not XML: the file is empty");
    CHECK(fault_of("hello\nworld") == ":1: not XML: text outside the root element: hello world");
    CHECK(fault_of("<svg viewBox='0 0 1 1'>\n<g>\n</svg>").substr(0, 12) == ":3: not XML:");
    CHECK(fault_of("<svg viewBox='0 0 1 1'>\n<g>").substr(0, 10) == ":2: not XM");
    CHECK(fault_of("<svg>\n<g a='<'/></svg>") == ":2: not XML: < in the value of an attribute");
    CHECK(fault_of("<svg>\n<g a='1' b='2' a='3'/></svg>").substr(0, 49) ==
          ":1: svg: there must be a viewBox, or width and he");
    CHECK(warnings_of("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'>\n<g a='1' b='2' a='3'/><circle "
                      "class='ball' cx='3' cy='3' r='1'/></svg>") == "2! not XML: the attribute a stands twice in g");
    CHECK(fault_of("<svg/>\n<svg/>") == ":2: not XML: a second root element, svg");
    CHECK(fault_of("<html/>") == ":1: html: the root element must be svg");
    CHECK(fault_of(std::string("<svg>\n\0</svg>", 13)) == ":2: not XML: it holds a NUL byte");
    CHECK(fault_of("\x89PNG\r\n\x1a\n\x01\x02").find('\n') == std::string::npos);
    CHECK(fault_of("<!DOCTYPE svg [\n<!ENTITY r \"1\">]>\n<svg/>") ==
          ":2: DOCTYPE: must not declare entities; save the drawing without them, as Inkscape does");
    CHECK(fault_of("<!DOCTYPE svg [<!ELEMENT a ANY>]>" + with("")) == "");
    CHECK(fault_of("<svg viewBox='0 0 9 9'><circle class='ball' r='&r;'/></svg>") ==
          ":1: ball: r must be a number, or one with px, mm, cm, in, pt, pc, Q or %, got &r;");
    for (char const* box : {"0 0 1", "0 0 1 x", "0 0 1 inf", ""})
        CHECK(fault_of("<svg viewBox='" + std::string(box) + "'><circle class='ball' r='1'/></svg>").substr(0, 43) ==
              ":1: svg: viewBox must be four finite number");
    CHECK(fault_of("<svg viewBox='0 0 0 9'><circle class='ball' r='1'/></svg>") ==
          ":1: svg: viewBox must have a width and height greater than 0, got 0 0 0 9");
    CHECK(fault_of(with("", "data-gravity='-1'")) == ":1: svg: data-gravity must be from 0 to 1e6, got -1");
    CHECK(fault_of(with("", "data-gravity='0'")) == "");
    CHECK(fault_of(with("", "data-metres-per-unit='0'")) ==
          ":1: svg: data-metres-per-unit must be greater than 0 and at most 1e6, got 0");
}

TEST_CASE("a file that cannot be opened is named with the reason") {
    CHECK_THROWS_WITH(level::read_level("/nowhere/x.svg"), "/nowhere/x.svg: cannot be read: No such file or directory");
    CHECK_THROWS_WITH(level::checked_level("/tmp"), "/tmp: cannot be read: Is a directory");
}

TEST_CASE("deep overlaps are faults, slight ones are not") {
    auto const ball_at = [](std::string const& y) {
        return fault_of(
            "<svg viewBox='0 0 9 9'>\n<line class='terrain' x2='9' y1='8' y2='8'/>\n<circle class='ball' cx='3' cy='" +
            y + "' r='1'/></svg>");
    };
    CHECK(ball_at("7.05") == "");
    CHECK(ball_at("7.06") == ":3: ball: overlaps terrain by 0.06 m, more than 5 % of its radius");
    CHECK(ball_at("8") == ":3: ball: overlaps terrain by 1 m, more than 5 % of its radius");
    auto const second_at = [](std::string const& x) {
        return fault_of(
            "<svg viewBox='0 0 9 9'>\n<circle class='ball' cx='3' cy='3' r='1'/>\n<circle class='ball' cx='" + x +
            "' cy='3' r='0.5'/></svg>");
    };
    CHECK(second_at("4.48") == "");
    CHECK(second_at("4.47") == ":3: ball: overlaps ball 0 by 0.03 m, more than 5 % of its radius");
    CHECK(second_at("3") == ":3: ball: overlaps ball 0 by 1.5 m, more than 5 % of its radius");
}

TEST_CASE("a ball that is moved out of one wall into another does not fit") {
    auto const between = [](std::string const& right) {
        return fault_of("<svg viewBox='0 0 9 9'>\n<path class='terrain' d='M2 0V8'/>\n<path class='terrain' d='" +
                        right + "'/>\n<circle class='ball' cx='2.9975' cy='4' r='1'/></svg>");
    };
    CHECK(between("M4 0V8") == "");
    CHECK(between("M3.995 0V8") ==
          ":4: ball: does not fit between what it touches: moved out, it overlaps terrain by 0.005 m");
    // Two degrees from the other wall, which it may leave upwards: the moves take thousands of rounds.
    CHECK(between("M4.135 0L3.855615 8") == "");
    CHECK(fault_of("<svg viewBox='0 0 9 9'>\n<path class='terrain' d='M2 0V8M5.98 0V8'/>\n"
                   "<circle class='ball' cx='3' cy='4' r='1'/>\n<circle class='ball' cx='4.98' cy='4' r='1'/></svg>")
              .find("ball: does not fit between what it touches: moved out, it overlaps ") != std::string::npos);
}

TEST_CASE("the first fault is the one on the first line, check finds them all") {
    std::string const text =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9' data-gravity='x'>\n<circle class='ball' cx='3' "
        "cy='3' r='1' data-mass='0' "
        "data-inertia='2'/>\n<circle class='banana' r='0'/>\n<path class='terrain' d='M0'/></svg>";
    CHECK(fault_of(text) == ":1: svg: data-gravity must be a number, got x");
    CHECK(warnings_of(text) ==
          "1! svg: data-gravity must be a number, got x\n2! ball: data-mass must be greater than 0, got 0\n"
          "2! ball: data-inertia must be greater than 0 and at most 1, got 2\n3! banana: r must be greater than 0, got "
          "0\n"
          "4! terrain: d: a number was expected, got nothing");
}

TEST_CASE("a level has at most 100000 elements, at whatever depth") {
    auto const nested = [](int count) {
        std::string text = "<svg viewBox='0 0 9 9'>\n<circle class='ball' cx='3' cy='3' r='1'/>\n";
        for (int i = 0; i < count; ++i) text += "<g>";
        for (int i = 0; i < count; ++i) text += "</g>";
        return text + "</svg>";
    };
    CHECK(fault_of(nested(99'998)) == "");
    CHECK(fault_of(nested(99'999)) == ":3: g: a level must have at most 100000 elements");
}

TEST_CASE("a file of more than 64 MB is refused") {
    std::string text = with("");
    text.resize(64'000'001, ' ');
    CHECK(fault_of(text) == ":1: svg: the file must have at most 64 MB, got more");
}

TEST_CASE("the decimal point does not depend on the locale") {
    if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) MESSAGE("no such locale here");
    CHECK(read(with("<circle class='banana' cx='1.5' cy='2' r='.25'/>")).scene.sensors[0].rim);
    std::setlocale(LC_ALL, "C");
}
