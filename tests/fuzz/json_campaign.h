// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/campaign.h"

namespace trivar::testing {

// Values of glTF's JSON replaced, in .gltf files and in containers that are sound.
std::vector<CampaignEntry> json_campaigns();

} // namespace trivar::testing
