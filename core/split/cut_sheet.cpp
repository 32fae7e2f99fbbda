// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/cut_sheet.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double least_q = 1e-3; // nothing is nearer to the eye than that share of its distance

// The slopes of a cubic through points: those of the parabola through a point and its neighbours.
std::vector<double> slopes_at(const std::vector<glm::dvec2>& points)
{
    const std::size_t last = points.size() - 1;
    std::vector<double> chords(last), out(last + 1);
    for (std::size_t i = 0; i < last; ++i)
        chords[i] = (points[i + 1].y - points[i].y) / (points[i + 1].x - points[i].x);
    for (std::size_t i = 1; i < last; ++i) {
        const double before = points[i].x - points[i - 1].x, after = points[i + 1].x - points[i].x;
        out[i] = (chords[i - 1] * after + chords[i] * before) / (before + after);
    }
    out.front() = last == 1 ? chords[0] : 2 * chords[0] - out[1];
    out.back() = last == 1 ? chords[0] : 2 * chords[last - 1] - out[last - 1];
    return out;
}

} // namespace

std::string stroke_trouble(const std::vector<glm::dvec2>& stroke)
{
    if (stroke.empty()) return {};
    if (stroke.size() == 1) return "the stroke of a cut needs at least two points";
    for (std::size_t i = 0; i + 1 < stroke.size(); ++i)
        if (!(stroke[i].x < stroke[i + 1].x))
            return "the stroke of a cut turns back; draw it so that it goes on from one end of its "
                   "chord to the other";
    return {};
}

CutSheet::CutSheet(const PlainCut& cut, const glm::dmat4& to_own) : eye_(cut.eye)
{
    const glm::dvec3 u = glm::normalize(cut.normal);
    glm::dvec3 v = cut.along - u * glm::dot(u, cut.along);
    if (!(glm::length(v) > 1e-9 * glm::length(cut.along))) // a plane may have any
        v = glm::cross(u, std::abs(u.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    v = glm::normalize(v);
    const glm::dvec3 w = glm::cross(u, v);
    points_ = cut.stroke;
    // In a mirrored mesh v is turned round, so that (u, v, w) is right-handed there
    const double way = glm::determinant(glm::dmat3(to_own)) < 0 ? -1 : 1;
    if (way < 0) {
        v = -v;
        std::ranges::reverse(points_);
        for (glm::dvec2& p : points_) p.x = -p.x;
    }
    const glm::dmat4 own_from_uvw{glm::dvec4(u, 0), glm::dvec4(v, 0), glm::dvec4(w, 0),
                                  glm::dvec4(cut.point, 1)};
    const glm::dmat3 turn = glm::transpose(glm::dmat3(u, v, w));
    glm::dmat4 uvw_from_own(turn);
    uvw_from_own[3] = glm::dvec4(-(turn * cut.point), 1);
    to_uvw_ = uvw_from_own * to_own;
    from_uvw_ = glm::inverse(to_own) * own_from_uvw;
    if (points_.empty()) return;
    slopes_ = slopes_at(points_);
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        const double length = points_[i + 1].x - points_[i].x;
        const double chord = (points_[i + 1].y - points_[i].y) / length;
        bent_.push_back(std::max(std::abs(6 * chord - 4 * slopes_[i] - 2 * slopes_[i + 1]),
                                 std::abs(6 * chord - 2 * slopes_[i] - 4 * slopes_[i + 1])) /
                        length);
    }
}

double CutSheet::q(double w) const
{
    return eye_ > 0 ? std::max(least_q, 1 + w / eye_) : 1;
}

CutSheet::Slope CutSheet::curve(double v) const
{
    if (v <= points_.front().x)
        return {points_.front().y + slopes_.front() * (v - points_.front().x), slopes_.front()};
    if (v >= points_.back().x)
        return {points_.back().y + slopes_.back() * (v - points_.back().x), slopes_.back()};
    const auto after = std::ranges::upper_bound(points_, v, {}, &glm::dvec2::x);
    const auto i = static_cast<std::size_t>(after - points_.begin()) - 1;
    const double length = points_[i + 1].x - points_[i].x, x = v - points_[i].x;
    const double chord = (points_[i + 1].y - points_[i].y) / length;
    const double a = slopes_[i], b = slopes_[i + 1];
    const double c2 = (3 * chord - 2 * a - b) / length;
    const double c3 = (a + b - 2 * chord) / (length * length);
    return {points_[i].y + x * (a + x * (c2 + x * c3)), a + x * (2 * c2 + 3 * x * c3)};
}

double CutSheet::phi(const glm::dvec2& vw) const
{
    if (is_flat()) return 0;
    const double by = q(vw.y);
    return by * curve(vw.x / by).value;
}

glm::dvec3 CutSheet::point(const glm::dvec2& vw) const
{
    return from_uvw_ * glm::dvec4(phi(vw), vw, 1);
}

glm::dvec3 CutSheet::normal(const glm::dvec2& vw) const
{
    glm::dvec3 gradient(1, 0, 0);
    if (!is_flat()) {
        const double v = vw.x / q(vw.y);
        const Slope f = curve(v);
        gradient.y = -f.slope;
        if (eye_ > 0) gradient.z = -(f.value - v * f.slope) / eye_;
    }
    return glm::normalize(glm::transpose(glm::dmat3(to_uvw_)) * gradient);
}

double CutSheet::most_bent(double lo, double hi) const
{
    const auto after = std::ranges::upper_bound(points_, lo, {}, &glm::dvec2::x);
    auto i = static_cast<std::size_t>(std::max<long>(1, after - points_.begin())) - 1;
    double most = 0;
    for (; i < bent_.size() && points_[i].x <= hi; ++i)
        if (points_[i + 1].x >= lo) most = std::max(most, bent_[i]);
    return most;
}

std::array<double, 3> CutSheet::bends(const std::array<glm::dvec2, 3>& vw) const
{
    if (is_flat()) return {};
    double lo = 1e300, hi = -1e300, least = 1e300;
    for (const glm::dvec2& p : vw) {
        const double by = q(p.y), v = p.x / by;
        lo = std::min(lo, v);
        hi = std::max(hi, v);
        least = std::min(least, by);
    }
    const double bent = most_bent(lo, hi);
    std::array<double, 3> out{};
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 e = vw[(i + 1) % 3] - vw[i];
        // phi_ee = f''(v') (e_v - v' e_w / eye)^2 / q, with v' = v / q
        const double turn = eye_ > 0 ? e.y / eye_ : 0;
        const double way = std::max(std::abs(e.x - lo * turn), std::abs(e.x - hi * turn));
        out[i] = bent * way * way / least;
    }
    return out;
}

} // namespace trivar
