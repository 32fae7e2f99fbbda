// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/command_line/command_line.h"

namespace trivar {

struct VerifyOptions {
    std::string file, log; // empty: the scene that the file names, beside it
    std::vector<std::string> relinked;
};

// trivar verify: what an exported file claims, against the scene. Throws Rejected.
Status run_verify(const VerifyOptions& options, const Streams& streams);

} // namespace trivar
