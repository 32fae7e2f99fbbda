// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/usd_curves.h"

#include "core/base/text.h"
#include "core/export/usd_text.h"

#include <fmt/format.h>

namespace trivar {
namespace {

// UsdLines are the lines of one material.
struct UsdLines {
    std::vector<std::uint32_t> counts, points;
};

std::string points_text(const CurvePart& part, const std::vector<std::uint32_t>& which)
{
    const Curves there = in_world(part);
    std::vector<glm::vec3> points;
    for (const std::uint32_t p : which) points.push_back(there.points->positions[p]);
    return usd_list(points);
}

} // namespace

std::string usd_time(const Film& film, std::size_t moment)
{
    return shortest(film.moments[moment]);
}

std::size_t add_usd_curves(GrowingFile& file, const Film& film, const CurveStrip& strip,
                           std::size_t number, std::size_t first_material)
{
    const auto line = [&](const std::string& text) { file.append("        " + text + "\n"); };
    const Curves& curves = *strip.first().curves;
    std::map<std::uint32_t, UsdLines> by_material;
    for (std::size_t l = 0; l < curves.line_count(); ++l) {
        UsdLines& lines = by_material[curves.material_of(l)];
        lines.counts.push_back(curves.begin[l + 1] - curves.begin[l]);
        for (std::uint32_t p = curves.begin[l]; p < curves.begin[l + 1]; ++p)
            lines.points.push_back(p);
    }
    // Lines have no width, but viewers draw a tube: a thousandth of their size looks thin.
    const double width = glm::length(bounding_box(*in_world(strip.first()).points).size()) / 1000;
    for (const auto& [material, lines] : by_material) {
        file.append(fmt::format("    def BasisCurves \"{}\" (\n"
                                "        prepend apiSchemas = [\"MaterialBindingAPI\"]\n    )\n"
                                "    {{\n        uniform token type = \"linear\"\n",
                                usd_name(strip.name, number++)));
        line("uniform token wrap = \"nonperiodic\"");
        line("int[] curveVertexCounts = " + usd_list(lines.counts));
        line("float[] widths = [" + usd_number(static_cast<float>(width)) +
             "] (\n            interpolation = \"constant\"\n        )");
        if (strip.rests()) {
            line("point3f[] points = " + points_text(strip.first(), lines.points));
        } else {
            line("point3f[] points.timeSamples = {");
            for (std::size_t i = 0; i < film.moments.size(); ++i)
                if (strip.shown[i])
                    line("    " + usd_time(film, i) + ": " +
                         points_text(*strip.shown[i], lines.points) + ",");
            line("}");
        }
        if (!strip.always_shown()) {
            line("token visibility.timeSamples = {");
            for (std::size_t i = 0; i < film.moments.size(); ++i)
                line(fmt::format("    {}: \"{}\",", usd_time(film, i),
                                 strip.shown[i] ? "inherited" : "invisible"));
            line("}");
        }
        line(fmt::format("rel material:binding = </Scene/Materials/Material_{}>",
                         first_material + material));
        if (material < strip.materials->size())
            line("color3f[] primvars:displayColor = [" +
                 usd_tuple(glm::vec3((*strip.materials)[material].base_color)) + "]");
        file.append("    }\n");
    }
    return number;
}

} // namespace trivar
