// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/volume_levels.h"

#include "core/base/number_text.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/color_space.hpp>

namespace trivar {
namespace {

// sRGB; told from each other on a dark ground.
constexpr std::array<std::array<float, 3>, 6> level_colors{{{0.40f, 0.82f, 1.00f},
                                                            {1.00f, 0.77f, 0.42f},
                                                            {0.49f, 0.89f, 0.66f},
                                                            {0.95f, 0.55f, 0.66f},
                                                            {0.79f, 0.63f, 1.00f},
                                                            {0.95f, 0.90f, 0.42f}}};

} // namespace

std::string name_of(const VoxelLevel& level)
{
    return level.name.empty() ? fmt::format("Level {}", number_text(level.value, {.digits = 6}))
                              : level.name;
}

std::string value_words(double value, const std::string& unit)
{
    return number_text(value, {.digits = 6}) + (unit.empty() ? "" : " " + unit);
}

void set_color(VoxelLevel& level, const glm::vec3& srgb)
{
    constexpr float pale = 0.85f; // so that its lines stand out
    level.ink.color = srgb;
    const glm::vec3 body = glm::convertSRGBToLinear(glm::mix(srgb, glm::vec3(0.8f), pale));
    level.look.base_color = glm::vec4(body, level.look.base_color.a);
}

ui::Color level_color(const VoxelLevel& level)
{
    const auto byte = [](float c) {
        return static_cast<unsigned>(std::lround(255 * std::clamp(c, 0.0f, 1.0f)));
    };
    const glm::vec3& c = level.ink.color;
    return ui::rgb(byte(c.r) << 16 | byte(c.g) << 8 | byte(c.b));
}

VoxelLevel new_level(const VoxelShape& shape, double value)
{
    std::size_t at = shape.levels.size() % level_colors.size();
    for (std::size_t i = 0; i < level_colors.size(); ++i) {
        const glm::vec3 color(level_colors[i][0], level_colors[i][1], level_colors[i][2]);
        if (std::ranges::any_of(shape.levels,
                                [&](const VoxelLevel& each) { return each.ink.color == color; }))
            continue;
        at = i;
        break;
    }
    VoxelLevel level;
    level.value = value;
    level.ink.taper = 0; // so that lines are strokes in files, which a hand can edit
    set_color(level, {level_colors[at][0], level_colors[at][1], level_colors[at][2]});
    level.look.roughness = 0.7f;
    return level;
}

double next_value(const VoxelShape& shape, const VolumeSummary& summary)
{
    if (shape.levels.empty())
        return readable_value((summary.least + summary.greatest) / 2, summary);
    const double last = shape.levels.back().value;
    const bool low = last < summary.least + 0.75 * (summary.greatest - summary.least);
    return readable_value((last + (low ? summary.greatest : summary.least)) / 2, summary);
}

double readable_value(double value, const VolumeSummary& summary)
{
    const double range = summary.greatest - summary.least;
    if (range <= 0) return summary.least;
    const double step = std::pow(10, std::floor(std::log10(range / 500)));
    const double near = std::round(value / step) * step;
    return std::clamp(near, summary.least, summary.greatest);
}

const VoxelShape* volume_of(const Document& document, Id id)
{
    return made_of<VoxelShape>(document, id);
}

Id volume_at_work(const Document& document, Id active)
{
    if (volume_of(document, active)) return active;
    Id only = 0;
    for (const auto& [id, each] : document.objects) {
        if (!kind_of(*each).has_levels) continue;
        if (only != 0) return 0;
        only = id;
    }
    return only;
}

LevelShows shows_of(const VoxelLevel& level)
{
    if (level.lines) return level.surface ? LevelShows::both : LevelShows::lines;
    return LevelShows::surface;
}

void show(VoxelLevel& level, LevelShows shows)
{
    level.lines = shows != LevelShows::surface;
    level.surface = shows != LevelShows::lines;
}

} // namespace trivar
