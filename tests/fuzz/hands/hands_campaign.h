// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/campaign.h"

#include <vector>

namespace trivar::testing {

struct HandsOptions {
    int gestures = 10;          // of a case
    double longest_frame_s = 0; // processor time of the frame thread; 0: it is not judged
};

// One campaign for each kind of scenes in which hands begin. The first file of a case holds its
// gestures, a line each: without some of its lines it is a case as well.
std::vector<CampaignEntry> hands_campaigns(const HandsOptions& options);

} // namespace trivar::testing
