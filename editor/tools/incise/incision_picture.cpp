// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/incise/incision_picture.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr float dash_px = 9, gap_px = 6; // at scale 1

} // namespace

std::vector<gpu::Line> dashes_of(const SeenIncision& cut, const Camera& camera,
                                 const ui::Theme& theme, bool strong)
{
    std::vector<gpu::Line> out;
    if (!(cut.length_world > 0)) return out;
    const glm::dvec3 middle = cut.line[SeenIncision::steps / 2].p_world;
    const double px = pixel_size_world(camera, project(camera, middle).depth_world);
    const double period = static_cast<double>(theme.px(dash_px + gap_px)) * px;
    constexpr double most = 400;
    const double count =
        std::clamp(std::round(cut.length_world / std::max(period, 1e-9)), 1.0, most);
    const double dash = static_cast<double>(dash_px / (dash_px + gap_px));
    const glm::vec4 halo = ui::linear_light(theme.color.halo);
    const glm::vec4 color =
        ui::linear_light(strong ? theme.color.incision : ui::faded(theme.color.incision, 0.6f));
    const auto step_at = [](double share) {
        const auto i =
            static_cast<std::size_t>(share * static_cast<double>(SeenIncision::steps) + 0.5);
        return std::min(i, SeenIncision::steps);
    };
    // A little off the skin, so that no face of it hides the line
    const auto at = [&](double share) {
        return glm::vec3(cut.at(share) + 1.5 * px * cut.line[step_at(share)].normal_world);
    };
    for (const bool rim : {true, false})
        for (double k = 0; k < count; ++k) {
            gpu::Line line{{}, rim ? halo : color, theme.line(rim ? 4.5f : strong ? 2.4f : 1.6f)};
            const double from = (k + (1 - dash) / 2) / count, to = from + dash / count;
            if (!cut.on_skin[step_at((from + to) / 2)]) continue;
            const int pieces =
                1 + static_cast<int>((to - from) * static_cast<double>(SeenIncision::steps));
            for (int i = 0; i <= pieces; ++i)
                line.points.push_back(at(from + (to - from) * i / pieces));
            if (!rim || strong) out.push_back(std::move(line));
        }
    return out;
}

std::vector<gpu::Line> cage_of(const SeenIncision& cut, const ui::Theme& theme)
{
    std::vector<gpu::Line> out;
    const glm::vec4 outer = ui::linear_light(ui::faded(theme.color.lattice, 0.7f)),
                    inner = ui::linear_light(ui::faded(theme.color.lattice, 0.32f));
    const auto add = [&](const std::vector<glm::dvec3>& points, bool outside) {
        gpu::Line line{{}, outside ? outer : inner, theme.line(outside ? 1.4f : 1)};
        for (const glm::dvec3& p : points) line.points.emplace_back(p);
        if (line.points.size() > 1) out.push_back(std::move(line));
    };
    for (const std::vector<glm::dvec3>& rim : cut.rims) add(rim, true);
    for (std::size_t i = 0; i < cut.rungs.size(); ++i)
        add(cut.rungs[i], i == 0 || i + 1 == cut.rungs.size());
    return out;
}

} // namespace trivar
