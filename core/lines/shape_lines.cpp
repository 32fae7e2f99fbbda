// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/shape_lines.h"

#include "core/base/parallel.h"
#include "core/lines/zero_lines.h"
#include "core/silhouette/silhouette_curves.h"

#include <cmath>

namespace trivar {
namespace {

// The strength that lines must have somewhere; along all of their length `weaker` of that is
// enough. Curvatures are per size of the surface, their changes per its square.
constexpr float strong_suggestive = 120, strong_ridge = 22, strong_valley = 16,
                strong_parabolic = 8, strong_isophote = 1, weaker = 0.4f;
constexpr float least_facing = 0.12f; // cosine to the sight, of suggestive contours
constexpr float seen_straight =
    0.01f; // squared sine, where the sight has no direction on a surface
constexpr int line_rounding = 6;
constexpr float shortest_line = 0.01f, line_spacing = 0.0005f; // of the size

LineThresholds thresholds(const SurfaceShape& shape, const MoreLines& wanted, float strong)
{
    strong /= std::max(1e-3f, wanted.detail);
    return {.weak = weaker * strong,
            .strong = strong,
            .rounding = line_rounding,
            .spacing = line_spacing * shape.size,
            .shortest = shortest_line * shape.size};
}

std::vector<float> at_vertices(const SurfaceShape& shape, auto&& value)
{
    std::vector<float> out(shape.positions.size());
    parallel_blocks(out.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) out[i] = value(i);
    });
    return out;
}

float mean_of(const SurfaceShape& shape, std::size_t triangle, std::span<const float> values)
{
    const std::uint32_t* v = shape.corners.data() + 3 * triangle;
    return (values[v[0]] + values[v[1]] + values[v[2]]) / 3;
}

// Ridges for a sign of 1, valleys for -1.
Silhouettes ridge_lines(const SurfaceShape& shape, const MoreLines& wanted, float sign)
{
    std::vector<PrincipalBend> bends(shape.positions.size());
    const std::vector<float> greatest = at_vertices(shape, [&](std::size_t i) {
        bends[i] = principal(sign * shape.bends[i], shape.normals[i]);
        return bends[i].greatest;
    });
    std::vector<glm::vec3> gradients;
    if (!shape.at) gradients = vertex_gradients(shape, greatest);
    std::vector<glm::vec3> directions(bends.size());
    const std::vector<float> change = at_vertices(shape, [&](std::size_t i) {
        directions[i] = bends[i].direction;
        if (!shape.at) return glm::dot(gradients[i], directions[i]);
        const glm::vec3 step = shape.step * directions[i];
        const auto greatest_at = [&](const glm::vec3& p) {
            const LocalShape place = shape.at(p);
            return principal(sign * place.bend, place.normal).greatest;
        };
        return (greatest_at(shape.positions[i] + step) - greatest_at(shape.positions[i] - step)) /
               (2 * shape.step);
    });
    // A place that bends more the other way is the flank of another line.
    const std::vector<float> strength = at_vertices(shape, [&](std::size_t i) {
        return bends[i].greatest > -bends[i].least ? shape.size * bends[i].greatest : 0;
    });
    const auto of_triangle = [&](std::size_t t, const std::array<float, 3>& values) {
        const glm::vec3& along = directions[shape.corners[3 * t]];
        const bool is_greatest = glm::dot(triangle_gradient(shape, t, values), along) < 0;
        return is_greatest ? mean_of(shape, t, strength) : 0;
    };
    return zero_lines(shape, {change, directions, of_triangle},
                      thresholds(shape, wanted, sign > 0 ? strong_ridge : strong_valley));
}

Silhouettes parabolic_lines(const SurfaceShape& shape, const MoreLines& wanted)
{
    const std::vector<float> gauss =
        at_vertices(shape, [&](std::size_t i) { return shape.bends[i].gauss(); });
    const std::vector<float> bent = at_vertices(
        shape, [&](std::size_t i) { return 2 * shape.size * std::abs(shape.bends[i].mean()); });
    return zero_lines(
        shape,
        {gauss,
         {},
         [&](std::size_t t, const std::array<float, 3>&) { return mean_of(shape, t, bent); }},
        thresholds(shape, wanted, strong_parabolic));
}

void append(Silhouettes& to, const Silhouettes& from)
{
    const auto before = static_cast<std::uint32_t>(to.points.size());
    to.points.insert(to.points.end(), from.points.begin(), from.points.end());
    for (std::size_t c = 0; c < from.count(); ++c) {
        to.first.push_back(before + from.first[c + 1]);
        to.closed.push_back(from.closed[c]);
    }
}

Silhouettes isophote_lines(const SurfaceShape& shape, const MoreLines& wanted)
{
    const float length = glm::length(wanted.light);
    Silhouettes out;
    if (!(length > 0)) return out;
    const glm::vec3 light = wanted.light / length;
    const std::vector<float> shade =
        at_vertices(shape, [&](std::size_t i) { return glm::dot(shape.normals[i], light); });
    for (int k = 0; k < wanted.isophotes; ++k) {
        const float step = static_cast<float>(k) / static_cast<float>(wanted.isophotes);
        const std::vector<float> less =
            at_vertices(shape, [&](std::size_t i) { return shade[i] - step; });
        append(out, zero_lines(shape,
                               {less,
                                {},
                                [&](std::size_t t, const std::array<float, 3>& values) {
                                    return shape.size *
                                           glm::length(triangle_gradient(shape, t, values));
                                }},
                               thresholds(shape, wanted, strong_isophote)));
    }
    return out;
}

} // namespace

std::string_view words_of(LineKind kind)
{
    switch (kind) {
    case LineKind::silhouettes: return "silhouettes";
    case LineKind::borders: return "borders";
    case LineKind::creases: return "creases";
    case LineKind::intersections: return "intersections";
    case LineKind::suggestive: return "suggestive contours";
    case LineKind::ridges: return "ridges";
    case LineKind::valleys: return "valleys";
    case LineKind::parabolic: return "parabolic lines";
    case LineKind::isophotes: return "isophotes";
    }
    return {};
}

std::vector<KindLines> fixed_lines(const SurfaceShape& shape, const MoreLines& wanted)
{
    std::vector<KindLines> out;
    if (shape.corners.empty()) return out;
    if (wanted.ridges) out.push_back({LineKind::ridges, ridge_lines(shape, wanted, 1)});
    if (wanted.valleys) out.push_back({LineKind::valleys, ridge_lines(shape, wanted, -1)});
    if (wanted.parabolic) out.push_back({LineKind::parabolic, parabolic_lines(shape, wanted)});
    if (wanted.isophotes > 0) out.push_back({LineKind::isophotes, isophote_lines(shape, wanted)});
    return out;
}

Silhouettes suggestive_lines(const SurfaceShape& shape, const ViewPoint& view,
                             const MoreLines& wanted)
{
    check(view);
    // The way to the eye at a vertex, unit.
    const auto to_eye = [&](const glm::vec3& p) {
        return -glm::normalize(glm::vec3(view.sight(glm::dvec3(p))));
    };
    // Times the squared sine of the angle between normal and sight, which does not move its zeros.
    const std::vector<float> radial = at_vertices(
        shape, [&](std::size_t i) { return shape.bends[i].along(to_eye(shape.positions[i])); });
    const auto strength = [&](std::size_t t, const std::array<float, 3>& values) {
        const std::uint32_t* v = shape.corners.data() + 3 * t;
        const glm::vec3 sum = shape.normals[v[0]] + shape.normals[v[1]] + shape.normals[v[2]];
        const float length = glm::length(sum);
        if (!(length > 0)) return 0.0f;
        const glm::vec3 n = sum / length, eye = to_eye(shape.positions[v[0]]);
        const float facing = glm::dot(n, eye), sine2 = 1 - facing * facing;
        if (facing < least_facing || sine2 < seen_straight) return 0.0f;
        const glm::vec3 along = (eye - facing * n) / std::sqrt(sine2);
        return glm::dot(triangle_gradient(shape, t, values), along) / sine2 * shape.size *
               shape.size;
    };
    return zero_lines(shape, {radial, {}, strength}, thresholds(shape, wanted, strong_suggestive));
}

} // namespace trivar
