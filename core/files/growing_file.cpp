// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/growing_file.h"

#include "core/base/ordinary_file.h"
#include "core/base/rejected.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace trivar {
namespace {

std::string without_link(const std::string& path)
{
    std::error_code ignored;
    return std::filesystem::is_symlink(path, ignored)
               ? std::filesystem::weakly_canonical(path, ignored).string()
               : path;
}

std::string descriptor_path(const char* process, int descriptor)
{
    return fmt::format("/proc/{}/fd/{}", process, descriptor);
}

// Opens a file without a name on the disk of a folder; -1 if the file system has no such files.
int unnamed_file(const std::string& folder)
{
    const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    // It can be linked to a name through this path.
    if (file < 0 || ::access(descriptor_path("self", file).c_str(), F_OK) == 0) return file;
    ::close(file);
    return -1;
}

} // namespace

GrowingFile::GrowingFile(std::string path) : path_(std::move(path)), target_(without_link(path_))
{
    check_replaceable(path_);
    const std::string folder = std::filesystem::path(target_).parent_path().string();
    file_ = unnamed_file(folder.empty() ? "." : folder);
    if (file_ < 0) open_named();
}

GrowingFile::~GrowingFile()
{
    if (file_ >= 0) ::close(file_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void GrowingFile::fail(int reason)
{
    throw Rejected(fmt::format("{}: cannot be written ({})", path_, std::strerror(reason)));
}

void GrowingFile::open_named()
{
    std::string name = target_ + ".XXXXXX";
    file_ = ::mkostemp(name.data(), O_CLOEXEC);
    if (file_ < 0) fail(errno);
    temporary_ = std::move(name);
}

void GrowingFile::append(std::string_view bytes)
{
    constexpr std::size_t most_waiting = std::size_t{1} << 20;
    waiting_.append(bytes);
    if (waiting_.size() >= most_waiting) flush();
}

void GrowingFile::flush()
{
    std::size_t written = 0;
    while (written < waiting_.size()) {
        const ssize_t count = ::write(file_, waiting_.data() + written, waiting_.size() - written);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) fail(count == 0 ? ENOSPC : errno);
        written += static_cast<std::size_t>(count);
    }
    waiting_.clear();
}

void GrowingFile::settle()
{
    if (std::exchange(settled_, true)) return;
    flush();
    // Until now only its owner could access the file; it gets the usual permissions.
    if (::fchmod(file_, 0644) != 0 || ::fsync(file_) != 0) fail(errno);
}

void GrowingFile::name_temporarily()
{
    if (!temporary_.empty()) return;
    const std::string unnamed = descriptor_path("self", file_);
    constexpr int most_tries = 1000;
    for (int i = 0;; ++i) {
        std::string name = fmt::format("{}.{}-{}", target_, ::getpid(), file_ + i);
        if (::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
            temporary_ = std::move(name);
            return;
        }
        if (errno != EEXIST || i == most_tries) fail(errno);
    }
}

void GrowingFile::close()
{
    settle();
    if (file_ < 0) return;
    name_temporarily();
    if (::close(std::exchange(file_, -1)) != 0) fail(errno);
}

void GrowingFile::finish()
{
    settle();
    const std::string unnamed = descriptor_path("self", file_);
    const bool is_new = temporary_.empty() && ::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD,
                                                       target_.c_str(), AT_SYMLINK_FOLLOW) == 0;
    if (!is_new) { // an existing file is replaced atomically, through a temporary name
        name_temporarily();
        if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
        temporary_.clear();
    }
    if (file_ >= 0 && ::close(std::exchange(file_, -1)) != 0) fail(errno);
}

std::string GrowingFile::for_others() const
{
    return temporary_.empty() ? descriptor_path(std::to_string(::getpid()).c_str(), file_)
                              : temporary_;
}

} // namespace trivar
