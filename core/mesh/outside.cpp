// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/outside.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace trivar {
namespace {

constexpr int most_pixels = 512; // along the diagonal

// The faces and the corners of a cube.
std::vector<glm::dvec3> directions()
{
    std::vector<glm::dvec3> out;
    for (const double sign : {-1.0, 1.0})
        for (int axis = 0; axis < 3; ++axis) {
            out.emplace_back(0);
            out.back()[axis] = sign;
        }
    for (const glm::dvec3& corner : Box{glm::dvec3(-1), glm::dvec3(1)}.corners())
        out.push_back(glm::normalize(corner));
    return out;
}

// A Picture shows which triangle is in front at each pixel, along one direction.
class Picture {
public:
    Picture(const Box& box, const glm::dvec3& toward_eye, int pixels)
        : pixels_(pixels),
          middle_(box.center()),
          pixels_each_(pixels / glm::length(box.size())),
          toward_eye_(toward_eye),
          right_(glm::normalize(
              glm::cross(std::abs(toward_eye.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0),
                         toward_eye))),
          up_(glm::cross(toward_eye, right_)),
          depth_(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels), -1e300),
          shown_(depth_.size(), nothing)
    {
    }

    void draw(const std::array<glm::dvec3, 3>& corners, std::uint32_t triangle)
    {
        std::array<glm::dvec3, 3> p; // in pixels; z toward the eye
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 at = (corners[k] - middle_) * pixels_each_;
            p[k] = {glm::dot(at, right_) + pixels_ / 2.0, glm::dot(at, up_) + pixels_ / 2.0,
                    glm::dot(at, toward_eye_)};
        }
        const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
        if (!(std::abs(normal.z) > 0)) return;
        const double by_x = -normal.x / normal.z, by_y = -normal.y / normal.z; // of the depth
        const auto [low, high] = std::minmax({p[0].y, p[1].y, p[2].y});
        const auto [deep, near] = std::minmax({p[0].z, p[1].z, p[2].z});
        for (int y = first(low); y <= last(high); ++y) {
            double from = 1e300,
                   to = -1e300; // where the line through the middles of pixels is in it
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec3 &a = p[k], &b = p[(k + 1) % 3];
                const double share = (y + 0.5 - a.y) / (b.y - a.y);
                if (!(share >= 0 && share <= 1)) continue; // also of a level side
                const double x = a.x + share * (b.x - a.x);
                from = std::min(from, x), to = std::max(to, x);
            }
            const double depth = p[0].z + by_x * (0.5 - p[0].x) + by_y * (y + 0.5 - p[0].y);
            for (int x = first(from); x <= last(to); ++x)
                show(x, y, std::clamp(depth + by_x * x, deep, near), triangle, normal.z > 0);
        }
    }

    // Calls use(triangle, whether its front is seen) for every pixel that shows one.
    template <class Use> void each(Use use) const
    {
        for (const std::uint64_t shown : shown_)
            if (shown != nothing) use(static_cast<std::uint32_t>(shown >> 1), (shown & 1) != 0);
    }

private:
    static constexpr std::uint64_t nothing = ~std::uint64_t{0};
    static constexpr double slack = 1e-7; // pixels: no gap between neighbours by rounding

    // The first and the last pixel whose middle is in a range.
    int first(double from) const
    {
        return static_cast<int>(std::ceil(std::clamp(from - 0.5 - slack, 0.0, 1.0 * pixels_)));
    }
    int last(double to) const
    {
        return static_cast<int>(std::floor(std::clamp(to - 0.5 + slack, -1.0, pixels_ - 1.0)));
    }

    void show(int x, int y, double depth, std::uint32_t triangle, bool front)
    {
        constexpr double same = 1e-6; // pixels
        const auto at = static_cast<std::size_t>(y * pixels_ + x);
        const bool tied = std::abs(depth - depth_[at]) <= same;
        if (tied ? !front || (shown_[at] & 1) != 0 : depth < depth_[at]) return;
        depth_[at] = depth;
        shown_[at] = std::uint64_t{triangle} << 1 | (front ? 1 : 0);
    }

    int pixels_;
    glm::dvec3 middle_;
    double pixels_each_; // in the unit of the mesh
    glm::dvec3 toward_eye_, right_, up_;
    std::vector<double> depth_;        // toward the eye, in pixels
    std::vector<std::uint64_t> shown_; // twice the triangle, + 1: its front
};

// Fewer pixels where so many large triangles lie over each other that they would take long.
int pixels_for(const Mesh& mesh, const std::vector<glm::uvec3>& all, const Box& box)
{
    constexpr double most_drawn = 3e7; // in a picture
    double area = 0;
    for (const glm::uvec3& t : all) {
        const glm::dvec3 p(mesh.positions[t.x]);
        area += glm::length(
            glm::cross(glm::dvec3(mesh.positions[t.y]) - p, glm::dvec3(mesh.positions[t.z]) - p));
    }
    const double drawn = area / glm::dot(box.size(), box.size()); // by the square of the pixels
    return static_cast<int>(std::clamp(std::sqrt(most_drawn / drawn), 16.0, 1.0 * most_pixels));
}

} // namespace

std::vector<SeenSides> seen_from_outside(const Mesh& mesh,
                                         const std::vector<std::uint32_t>& part_of,
                                         std::size_t parts, const Box& box)
{
    std::vector<SeenSides> out(parts);
    if (!(glm::length(box.size()) > 0)) return out;
    const std::vector<glm::uvec3> all = triangles(mesh);
    std::vector<std::uint32_t> face;
    face.reserve(all.size());
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
        face.insert(face.end(), mesh.face_begin[f + 1] - mesh.face_begin[f] - 2, f);
    const std::vector<glm::dvec3> ways = directions();
    const int pixels = pixels_for(mesh, all, box);
    std::mutex adding; // whole numbers have one sum, in any order
    parallel_blocks(ways.size(), 1, [&](std::size_t way, std::size_t) {
        Picture picture(box, ways[way], pixels);
        for (std::uint32_t t = 0; t < all.size(); ++t)
            picture.draw(
                {mesh.positions[all[t].x], mesh.positions[all[t].y], mesh.positions[all[t].z]}, t);
        const std::lock_guard lock(adding);
        picture.each([&](std::uint32_t t, bool front) {
            SeenSides& sides = out[part_of[face[t]]];
            ++(front ? sides.front : sides.back);
        });
    });
    return out;
}

} // namespace trivar
