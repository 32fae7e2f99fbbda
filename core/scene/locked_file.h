// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace trivar {

// An open file that is locked against other programs (flock) while it lives.
class LockedFile {
public:
    enum class Access { locked, in_use, read_only };

    // Opens an existing regular file for appending. Waits for the lock where a killed program is
    // about to lose it. Throws Rejected if it cannot even be read.
    explicit LockedFile(const std::string& path);
    // Writes `text` to a file beside `path`, flushes it to the disk, locks it, and renames it
    // over `path`. Throws Rejected; what was at `path` is then still there.
    LockedFile(const std::string& path, std::string_view text);
    ~LockedFile();
    LockedFile(LockedFile&&) noexcept;
    LockedFile& operator=(LockedFile&&) noexcept;

    Access access() const { return access_; }
    std::string read() const; // everything. Throws Rejected

    // Cuts the file at `length` and appends `text` there, all or (cut again) nothing. Returns
    // why it failed, or nothing.
    std::string write_at(std::uintmax_t length, std::string_view text);

private:
    std::string path_;
    int descriptor_ = -1;
    Access access_ = Access::read_only;
};

} // namespace trivar
