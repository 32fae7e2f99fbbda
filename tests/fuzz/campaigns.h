// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/campaign.h"

namespace trivar::testing {

// The table of all of them: what is damaged and how.
std::vector<CampaignEntry> all_campaigns();

} // namespace trivar::testing
