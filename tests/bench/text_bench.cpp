// SPDX-License-Identifier: GPL-3.0-or-later
// Letters as bodies, from their outlines on: nearly all of it is the triangulation of the plane.
#include "core/plane/triangulation.h"
#include "core/text/installed_fonts.h"
#include "core/text/letter.h"

#include <benchmark/benchmark.h>
#include <cmath>

namespace trivar {
namespace {

std::vector<Region> outlines(const Font& font)
{
    constexpr std::u32string_view alphabet =
        U"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789&@%$#?!;";
    std::vector<Region> out;
    for (const char32_t letter : alphabet) {
        const Font::Glyph glyph = font.glyph(
            font.line(std::u32string(1, letter), 0).glyphs.at(0).glyph, 0.001 * em_units);
        out.push_back(united(glyph.loops, glyph.even_odd));
    }
    return out;
}

void letters(benchmark::State& state, const Extrusion& extrusion)
{
    const std::vector<Region> regions = outlines(find_font("DejaVu Serif").font);
    std::size_t faces = 0;
    for (auto _ : state) {
        faces = 0;
        for (const Region& region : regions) faces += letter_body(region, extrusion)->face_count();
    }
    state.counters["faces"] = static_cast<double>(faces);
}
BENCHMARK_CAPTURE(letters, flat, Extrusion{})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(letters, with_bevels, Extrusion{.bevel = 0.03, .bevel_steps = 4})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(letters, with_short_edges, Extrusion{.max_edge = 0.01})
    ->Unit(benchmark::kMillisecond);

// A star with edges so short that half of its triangles lie at its rim.
void triangulation_of_a_star(benchmark::State& state)
{
    Loop star;
    for (int i = 0; i < 20'000; ++i) {
        const double angle = 6.283185307179586 * i / 20'000;
        const double radius = 4e6 * (1 + 0.3 * std::sin(40 * angle));
        star.emplace_back(glm::round(radius * glm::dvec2(std::cos(angle), std::sin(angle))));
    }
    std::size_t triangles = 0;
    for (auto _ : state) {
        Triangulation plane;
        std::vector<int> points;
        for (const glm::ivec2& p : star) points.push_back(plane.insert(p));
        std::vector<std::pair<int, int>> edges;
        for (std::size_t i = 0; i < points.size(); ++i)
            edges.emplace_back(points[i], points[(i + 1) % points.size()]);
        for (const auto& [a, b] : edges) plane.join(a, b);
        plane.fill(edges);
        plane.refine(
            100'000, [](const auto&) { return true; }, [](int, const auto&) {});
        triangles = plane.inside().size();
    }
    state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(triangulation_of_a_star)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace trivar
