// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/limit_colors.h"

#include <algorithm>
#include <array>
#include <map>

namespace trivar {
namespace {

struct Mark {
    double share;
    glm::vec3 color;
};
constexpr std::array<Mark, 4> marks{{{0.5, {0.30f, 0.31f, 0.33f}},
                                     {0.8, {0.72f, 0.48f, 0.10f}},
                                     {0.92, {0.86f, 0.26f, 0.04f}},
                                     {1.0, {0.55f, 0.02f, 0.03f}}}};

using Tiles = Ref<PlacedTiles>;

Tiles colored(const Tiles& tiles)
{
    PlacedTiles out;
    for (const PlacedTiles::Run& run : tiles->runs()) {
        std::vector<PlacedTile> those = *run;
        for (PlacedTile& tile : those) {
            tile.tint = limit_color(static_cast<double>(tile.of_limit));
            tile.tint_over = 1;
        }
        out.add(make_ref(std::move(those)));
    }
    return make_ref(std::move(out));
}

Material matt_white(const Material& before)
{
    Material out;
    out.base_color = glm::vec4(1);
    out.double_sided = before.double_sided;
    return out;
}

} // namespace

glm::vec3 limit_color(double share)
{
    std::size_t i = 1;
    while (i + 1 < marks.size() && share > marks[i].share) ++i;
    const Mark &a = marks[i - 1], &b = marks[i];
    const double t = std::clamp((share - a.share) / (b.share - a.share), 0.0, 1.0);
    return glm::mix(a.color, b.color, static_cast<float>(t));
}

void color_by_limits(gpu::Picture& picture, Id layer)
{
    std::map<Tiles, Tiles> known; // several meshes stand on the same tiles
    for (gpu::Instance& instance : picture.instances) {
        if (instance.id != layer || !instance.tiles) continue;
        TileSet set = *instance.tiles;
        Tiles& tiles = known[set.tiles];
        if (!tiles) tiles = colored(set.tiles);
        set.tiles = tiles;
        instance.tiles = make_ref(std::move(set));
        std::vector<Material> plain;
        if (instance.materials)
            for (const Material& each : *instance.materials) plain.push_back(matt_white(each));
        instance.materials = make_ref(std::move(plain));
    }
}

} // namespace trivar
