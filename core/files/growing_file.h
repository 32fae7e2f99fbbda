// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace trivar {

// A file that is written piece by piece and gets its name when it is whole. Until then, and where
// something throws, the previous file of that name stays as it was and nothing else is left: it has
// no name at all (O_TMPFILE), so that the system takes it away however the program ends. Only where
// a file system knows no such files has it a temporary name beside its own, which a killed program
// leaves there. Behind a link the file it leads to is replaced.
class GrowingFile {
public:
    // Throws Rejected, as all of these do: also where a folder, pipe or device has the name.
    explicit GrowingFile(std::string path);
    ~GrowingFile();
    GrowingFile(const GrowingFile&) = delete;
    GrowingFile& operator=(const GrowingFile&) = delete;
    void append(std::string_view bytes);
    void settle(); // all of it is on the disk then, and nothing can be added
    void close();  // the same, and it is not open any more: it has a temporary name
    void finish(); // it is there under its name
    // Where another program, while this one runs, can open it to fill it.
    std::string for_others() const;

private:
    void open_named();
    void flush();
    void name_temporarily();
    [[noreturn]] void fail(int reason);

    std::string path_, target_; // target_: without links
    std::string temporary_;     // empty: it has no name
    std::string waiting_;
    int file_ = -1;
    bool settled_ = false;
};

} // namespace trivar
