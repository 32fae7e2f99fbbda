// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gallery/scenes.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace trivar::testing {

std::vector<std::string> every_scene(const std::string& folder)
{
    std::vector<std::string> out;
    for (const auto& entry :
         std::filesystem::directory_iterator(TRIVAR_SOURCE_DIR "/assets/" + folder))
        if (entry.path().extension() == ".trivar") out.push_back(entry.path().stem());
    std::ranges::sort(out);
    return out;
}

std::optional<int> shown_frame(const std::string& scene)
{
    constexpr int between_the_cars = 200, grown = 120, half_open = 57, thorny = 96;
    constexpr int between_the_bars = 44, in_the_tree = 62, round_the_column = 47, sliced_apart = 48;
    constexpr int round_the_head = 49, in_the_camel = 46, in_rings = 60, quite_open = 48;
    constexpr int held_open = 24;
    const std::map<std::string, int> frames{{"bulldozer_parks", between_the_cars},
                                            {"wreath", grown},
                                            {"thorn_to_flower", half_open},
                                            {"face_thorns", thorny},
                                            {"robot_bars", between_the_bars},
                                            {"robot_bars_tilted", between_the_bars},
                                            {"bulldozer_tree", in_the_tree},
                                            {"sphere_cylinder", round_the_column},
                                            {"sphere_cylinder_stitched", round_the_column},
                                            {"sphere_cylinder_ends", round_the_column},
                                            {"part_profile", round_the_head},
                                            {"bunny_cylinder", in_the_camel},
                                            {"sliced", sliced_apart},
                                            {"pineapple", in_rings},
                                            {"crossing_cuts", quite_open},
                                            {"face_incisions", quite_open},
                                            {"forearm_layers", held_open}};
    const auto found = frames.find(scene);
    return found == frames.end() ? std::nullopt : std::optional(found->second);
}

} // namespace trivar::testing
