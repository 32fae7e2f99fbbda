// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace make {

namespace {

float smallest_angle_deg(const std::array<vec3, 3>& p)
{
    float smallest = 180;
    for (std::size_t i = 0; i < 3; ++i) {
        const vec3 a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
        const float cosine = glm::dot(a, b) / std::max(1e-20f, glm::length(a) * glm::length(b));
        smallest = std::min(smallest, glm::degrees(std::acos(glm::clamp(cosine, -1.f, 1.f))));
    }
    return smallest;
}

std::vector<std::array<vec3, 3>> triangles(const Mesh& mesh, const Face& q)
{
    const auto at = [&](std::size_t k) { return mesh.points[std::size_t(q[k])]; };
    if (q[3] < 0) return {{at(0), at(1), at(2)}};
    if (glm::distance(at(1), at(3)) < glm::distance(at(0), at(2))) {
        return {{at(0), at(1), at(3)}, {at(1), at(2), at(3)}};
    }
    return {{at(0), at(1), at(2)}, {at(0), at(2), at(3)}};
}

void count_edges(const Mesh& mesh, Report& report)
{
    std::map<std::pair<int, int>, int> uses;
    std::vector<int> parent(mesh.points.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto find = [&](int a) {
        while (parent[std::size_t(a)] != a) {
            parent[std::size_t(a)] = parent[std::size_t(parent[std::size_t(a)])];
            a = parent[std::size_t(a)];
        }
        return a;
    };
    for (const Face& q : mesh.faces) {
        for (std::size_t i = 0; i < corner_count(q); ++i) {
            const int a = q[i], b = q[(i + 1) % corner_count(q)];
            ++uses[{a, b}];
            parent[std::size_t(find(a))] = find(b);
        }
    }
    for (const auto& [edge, count] : uses) {
        report.nonmanifold += count > 1;
        report.open += !uses.contains({edge.second, edge.first});
    }
    for (std::size_t i = 0; i < parent.size(); ++i) report.pieces += find(int(i)) == int(i);
}

} // namespace

Report check(const Model& model)
{
    Report report;
    const std::vector<mat4> world = world_matrices(model);
    int triangle_count = 0, thin = 0;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        for (const Mesh& part : model.nodes[n].parts) {
            report.vertices += int(part.points.size());
            report.faces += int(part.faces.size());
            count_edges(part, report);
            for (const Face& q : part.faces) {
                report.quads += corner_count(q) == 4;
                for (const auto& t : triangles(part, q)) {
                    const float angle = smallest_angle_deg(t);
                    report.worst_angle_deg = std::min(report.worst_angle_deg, angle);
                    report.volume += glm::dot(t[0], glm::cross(t[1], t[2])) / 6;
                    thin += angle < 20;
                    ++triangle_count;
                }
            }
            for (const vec3& p : part.points) {
                const vec3 q(world[n] * vec4(p, 1));
                report.lo = glm::min(report.lo, q);
                report.hi = glm::max(report.hi, q);
            }
        }
    }
    report.under_20_deg = 100.f * float(thin) / float(std::max(1, triangle_count));
    return report;
}

} // namespace make
