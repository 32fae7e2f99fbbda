// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/rejected.h"
#include "editor/command_line/command_line.h"

#include <map>
#include <optional>

namespace trivar {

// An option's value that is no value of that option: status 2.
struct WrongUsage : Rejected {
    using Rejected::Rejected;
};

struct ReplayOptions {
    std::string log;
    int to = 0;                    // line of the file; 0: all
    std::optional<int> frame;      // nothing: the first
    std::optional<double> epsilon; // metres; nothing: what the scene says
    std::vector<std::string> relinked, exports;
    std::string image, size = "1280x720", camera, quality = "standard", deform = "processor";
    bool check = false, digest = false;
    std::string timings, shaders;
    int threads = 0; // 0: as many as there are
};

// NAME=FILE, as --set has it. Throws WrongUsage.
std::map<std::string, std::string> relinked_files(const std::vector<std::string>& settings);

// trivar replay. Throws Rejected.
Status run_replay(const ReplayOptions& options, const Streams& streams);

} // namespace trivar
