// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/growing_file.h"

#include "core/base/rejected.h"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace trivar {

GrowingFile::GrowingFile(std::string path) : path_(std::move(path)), temporary_(path_ + ".XXXXXX")
{
    file_ = ::mkstemp(temporary_.data());
    if (file_ < 0) fail(errno);
    there_ = true;
}

GrowingFile::~GrowingFile()
{
    if (file_ >= 0) ::close(file_);
    if (there_) ::unlink(temporary_.c_str());
}

void GrowingFile::fail(int reason)
{
    throw Rejected(fmt::format("{}: cannot be written ({})", path_, std::strerror(reason)));
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

void GrowingFile::close()
{
    if (file_ < 0) return;
    flush();
    // mkstemp makes files for the owner only; these are ordinary ones.
    if (::fchmod(file_, 0644) != 0 || ::fsync(file_) != 0) fail(errno);
    if (::close(std::exchange(file_, -1)) != 0) fail(errno);
}

void GrowingFile::finish()
{
    close();
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(errno);
    there_ = false;
}

} // namespace trivar
