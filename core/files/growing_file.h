// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace trivar {

// A file that is written piece by piece, beside the name it gets when it is whole. Until then, and
// where something throws, the previous file of that name stays as it was and nothing else is left.
class GrowingFile {
public:
    explicit GrowingFile(std::string path); // throws Rejected, as all of these do
    ~GrowingFile();
    GrowingFile(const GrowingFile&) = delete;
    GrowingFile& operator=(const GrowingFile&) = delete;
    void append(std::string_view bytes);
    void close();  // all of it is on the disk then, and nothing can be added
    void finish(); // it is there under its name
    const std::string& temporary() const { return temporary_; } // for another program to fill

private:
    void flush();
    [[noreturn]] void fail(int reason);

    std::string path_, temporary_, waiting_;
    int file_ = -1;
    bool there_ = false; // under the temporary name
};

} // namespace trivar
