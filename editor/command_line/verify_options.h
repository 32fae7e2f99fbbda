// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace trivar {

struct VerifyOptions {
    std::string file, log; // empty: the scene that the file names, beside it
    std::vector<std::string> relinked;
};

} // namespace trivar
