#include "level/svg_path.h"

#include <cmath>
#include <string>

#include "level/faults.h"
#include "level/limits.h"
#include "level/numbers.h"

namespace level {

namespace {

enum class Memory { nothing, cubic, quadratic };  // which control point S or T would mirror

class PathReader {
public:
    explicit PathReader(std::string_view data) : cursor_(data) {}

    std::vector<Subpath> read() {
        cursor_.skip_spaces();
        while (!cursor_.at_end()) read_command();
        finish_subpath();
        return std::move(subpaths_);
    }

private:
    void read_command() {
        char const command = cursor_.next();
        constexpr std::string_view known = "MmLlHhVvAaCcSsQqTtZz";
        if (known.find(command) == std::string_view::npos)
            throw Broken("unknown command " + level::quoted(std::string(1, command)));
        if (!begun_ && command != 'M' && command != 'm')
            throw Broken("must begin with M, got " + std::string(1, command));
        relative_ = command >= 'a';
        if (command == 'Z' || command == 'z') {
            close();
            cursor_.skip_spaces();
            return;
        }
        char kind = relative_ ? static_cast<char>(command - 'a' + 'A') : command;
        cursor_.skip_spaces();
        fresh_ = true;
        do {
            draw(kind);
            if (kind == 'M') kind = 'L';
        } while (another_follows());
    }

    bool another_follows() {
        cursor_.skip_spaces();
        if (cursor_.peek() == ',') {
            cursor_.skip_separator();
            if (!cursor_.begins_number()) throw Broken("a number was expected, got " + level::quoted(cursor_.rest()));
        }
        return cursor_.begins_number();
    }

    void draw(char kind) {
        switch (kind) {
            case 'M':
                return move(point());
            case 'L':
                return append(LineTo{point()});
            case 'H':
                return append(LineTo{{number() + (relative_ ? at_.x() : 0), at_.y()}});
            case 'V':
                return append(LineTo{{at_.x(), number() + (relative_ ? at_.y() : 0)}});
            case 'A':
                return append(arc());
            case 'C':
                return append_cubic(point());
            case 'S':
                return append_cubic(mirrored(Memory::cubic));
            case 'Q':
                return append_quadratic(point());
            default:
                return append_quadratic(mirrored(Memory::quadratic));
        }
    }

    void move(Vec2 const& to) {
        finish_subpath();
        begun_ = true;
        start_subpath(to);
        moved_ = true;
    }

    void start_subpath(Vec2 const& at) {
        current_ = Subpath{};
        current_.start = at;
        at_ = at;
        memory_ = Memory::nothing;
        moved_ = false;
    }

    void close() {
        Vec2 const start = current_.start;
        current_.closed = true;
        if (at_ != start) current_.draws.push_back(LineTo{start});
        // A point that is moved to and closed is part of the path, and of its box.
        if (moved_ && current_.draws.empty()) {
            count_piece();
            subpaths_.push_back(current_);
        }
        finish_subpath();
        start_subpath(start);
    }

    void finish_subpath() {
        if (!current_.draws.empty()) subpaths_.push_back(std::move(current_));
        current_ = Subpath{};
    }

    void count_piece() {
        if (++appended_ > most_pieces) throw Broken("a path must have at most 1000000 pieces");
    }

    void append(Draw const& draw) {
        count_piece();
        at_ = end_of(draw);
        current_.draws.push_back(draw);
        memory_ = Memory::nothing;
    }

    void append_cubic(Vec2 const& first) {
        CubicTo cubic{first, point(), Vec2::Zero()};
        cubic.end = point();
        append(cubic);
        control_ = cubic.second;
        memory_ = Memory::cubic;
    }

    void append_quadratic(Vec2 const& control) {
        append(QuadraticTo{control, point()});
        control_ = control;
        memory_ = Memory::quadratic;
    }

    Vec2 mirrored(Memory wanted) const { return memory_ == wanted ? Vec2(2 * at_ - control_) : at_; }

    ArcTo arc() {
        ArcTo arc;
        arc.rx = std::abs(number());
        arc.ry = std::abs(number());
        arc.rotation = number();
        arc.large = flag();
        arc.sweep = flag();
        arc.end = point();
        return arc;
    }

    bool flag() {
        separate();
        char const c = cursor_.peek();
        if (c != '0' && c != '1') throw Broken("a flag of an arc must be 0 or 1, got " + level::quoted(cursor_.rest()));
        cursor_.next();
        return c == '1';
    }

    Vec2 point() {
        double const x = number();
        double const y = number();
        return relative_ ? Vec2(at_.x() + x, at_.y() + y) : Vec2(x, y);
    }

    double number() {
        separate();
        return cursor_.number();
    }

    // Not before the first number of a command, where a comma has no place.
    void separate() {
        if (!fresh_) cursor_.skip_separator();
        fresh_ = false;
    }

    Cursor cursor_;
    std::vector<Subpath> subpaths_;
    Subpath current_;
    Vec2 at_ = Vec2::Zero(), control_ = Vec2::Zero();
    Memory memory_ = Memory::nothing;
    std::size_t appended_ = 0;
    bool begun_ = false, relative_ = false, fresh_ = false;
    bool moved_ = false;  // the subpath is begun by M or m
};

}  // namespace

Vec2 end_of(Draw const& draw) {
    return std::visit([](auto const& d) -> Vec2 { return d.end; }, draw);
}

std::vector<Subpath> parsed_path(std::string_view data) { return PathReader(trimmed(data)).read(); }

std::vector<Subpath> parsed_points(std::string_view points) {
    Cursor cursor(trimmed(points));
    std::vector<double> numbers;
    while (!cursor.at_end()) {
        numbers.push_back(cursor.number());
        if (numbers.size() > 2 * most_pieces) throw Broken("there must be at most 1000000 points");
        cursor.skip_separator();
    }
    if (numbers.size() % 2 != 0) throw Broken("an odd number of coordinates");
    if (numbers.size() < 4) return {};
    Subpath subpath;
    subpath.start = {numbers[0], numbers[1]};
    for (std::size_t i = 2; i < numbers.size(); i += 2) subpath.draws.push_back(LineTo{{numbers[i], numbers[i + 1]}});
    return {subpath};
}

Subpath closed_to_start(Subpath subpath) {
    subpath.closed = true;
    if (!subpath.draws.empty() && end_of(subpath.draws.back()) != subpath.start)
        subpath.draws.push_back(LineTo{subpath.start});
    return subpath;
}

}  // namespace level
