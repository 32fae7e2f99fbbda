// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/incise/crossing_handles.h"

#include "core/base/number_text.h"
#include "core/base/rounded.h"
#include "core/commands/cutting/peel.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr double flap_reach_px = 14; // of the mouse, as an arrow stands apart
constexpr double flaps_near_px = 80; // from a crossing whose flaps have handles
constexpr double flap_off_px = 20;   // so far from the crossing they begin at least
constexpr double flap_stalk_px = 12; // so far off the skin they stand
constexpr double flap_end_on = 0.35; // below it a way points at the eye
constexpr double least_open_of_flap = 0.02;

struct FlapSide {
    glm::dvec3 across_world{0}; // into the flap, unit
    double half_gap_world = 0;
    double open = 0; // share of the opening
};

FlapSide side_of_flap(const NamedIncision& incision, const SeenIncision& seen, double share,
                      IncisionSide side)
{
    const auto i =
        std::min(static_cast<std::size_t>(share * SeenIncision::steps), SeenIncision::steps - 1);
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
glm::dvec3 moved_by_others(const SeenIncising& seen, const IncisionCrossing& crossing,
                           const glm::dvec3& flap_world)
{
    glm::dvec3 out(0);
    for (std::size_t k = 0; k < seen.cuts.size(); ++k) {
        const auto number = static_cast<int>(k) + 1;
        if (number == crossing.first || number == crossing.second || !seen.cuts[k]) continue;
        const SeenIncision& cut = *seen.cuts[k];
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
                         static_cast<double>(i) / static_cast<double>(SeenIncision::steps),
                         right ? IncisionSide::right : IncisionSide::left);
        out += (1 - x * x) * (1 - x * x) * side.half_gap_world * side.across_world;
    }
    return out;
}

// A flap as high as a hand lifts it. One that it has laid back leaves no number behind, unless that
// has keys. Nothing: it lay.
std::optional<Command> peeled(const TakenIncision& taken, const PeeledFlap& flap, double lift,
                              bool done)
{
    PeelFlap out{taken.object, flap};
    out.flap.lift = lift;
    if (!done || lift > 0) return out;
    const std::vector<PeeledFlap>& flaps = taken.incising().flaps;
    const auto known =
        std::ranges::find_if(flaps, [&](const PeeledFlap& each) { return each.same_place(flap); });
    if (known == flaps.end()) return {};
    const auto index = static_cast<int>(known - flaps.begin());
    const std::string keyed = fmt::format("incising.flaps.{}.lift", index);
    const std::vector<Track>& tracks = object(taken.before, taken.object).tracks;
    if (std::ranges::find(tracks, keyed, &Track::parameter) != tracks.end()) return out;
    return LayFlap{taken.object, index + 1};
}

// The handle of a flap; nothing: it is shut, or behind the eye.
std::optional<Handle> flap_handle(const SeenIncising& seen, const IncisionCrossing& crossing,
                                  const PeeledFlap& flap, int number, const Camera& camera,
                                  double scale, const TakeIncision& take)
{
    const auto a = static_cast<std::size_t>(crossing.first) - 1,
               b = static_cast<std::size_t>(crossing.second) - 1;
    const std::optional<SeenIncision>&cut_a = seen.cuts.at(a), &cut_b = seen.cuts.at(b);
    if (!cut_a || !cut_b) return {};
    Handle out{
        .key = {"flap",
                {crossing.first, crossing.second,
                 2 * static_cast<int>(flap.side_of_first) + static_cast<int>(flap.side_of_second)}},
        .p_world = crossing.at.p_world,
        .way_px = {0, -1},
        .look = Handle::Look::arrow,
        .thread = Handle::Thread::always,
        .color = &ui::Palette::free_node,
        .lit = &ui::Palette::incision,
        .reach_px = flap_reach_px,
        .number = Handle::Number::length,
        .verb = "Drag to peel this flap"};
    const FlapSide first = side_of_flap(seen.incising.cuts[a], *cut_a, crossing.share_of_first,
                                        flap.side_of_first),
                   second = side_of_flap(seen.incising.cuts[b], *cut_b, crossing.share_of_second,
                                         flap.side_of_second);
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
    const double metres_per_px = world_per_px / cut_a->scale / open; // of the lift, on the model
    out.p_px = out.base_px + out.way_px * (flap.lift / metres_per_px + flap_stalk_px * scale);
    // About the length of the flap
    const double highest = 1.2 * std::min(reach_of(seen.incising.cuts[a].cut, cut_a->length),
                                          reach_of(seen.incising.cuts[b].cut, cut_b->length));
    const double scale_now = (number == crossing.first ? cut_a : cut_b)->scale;
    out.words = "Peeled " + ui::short_number(rounded(flap.lift * scale_now, 3)) + " m";
    out.take = [=, way_px = out.way_px] {
        const std::optional<TakenIncision> taken = take();
        if (!taken) return HandleDrag{};
        return HandleDrag{[=, taken = *taken](const HandMove& move) {
            if (move.typed)
                return peeled(taken, flap, std::max(0.0, *move.typed / taken.seen.scale),
                              move.done);
            const double by = glm::dot(move.by_px(), way_px) * metres_per_px;
            const double lift = std::clamp(flap.lift + by, 0.0, std::max(highest, flap.lift));
            return peeled(taken, flap, rounded(lift, move.snap ? 1 : 3), move.done);
        }};
    };
    return out;
}

// The crossing at another share of the chosen incision; the other one moves with it.
EditIncision slid(const TakenIncision& taken, const IncisionCrossing& crossing, double other_length,
                  double share)
{
    const int other = crossing.other_than(taken.number);
    EditIncision out{taken.object, other,
                     taken.incising().cuts.at(static_cast<std::size_t>(other) - 1)};
    const double s = std::clamp(share, 0.0, 1.0) * static_cast<double>(SeenIncision::steps);
    const auto i = std::min(static_cast<std::size_t>(s), SeenIncision::steps - 1);
    const SurfacePoint &a = taken.seen.line[i].at_rest, &b = taken.seen.line[i + 1].at_rest;
    const double t = s - static_cast<double>(i);
    const SurfacePoint to{glm::mix(a.p, b.p, t), glm::normalize(glm::mix(a.normal, b.normal, t))};
    // Beyond an edge of the skin it stays where it was
    if (auto moved = moved_over(taken.skin, out.incision.cut.stroke, crossing.at.at_rest, to,
                                0.5 * other_length))
        out.incision.cut.stroke = *std::move(moved);
    else
        out.incision.cut.stroke.clear();
    return out;
}

Handle crossing_handle(const SeenIncising& seen, const IncisionCrossing& crossing, int number,
                       const Camera& camera, const TakeIncision& take)
{
    const auto first = static_cast<std::size_t>(crossing.first) - 1,
               second = static_cast<std::size_t>(crossing.second) - 1;
    std::string name = seen.incising.cuts.at(second).name;
    if (name.empty()) name = fmt::format("Incision {}", crossing.second);
    const double share = crossing.share_of(number);
    Handle out{.key = {"crossing", {crossing.first, crossing.second}},
               .p_world = crossing.at.p_world,
               .look = Handle::Look::cross,
               .color = &ui::Palette::incision,
               .words = fmt::format("Crosses at {} %, {} is the later one",
                                    number_text(100 * share), name),
               .number = Handle::Number::percent,
               .verb = "Drag to slide the crossing",
               .click_verb = "Click to swap which is cut first"};
    const glm::dvec2 at_px = out.p_px = out.base_px = project(camera, crossing.at.p_world).p_px;
    // A bar along the one that is cut first
    if (const auto& cut = seen.cuts.at(first)) {
        const double s = crossing.share_of_first;
        out.way_px =
            project(camera, cut->at(s + 0.01)).p_px - project(camera, cut->at(s - 0.01)).p_px;
    }
    const std::optional<SeenIncision>& other =
        seen.cuts.at(static_cast<std::size_t>(crossing.other_than(number)) - 1);
    out.take = [=, other_length = other ? other->length : 0] {
        const std::optional<TakenIncision> taken = take();
        if (!taken) return HandleDrag{};
        return HandleDrag{
            [=, taken = *taken](const HandMove& move) {
                if (move.typed) return slid(taken, crossing, other_length, *move.typed / 100);
                const auto near = near_cut(taken.seen, move.camera, at_px + move.by_px());
                const double to = near ? near->share : share;
                return slid(taken, crossing, other_length,
                            move.snap ? std::round(to * 20) / 20 : to);
            },
            {},
            [=, object = taken->object](Session& session) {
                if (session.run(SwapIncisions{object, crossing.first, crossing.second}))
                    session.incision.number = crossing.other_than(number);
            }};
    };
    return out;
}

} // namespace

std::vector<Handle> crossing_handles(const SeenIncising& seen, int number, const Camera& camera,
                                     glm::dvec2 near_px, double scale, const TakeIncision& take)
{
    std::vector<Handle> out;
    const IncisionCrossing* nearest = nullptr;
    double least = flaps_near_px * scale;
    for (const IncisionCrossing& each : seen.crossings) {
        if (each.first != number && each.second != number) continue;
        const PicturePoint at = project(camera, each.at.p_world);
        if (!(at.depth_world > 0)) continue;
        out.push_back(crossing_handle(seen, each, number, camera, take));
        if (const double away = glm::distance(at.p_px, near_px); away < least) {
            least = away;
            nearest = &each;
        }
    }
    if (!nearest) return out;
    for (const IncisionSide first : {IncisionSide::left, IncisionSide::right})
        for (const IncisionSide second : {IncisionSide::left, IncisionSide::right}) {
            const PeeledFlap flap = flap_in(seen.incising, {.first = nearest->first,
                                                            .second = nearest->second,
                                                            .side_of_first = first,
                                                            .side_of_second = second});
            if (auto each = flap_handle(seen, *nearest, flap, number, camera, scale, take))
                out.push_back(*std::move(each));
        }
    return out;
}

} // namespace trivar
