// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/ordinary_file.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace trivar {
namespace {

// Names the kind of a file that is not ordinary; empty if it is ordinary.
std::string unusual_kind(mode_t mode)
{
    return S_ISREG(mode)    ? ""
           : S_ISDIR(mode)  ? "folder"
           : S_ISFIFO(mode) ? "pipe"
           : S_ISSOCK(mode) ? "socket"
                            : "device";
}

void check_ordinary(const std::string& path, mode_t mode)
{
    if (const std::string kind = unusual_kind(mode); !kind.empty())
        throw Rejected(fmt::format("{}: this is a {}, not an ordinary file", path, kind));
}

[[noreturn]] void not_opened(const std::string& path, int reason)
{
    if (reason == ENOENT) throw Rejected(path + ": there is no such file");
    throw Rejected(fmt::format("{}: cannot be opened ({})", path, std::strerror(reason)));
}

} // namespace

OrdinaryFile::OrdinaryFile(const std::string& path) : path_(path)
{
    // The file is examined before it is opened, because opening a device can have effects, and
    // again after, because it may have been replaced meanwhile. Without O_NONBLOCK a pipe would
    // wait for its writer.
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) not_opened(path, errno);
    check_ordinary(path, status.st_mode);
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor_ < 0) not_opened(path, errno);
    try {
        if (::fstat(descriptor_, &status) != 0) not_opened(path, errno);
        check_ordinary(path, status.st_mode);
    } catch (const Rejected&) {
        ::close(descriptor_);
        throw;
    }
    size_ = left_ = static_cast<std::uintmax_t>(status.st_size);
}

OrdinaryFile::~OrdinaryFile()
{
    ::close(descriptor_);
}

std::size_t OrdinaryFile::read(std::span<char> bytes)
{
    const std::size_t wanted =
        static_cast<std::size_t>(std::min<std::uintmax_t>(bytes.size(), left_));
    std::size_t done = 0;
    while (done < wanted) {
        const ssize_t got = ::read(descriptor_, bytes.data() + done, wanted - done);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) throw Rejected(path_ + ": cannot be read completely");
        done += static_cast<std::size_t>(got);
    }
    left_ -= done;
    return done;
}

std::size_t OrdinaryFile::read_at(std::uintmax_t at, std::span<char> bytes) const
{
    const std::uintmax_t behind = size_ - std::min(at, size_);
    const auto wanted = static_cast<std::size_t>(std::min<std::uintmax_t>(bytes.size(), behind));
    std::size_t done = 0;
    while (done < wanted) {
        const ssize_t got =
            ::pread(descriptor_, bytes.data() + done, wanted - done, static_cast<off_t>(at + done));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) throw Rejected(path_ + ": cannot be read completely");
        done += static_cast<std::size_t>(got);
    }
    return done;
}

std::string read_file(const std::string& path, std::uintmax_t most_bytes)
{
    OrdinaryFile file(path);
    if (file.size() > most_bytes)
        throw Rejected(fmt::format("{}: has {} bytes, more than the {} allowed", path,
                                   with_commas(file.size()), with_commas(most_bytes)));
    std::string bytes(static_cast<std::size_t>(file.size()), '\0');
    file.read(bytes);
    return bytes;
}

void check_replaceable(const std::string& path)
{
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return;
    if (const std::string kind = unusual_kind(status.st_mode); !kind.empty())
        throw Rejected(fmt::format("{}: this is a {}, not an ordinary file, so it is not replaced",
                                   path, kind));
}

} // namespace trivar
