// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timing_overlay.h"

#include <fmt/format.h>

namespace trivar::ui {
namespace {

std::string group_text(std::string_view title, const Timings& timings)
{
    if (timings.stages.empty()) return {};
    std::string text = fmt::format("{:<24}{:>10.2f} ms\n", title, total_ms(timings));
    for (const Timings::Stage& stage : timings.stages) {
        text += fmt::format("  {:<22}{:>10.2f} ms", stage.name, stage.time_ms);
        if (stage.vertices > 0 && stage.time_ms > 0)
            text += fmt::format("  {} vertices, {:.1f} million a second", stage.vertices,
                                static_cast<double>(stage.vertices) / stage.time_ms / 1000);
        text += "\n";
    }
    return text;
}

} // namespace

std::string timing_text(const TimingSources& s)
{
    std::string text = fmt::format("{:<24}{:>10.2f} ms\n", "Median", s.history.median_ms());
    text += group_text("Evaluation", s.evaluation);
    if (!s.history.pictures().empty())
        text += group_text("Picture while moving", s.history.pictures().back().passes);
    text += group_text("Picture at rest", s.at_rest);
    for (const TimedWay& way : s.ways)
        if (way.time_ms)
            text += fmt::format("{:<24}{:>10.2f} ms  {} vertices, {:.1f} million a second{}\n",
                                "Deformed by " + way.name, *way.time_ms, way.vertices,
                                static_cast<double>(way.vertices) / *way.time_ms / 1000,
                                way.off.empty() ? "" : ", off by " + way.off);
    if (!s.drawn.empty()) text += s.drawn + "\n";
    constexpr double mega = 1024 * 1024;
    return text + fmt::format("{:<24}{:>10.1f} MB\n{:<24}{:>10.1f} MB\n", "Memory of the program",
                              static_cast<double>(s.program_bytes) / mega, "Meshes and textures",
                              static_cast<double>(s.uploaded_bytes) / mega);
}

} // namespace trivar::ui
