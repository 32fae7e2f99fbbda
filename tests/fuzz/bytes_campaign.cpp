// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/bytes_campaign.h"

#include "core/files/gltf/glb_chunks.h"
#include "tests/fuzz/byte_damage.h"
#include "tests/fuzz/model_use.h"
#include "tests/fuzz/sound_files.h"

#include <algorithm>

namespace trivar::testing {
namespace {

// The file of a set that is damaged: the first, but of glTF its buffer once in three cases.
std::size_t damaged_file(const std::string& kind, Dice& dice)
{
    return kind == "mtl" || (kind == "gltf" && dice.below(3) == 0) ? 1 : 0;
}

std::string damaged_bytes(const std::string& kind, const std::string& sound,
                          const std::vector<std::string>& others, Dice& dice)
{
    if (kind != "glb" || dice.below(2) == 0) return with_bytes_damaged(sound, others, dice);
    // Inside a container whose own lengths are right more is read of what is damaged.
    GlbChunks chunks = glb_chunks(sound);
    std::string& chunk = dice.below(2) == 0 ? chunks.json : chunks.binary;
    chunk = with_bytes_damaged(chunk, {chunk}, dice);
    return glb_container(chunks);
}

Campaign bytes_campaign(const std::string& kind)
{
    std::vector<FileSet> sound = sound_files(kind == "mtl" ? "obj" : kind);
    if (kind == "mtl") std::erase_if(sound, [](const FileSet& set) { return set.size() < 2; });
    const auto damaged = [kind, sound](std::uint64_t seed, int number) {
        Dice dice(seed, number);
        FileSet out = dice.one_of(sound);
        const std::size_t at = std::min(damaged_file(kind, dice), out.size() - 1);
        std::vector<std::string> others;
        for (const FileSet& set : sound) others.push_back(set[std::min(at, set.size() - 1)].bytes);
        out[at].bytes = damaged_bytes(kind, out[at].bytes, others, dice);
        return out;
    };
    return {damaged, use_model};
}

} // namespace

std::vector<CampaignEntry> bytes_campaigns()
{
    std::vector<CampaignEntry> out;
    for (const char* kind :
         {"obj", "mtl", "ply", "ply-text", "stl", "stl-text", "off", "gltf", "glb"})
        out.push_back({"bytes", kind, [kind] { return bytes_campaign(kind); }});
    return out;
}

} // namespace trivar::testing
