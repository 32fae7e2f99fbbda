// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/logs_campaign.h"

#include "tests/fuzz/log_damage.h"
#include "tests/fuzz/log_use.h"
#include "tests/fuzz/sound_logs.h"

namespace trivar::testing {
namespace {

Campaign logs_campaign()
{
    const auto damaged = [sound = sound_logs()](std::uint64_t seed, int number) {
        Dice dice(seed, number);
        FileSet out = dice.one_of(sound);
        out.front().bytes = with_lines_damaged(out.front().bytes, dice);
        return out;
    };
    return {damaged, use_log};
}

} // namespace

std::vector<CampaignEntry> logs_campaigns()
{
    return {{"logs", "trivar", logs_campaign}};
}

} // namespace trivar::testing
