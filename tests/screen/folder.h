// A folder that is gone when the test ends.
#pragma once

#include <filesystem>
#include <string>

#include <stdlib.h>

class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "smb2d-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(Folder const&) = delete;
    Folder& operator=(Folder const&) = delete;

    std::filesystem::path operator/(std::string const& name) const { return path_ / name; }
    std::filesystem::path const& path() const { return path_; }
    bool is_empty() const { return std::filesystem::is_empty(path_); }

private:
    std::filesystem::path path_;
};
