// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/incise/seen_incision.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace trivar {
namespace {

constexpr double skin_reach = 0.02; // of the diagonal: points are looked for so far off the skin

std::vector<double> lengths_along(std::span<const SurfacePoint> stroke)
{
    std::vector<double> out{0};
    for (std::size_t i = 1; i < stroke.size(); ++i)
        out.push_back(out.back() + glm::distance(stroke[i - 1].p, stroke[i].p));
    return out;
}

SurfacePoint between(const SurfacePoint& a, const SurfacePoint& b, double share)
{
    const glm::dvec3 n = glm::mix(a.normal, b.normal, share);
    const double length = glm::length(n);
    return {glm::mix(a.p, b.p, share), length > 1e-9 ? n / length : a.normal};
}

SurfaceHit between(const SurfaceHit& a, const SurfaceHit& b, double share)
{
    const SurfacePoint world = between(SurfacePoint{a.p_world, a.normal_world},
                                       SurfacePoint{b.p_world, b.normal_world}, share);
    return {world.p, world.normal, between(a.at_rest, b.at_rest, share),
            glm::mix(a.scale, b.scale, share)};
}

SurfacePoint at_length(std::span<const SurfacePoint> stroke, const std::vector<double>& lengths,
                       double s)
{
    const auto after = std::ranges::upper_bound(lengths, s);
    const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(after - lengths.begin()), 1,
                                           lengths.size() - 1);
    const double step = lengths[i] - lengths[i - 1];
    return between(stroke[i - 1], stroke[i],
                   step > 0 ? std::clamp((s - lengths[i - 1]) / step, 0.0, 1.0) : 0);
}

glm::dvec3 unit_or_zero(const glm::dvec3& v)
{
    const double length = glm::length(v);
    return length > 1e-12 ? v / length : glm::dvec3(0);
}

// Directions to the right, as they are seen.
void find_across(SeenIncision& cut, const IncisedSkin& skin, const std::vector<SurfacePoint>& even,
                 const std::vector<glm::dvec3>& rights, double reach)
{
    const double step = 0.02 * cut.length;
    std::vector<SurfacePoint> beside;
    for (std::size_t i = 0; i < even.size(); ++i)
        beside.push_back({even[i].p + step * rights[i], even[i].normal});
    const auto found = skin.seen(beside, reach + step);
    for (std::size_t i = 0; i < cut.across.size(); ++i)
        if (found[i] && cut.on_skin[i])
            cut.across[i] = unit_or_zero(found[i]->p_world - cut.line[i].p_world);
}

// Puts the places on the skin, and those in the air between them; false: none is on the skin.
bool find_line(SeenIncision& cut, const std::vector<std::optional<SurfaceHit>>& on_skin)
{
    const std::size_t count = cut.line.size();
    std::size_t before = count,
                run = 0; // the last place that is on the skin, and how many in a row
    cut.first = cut.last = 0;
    for (std::size_t i = 0; i < count; ++i) {
        cut.on_skin[i] = on_skin[i].has_value();
        run = cut.on_skin[i] ? run + 1 : 0;
        if (!cut.on_skin[i]) continue;
        cut.line[i] = *on_skin[i];
        if (run > cut.last - cut.first) cut.first = i + 1 - run, cut.last = i;
        const SurfaceHit& from = cut.line[before < count ? before : i];
        for (std::size_t k = before < count ? before + 1 : 0; k < i; ++k)
            cut.line[k] = between(from, cut.line[i],
                                  before < count ? static_cast<double>(k - before) /
                                                       static_cast<double>(i - before)
                                                 : 1);
        before = i;
    }
    for (std::size_t k = before + 1; k < count; ++k) cut.line[k] = cut.line[before];
    return before < count;
}

// The net over what gives way: its sides turn more slowly than the cut, so that they do not cross.
void find_cage(SeenIncision& cut, const IncisedSkin& skin, const std::vector<SurfacePoint>& even,
               const std::vector<glm::dvec3>& rights, double reach)
{
    constexpr int across = 12;            // points from the cut to a rim
    constexpr std::size_t rung_every = 8; // steps of a cut
    constexpr double lifted = 0.012;      // share of its length, so that no face hides it
    constexpr double most_off = 0.5;      // of the way from the cut: beyond lies another limb
    constexpr double leap = 3;            // steps along a line: there it goes through the air
    const double window = std::clamp(reach / std::max(cut.length, 1e-12), 0.1, 1.0);
    const auto wide = static_cast<long>(window * static_cast<double>(SeenIncision::steps));
    const auto last = static_cast<long>(even.size()) - 1;
    std::vector<SurfacePoint> wanted;
    for (long i = 0; i <= last; ++i) {
        glm::dvec3 right(0);
        for (long k = std::max(0L, i - wide); k <= std::min(last, i + wide); ++k)
            right += rights[static_cast<std::size_t>(k)];
        const SurfacePoint& at = even[static_cast<std::size_t>(i)];
        right = unit_or_zero(right - at.normal * glm::dot(right, at.normal));
        const bool rung = static_cast<std::size_t>(i) % rung_every == 0;
        for (int k = -across; k <= across; k += rung ? 1 : 2 * across)
            wanted.push_back({at.p + (reach * k / across) * right, at.normal});
    }
    const auto found = skin.seen(wanted, most_off * reach);
    // Adds what lies on this side of the skin as lines, each without a leap
    const auto add = [&](std::vector<std::vector<glm::dvec3>>& lines,
                         const std::vector<std::size_t>& places) {
        std::optional<std::size_t> before;
        for (const std::size_t i : places) {
            const double off = found[i] ? glm::distance(found[i]->at_rest.p, wanted[i].p) : reach;
            const bool here =
                off < most_off * reach && glm::dot(found[i]->at_rest.normal, wanted[i].normal) > 0;
            const bool goes_on =
                here && before &&
                glm::distance(found[i]->at_rest.p, found[*before]->at_rest.p) <
                    leap * std::max(glm::distance(wanted[i].p, wanted[*before].p), reach / across);
            before = here ? std::optional(i) : std::nullopt;
            if (!here) continue;
            if (!goes_on) lines.emplace_back();
            lines.back().push_back(found[i]->p_world +
                                   lifted * cut.length_world * found[i]->normal_world);
        }
    };
    std::array<std::vector<std::size_t>, 2> rims;
    std::size_t k = 0;
    for (std::size_t i = 0; i < even.size(); ++i) {
        const bool rung = i % rung_every == 0;
        const std::size_t count = rung ? 2 * across + 1 : 2;
        rims[0].push_back(k);
        rims[1].push_back(k + count - 1);
        if (rung) {
            std::vector<std::size_t> all(count);
            std::iota(all.begin(), all.end(), k);
            add(cut.rungs, all);
        }
        k += count;
    }
    for (const std::vector<std::size_t>& rim : rims) add(cut.rims, rim);
}

} // namespace

std::vector<SurfacePoint> at_equal_steps(std::span<const SurfacePoint> stroke, std::size_t steps)
{
    std::vector<SurfacePoint> out;
    if (stroke.size() < 2) return out;
    const std::vector<double> lengths = lengths_along(stroke);
    for (std::size_t i = 0; i <= steps; ++i)
        out.push_back(at_length(
            stroke, lengths, lengths.back() * static_cast<double>(i) / static_cast<double>(steps)));
    return out;
}

std::vector<SurfacePoint> part_of(std::span<const SurfacePoint> stroke, double from, double to)
{
    const std::vector<double> lengths = lengths_along(stroke);
    const double a = from * lengths.back(), b = to * lengths.back();
    std::vector<SurfacePoint> out{at_length(stroke, lengths, a)};
    const double near = 1e-3 * lengths.back();
    for (std::size_t i = 0; i < stroke.size(); ++i)
        if (lengths[i] > a + near && lengths[i] < b - near) out.push_back(stroke[i]);
    out.push_back(at_length(stroke, lengths, b));
    return out;
}

glm::dvec3 SeenIncision::at(double share) const
{
    const double s = std::clamp(share, 0.0, 1.0) * static_cast<double>(steps);
    const auto i = std::min(static_cast<std::size_t>(s), steps - 1);
    return glm::mix(line[i].p_world, line[i + 1].p_world, s - static_cast<double>(i));
}

std::optional<SeenIncision> seen_incision(const IncisedSkin& skin, const NamedIncision& incision,
                                          const IncisingEffects::OfIncision* told)
{
    SeenIncision out;
    const Incision& cut = incision.cut;
    const std::vector<SurfacePoint> even = at_equal_steps(cut.stroke, SeenIncision::steps);
    if (even.empty() || skin.empty()) return {};
    const double reach = skin_reach * skin.diagonal();
    if (!find_line(out, skin.seen(even, reach))) return {};
    const double of_stroke = length_of(cut.stroke);
    out.length = told && told->length > 0 ? told->length : of_stroke;
    out.widest = told && told->refusal.empty() ? told->widest : 1;
    out.depth = told && told->depth > 0 ? told->depth : cut.depth;
    const std::size_t last = SeenIncision::steps;
    std::vector<glm::dvec3> rights; // at rest
    double most = -1;
    for (std::size_t i = 0; i <= last; ++i) {
        const glm::dvec3 along =
            out.line[std::min(i + 1, last)].at_rest.p - out.line[i > 0 ? i - 1 : 0].at_rest.p;
        rights.push_back(unit_or_zero(glm::cross(along, even[i].normal)));
        const double x = static_cast<double>(i) / static_cast<double>(last);
        const double b = value_at(cut.opening_profile, x);
        const double open = cut.width / 2 * out.widest * b * share_at(incision.opening, x);
        // Where several are as wide, the middle; where it is shut, where it would be widest
        const double wish = (open + 1e-3 * cut.width * b) * (1 - 0.02 * std::abs(x - 0.5));
        if (wish > most && i >= out.first && i <= out.last) most = wish, out.widest_at = i;
        if (i > 0) out.length_world += glm::distance(out.line[i - 1].p_world, out.line[i].p_world);
    }
    out.scale = of_stroke > 0 ? out.length_world / of_stroke : 1;
    find_across(out, skin, even, rights, reach);
    find_cage(out, skin, even, rights, reach_of(cut, out.length));
    return out;
}

std::optional<NearCut> near_cut(const SeenIncision& cut, const Camera& camera, glm::dvec2 p_px)
{
    std::optional<NearCut> out;
    glm::dvec2 before(0);
    bool follows = false; // the place before is seen, too
    for (std::size_t i = 0; i < cut.line.size(); ++i) {
        const PicturePoint at = project(camera, cut.line[i].p_world);
        if (!(at.depth_world > 0)) {
            follows = false;
            continue;
        }
        if (follows) {
            const glm::dvec2 way = at.p_px - before;
            const double far = glm::dot(way, way);
            const double t = far > 0 ? std::clamp(glm::dot(p_px - before, way) / far, 0.0, 1.0) : 0;
            const double away = glm::distance(p_px, before + t * way);
            if (!out || away < out->away_px)
                out = NearCut{(static_cast<double>(i) - 1 + t) /
                                  static_cast<double>(SeenIncision::steps),
                              away};
        }
        before = at.p_px;
        follows = true;
    }
    return out;
}

} // namespace trivar
