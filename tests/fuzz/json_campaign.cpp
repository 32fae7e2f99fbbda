// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/json_campaign.h"

#include "core/files/gltf/glb_chunks.h"
#include "tests/fuzz/json_damage.h"
#include "tests/fuzz/model_use.h"
#include "tests/fuzz/sound_files.h"
#include "tests/support/rigged.h"

namespace trivar::testing {
namespace {

std::string damaged_json(const std::string& kind, const std::string& sound, Dice& dice)
{
    if (kind == "gltf") return with_values_replaced(sound, dice);
    GlbChunks chunks = glb_chunks(sound);
    chunks.json = with_values_replaced(chunks.json, dice);
    return glb_container(chunks);
}

Campaign json_campaign(const std::string& kind)
{
    std::vector<FileSet> sound = sound_files(kind);
    if (kind == "gltf") sound.push_back({{"rigged.gltf", gltf_text(rigged_model())}});
    const auto damaged = [kind, sound](std::uint64_t seed, int number) {
        Dice dice(seed, number);
        FileSet out = dice.one_of(sound);
        out.front().bytes = damaged_json(kind, out.front().bytes, dice);
        return out;
    };
    return {damaged, use_model};
}

} // namespace

std::vector<CampaignEntry> json_campaigns()
{
    std::vector<CampaignEntry> out;
    for (const char* kind : {"gltf", "glb"})
        out.push_back({"json", kind, [kind] { return json_campaign(kind); }});
    return out;
}

} // namespace trivar::testing
