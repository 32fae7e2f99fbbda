// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limit/facet_surface.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/base/unit.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace trivar {
namespace {

glm::dvec3 bilinear(const ChartNet::Chart& chart, const std::vector<glm::dvec3>& values,
                    const glm::dvec2& uv)
{
    const auto& p = chart.points;
    return (1 - uv.y) * ((1 - uv.x) * values[p[0]] + uv.x * values[p[1]]) +
           uv.y * ((1 - uv.x) * values[p[3]] + uv.x * values[p[2]]);
}

// Four points a face: a triangle has that at which most triangles meet twice.
std::vector<int> with_poles(const Cage& cage)
{
    std::vector<int> triangles_round(cage.points.size(), 0);
    const auto each_face = [&](auto&& found) {
        std::size_t first = 0;
        for (const int size : cage.face_sizes) {
            found(std::span(cage.corners).subspan(first, static_cast<std::size_t>(size)));
            first += static_cast<std::size_t>(size);
        }
    };
    each_face([&](std::span<const int> face) {
        if (face.size() == 3)
            for (const int p : face) ++triangles_round[static_cast<std::size_t>(p)];
    });
    std::vector<int> out;
    each_face([&](std::span<const int> face) {
        if (face.size() == 4) {
            out.insert(out.end(), face.begin(), face.end());
            return;
        }
        std::size_t pole = 0;
        const auto round = [&](std::size_t k) {
            return triangles_round[static_cast<std::size_t>(face[k])];
        };
        for (std::size_t k = 1; k < 3; ++k)
            if (round(k) > round(pole)) pole = k;
        out.insert(out.end(), {face[(pole + 1) % 3], face[(pole + 2) % 3], face[pole], face[pole]});
    });
    return out;
}

} // namespace

FacetSurface::FacetSurface(const Cage& cage)
{
    const bool quads = std::ranges::all_of(cage.face_sizes, [](int n) { return n <= 4; });
    const std::size_t charts = quads ? cage.face_sizes.size() : cage.corners.size();
    if (charts > most_facets)
        throw Rejected(fmt::format("a surface of {} faces is too large to be covered; at most {} "
                                   "are possible",
                                   with_commas(charts), with_commas(most_facets)));
    if (quads)
        net_ = std::make_shared<const ChartNet>(with_poles(cage), std::span<const int>{});
    else {
        std::vector<int> corners;
        std::map<std::pair<int, int>, int> middles;
        const auto mean = [&](std::initializer_list<int> of) {
            means_.push_back({static_cast<std::uint32_t>(members_.size()),
                              static_cast<std::uint32_t>(of.size())});
            for (const int p : of) members_.push_back(static_cast<std::uint32_t>(p));
            return static_cast<int>(cage.points.size() + means_.size()) - 1;
        };
        const auto middle = [&](int a, int b) {
            const auto [found, fresh] = middles.try_emplace(std::minmax(a, b), 0);
            if (fresh) found->second = mean({std::min(a, b), std::max(a, b)});
            return found->second;
        };
        std::size_t first = 0;
        for (const int size : cage.face_sizes) {
            const auto n = static_cast<std::size_t>(size);
            const auto at = [&](std::size_t k) { return cage.corners[first + k % n]; };
            const int center = mean({});
            means_.back().count = static_cast<std::uint32_t>(n);
            for (std::size_t k = 0; k < n; ++k)
                members_.push_back(static_cast<std::uint32_t>(at(k)));
            for (std::size_t k = 0; k < n; ++k)
                corners.insert(corners.end(), {at(k), middle(at(k), at(k + 1)), center,
                                               middle(at(k + n - 1), at(k))});
            first += n;
        }
        net_ = std::make_shared<const ChartNet>(corners, std::span<const int>{});
    }
    place(cage.points);
}

FacetSurface FacetSurface::moved(std::span<const glm::dvec3> points) const
{
    FacetSurface out = *this;
    out.place(points);
    return out;
}

void FacetSurface::place(std::span<const glm::dvec3> points)
{
    points_.assign(points.begin(), points.end());
    for (const Mean& mean : means_) {
        glm::dvec3 sum(0);
        for (std::uint32_t k = 0; k < mean.count; ++k) sum += points[members_[mean.first + k]];
        points_.push_back(sum / static_cast<double>(mean.count));
    }
    normals_.assign(points_.size(), glm::dvec3(0));
    for (std::uint32_t c = 0; c < net_->size(); ++c) {
        const auto at = [&](int k) { return points_[net_->point(c, k)]; };
        const auto is_pole = [&](int k) { return net_->point(c, k) == net_->point(c, k + 1); };
        for (int k = 0; k < 4; ++k) { // weighted by angle
            if (is_pole(k)) continue; // the corner after it counts for both
            const glm::dvec3 a = at(k + 1) - at(k), b = at(is_pole(k + 3) ? k + 2 : k + 3) - at(k),
                             n = glm::cross(a, b);
            const double length = glm::length(n);
            if (length > 0)
                normals_[net_->point(c, k)] += std::atan2(length, glm::dot(a, b)) / length * n;
        }
    }
    for (glm::dvec3& n : normals_) n = unit_or(n, {0, 0, 1});
}

glm::dvec3 FacetSurface::position(const ChartPlace& at) const
{
    return bilinear(net_->chart(at.chart), points_, at.uv);
}

glm::dvec3 FacetSurface::normal(const ChartPlace& at) const
{
    return unit_or(bilinear(net_->chart(at.chart), normals_, at.uv), {0, 0, 1});
}

} // namespace trivar
