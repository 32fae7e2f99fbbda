// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/campaign.h"

namespace trivar::testing {

// Scenes: all that the repository has, without the models that they name, and a small one with its
// model, which has a few of everything that is cheap to work out.
std::vector<FileSet> sound_logs();

} // namespace trivar::testing
