// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace trivar {

// A file that has an end, open to be read. Folders, pipes, sockets and devices, of which one waits
// for what never comes and another never ends, are refused at once; links are followed.
class OrdinaryFile {
public:
    explicit OrdinaryFile(const std::string& path); // throws Rejected
    ~OrdinaryFile();
    OrdinaryFile(const OrdinaryFile&) = delete;
    OrdinaryFile& operator=(const OrdinaryFile&) = delete;

    std::uintmax_t size() const { return size_; } // as it was when it was opened
    // The next bytes of these, as many as fit; 0 at the end. Throws Rejected.
    std::size_t read(std::span<char> bytes);

private:
    std::string path_;
    int descriptor_ = -1;
    std::uintmax_t size_ = 0, left_ = 0;
};

// All of an ordinary file. Throws Rejected, also where it has more than `most_bytes`.
std::string read_file(const std::string& path, std::uintmax_t most_bytes);

// Throws Rejected where what stands at a path, links followed, is no ordinary file, which no file
// may take the place of. Nothing being there is well.
void check_replaceable(const std::string& path);

} // namespace trivar
