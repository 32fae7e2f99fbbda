// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>

namespace trivar {

// The files that something is made from, by what they really are (device and number on it): another
// name of one, or a link to it, is the same file. What is made takes the place of none of them.
// There are none as it is made.
class SourceFiles {
public:
    SourceFiles() = default;
    // Takes the alternative to another name, for the message: "or say --overwrite".
    explicit SourceFiles(std::string or_else) : or_else_(std::move(or_else)) {}

    void add(const std::string& path); // what is not there is passed over
    // Throws Rejected where a file that would be written is one of them.
    void check(const std::string& written) const;

private:
    std::set<std::pair<std::uint64_t, std::uint64_t>> known_; // device, number
    std::string or_else_;
};

} // namespace trivar
