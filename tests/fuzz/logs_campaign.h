// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/campaign.h"

namespace trivar::testing {

// Scenes with damaged lines.
std::vector<CampaignEntry> logs_campaigns();

} // namespace trivar::testing
