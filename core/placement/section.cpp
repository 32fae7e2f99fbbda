// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/section.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace trivar {
namespace {

constexpr double whole_turn = glm::two_pi<double>();
constexpr int angles_round = 2880;   // at which the length is measured
constexpr int planes_to_a_side = 24; // beside the way

double turn_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Returns the convex hull, counter-clockwise, without points on its edges. Andrew 1979.
std::vector<glm::dvec2> convex_hull(std::vector<glm::dvec2> points)
{
    std::ranges::sort(points, [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x != b.x ? a.x < b.x : a.y < b.y;
    });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return {};
    std::vector<glm::dvec2> hull;
    for (int half = 0; half < 2; ++half) {
        const std::size_t begun = hull.size();
        for (const glm::dvec2& p : points) {
            while (hull.size() >= begun + 2 && turn_of(hull.end()[-2], hull.back(), p) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back(); // the other half begins with it
        std::ranges::reverse(points);
    }
    return hull;
}

// Returns the area of the hull and its centroid.
std::pair<double, glm::dvec2> area_of(const std::vector<glm::dvec2>& hull)
{
    double sum = 0;
    glm::dvec2 moment(0);
    for (std::size_t i = 2; i < hull.size(); ++i) {
        const double twice = turn_of(hull[0], hull[i - 1], hull[i]);
        sum += twice;
        moment += twice * (hull[0] + hull[i - 1] + hull[i]) / 3.0;
    }
    return {sum / 2, sum > 0 ? moment / sum : glm::dvec2(0)};
}

} // namespace

double Section::Cut::radius(double angle) const
{
    const glm::dvec2 way(std::cos(angle), std::sin(angle));
    const glm::dvec2 left(-way.y, way.x);
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2 a = hull[i] - middle, b = hull[(i + 1) % hull.size()] - middle;
        const double right_of = glm::dot(a, left), left_of = glm::dot(b, left);
        if (right_of <= 0 && left_of > 0) { // the only such crossing, counter-clockwise
            const double share = right_of / (right_of - left_of);
            return glm::dot(a + (b - a) * share, way);
        }
    }
    return 0;
}

Section::Section(const std::vector<SectionBody>& bodies, const SectionPlane& plane)
    : bodies_(bodies),
      p_(plane.p),
      normal_(plane.normal)
{
    const auto in_plane = [&](const glm::dvec3& v) { return v - normal_ * glm::dot(v, normal_); };
    right_ = in_plane(plane.first);
    for (const glm::dvec3 other : {glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0)})
        if (!(glm::length(right_) > 1e-9)) right_ = in_plane(other);
    right_ = glm::normalize(right_);
    up_ = glm::cross(normal_, right_);
    cuts_ = cuts_at({0});
    if (cuts_.empty())
        throw Rejected("the plane does not cut what it goes round; choose another level");
    lengths_.push_back(0);
    glm::dvec3 before = place(cuts_[0], 0);
    for (int i = 1; i <= angles_round; ++i) {
        const glm::dvec3 now = place(cuts_[0], whole_turn * i / angles_round);
        lengths_.push_back(lengths_.back() + glm::distance(before, now));
        before = now;
    }
}

void Section::widen(double reach)
{
    std::vector<double> heights;
    for (int i = -planes_to_a_side; i <= planes_to_a_side; ++i)
        heights.push_back(reach * i / planes_to_a_side);
    std::vector<Cut> cuts = cuts_at(heights);
    // Only cuts connected with that of the way are kept.
    const auto own = std::ranges::find(cuts, 0.0, &Cut::height);
    const double pitch = 1.5 * reach / planes_to_a_side;
    auto first = own, last = own + 1;
    while (first != cuts.begin() && first->height - (first - 1)->height < pitch) --first;
    while (last != cuts.end() && last->height - (last - 1)->height < pitch) ++last;
    own_ = static_cast<std::size_t>(own - first);
    cuts_ = std::vector<Cut>(first, last);
}

// Returns the cuts at the given heights, without empty ones.
std::vector<Section::Cut> Section::cuts_at(const std::vector<double>& heights) const
{
    std::vector<std::vector<glm::dvec2>> met(heights.size());
    std::vector<glm::dvec3> places;
    for (const SectionBody& body : bodies_) {
        places.clear();
        for (const glm::vec3& p : body.mesh->positions) {
            const glm::dvec3 d = glm::dvec3(body.to_world * glm::dvec4(p, 1)) - p_;
            places.emplace_back(glm::dot(d, right_), glm::dot(d, up_), glm::dot(d, normal_));
        }
        const Mesh& mesh = *body.mesh;
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
                const bool last = c + 1 == mesh.face_begin[f + 1];
                glm::dvec3 a = places[mesh.corners[c]];
                glm::dvec3 b = places[mesh.corners[last ? mesh.face_begin[f] : c + 1]];
                if (a.z > b.z) std::swap(a, b);
                // These are the planes at or above the lower end and below the upper one.
                auto at = std::ranges::lower_bound(heights, a.z);
                for (; at != heights.end() && *at < b.z; ++at)
                    met[static_cast<std::size_t>(at - heights.begin())].push_back(
                        glm::dvec2(a) + glm::dvec2(b - a) * ((*at - a.z) / (b.z - a.z)));
            }
    }
    std::vector<Cut> cuts;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        Cut cut{convex_hull(std::move(met[i])), {}, heights[i]};
        const auto [area, middle] = area_of(cut.hull);
        cut.middle = middle;
        if (area > 0) cuts.push_back(std::move(cut));
    }
    return cuts;
}

glm::dvec3 Section::place(const Cut& cut, double angle) const
{
    const double r = cut.radius(angle);
    const glm::dvec2 at = cut.middle + r * glm::dvec2(std::cos(angle), std::sin(angle));
    return p_ + right_ * at.x + up_ * at.y + normal_ * cut.height;
}

Section::Column Section::column(double share) const
{
    const double length = (share - std::floor(share)) * lengths_.back();
    const auto next = std::ranges::upper_bound(lengths_, length);
    const auto i = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(next - lengths_.begin(), 1, angles_round));
    const double step = lengths_[i] - lengths_[i - 1];
    const double within = step > 0 ? (length - lengths_[i - 1]) / step : 0;
    const double angle = whole_turn * (static_cast<double>(i - 1) + within) / angles_round;
    Column out;
    for (const Cut& cut : cuts_) {
        const glm::dvec3 p = place(cut, angle);
        out.across.push_back(
            out.places.empty() ? 0 : out.across.back() + glm::distance(p, out.places.back()));
        out.places.push_back(p);
    }
    const double own = out.across[own_];
    for (double& across : out.across) across -= own;
    return out;
}

glm::dvec3 place_at(const Section::Column& column, double across)
{
    const double slack = 1e-9 * (column.across.back() - column.across.front());
    if (across < column.across.front() - slack || across > column.across.back() + slack)
        throw Rejected(
            "the model is wider than the object it goes round; reduce its width, or choose "
            "another level");
    const auto next = std::ranges::upper_bound(column.across, across);
    const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
        next - column.across.begin(), 1, static_cast<std::ptrdiff_t>(column.across.size()) - 1));
    const double step = column.across[i] - column.across[i - 1];
    const double share = step > 0 ? (across - column.across[i - 1]) / step : 0;
    return column.places[i - 1] + share * (column.places[i] - column.places[i - 1]);
}

} // namespace trivar
