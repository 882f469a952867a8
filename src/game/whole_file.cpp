#include "game/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace game {

namespace {

constexpr int most_links = 40;

[[noreturn]] void fail(std::string const& file, int error) {
    throw std::runtime_error(file + ": " + std::strerror(error));
}

// 0, or the errno of what went wrong.
int error_of_writing(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        ssize_t const written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

}  // namespace

std::string behind_links(std::string const& file) {
    std::error_code error;
    std::filesystem::path path(file);
    // The system gives up after as many links itself.
    for (int links = 0; std::filesystem::is_symlink(std::filesystem::symlink_status(path, error)); ++links) {
        if (links == most_links) fail(file, ELOOP);
        std::filesystem::path const target = std::filesystem::read_symlink(path, error);
        if (error) fail(file, error.value());
        path = path.parent_path() / target;  // an absolute target replaces the folder
    }
    return path.string();
}

void write_whole_file(std::string const& name, std::string_view bytes) {
    std::string const file = behind_links(name);
    std::filesystem::path const path(file);
    if (path.has_parent_path()) {
        std::error_code error;
        std::filesystem::create_directories(path.parent_path(), error);
        if (error) fail(path.parent_path().string(), error.value());
    }
    std::string const beside = file + ".part." + std::to_string(::getpid());
    int const descriptor = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0) fail(file, errno);
    int error = error_of_writing(descriptor, bytes);
    if (::close(descriptor) != 0 && error == 0 && errno != EINTR) error = errno;
    if (error == 0 && ::rename(beside.c_str(), file.c_str()) != 0) error = errno;
    if (error == 0) return;
    ::unlink(beside.c_str());
    fail(file, error);
}

std::string read_whole_file(std::string const& file, std::size_t limit) {
    if (std::filesystem::is_directory(file)) fail(file, EISDIR);
    std::ifstream stream(file, std::ios::binary);
    if (!stream) fail(file, errno);
    std::string bytes;
    char block[65536];
    while (stream.read(block, sizeof block) || stream.gcount() > 0) {
        bytes.append(block, static_cast<std::size_t>(stream.gcount()));
        if (bytes.size() > limit)
            throw std::runtime_error(file + ": is larger than " + std::to_string(limit >> 20) + " MB");
    }
    if (stream.bad()) fail(file, EIO);
    return bytes;
}

std::filesystem::path set_aside(std::filesystem::path const& file) {
    std::filesystem::path const whole = behind_links(file.string());
    std::filesystem::path aside = whole.string() + ".spoilt";
    for (int i = 2; std::filesystem::exists(std::filesystem::symlink_status(aside)); ++i)
        aside = whole.string() + ".spoilt-" + std::to_string(i);
    std::filesystem::rename(whole, aside);
    return aside;
}

}  // namespace game
