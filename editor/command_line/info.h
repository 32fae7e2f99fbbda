// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/command_line/status.h"

#include <string>
#include <vector>

namespace trivar {

struct InfoOptions {
    std::vector<std::string> files;
    bool json = false;
};

// trivar info. A file that cannot be read is said and the others are still looked at.
Status run_info(const InfoOptions& options, const Streams& streams);

} // namespace trivar
