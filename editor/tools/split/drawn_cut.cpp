// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/split/drawn_cut.h"

#include "core/base/rounded.h"
#include "core/split/cut_sheet.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double shortest_px = 8, back_px = 5; // a hand may go back as far as that
constexpr double grid_px = 2;                  // between heights that are smoothed
constexpr int smoothings = 24;
constexpr double knot_px = 16; // between the points of a cut, about
constexpr int most_knots = 48;

glm::dvec3 rounded_each(const glm::dvec3& p, const auto& round)
{
    return {round(p.x), round(p.y), round(p.z)};
}

// The plane, in the object's own space, in which a stroke is taken to lie: through the middle, and
// across the line of sight to the middle of the stroke.
class StrokePlane {
public:
    StrokePlane(const DrawnWay& way, const glm::dvec2& middle_px)
        : way_(way),
          to_own_(glm::inverse(way.own_to_world))
    {
        const Ray ray = ray_through(way.camera, middle_px);
        const glm::dvec3 view = glm::normalize(way.camera.target - way.camera.eye);
        const double steep = glm::dot(ray.direction, view);
        const double depth = glm::dot(way.middle - ray.origin, view);
        // An eye within the object looks past its middle
        const double least = 1e-3 * glm::distance(way.camera.target, way.camera.eye);
        const double far = way.camera.perspective ? std::max(depth, least) : depth;
        eye_ = own(ray.origin);
        origin_ = own(ray.origin + ray.direction * (far / steep));
        away_ = glm::normalize(glm::dmat3(to_own_) * ray.direction);
    }
    glm::dvec3 at(const glm::dvec2& p_px) const
    {
        const Ray ray = ray_through(way_.camera, p_px);
        const glm::dvec3 from = own(ray.origin), along = glm::dmat3(to_own_) * ray.direction;
        return from + along * (glm::dot(origin_ - from, away_) / glm::dot(along, away_));
    }
    // The cut along the line of sight through two points, without a stroke.
    PlainCut cut_through(const glm::dvec2& a_px, const glm::dvec2& b_px) const
    {
        const glm::dvec3 along = glm::normalize(at(b_px) - at(a_px));
        PlainCut out;
        out.point = origin_;
        out.along = along;
        out.normal = glm::normalize(glm::cross(along, away_));
        out.opened = way_.opened;
        out.parted = way_.parted;
        return out;
    }
    double pixel(const glm::dvec2& a_px, const glm::dvec2& b_px) const
    {
        return glm::distance(at(a_px), at(b_px)) / glm::distance(a_px, b_px);
    }
    double eye() const { return way_.camera.perspective ? glm::distance(eye_, origin_) : 0; }

private:
    glm::dvec3 own(const glm::dvec3& p_world) const { return to_own_ * glm::dvec4(p_world, 1); }

    const DrawnWay& way_;
    glm::dmat4 to_own_;
    glm::dvec3 eye_, origin_, away_;
};

// Heights of the way over its chord, to its left, at equal distances; empty: it turns back.
std::vector<double> heights_over(const std::vector<glm::dvec2>& points, const glm::dvec2& chord,
                                 double length)
{
    const glm::dvec2 left(-chord.y, chord.x);
    std::vector<glm::dvec2> ascending; // (along, height)
    double furthest = 0;
    for (const glm::dvec2& p : points) {
        const glm::dvec2 way = p - points.front();
        const double s = glm::dot(way, chord);
        if (s < furthest - back_px || s < -back_px || s > length + back_px) return {};
        if (!ascending.empty() && s <= ascending.back().x + 1e-3) continue;
        furthest = std::max(furthest, s);
        ascending.emplace_back(std::max(s, 0.0), glm::dot(way, left));
    }
    const int count = std::max(4, static_cast<int>(length / grid_px));
    std::vector<double> out;
    std::size_t i = 0;
    for (int k = 0; k <= count; ++k) {
        const double s = length * k / count;
        while (i + 2 < ascending.size() && ascending[i + 1].x < s) ++i;
        if (ascending.size() < 2) return {};
        const glm::dvec2 a = ascending[i], b = ascending[i + 1];
        out.push_back(glm::mix(a.y, b.y, std::clamp((s - a.x) / (b.x - a.x), 0.0, 1.0)));
    }
    for (int round = 0; round < smoothings; ++round) {
        double before = out.front();
        for (std::size_t k = 1; k + 1 < out.size(); ++k) {
            const double now = out[k];
            out[k] = (before + 2 * now + out[k + 1]) / 4;
            before = now;
        }
    }
    return out;
}

bool is_short(const DrawnWay& way, std::string* why)
{
    if (way.points_px.size() > 1 &&
        glm::distance(way.points_px.front(), way.points_px.back()) >= shortest_px)
        return false;
    if (why) *why = "The line is too short; drag across the whole object.";
    return true;
}

// Rounds directions to six digits, and places so that none of them moves by a hundredth of a pixel,
// which has that size in the object's space.
void round_numbers(PlainCut& cut, double pixel)
{
    if (!(pixel > 0)) return;
    const double unit = std::pow(10, std::floor(std::log10(pixel / 100)));
    const auto place = [&](double x) { return rounded_to(unit, x); };
    const auto share = [](double x) { return rounded(x, 6); };
    cut.point = rounded_each(cut.point, place);
    cut.normal = rounded_each(cut.normal, share);
    cut.along = rounded_each(cut.along, share);
    cut.eye = place(cut.eye);
    for (glm::dvec2& p : cut.stroke) p = {place(p.x), place(p.y)};
    for (glm::dvec3& off : cut.opened) off = rounded_each(off, place);
}

} // namespace

std::optional<PlainCut> cut_along_line(const DrawnWay& way, std::string* why)
{
    if (is_short(way, why)) return {};
    const glm::dvec2 a = way.points_px.front(), b = way.points_px.back();
    const StrokePlane plane(way, (a + b) / 2.0);
    PlainCut out = plane.cut_through(a, b);
    round_numbers(out, plane.pixel(a, b));
    return out;
}

std::optional<PlainCut> cut_along_way(const DrawnWay& way, std::string* why)
{
    if (is_short(way, why)) return {};
    const glm::dvec2 a = way.points_px.front(), b = way.points_px.back();
    const double length = glm::distance(a, b);
    const glm::dvec2 chord = (b - a) / length, left(-chord.y, chord.x);
    const std::vector<double> heights = heights_over(way.points_px, chord, length);
    PlainCut out;
    if (!heights.empty()) {
        const StrokePlane plane(way, (a + b) / 2.0);
        out = plane.cut_through(a, b);
        out.eye = plane.eye();
        const int knots = std::clamp(static_cast<int>(length / knot_px), 3, most_knots);
        for (int k = 0; k <= knots; ++k) {
            const double share = static_cast<double>(k) / knots;
            const double at = share * static_cast<double>(heights.size() - 1);
            const auto i = std::min(static_cast<std::size_t>(at), heights.size() - 2);
            const double height = glm::mix(heights[i], heights[i + 1], at - static_cast<double>(i));
            const glm::dvec3 p = plane.at(a + chord * (share * length) + left * height);
            out.stroke.emplace_back(glm::dot(p - out.point, out.along),
                                    glm::dot(p - out.point, out.normal));
        }
        round_numbers(out, plane.pixel(a, b));
    }
    if (heights.empty() || !stroke_trouble(out.stroke).empty()) {
        if (why)
            *why = "The stroke turns back; draw it from one side of the object to the other "
                   "without a loop.";
        return {};
    }
    return out;
}

Cutting flipped(Cutting cutting, std::size_t number)
{
    PlainCut& cut = cutting.cuts.at(number);
    cut.normal = -cut.normal;
    cut.along = -cut.along;
    std::ranges::reverse(cut.stroke);
    for (glm::dvec2& p : cut.stroke) p = -p;
    for (PlainCut& each : cutting.cuts)
        if (number < each.opened.size()) each.opened[number] = -each.opened[number];
    return cutting;
}

} // namespace trivar
