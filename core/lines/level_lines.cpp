// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/level_lines.h"

#include "core/base/parallel.h"
#include "core/field/blur.h"

#include <cmath>

namespace trivar {
namespace {

constexpr int settling_steps = 3;
// Third derivatives of a cubic are steps, so that second ones are compared over this, in voxels.
constexpr float ridge_step = 1.5f;
constexpr float longest_settling = 0.5f; // voxels; further off the field is no help

// The angles of a space, with a unit that is the mean side of a voxel.
glm::dmat3 in_mean_voxels(const glm::dmat4& to_space)
{
    const glm::dmat3 own(to_space);
    return own / std::cbrt(std::max(1e-300, std::abs(glm::determinant(own))));
}

// LevelPlaces tells how the levels of a field lie at places of a space with its own angles.
class LevelPlaces {
public:
    LevelPlaces(const ScalarField<float>& field, LevelSide side, const glm::dmat3& metric)
        : field_(field),
          outward_(side == LevelSide::above ? -1.0f : 1.0f),
          back_(glm::inverse(metric)),
          of_gradients_(glm::transpose(back_))
    {
    }
    LocalShape at_voxels(const glm::vec3& p) const
    {
        const ScalarJet<float> jet = field_.at<2>(p);
        const glm::vec3 g = of_gradients_ * gradient_of(jet);
        const float length = glm::length(g);
        if (!(length > 0)) return {};
        const glm::mat3 b = outward_ / length * (of_gradients_ * hessian_of(jet) * back_);
        const glm::vec3 normal = outward_ / length * g;
        return {normal,
                in_tangent_plane({{b[0][0], b[1][1], b[2][2], b[0][1], b[0][2], b[1][2]}}, normal)};
    }
    LocalShape operator()(const glm::vec3& p) const { return at_voxels(back_ * p); }

private:
    const ScalarField<float>& field_;
    float outward_;
    glm::mat3 back_, of_gradients_;
};

SurfaceShape shape_of(const LevelPlaces& places, const LevelMesh& level, const glm::dmat3& metric)
{
    const glm::mat3 to_metric(metric);
    SurfaceShape out;
    out.corners = level.triangles();
    out.positions.resize(level.positions.size());
    out.normals.resize(level.positions.size());
    out.bends.resize(level.positions.size());
    parallel_blocks(out.positions.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            out.positions[i] = to_metric * level.positions[i];
            const LocalShape place = places.at_voxels(level.positions[i]);
            out.normals[i] = place.normal;
            out.bends[i] = place.bend;
        }
    });
    out.size = size_of(out.positions);
    return out;
}

// Takes lines back to voxels, and their points to the level itself, by Newton's method.
void settle(Silhouettes& lines, const glm::dmat4& to_voxels, const ScalarField<float>& field,
            float level)
{
    parallel_blocks(lines.points.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            SilhouettePoint& point = lines.points[i];
            const glm::vec3 start(to_voxels * glm::dvec4(glm::dvec3(point.p), 1));
            point.p = start;
            for (int k = 0; k < settling_steps; ++k) {
                const ScalarJet<float> jet = field.at<1>(point.p);
                const glm::vec3 g = gradient_of(jet);
                point.slope = glm::length(g);
                if (!(point.slope > 0)) break;
                point.p -= (jet.value - level) / (point.slope * point.slope) * g;
            }
            point.p = glm::clamp(point.p, glm::vec3(0), field.end());
            point.polished = glm::distance(point.p, start) <= longest_settling;
            if (!point.polished) point.p = start;
        }
    });
}

} // namespace

std::size_t LevelLines::bytes() const
{
    std::size_t out = shape.positions.size() * (2 * sizeof(glm::vec3) + sizeof(SurfaceBend)) +
                      shape.corners.size() * sizeof(std::uint32_t);
    for (const KindLines& each : fixed) out += each.lines.points.size() * sizeof(SilhouettePoint);
    return out;
}

ScalarField<float> smooth_field(const VoxelField& field, float smoothing)
{
    const VoxelGrid& grid = field.grid();
    const glm::dmat3 metric = in_mean_voxels(grid.to_metres);
    glm::ivec3 times; // (1 2 1)/4 has a variance of 1/2
    for (int k = 0; k < 3; ++k) {
        const double sigma = double{smoothing} / std::max(1e-9, glm::length(metric[k]));
        times[k] = field.blur() + static_cast<int>(std::lround(std::min(64.0, 2 * sigma * sigma)));
    }
    const auto of = [&](const auto& samples) {
        return ScalarField<float>(
            std::span<const float>(blurred(std::span(samples), grid.size, times)), grid.size);
    };
    return std::visit(of, grid.samples);
}

LevelLines level_lines(const VoxelField& field, const ScalarField<float>& smooth,
                       const LevelMesh& level, LevelSide side, const glm::dmat4& to_space,
                       const MoreLines& wanted)
{
    const glm::dmat3 metric = in_mean_voxels(to_space);
    const LevelPlaces places(smooth, side, metric);
    LevelLines out{glm::dmat4(metric), shape_of(places, level, metric), {}};
    out.shape.at = places;
    out.shape.step = ridge_step;
    out.fixed = fixed_lines(out.shape, wanted);
    out.shape.at = nullptr; // the smooth field is not kept
    for (KindLines& each : out.fixed)
        settle(each.lines, glm::inverse(out.from_voxels), field.field(), level.level);
    return out;
}

std::vector<KindLines> lines_seen(const LevelLines& lines, const MoreLines& wanted,
                                  const ViewPoint& view, const ScalarField<float>& field,
                                  float level)
{
    std::vector<KindLines> out;
    if (wanted.suggestive) {
        out.push_back({LineKind::suggestive,
                       suggestive_lines(lines.shape, {lines.from_voxels * view.at}, wanted)});
        settle(out[0].lines, glm::inverse(lines.from_voxels), field, level);
    }
    out.insert(out.end(), lines.fixed.begin(), lines.fixed.end());
    return out;
}

} // namespace trivar
