// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/incise/crossing_holds.h"

#include "core/base/number_text.h"
#include "core/base/rounded.h"
#include "core/commands/cutting/peel.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double crossing_hold_px = 9; // of a handle
constexpr double flap_hold_px = 14;    // of an arrow, which stands apart
constexpr double flaps_near_px = 80;   // from a crossing whose flaps have handles
constexpr double flap_off_px = 20;     // so far from the crossing they begin at least
constexpr double flap_stalk_px = 12;   // so far off the skin they stand
constexpr double flap_end_on = 0.35;   // below it a way points at the eye
constexpr double least_open_of_flap = 0.02;

struct FlapSide {
    glm::dvec3 across_world{0}; // into the flap, unit
    double half_gap_world = 0;
    double open = 0; // share of the opening
};

FlapSide side_of_flap(const NamedIncision& incision, const SeenCut& seen, double share,
                      IncisionSide side)
{
    const auto i = std::min(static_cast<std::size_t>(share * SeenCut::steps), SeenCut::steps - 1);
    FlapSide out;
    out.open = share_at(incision.opening, share);
    out.across_world = seen.across[i] * (side == IncisionSide::right ? 1.0 : -1.0);
    out.half_gap_world = incision.cut.width / 2 * seen.widest *
                         value_at(incision.cut.opening_profile, share) * out.open * seen.scale;
    return out;
}

// The lift that the document has for a flap.
PeeledFlap flap_in(const Incising& incising, PeeledFlap place)
{
    for (const PeeledFlap& each : incising.flaps)
        if (each.same_place(place)) return each;
    return place;
}

// Returns how far all other incisions near a crossing move a flap there, in the world.
glm::dvec3 moved_by_others(const SeenIncising& seen, const CutCrossing& crossing,
                           const glm::dvec3& flap_world)
{
    glm::dvec3 out(0);
    for (std::size_t k = 0; k < seen.cuts.size(); ++k) {
        const auto number = static_cast<int>(k) + 1;
        if (number == crossing.first || number == crossing.second || !seen.cuts[k]) continue;
        const SeenCut& cut = *seen.cuts[k];
        const auto away = [&](const SurfaceHit& each) {
            return glm::distance(each.at_rest.p, crossing.at.at_rest.p);
        };
        const auto near = std::ranges::min_element(cut.line, {}, away);
        const double x = away(*near) / reach_of(seen.incising.cuts[k].cut, cut.length);
        if (!(x < 1)) continue;
        const auto i = static_cast<std::size_t>(near - cut.line.begin());
        const bool right = glm::dot(flap_world - near->p_world, cut.across[i]) > 0;
        const FlapSide side =
            side_of_flap(seen.incising.cuts[k], cut,
                         static_cast<double>(i) / static_cast<double>(SeenCut::steps),
                         right ? IncisionSide::right : IncisionSide::left);
        out += (1 - x * x) * (1 - x * x) * side.half_gap_world * side.across_world;
    }
    return out;
}

// The handle of a flap; nothing: it is shut, or behind the eye.
std::optional<CrossingHold> flap_hold(const SeenIncising& seen, const CutCrossing& crossing,
                                      IncisionSide of_first, IncisionSide of_second,
                                      const Camera& camera, double scale)
{
    const auto a = static_cast<std::size_t>(crossing.first) - 1,
               b = static_cast<std::size_t>(crossing.second) - 1;
    const std::optional<SeenCut>&cut_a = seen.cuts.at(a), &cut_b = seen.cuts.at(b);
    if (!cut_a || !cut_b) return {};
    CrossingHold out;
    out.crossing = crossing;
    out.flap = flap_in(seen.incising, {.first = crossing.first,
                                       .second = crossing.second,
                                       .side_of_first = of_first,
                                       .side_of_second = of_second});
    const FlapSide first = side_of_flap(seen.incising.cuts[a], *cut_a, crossing.share_of_first,
                                        of_first),
                   second = side_of_flap(seen.incising.cuts[b], *cut_b, crossing.share_of_second,
                                         of_second);
    const double open = std::pow(first.open * second.open, 0.75);
    if (!(open > least_open_of_flap)) return {};
    const glm::dvec3 middle = crossing.at.p_world;
    glm::dvec3 tip = middle + first.half_gap_world * first.across_world +
                     second.half_gap_world * second.across_world;
    tip += moved_by_others(seen, crossing, tip);
    const PicturePoint at = project(camera, middle), tip_at = project(camera, tip);
    if (!(at.depth_world > 0) || !(tip_at.depth_world > 0)) return {};
    const double px = pixel_size_world(camera, at.depth_world);
    // The way into the flap as it is seen, however little it is open
    const glm::dvec3 into = first.across_world + second.across_world;
    const glm::dvec2 off = project(camera, middle + into * px * flap_off_px).p_px - at.p_px;
    const double far = glm::length(off);
    out.base_px = tip_at.p_px;
    if (far > 1e-3 && glm::distance(tip_at.p_px, at.p_px) < flap_off_px * scale)
        out.base_px = at.p_px + off / far * flap_off_px * scale;
    const glm::dvec2 up = project(camera, middle + crossing.at.normal_world * px).p_px - at.p_px;
    const bool hidden = glm::length(up) < flap_end_on; // it points at the eye
    if (!hidden) out.way_px = glm::normalize(up);
    const double world_per_px = px / (hidden ? 1 : glm::length(up));
    out.metres_per_px = world_per_px / cut_a->scale / open;
    out.highest = 1.2 * std::min(reach_of(seen.incising.cuts[a].cut, cut_a->length),
                                 reach_of(seen.incising.cuts[b].cut, cut_b->length));
    const double raised = out.flap->lift / out.metres_per_px;
    out.p_px = out.base_px + out.way_px * (raised + flap_stalk_px * scale);
    return out;
}

PeelFlap peeled(const CrossingDrag& drag, double lift)
{
    PeelFlap out{drag.object, *drag.held.flap};
    out.flap.lift = lift;
    return out;
}

// The crossing at another share of the chosen incision; the other one moves with it.
EditIncision slid(const CrossingDrag& drag, double share)
{
    EditIncision out{drag.object, drag.held.crossing.other_than(drag.number), drag.other};
    const double s = std::clamp(share, 0.0, 1.0) * static_cast<double>(SeenCut::steps);
    const auto i = std::min(static_cast<std::size_t>(s), SeenCut::steps - 1);
    const SurfacePoint &a = drag.seen.line[i].at_rest, &b = drag.seen.line[i + 1].at_rest;
    const double t = s - static_cast<double>(i);
    const SurfacePoint to{glm::mix(a.p, b.p, t), glm::normalize(glm::mix(a.normal, b.normal, t))};
    // Beyond an edge of the skin it stays where it was
    if (auto moved = moved_over(drag.skin, drag.other.cut.stroke, drag.held.crossing.at.at_rest, to,
                                0.5 * drag.seen_other.length))
        out.incision.cut.stroke = *std::move(moved);
    else
        out.incision.cut.stroke.clear();
    return out;
}

} // namespace

std::vector<CrossingHold> crossing_holds(const SeenIncising& seen, int number, const Camera& camera,
                                         glm::dvec2 near_px, double scale)
{
    std::vector<CrossingHold> out;
    const CutCrossing* nearest = nullptr;
    double least = flaps_near_px * scale;
    for (const CutCrossing& each : seen.crossings) {
        if (each.first != number && each.second != number) continue;
        const PicturePoint at = project(camera, each.at.p_world);
        if (!(at.depth_world > 0)) continue;
        out.push_back({.crossing = each, .flap = {}, .p_px = at.p_px, .base_px = at.p_px});
        if (const double away = glm::distance(at.p_px, near_px); away < least) {
            least = away;
            nearest = &each;
        }
    }
    if (!nearest) return out;
    for (const IncisionSide first : {IncisionSide::left, IncisionSide::right})
        for (const IncisionSide second : {IncisionSide::left, IncisionSide::right})
            if (auto hold = flap_hold(seen, *nearest, first, second, camera, scale))
                out.push_back(*std::move(hold));
    return out;
}

std::optional<std::size_t> crossing_hold_at(const std::vector<CrossingHold>& holds, glm::dvec2 p_px,
                                            double scale)
{
    std::optional<std::size_t> out;
    double nearest = 1e300;
    for (std::size_t i = 0; i < holds.size(); ++i) {
        const double reach = (holds[i].flap ? flap_hold_px : crossing_hold_px) * scale;
        const double away = glm::distance(holds[i].p_px, p_px);
        if (away >= std::min(reach, nearest)) continue;
        nearest = away;
        out = i;
    }
    return out;
}

Command dragged(const CrossingDrag& drag, glm::dvec2 to_px, bool snap)
{
    const glm::dvec2 by_px = to_px - drag.from_px;
    if (drag.held.flap) {
        const double by = glm::dot(by_px, drag.held.way_px) * drag.held.metres_per_px;
        const double most = std::max(drag.held.highest, drag.held.flap->lift);
        return peeled(drag,
                      rounded(std::clamp(drag.held.flap->lift + by, 0.0, most), snap ? 1 : 3));
    }
    const auto near = near_cut(drag.seen, drag.camera, drag.held.p_px + by_px);
    const double share = near ? near->share : drag.held.crossing.share_of(drag.number);
    return slid(drag, snap ? std::round(share * 20) / 20 : share);
}

Command typed_in(const CrossingDrag& drag, double number)
{
    if (drag.held.flap) return peeled(drag, std::max(0.0, number / drag.seen.scale));
    return slid(drag, number / 100);
}

std::string words_of(const CrossingHold& hold, const Incising& incising, const SeenCut& seen,
                     int number)
{
    if (hold.flap) {
        const double lift = flap_in(incising, *hold.flap).lift;
        return "Peeled " + ui::short_number(rounded(lift * seen.scale, 3)) + " m";
    }
    const auto below = static_cast<std::size_t>(hold.crossing.second) - 1;
    std::string name = below < incising.cuts.size() ? incising.cuts[below].name : "";
    if (name.empty()) name = fmt::format("Incision {}", hold.crossing.second);
    return fmt::format("Crosses at {} %, {} is the later one",
                       number_text(100 * hold.crossing.share_of(number)), name);
}

} // namespace trivar
