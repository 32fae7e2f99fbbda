// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/locked_file.h"

#include "core/base/ordinary_file.h"
#include "core/base/rejected.h"
#include "core/scene/lock_holders.h"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace trivar {
namespace {

[[noreturn]] void fail(const std::string& path, std::string_view what, int error)
{
    throw Rejected(fmt::format("{}: {} ({})", path, what, std::strerror(error)));
}

bool write_all(int descriptor, std::string_view text)
{
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

// Says whether the open file still has this path: another program may have renamed a new file over
// it between opening and locking.
bool still_at(int descriptor, const std::string& path)
{
    struct stat open_file {
    }, named_file{};
    return ::fstat(descriptor, &open_file) == 0 && ::stat(path.c_str(), &named_file) == 0 &&
           open_file.st_ino == named_file.st_ino && open_file.st_dev == named_file.st_dev;
}

// Tries to lock the file. A file system without locks (some network ones) counts as locked, so that
// it stops nobody from working.
bool locked(int descriptor)
{
    return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

// Waits for the lock while a killed program that still holds it exits; says whether it was got.
bool freed_in_a_moment(int descriptor)
{
    constexpr auto step = std::chrono::milliseconds(5);
    constexpr int most = 2000; // writing the core dump of a crashed program takes seconds
    struct stat file {};
    if (::fstat(descriptor, &file) != 0) return false;
    for (int i = 0; i < most && held_by_the_dying(file); ++i) {
        std::this_thread::sleep_for(step);
        if (locked(descriptor)) return true;
    }
    return locked(descriptor); // the holder exited meanwhile
}

void flush_folder(const std::string& path)
{
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    const int descriptor =
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

} // namespace

LockedFile::LockedFile(const std::string& path) : path_(path)
{
    static_cast<void>(OrdinaryFile(path)); // throws before a device or pipe is opened or locked
    for (;;) {
        descriptor_ = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
        if (descriptor_ < 0) {
            descriptor_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
            if (descriptor_ < 0) fail(path, "cannot be opened", errno);
            return;
        }
        const bool ours = locked(descriptor_) || freed_in_a_moment(descriptor_);
        access_ = ours ? Access::locked : Access::in_use;
        if (access_ == Access::in_use || still_at(descriptor_, path)) return;
        ::close(descriptor_);
    }
}

LockedFile::LockedFile(const std::string& path, std::string_view text)
    : path_(path),
      access_(Access::locked)
{
    std::error_code ignored;
    // If the path is a symbolic link, its target is replaced.
    const std::filesystem::path target = std::filesystem::is_symlink(path, ignored)
                                             ? std::filesystem::weakly_canonical(path, ignored)
                                             : std::filesystem::path(path);
    check_replaceable(path);
    std::string beside = target.string() + ".XXXXXX";
    descriptor_ = ::mkostemp(beside.data(), O_CLOEXEC);
    if (descriptor_ < 0) fail(path, "cannot be written", errno);
    struct stat previous {};
    const bool replaces = ::stat(target.c_str(), &previous) == 0;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::fchmod(descriptor_, replaces ? previous.st_mode & 0777 : 0666 & ~mask);
    const bool done = write_all(descriptor_, text) && ::fsync(descriptor_) == 0 &&
                      locked(descriptor_) && ::rename(beside.c_str(), target.c_str()) == 0;
    if (!done) {
        const int error = errno;
        ::unlink(beside.c_str());
        ::close(descriptor_);
        descriptor_ = -1;
        fail(path, "cannot be saved; the file there is unchanged", error);
    }
    flush_folder(target.string());
}

LockedFile::~LockedFile()
{
    if (descriptor_ >= 0) ::close(descriptor_);
}

LockedFile::LockedFile(LockedFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      access_(other.access_)
{
}

LockedFile& LockedFile::operator=(LockedFile&& other) noexcept
{
    std::swap(path_, other.path_);
    std::swap(descriptor_, other.descriptor_);
    std::swap(access_, other.access_);
    return *this;
}

std::string LockedFile::read() const
{
    std::string text;
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) fail(path_, "cannot be read", errno);
    text.resize(static_cast<std::size_t>(status.st_size));
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t got =
            ::pread(descriptor_, text.data() + done, text.size() - done, static_cast<off_t>(done));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(path_, "cannot be read", errno);
        if (got == 0) break;
        done += static_cast<std::size_t>(got);
    }
    text.resize(done);
    return text;
}

std::string LockedFile::write_at(std::uintmax_t length, std::string_view text)
{
    const auto cut = [&] { return ::ftruncate(descriptor_, static_cast<off_t>(length)) == 0; };
    if (!still_at(descriptor_, path_))
        return fmt::format("{}: the file was moved or deleted by another program", path_);
    if (cut() && ::lseek(descriptor_, 0, SEEK_END) >= 0 && write_all(descriptor_, text)) return {};
    const int error = errno;
    cut();
    return fmt::format("{}: cannot be written ({})", path_, std::strerror(error));
}

} // namespace trivar
