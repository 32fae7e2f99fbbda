// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/campaign.h"

namespace trivar::testing {

// Damaged bytes of volume data: of files, of those that a head names, and of slices of a series.
std::vector<CampaignEntry> volumes_campaigns();

} // namespace trivar::testing
