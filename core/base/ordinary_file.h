// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace trivar {

// An OrdinaryFile is a file with an end, open to be read. Folders, pipes, sockets and devices are
// refused at once, because reading some of them never ends; links are followed.
class OrdinaryFile {
public:
    explicit OrdinaryFile(const std::string& path); // throws Rejected
    ~OrdinaryFile();
    OrdinaryFile(const OrdinaryFile&) = delete;
    OrdinaryFile& operator=(const OrdinaryFile&) = delete;

    std::uintmax_t size() const { return size_; } // when the file was opened
    // Reads the next bytes, as many as fit, and returns their number; 0 at the end. Throws
    // Rejected.
    std::size_t read(std::span<char> bytes);
    // Reads the bytes from a place on, as many as fit, and returns their number, which is less only
    // at the end; the place of read() stays. Throws Rejected.
    std::size_t read_at(std::uintmax_t at, std::span<char> bytes) const;

private:
    std::string path_;
    int descriptor_ = -1;
    std::uintmax_t size_ = 0, left_ = 0;
};

// The content of an ordinary file. Throws Rejected, also where it has more than `most_bytes`.
std::string read_file(const std::string& path, std::uintmax_t most_bytes);

// Throws Rejected where something other than an ordinary file stands at a path, links followed, for
// then no file may replace it. A missing file is fine.
void check_replaceable(const std::string& path);

} // namespace trivar
