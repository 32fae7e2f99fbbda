// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/campaign.h"
#include "tests/fuzz/case_result.h"

#include <string>
#include <vector>

namespace trivar::testing {

struct Tally {
    int cases = 0, accepted = 0;
    CaseResult largest, slowest;
    std::vector<CaseResult> failures; // in their order
    int ended(CaseEnd by) const;      // how many of the failures
};

// Runs the cases one after another in a child process, which a new one replaces where it dies or is
// killed. The caller has one thread. Throws std::runtime_error where the system gives no process,
// or where a child dies outside of a case.
Tally run_campaign(const CampaignEntry& entry, const CampaignOptions& options);

// One line for people.
std::string summary(const CampaignEntry& entry, const Tally& tally);

} // namespace trivar::testing
