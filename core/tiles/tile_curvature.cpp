// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_curvature.h"

#include "core/limit/tangent.h"
#include "core/tiles/on_surface.h"

#include <algorithm>
#include <array>

namespace trivar {
namespace {

// Below this share of the other one, the smaller curvature is clearly the smaller one.
constexpr double clearly_less = 0.85;
// A surface that turns by less than this over the diagonal of its base, radians, is flat.
constexpr double flat_turn = 0.02;
constexpr int rounds_of_smoothing = 2;

glm::dmat3 outer(const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::outerProduct(a, b);
}

// The symmetric tensor of a triangle that takes its edges to the changes of normals along them, by
// least squares: zero across its plane.
glm::dmat3 tensor_of(const std::array<glm::dvec3, 3>& p, const std::array<glm::dvec3, 3>& n,
                     const glm::dvec3& face_normal)
{
    const glm::dvec3 x = direction_on(p[1] - p[0], face_normal), y = glm::cross(face_normal, x);
    // The unknowns are a, b, c of [a b; b c]; each edge gives two equations.
    glm::dmat3 squares(0);
    glm::dvec3 right(0);
    for (std::size_t e = 0; e < 3; ++e) {
        const glm::dvec3 step = p[(e + 1) % 3] - p[e], turn = n[(e + 1) % 3] - n[e];
        const double u = glm::dot(step, x), v = glm::dot(step, y);
        for (const auto& [row, value] : {std::pair(glm::dvec3(u, v, 0), glm::dot(turn, x)),
                                         std::pair(glm::dvec3(0, u, v), glm::dot(turn, y))}) {
            squares += outer(row, row);
            right += value * row;
        }
    }
    if (!(std::abs(glm::determinant(squares)) > 0)) return glm::dmat3(0);
    const glm::dvec3 s = glm::inverse(squares) * right;
    const glm::dmat3 tensor =
        s.x * outer(x, x) + s.y * (outer(x, y) + outer(y, x)) + s.z * outer(y, y);
    for (int k = 0; k < 3; ++k)
        if (!glm::all(glm::lessThan(glm::abs(tensor[k]), glm::dvec3(1e300)))) return glm::dmat3(0);
    return tensor;
}

// The direction of the smaller eigenvalue, by its size, of [a b; b c] over x and y; zero where both
// are about as large, or below `flat`.
glm::dvec3 lesser_direction(double a, double b, double c, const glm::dvec3& x, const glm::dvec3& y,
                            double flat)
{
    const double mean = (a + c) / 2, apart = std::hypot((a - c) / 2, b);
    const double hi = std::abs(mean + apart), lo = std::abs(mean - apart);
    if (!(std::max(hi, lo) > flat) || std::min(hi, lo) > clearly_less * std::max(hi, lo))
        return glm::dvec3(0);
    // The larger eigenvalue lies at this angle.
    const double angle = 0.5 * std::atan2(2 * b, a - c);
    const glm::dvec3 at_hi = std::cos(angle) * x + std::sin(angle) * y;
    return hi < lo ? at_hi : -std::sin(angle) * x + std::cos(angle) * y;
}

} // namespace

TileCurvature::TileCurvature(const TileBase& base)
{
    const std::size_t count = base.points().size();
    std::vector<glm::dvec3> normals(count, glm::dvec3(0));
    std::vector<double> areas(count, 0);
    tensors_.assign(count, glm::dmat3(0));
    const auto triangles = static_cast<std::uint32_t>(base.triangle_count());
    for (std::uint32_t t = 0; t < triangles; ++t)
        for (int k = 0; k < 3; ++k) {
            glm::dvec3 weights(0);
            weights[k] = 1;
            normals[base.triangle(t)[k]] = base.normal({t, weights});
        }
    for (std::uint32_t t = 0; t < triangles; ++t) {
        const glm::uvec3& c = base.triangle(t);
        const double area = base.area(t);
        const glm::dmat3 tensor =
            area * tensor_of(base.corners(t), {normals[c.x], normals[c.y], normals[c.z]},
                             base.face_normal(t));
        for (int k = 0; k < 3; ++k) {
            tensors_[c[k]] += tensor;
            areas[c[k]] += area;
        }
    }
    for (std::size_t p = 0; p < count; ++p)
        if (areas[p] > 0) tensors_[p] /= areas[p];
    // A scanned mesh is rougher than the surface that it stands for.
    for (int round = 0; round < rounds_of_smoothing; ++round) {
        std::vector<glm::dmat3> sums = tensors_;
        std::vector<double> weights(count, 1);
        for (std::uint32_t t = 0; t < triangles; ++t) {
            const glm::uvec3& c = base.triangle(t);
            for (int k = 0; k < 3; ++k) {
                sums[c[k]] += 0.5 * (tensors_[c[(k + 1) % 3]] + tensors_[c[(k + 2) % 3]]);
                weights[c[k]] += 1;
            }
        }
        for (std::size_t p = 0; p < count; ++p) tensors_[p] = sums[p] / weights[p];
    }
}

TileCurvature::TileCurvature(Ref<LimitBase> base) : limit_(std::move(base)) {}

glm::dvec3 TileCurvature::least(const TileBase& base, const SurfacePlace& at) const
{
    const double flat = flat_turn / base.diagonal();
    const glm::dvec3 n = base.normal(at);
    const glm::dvec3 x = direction_on({1, 0, 0}, n), y = glm::cross(n, x);
    if (!limit_) {
        glm::dmat3 tensor(0);
        for (int k = 0; k < 3; ++k)
            tensor += at.weights[k] * tensors_[base.triangle(at.triangle)[k]];
        return lesser_direction(glm::dot(x, tensor * x), glm::dot(x, tensor * y),
                                glm::dot(y, tensor * y), x, y, flat);
    }
    const LimitJet jet = limit_->surface().jet(limit_->place(at));
    const SurfaceFrame frame = frame_of(jet);
    // In the plane of the surface itself, and from there by the smallest turn.
    const glm::dvec3 sx = turned_from_to(n, frame.normal, x), sy = glm::cross(frame.normal, sx);
    const auto change = [&](const glm::dvec3& along) {
        const glm::dvec2 uv = in_chart(jet, along);
        return uv.x * frame.normal_u + uv.y * frame.normal_v;
    };
    const glm::dvec3 by_x = change(sx), by_y = change(sy);
    return lesser_direction(glm::dot(by_x, sx), (glm::dot(by_x, sy) + glm::dot(by_y, sx)) / 2,
                            glm::dot(by_y, sy), x, y, flat);
}

} // namespace trivar
