// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/letter.h"

#include "core/text/letter_front.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace trivar {
namespace {

auto index(int i)
{
    return static_cast<std::size_t>(i);
}

glm::dvec2 em_of(const glm::ivec2& p)
{
    return glm::dvec2(p) / double(em_units);
}

// A Body is assembled from the front, the same shape at the back, and the sides. Its points are
// numbered in this order: front, back, inner rows of the sides.
class Body {
public:
    Body(const LetterFront& front, const std::vector<BevelRing>& rings, const Extrusion& extrusion)
        : front_(front),
          rings_(rings),
          extrusion_(extrusion),
          bevel_(bevel_of(extrusion))
    {
        mesh_.uvs.resize(1);
        next_point_ = static_cast<std::uint32_t>(2 * front.points.size());
    }

    Mesh made()
    {
        for (const bool behind : {false, true}) add_face_side(behind);
        for (std::size_t loop = 0; loop < front_.rim.size(); ++loop) add_sides(loop);
        number_points();
        return std::move(mesh_);
    }

private:
    double height(int point) const { return rings_[index(front_.ring_of[index(point)])].height; }

    std::uint32_t add_vertex(const glm::dvec3& p, const glm::dvec3& normal, const glm::dvec2& uv,
                             std::uint32_t point)
    {
        mesh_.positions.push_back(glm::vec3(p) + 0.0f); // no negative zeros
        mesh_.normals.push_back(glm::vec3(normal) + 0.0f);
        mesh_.uvs[0].push_back(glm::vec2(uv) + 0.0f);
        mesh_.points.push_back(point);
        return static_cast<std::uint32_t>(mesh_.vertex_count()) - 1;
    }

    // Computes the normals of a triangle: straight up if it is flat; on a bevel the normal of the
    // ring on this side of a corner, tilted by the profile of the bevel.
    std::array<glm::dvec3, 3> normals_of(const Triangulation::Corners& v) const
    {
        std::array<glm::dvec3, 3> p{}, normals{};
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = {em_of(front_.points[index(v[i])]), height(v[i])};
        normals.fill({0, 0, 1});
        if (p[0].z == p[1].z && p[1].z == p[2].z) return normals;
        const glm::dvec2 level(glm::cross(p[1] - p[0], p[2] - p[0]));
        const glm::dvec2 down = glm::normalize(level);
        for (std::size_t i = 0; i < 3; ++i) {
            glm::dvec2 best = down;
            double nearest = -2;
            for (const EdgeNormals& at : front_.at[index(v[i])])
                for (const glm::dvec2& each : {at.before, at.behind})
                    if (const double near = glm::dot(each, down); near > nearest) {
                        nearest = near;
                        best = each;
                    }
            const double slope = rings_[index(front_.ring_of[index(v[i])])].slope;
            normals[i] = {best * std::cos(slope), std::sin(slope)};
        }
        return normals;
    }

    void add_face_side(bool behind)
    {
        std::map<std::tuple<int, double, double, double>, std::uint32_t> known;
        const double low = extrusion_.depth - bevel_;
        for (const Triangulation::Corners& v : front_.triangles) {
            const std::array<glm::dvec3, 3> normals = normals_of(v);
            std::array<std::uint32_t, 3> own{};
            for (std::size_t i = 0; i < 3; ++i) {
                glm::dvec3 n = normals[i];
                const auto [entry, fresh] = known.try_emplace({v[i], n.x, n.y, n.z});
                if (fresh) {
                    const glm::dvec2 p = em_of(front_.points[index(v[i])]);
                    const double z = low + height(v[i]);
                    const auto point = static_cast<std::uint32_t>(
                        index(v[i]) + (behind ? front_.points.size() : 0));
                    if (behind) n.z = -n.z;
                    entry->second = add_vertex({p, behind ? extrusion_.depth - z : z}, n,
                                               {behind ? -p.x : p.x, p.y}, point);
                }
                own[i] = entry->second;
            }
            if (behind) std::swap(own[1], own[2]);
            add_face(mesh_, own);
        }
    }

    // Adds a column of vertices down the side at a corner of the rim, one for each of `points`.
    std::vector<std::uint32_t> column(const glm::dvec2& p, const glm::dvec2& normal, double along,
                                      const std::vector<std::uint32_t>& points)
    {
        std::vector<std::uint32_t> own;
        const double high = extrusion_.depth - bevel_;
        for (std::size_t row = 0; row < points.size(); ++row) {
            const double part = double(row) / static_cast<double>(points.size() - 1);
            // Both ends have the same bits as the front and the back.
            const double z =
                row + 1 == points.size() ? extrusion_.depth - high : high + (bevel_ - high) * part;
            own.push_back(add_vertex({p, z}, {normal, 0}, {along, z}, points[row]));
        }
        return own;
    }

    void add_sides(std::size_t loop)
    {
        const std::vector<int>& rim = front_.rim[loop];
        const std::size_t n = rim.size();
        const std::vector<EdgeNormals> normals = edge_normals(rings_[0].region[loop]);
        const double wall = extrusion_.depth - 2 * bevel_;
        const int rows = std::max(1, static_cast<int>(std::ceil(wall / extrusion_.max_edge)));
        std::vector<std::vector<std::uint32_t>> points(n);
        for (std::size_t i = 0; i < n; ++i) {
            points[i].push_back(static_cast<std::uint32_t>(rim[i]));
            for (int row = 1; row < rows; ++row) points[i].push_back(next_point_++);
            points[i].push_back(static_cast<std::uint32_t>(index(rim[i]) + front_.points.size()));
        }
        double along = 0;
        const auto place = [&](std::size_t i) { return em_of(front_.points[index(rim[i % n])]); };
        std::vector<std::uint32_t> left = column(place(0), normals[0].behind, 0, points[0]);
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t j = (i + 1) % n;
            along += glm::distance(place(i), place(j));
            const std::vector<std::uint32_t> right =
                column(place(j), normals[j].before, along, points[j]);
            for (std::size_t row = 0; row + 1 < right.size(); ++row)
                add_face(mesh_, std::array{left[row + 1], right[row + 1], right[row], left[row]});
            if (i + 1 == n) break;
            left = normals[j].before == normals[j].behind
                       ? right
                       : column(place(j), normals[j].behind, along, points[j]);
        }
    }

    // Numbers the points from 0 in the order of first appearance.
    void number_points()
    {
        std::map<std::uint32_t, std::uint32_t> number;
        for (std::uint32_t& point : mesh_.points)
            point =
                number.try_emplace(point, static_cast<std::uint32_t>(number.size())).first->second;
    }

    const LetterFront& front_;
    const std::vector<BevelRing>& rings_;
    const Extrusion& extrusion_;
    double bevel_;
    Mesh mesh_;
    std::uint32_t next_point_ = 0;
};

} // namespace

std::optional<Mesh> letter_body(const Region& region, const Extrusion& extrusion)
{
    // Tries growing insets of up to some thousandths of a percent of an em. They separate a shape
    // where it touches itself, or nearly does, in a point.
    for (const double units : {0, 6, 12, 24, 60}) {
        const Region apart = units > 0 ? inset(region, units) : region;
        if (apart.empty()) return std::nullopt;
        const std::vector<BevelRing> rings = bevel_rings(apart, extrusion);
        if (const auto front = letter_front(rings, extrusion.max_edge))
            return Body(*front, rings, extrusion).made();
    }
    return std::nullopt;
}

} // namespace trivar
