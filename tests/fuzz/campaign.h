// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/case_result.h"

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace trivar::testing {

struct NamedFile {
    std::string name, bytes;
};

// The first file is the one that is opened; the others lie beside it. One of them is damaged.
using FileSet = std::vector<NamedFile>;

// One kind of damage to one kind of file.
struct Campaign {
    // The files of one case. Pure: the same seed and number give the same bytes.
    std::function<FileSet(std::uint64_t seed, int number)> damaged;
    // Does with the first of them, which lies at `path`, all that a program does. Throws Rejected
    // if the file is refused. Any other exception is a failure.
    std::function<void(const std::string& path)> use;
};

// A promise that a file which was accepted, or a sentence, does not keep.
struct Broken : std::runtime_error {
    using runtime_error::runtime_error;
};

// A campaign before its sound files are made: that starts threads of libraries, and the process
// that starts the cases has none.
struct CampaignEntry {
    std::string damage, kind; // "bytes", "ply"
    std::function<Campaign()> make;
    CaseLimits limits = {};
};

} // namespace trivar::testing
