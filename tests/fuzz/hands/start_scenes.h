// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/campaign.h"

#include <string>
#include <vector>

namespace trivar::testing {

struct StartScene {
    FileSet files;     // the first is the scene
    std::string tools; // keys of those that have something to do there
    int main = 0;      // place, among the objects, of what a hand takes first
};

// Small scenes in which hands begin, of one kind: "bodies" of our own, "models" of files that the
// build makes and of files that are written here, "volumes", or "real", which is empty where there
// is no folder of real data.
std::vector<StartScene> start_scenes(const std::string& kind);

} // namespace trivar::testing
