// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/level_drawing.h"

#include "core/base/parallel.h"
#include "core/lines/fans.h"
#include "core/lines/line_budget.h"
#include "core/silhouette/border_lines.h"
#include "core/silhouette/dash_table.h"
#include "core/silhouette/silhouette_finder.h"

#include <fmt/format.h>
#include <iterator>
#include <utility>

namespace trivar {
namespace {

constexpr float shortest_further_line = 12; // pixels

// The points of a level's lines that it, other levels or whatever else hides.
std::vector<char> hidden_of(const Silhouettes& lines, const DrawnLevel& level,
                            const ViewPoint& from, const LevelBody& own,
                            std::span<const LevelBody> others)
{
    std::vector<char> out = hidden_points(lines, from, own, others);
    if (!level.hidden_by_others) return out;
    parallel_blocks(out.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (!out[i]) out[i] = level.hidden_by_others(lines.points[i].p);
    });
    return out;
}

} // namespace

DrawingView drawing_view(const Camera& camera, const glm::dmat4& to_world, const glm::ivec3& size)
{
    return drawing_view(camera, to_world, Box{glm::dvec3(0), glm::dvec3(size - 1)});
}

DrawingView drawing_view(const Camera& camera, const glm::dmat4& to_world, const Box& box)
{
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    Box depths; // along the view, of the box's corners
    for (const glm::dvec3& corner : box.corners())
        depths.add(glm::dvec3(
            glm::dot(glm::dvec3(to_world * glm::dvec4(corner, 1)) - camera.eye, forward)));
    const double margin = 1e-3 * std::max(1e-9, depths.size().x),
                 near = camera.perspective
                            ? std::max(depths.lo.x - margin, 1e-3 * std::abs(depths.hi.x))
                            : depths.lo.x - margin,
                 far = std::max(depths.hi.x + margin, near + margin);
    glm::dmat4 to_pixels(1);
    to_pixels[0][0] = camera.size_px.x / 2;
    to_pixels[1][1] = -camera.size_px.y / 2;
    to_pixels[2][2] = 0.5;
    to_pixels[3] = {camera.size_px.x / 2, camera.size_px.y / 2, 0.5, 1};
    const glm::dmat4 to_voxels = glm::inverse(to_world);
    return {
        to_pixels * projection_matrix(camera, near, far) * view_matrix(camera) * to_world,
        {to_voxels * (camera.perspective ? glm::dvec4(camera.eye, 1) : glm::dvec4(forward, 0))}};
}

std::array<std::vector<Stroke>, 2> level_strokes(const ScalarField<float>& field,
                                                 const FieldHulls& hulls, const DrawnLevel& level,
                                                 const DrawingView& view,
                                                 const LevelDrawingOptions& options,
                                                 std::vector<LevelBody> others, ProofGaps* gaps)
{
    const LevelBody own{field, hulls, level.mesh.level, level.side};
    const int depth = std::max(level.certified_depth, options.certified_depth);
    Silhouettes silhouettes;
    StrokeOptions joining = options.strokes;
    if (options.dash_rows > 0) {
        silhouettes =
            DashTable(field, hulls, level.mesh.level, options.dash_rows)(field, view.from);
        joining.join = joining.shortest = 0;
    } else if (depth < 0) {
        silhouettes = SilhouetteFinder()(field, level.mesh, view.from);
    } else {
        CertifiedSilhouettes certified = certified_silhouettes(
            field, hulls, level.mesh.level, view.from, depth, {.spacing = 0.1f}, options.progress);
        if (gaps) {
            gaps->open += certified.open;
            gaps->loose_ends += certified.loose_ends;
        }
        joining.shortest = 0;
        silhouettes = std::move(certified.curves);
    }
    std::array<std::vector<Stroke>, 2> out;
    out[0] = strokes(silhouettes, hidden_of(silhouettes, level, view.from, own, others),
                     view.to_image, joining);
    if (!level.border) return out;
    const Silhouettes border = border_lines(field, level.mesh);
    out[1] = strokes(border, hidden_of(border, level, view.from, own, others), view.to_image,
                     options.strokes);
    return out;
}

std::vector<KindStrokes> further_strokes(const ScalarField<float>& field, const FieldHulls& hulls,
                                         const DrawnLevel& level, const DrawingView& view,
                                         const LevelDrawingOptions& options,
                                         std::span<const LevelBody> others)
{
    std::vector<KindStrokes> out;
    if (!level.further) return out;
    const LevelBody own{field, hulls, level.mesh.level, level.side};
    StrokeOptions further = options.strokes;
    further.shortest = std::max(further.shortest, shortest_further_line);
    for (const KindLines& each :
         lines_seen(*level.further, level.more, view.from, field, level.mesh.level))
        out.push_back(
            {each.kind, strokes(each.lines, hidden_of(each.lines, level, view.from, own, others),
                                view.to_image, further)});
    return out;
}

LineStyle finer(LineStyle style, const MoreLines& wanted)
{
    style.width *= wanted.width;
    return style;
}

namespace {

std::string layer_name(const DrawnLevel& level, const KindStrokes& kind)
{
    return fmt::format("{}: {}", level.name, words_of(kind.kind));
}

// Returns for each line the share that persists at nearby levels. Empty: 1 for all.
std::vector<float> lasting(std::span<const Stroke> lines, const ScalarField<float>& field,
                           const DrawnLevel& level, const DrawingView& view)
{
    std::vector<std::vector<Stroke>> nearby;
    if (level.more.amount < 1)
        for (const LevelMesh& mesh : level.nearby) {
            const Silhouettes found =
                SilhouetteFinder()(field, mesh, view.from, {.spacing = 1, .polished = false});
            const std::vector<char> hidden(found.points.size(), 0);
            nearby.push_back(strokes(found, hidden, view.to_image, {}));
        }
    if (nearby.empty()) return {};
    return persistence(lines, nearby);
}

// The lines of a layer that its budget keeps, of each kind; those that it kept before stay rather
// than others. `weights` are of the first kind.
void keep_within_budget(std::span<std::vector<Stroke>> kinds, float share, const std::string& layer,
                        const LevelDrawingOptions& options, std::vector<float> weights = {})
{
    std::vector<std::uint64_t> before;
    if (options.kept) before = std::exchange(options.kept(layer), {});
    for (std::vector<Stroke>& kind : kinds) {
        kind = within_budget(std::move(kind), share, std::exchange(weights, {}), before);
        if (!options.kept) continue;
        std::vector<std::uint64_t>& kept = options.kept(layer);
        for (const Stroke& stroke : kind) kept.push_back(stroke.id);
    }
}

} // namespace

LevelDrawing draw_levels(const ScalarField<float>& field, const FieldHulls& hulls,
                         std::span<const DrawnLevel> levels, const DrawingView& view,
                         const LevelDrawingOptions& options)
{
    LevelDrawing out;
    for (const DrawnLevel& level : levels) {
        std::vector<LevelBody> others;
        if (options.hide_each_other)
            for (const DrawnLevel& other : levels)
                if (&other != &level)
                    others.push_back({field, hulls, other.mesh.level, other.side});
        out.layers.push_back({level.name, {}});
        std::array<std::vector<Stroke>, 2> made =
            level_strokes(field, hulls, level, view, options, others, &out.gaps);
        std::vector<KindStrokes> further =
            further_strokes(field, hulls, level, view, options, others);
        if (options.ids) {
            options.ids(level.name)(made);
            for (KindStrokes& kind : further)
                options.ids(layer_name(level, kind))(std::span(&kind.strokes, 1));
        }
        const LevelBody body{field, hulls, level.mesh.level, level.side};
        keep_within_budget(made, level.more.amount, level.name, options,
                           lasting(made[0], field, level, view));
        for (const std::vector<Stroke>& kind : made)
            std::ranges::move(inked_with_fans(body, kind, level.style, view.to_image),
                              std::back_inserter(out.layers.back().lines));
        for (KindStrokes& kind : further) {
            const std::string layer = layer_name(level, kind);
            keep_within_budget(std::span(&kind.strokes, 1), level.more.amount, layer, options);
            out.layers.push_back({layer, inked(kind.strokes, finer(level.style, level.more))});
        }
    }
    return out;
}

} // namespace trivar
