// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/curved_tears.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

// Faces of the border that differ by less are one plane.
constexpr double one_plane = 1e-3;

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

} // namespace

CurvedTears::CurvedTears(const SimplexDomain<3>& domain, const std::vector<bool>& inside)
    : domain_(domain)
{
    normals_.assign(domain.vertex_count(), glm::dvec3(0));
    std::vector<std::vector<glm::dvec3>> borders(normals_.size()); // planes at each vertex
    const std::vector<CellFace<3>> faces = sorted_faces(domain);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const CellFace<3>& a = faces[i];
        if (i + 1 == faces.size() || a.vertices != faces[i + 1].vertices) {
            const glm::dvec3 out = outward(domain, a);
            for (const int v : a.vertices) {
                auto& planes = borders[at(v)];
                if (std::none_of(planes.begin(), planes.end(), [&](const glm::dvec3& p) {
                        return glm::length(p - out) < one_plane;
                    }))
                    planes.push_back(out);
            }
            continue;
        }
        const CellFace<3>& b = faces[++i];
        if (inside[a.cell] == inside[b.cell]) continue;
        const glm::dvec3 out = outward(domain, inside[a.cell] ? a : b);
        const auto& v = a.vertices;
        faces_.insert(v);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 p = domain.vertex(v[k]),
                             q = glm::normalize(domain.vertex(v[(k + 1) % 3]) - p),
                             r = glm::normalize(domain.vertex(v[(k + 2) % 3]) - p);
            normals_[at(v[k])] += out * std::acos(std::clamp(glm::dot(q, r), -1.0, 1.0));
        }
        edges_.insert({v[0], v[1]});
        edges_.insert({v[0], v[2]});
        edges_.insert({v[1], v[2]});
    }
    for (std::size_t v = 0; v < normals_.size(); ++v) {
        glm::dvec3& n = normals_[v];
        if (borders[v].size() == 1) n -= borders[v][0] * glm::dot(borders[v][0], n);
        if (const double length = glm::length(n); length > 0) n /= length;
    }
    keep_volume();
}

// The mean of a cubic triangle is that of its ten control points.
void CurvedTears::keep_volume()
{
    for (std::size_t v = 0; v < normals_.size(); ++v)
        corners_.push_back(domain_.vertex(static_cast<int>(v)));
    std::vector<double> bulge(normals_.size(), 0), area(normals_.size(), 0);
    for (const auto& face : faces_) {
        glm::dvec3 corners(0), edges(0);
        for (std::size_t k = 0; k < 3; ++k) {
            const int p = face[k], q = face[(k + 1) % 3];
            corners += corners_[at(p)] / 3.0;
            edges += (towards(p, q) + towards(q, p)) / 6.0;
        }
        const glm::dvec3 offset = 0.75 * (edges - corners);
        const double weight =
            glm::length(glm::cross(corners_[at(face[1])] - corners_[at(face[0])],
                                   corners_[at(face[2])] - corners_[at(face[0])]));
        for (const int v : face) {
            bulge[at(v)] += weight * glm::dot(offset, normal(v));
            area[at(v)] += weight;
        }
    }
    for (std::size_t v = 0; v < normals_.size(); ++v)
        if (area[v] > 0) corners_[v] -= normals_[v] * (bulge[v] / area[v]);
}

glm::dvec3 CurvedTears::towards(int from, int to) const
{
    const glm::dvec3 p = corners_[at(from)], q = corners_[at(to)];
    return (2.0 * p + q - glm::dot(q - p, normal(from)) * normal(from)) / 3.0;
}

glm::dvec3 CurvedTears::on_edge(int a, int b, double t) const
{
    const double s = 1 - t;
    return corners_[at(a)] * (s * s * s) + towards(a, b) * (3 * s * s * t) +
           towards(b, a) * (3 * s * t * t) + corners_[at(b)] * (t * t * t);
}

glm::dvec3 CurvedTears::rounded(const std::array<int, 3>& v, const glm::dvec3& w) const
{
    glm::dvec3 flat(0);
    for (int k = 0; k < 3; ++k)
        if (v[at(k)] >= 0) flat += domain_.vertex(v[at(k)]) * w[k];
    if (v[1] < 0) return corners_[at(v[0])];
    if (v[2] < 0) return edges_.contains({v[0], v[1]}) ? on_edge(v[0], v[1], w[1]) : flat;
    if (!faces_.contains(v)) return flat;
    glm::dvec3 out(0), edges(0), corners(0);
    for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, p = v[at(k)], q = v[at(l)];
        const glm::dvec3 near = towards(p, q), far = towards(q, p);
        out += corners_[at(p)] * (w[k] * w[k] * w[k]) + near * (3 * w[k] * w[k] * w[l]) +
               far * (3 * w[k] * w[l] * w[l]);
        edges += (near + far) / 6.0;
        corners += corners_[at(p)] / 3.0;
    }
    return out + (edges + (edges - corners) / 2.0) * (6 * w[0] * w[1] * w[2]);
}

} // namespace trivar
