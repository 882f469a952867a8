// Small drawings as levels: written to a folder of their own, read, and thrown away.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

#include "level/level.h"

namespace drawing {

// The folder of this run, gone when it ends.
class Folder {
public:
    Folder() : path_(std::filesystem::temp_directory_path() / ("smb2d-level-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(Folder const&) = delete;
    Folder& operator=(Folder const&) = delete;
    std::filesystem::path const& path() const { return path_; }

private:
    std::filesystem::path path_;
};

class File {
public:
    explicit File(std::string const& text, std::string const& name = "level.svg") {
        static Folder const folder;
        path_ = (folder.path() / name).string();
        std::ofstream(path_, std::ios::binary) << text;
    }
    std::string const& path() const { return path_; }

private:
    std::string path_;
};

inline level::Level read(std::string const& text) { return level::read_level(File(text).path()); }

// What the reader says, without the name of the file; empty where it finds no fault.
inline std::string fault_of(std::string const& text) {
    File const file(text);
    try {
        level::read_level(file.path());
    } catch (std::runtime_error const& error) {
        std::string const what = error.what();
        return what.substr(0, file.path().size()) == file.path() ? what.substr(file.path().size()) : what;
    }
    return {};
}

inline std::vector<level::Finding> findings(std::string const& text) {
    return level::checked_level(File(text).path()).findings;
}

// A line for every finding, as "3: what" or, for a fault, "3! what".
inline std::string warnings_of(std::string const& text) {
    std::ostringstream all;
    char const* between = "";
    for (level::Finding const& finding : findings(text)) {
        all << between << finding.line << (finding.fault ? "! " : ": ") << finding.text;
        between = "\n";
    }
    return all.str();
}

// Line 1 is the root, line 2 the ball (on the ground of line 3, well above), line 3 what is under test.
inline std::string with(std::string const& third_line, std::string const& root_attributes = "") {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 16 9\" " + root_attributes +
           ">\n<circle class=\"ball\" cx=\"3\" cy=\"2\" r=\"0.5\"/>\n" + third_line + "\n</svg>\n";
}

inline std::string path(std::string const& data) {
    return with("<path class=\"terrain\" fill=\"none\" d=\"" + data + "\"/>");
}

// The path alone, with the ball far away from it.
inline std::string lone_path(std::string const& data) {
    return "<svg viewBox=\"0 0 16 9\">\n<circle class=\"ball\" cx=\"99\" cy=\"99\" r=\"0.5\"/>\n"
           "<path class=\"terrain\" d=\"" +
           data + "\"/>\n</svg>\n";
}

inline double distance(geometry::Vec2 const& a, geometry::Vec2 const& b) { return geometry::length(a - b); }

// All curves of the terrain in their order.
inline std::vector<geometry::Curve> curves_of(level::Level const& level) {
    std::vector<geometry::Curve> curves;
    for (auto const& piece : level.scene.terrain.pieces) curves.push_back(piece.curve);
    return curves;
}

}  // namespace drawing
