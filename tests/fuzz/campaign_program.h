// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/campaign.h"

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

namespace trivar::testing {

// The body of a program that runs campaigns: adds its options to those of `app`, reads the words of
// the command line and runs what they name. `entries` is called once they are read. Returns the
// status of the program.
int campaign_program(CLI::App& app, int count, char** words,
                     const std::function<std::vector<CampaignEntry>()>& entries);

} // namespace trivar::testing
