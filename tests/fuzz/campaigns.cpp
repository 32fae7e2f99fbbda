// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/campaigns.h"

#include "tests/fuzz/bytes_campaign.h"
#include "tests/fuzz/json_campaign.h"
#include "tests/fuzz/logs_campaign.h"
#include "tests/fuzz/volumes_campaign.h"

namespace trivar::testing {

std::vector<CampaignEntry> all_campaigns()
{
    std::vector<CampaignEntry> out;
    for (const auto& more :
         {bytes_campaigns(), volumes_campaigns(), json_campaigns(), logs_campaigns()})
        out.insert(out.end(), more.begin(), more.end());
    return out;
}

} // namespace trivar::testing
