// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace trivar {

// A LockedFile is an open file that is locked against other programs (flock) while it lives.
class LockedFile {
public:
    enum class Access { locked, in_use, read_only };

    // Opens an existing regular file for appending. Waits for the lock where a killed program is
    // about to lose it. Throws Rejected if the file cannot be read.
    explicit LockedFile(const std::string& path);
    // Writes `text` to a file beside `path`, flushes it to the disk, locks it, and renames it
    // over `path`. Throws Rejected; what was at `path` is then still there.
    LockedFile(const std::string& path, std::string_view text);
    ~LockedFile();
    LockedFile(LockedFile&&) noexcept;
    LockedFile& operator=(LockedFile&&) noexcept;

    Access access() const { return access_; }
    std::string read() const; // the whole content. Throws Rejected

    // Cuts the file at `length` and appends `text` there, completely or (cut again) not at all.
    // Returns why it failed; empty: it worked.
    std::string write_at(std::uintmax_t length, std::string_view text);

private:
    std::string path_;
    int descriptor_ = -1;
    Access access_ = Access::read_only;
};

} // namespace trivar
