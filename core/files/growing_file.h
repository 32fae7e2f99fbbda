// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace trivar {

// A GrowingFile is written piece by piece and gets its name when it is complete. Until then, and
// where something throws, the earlier file of that name stays unchanged and nothing else is left:
// the new file has no name at all (O_TMPFILE), so that the system removes it however the program
// ends. Only on file systems without this feature has it a temporary name beside its own, which a
// killed program leaves there. If the name is a link, the file to which it leads is replaced.
class GrowingFile {
public:
    // Throws Rejected, as all of these functions do: also where a folder, pipe or device has the
    // name.
    explicit GrowingFile(std::string path);
    ~GrowingFile();
    GrowingFile(const GrowingFile&) = delete;
    GrowingFile& operator=(const GrowingFile&) = delete;
    void append(std::string_view bytes);
    void settle(); // afterwards all of it is on the disk, and nothing can be added
    void close();  // the same, and the file is closed and has a temporary name
    void finish(); // the file gets its name
    // A path at which another program can open the file to fill it, while this one runs.
    std::string for_others() const;

private:
    void open_named();
    void flush();
    void name_temporarily();
    [[noreturn]] void fail(int reason);

    std::string path_, target_; // target_: without links
    std::string temporary_;     // empty: the file has no name
    std::string waiting_;
    int file_ = -1;
    bool settled_ = false;
};

} // namespace trivar
