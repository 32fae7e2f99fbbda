// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/plain/ply_header.h"
#include "core/files/text_scan.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// Reads the values behind a PLY's header one after another, in text or in either byte order. Throws
// Rejected, with the file's name and the element's number, where the file ends.
class PlyValues {
public:
    PlyValues(std::string_view data, PlyHeader::Format format, const std::string& name);

    // Names the element, counted from 0, that errors mention from now on. The name must live on.
    void begin(const PlyElement& element, std::size_t index);

    // Reads a value, which may be not finite: in text infinity stands for a word that is no number,
    // or one too large.
    double value(PlyType type);
    // Reads the length of a list; the bytes that are left can hold that many.
    std::size_t list_length(const PlyProperty& property);
    void skip(const PlyProperty& property);

    // Throws Rejected where so many elements take more bytes than there are.
    void check_count(const PlyElement& element) const;

    // The last value as it stands in the file.
    std::string last() const;
    [[noreturn]] void fail(const std::string& what) const;

private:
    std::size_t left() const { return static_cast<std::size_t>(scan_.end - scan_.at); }

    TextScan scan_;
    bool ascii_, swap_;
    const std::string& name_;
    const PlyElement* element_ = nullptr;
    std::size_t index_ = 0;
    const char* last_ = nullptr;
    double last_value_ = 0;
};

} // namespace trivar
