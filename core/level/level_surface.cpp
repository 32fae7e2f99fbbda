// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/level/level_surface.h"

#include "core/base/key_numbers.h"
#include "core/base/parallel.h"
#include "core/level/level_bricks.h"

namespace trivar {
namespace {

// A SurfaceBuilder turns a level outward and closes it in the faces of its grid.
class SurfaceBuilder {
public:
    SurfaceBuilder(const LevelMesh& level, const LatticeSigns& signs, LevelSide side,
                   const glm::dmat4& to_space)
        : level_(level),
          signs_(signs),
          bricks_(level_bricks(signs)),
          above_(side == LevelSide::above),
          mirrors_(glm::determinant(glm::dmat3(to_space)) < 0),
          to_space_(to_space),
          normals_to_space_(glm::transpose(glm::inverse(glm::dmat3(to_space))))
    {
    }
    Mesh operator()()
    {
        add_level();
        for (int axis = 0; axis < 3; ++axis)
            for (const bool last : {false, true}) close(axis, last);
        mesh_.face_begin.resize(mesh_.corners.size() / 3 + 1);
        for (std::size_t f = 0; f < mesh_.face_begin.size(); ++f)
            mesh_.face_begin[f] = static_cast<std::uint32_t>(3 * f);
        return std::move(mesh_);
    }

private:
    // A CapCorner is a corner of the part of a face's triangle that is in the body: a sample, or
    // the point at which the level crosses the edge between two of them.
    struct CapCorner {
        glm::ivec3 sample;
        int direction; // 0: the sample itself
    };

    glm::vec3 in_space(const glm::vec3& p) const
    {
        return glm::vec3(to_space_ * glm::dvec4(glm::dvec3(p), 1));
    }
    glm::vec3 normal_in_space(const glm::dvec3& n) const
    {
        const glm::dvec3 out = normals_to_space_ * n;
        const double length = glm::length(out);
        return length > 0 ? glm::vec3(out / length) : glm::vec3(0, 0, 1);
    }
    void add_level()
    {
        const std::size_t vertices = level_.positions.size();
        mesh_.positions.resize(vertices);
        mesh_.normals.resize(vertices);
        mesh_.points.resize(vertices);
        parallel_blocks(vertices, 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                mesh_.positions[v] = in_space(level_.positions[v]);
                const glm::dvec3 n(level_.normal_x[v], level_.normal_y[v], level_.normal_z[v]);
                mesh_.normals[v] = normal_in_space(above_ ? -n : n);
                mesh_.points[v] = static_cast<std::uint32_t>(v);
            }
        });
        points_ = static_cast<std::uint32_t>(vertices);
        mesh_.corners = level_.triangles();
        if (above_ == mirrors_)
            for (std::size_t c = 0; c + 2 < mesh_.corners.size(); c += 3)
                std::swap(mesh_.corners[c + 1], mesh_.corners[c + 2]);
    }
    bool is_inside(const glm::ivec3& p) const
    {
        return bool{(signs_.row(p.y, p.z, p.x >> 3) >> (p.x & 7) & 1) != 0} == above_;
    }
    // The vertex of a face for one of its corners.
    std::uint32_t vertex(const CapCorner& corner, const glm::vec3& normal)
    {
        const auto part = [&](int k) { return static_cast<std::uint64_t>(corner.sample[k]); };
        const std::uint64_t key = (part(2) << 40 | part(1) << 20 | part(0)) << 3 |
                                  static_cast<std::uint64_t>(corner.direction);
        const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
        const auto [number, is_new] = of_face_.insert(key, next);
        if (!is_new) return number;
        if (corner.direction == 0) {
            const auto [point, is_new_point] = point_of_sample_.insert(key, points_);
            points_ += is_new_point;
            mesh_.points.push_back(point);
            mesh_.positions.push_back(in_space(glm::vec3(corner.sample)));
        } else {
            const std::uint32_t of_level =
                bricks_.at(corner.sample >> 3)->vertex(corner.sample & 7, corner.direction);
            mesh_.points.push_back(of_level);
            mesh_.positions.push_back(mesh_.positions[of_level]);
        }
        mesh_.normals.push_back(normal);
        return number;
    }
    // The corners of a triangle's part in the body, in the triangle's order.
    std::size_t part_of(const std::array<glm::ivec3, 3>& corners, std::array<CapCorner, 4>& out)
    {
        std::size_t count = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::ivec3 &a = corners[i], &b = corners[(i + 1) % 3];
            if (is_inside(a)) out[count++] = {a, 0};
            if (is_inside(a) == is_inside(b)) continue;
            const glm::ivec3 lower = glm::min(a, b), step = glm::max(a, b) - lower;
            out[count++] = {lower, step.x | step.y << 1 | step.z << 2};
        }
        return count;
    }
    // The squares of a face are cut along the diagonal from their least corner, as the cells are.
    void close(int axis, bool last)
    {
        of_face_ = {};
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        glm::dvec3 outward(0);
        outward[axis] = last ? 1 : -1;
        const glm::vec3 normal = normal_in_space(outward);
        const bool turns = last == mirrors_;
        glm::ivec3 at(0);
        at[axis] = last ? signs_.size()[axis] - 1 : 0;
        glm::ivec3 along(0), up(0);
        along[u] = 1;
        up[v] = 1;
        for (at[v] = 0; at[v] + 1 < signs_.size()[v]; ++at[v])
            for (at[u] = 0; at[u] + 1 < signs_.size()[u]; ++at[u]) {
                const std::array<std::array<glm::ivec3, 3>, 2> halves{
                    {{at, at + along, at + along + up}, {at, at + along + up, at + up}}};
                for (const std::array<glm::ivec3, 3>& half : halves) add_part(half, turns, normal);
            }
    }
    void add_part(const std::array<glm::ivec3, 3>& corners, bool turns, const glm::vec3& normal)
    {
        std::array<CapCorner, 4> part;
        const std::size_t count = part_of(corners, part);
        for (std::size_t i = 2; i < count; ++i) {
            std::array<std::uint32_t, 3> triangle{
                vertex(part[0], normal), vertex(part[i - 1], normal), vertex(part[i], normal)};
            if (turns) std::swap(triangle[1], triangle[2]);
            mesh_.corners.insert(mesh_.corners.end(), triangle.begin(), triangle.end());
        }
    }

    const LevelMesh& level_;
    const LatticeSigns& signs_;
    LevelBricks bricks_;
    bool above_, mirrors_;
    glm::dmat4 to_space_;
    glm::dmat3 normals_to_space_;
    Mesh mesh_;
    std::uint32_t points_ = 0;
    KeyNumbers of_face_, point_of_sample_; // vertices of the present face, and points of samples
};

} // namespace

template <class Sample>
Mesh level_surface(const LevelMesh& level, std::span<const Sample> samples, const glm::ivec3& size,
                   LevelSide side, const glm::dmat4& to_space)
{
    const LatticeSigns signs(samples, size, level.level);
    return SurfaceBuilder(level, signs, side, to_space)();
}

#define TRIVAR_SURFACE_OF(Sample)                                                             \
    template Mesh level_surface(const LevelMesh&, std::span<const Sample>, const glm::ivec3&, \
                                LevelSide, const glm::dmat4&);
TRIVAR_SURFACE_OF(std::uint8_t)
TRIVAR_SURFACE_OF(std::int8_t)
TRIVAR_SURFACE_OF(std::uint16_t)
TRIVAR_SURFACE_OF(std::int16_t)
TRIVAR_SURFACE_OF(float)
#undef TRIVAR_SURFACE_OF

} // namespace trivar
