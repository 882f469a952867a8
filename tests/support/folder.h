// A folder for one test and a variable of the environment, gone and as before afterwards; and what a call throws.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

namespace support {

class Folder {
public:
    Folder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "smb2d-test-XXXXXX").string();
        if (!mkdtemp(pattern.data())) throw std::runtime_error("no folder for the test");
        folder_ = pattern;
    }
    ~Folder() { std::filesystem::remove_all(folder_); }
    Folder(Folder const&) = delete;
    Folder& operator=(Folder const&) = delete;

    std::filesystem::path const& path() const { return folder_; }
    std::filesystem::path operator/(std::string const& name) const { return folder_ / name; }
    std::string path(std::string const& name) const { return (folder_ / name).string(); }
    // Makes it, and the folders that it lies in.
    std::string file(std::string const& name, std::string const& text) const {
        std::filesystem::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return path(name);
    }
    bool is_empty() const { return std::filesystem::is_empty(folder_); }

private:
    std::filesystem::path folder_;
};

class Variable {
public:
    Variable(char const* name, std::optional<std::string> const& value) : name_(name) {
        if (char const* const before = std::getenv(name)) before_ = before;
        set(value);
    }
    ~Variable() { set(before_); }
    Variable(Variable const&) = delete;
    Variable& operator=(Variable const&) = delete;

    // None: it is not there.
    void set(std::optional<std::string> const& value) const {
        if (value)
            setenv(name_, value->c_str(), 1);
        else
            unsetenv(name_);
    }

private:
    char const* name_;
    std::optional<std::string> before_;
};

// What the user's data folder holds, in a folder of its own.
struct DataFolder {
    Folder folder;
    Variable variable{"XDG_DATA_HOME", folder.path("data")};

    std::string path(std::string const& name) const { return folder.path("data/smb2d/" + name); }
    std::string file(std::string const& name, std::string const& text) const {
        return folder.file("data/smb2d/" + name, text);
    }
};

template <typename Call>
std::string message_of(Call const& call) {
    try {
        call();
    } catch (std::runtime_error const& error) {
        return error.what();
    }
    return "nothing was thrown";
}

}  // namespace support
