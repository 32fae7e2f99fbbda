// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/campaign.h"

namespace trivar::testing {

// Models whose bytes are damaged: one campaign for each kind of file that a model is read from, and
// one for the material libraries of OBJ files that are sound.
std::vector<CampaignEntry> bytes_campaigns();

} // namespace trivar::testing
