// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/flaps.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr std::uint32_t no_number = 0xFFFFFFFF;
constexpr double lift_power = 0.75; // of the product: smooth at the base, full at the tip
constexpr double least_weight = 1e-3;
constexpr double most_back = 0.5; // of the length of a flap: beyond, its skin would turn over

double lift_weight(double product)
{
    return std::pow(std::max(product, 0.0), lift_power);
}

glm::dvec3 flap_unit(const glm::dvec3& v)
{
    const double length = glm::length(v);
    return length > 1e-12 ? v / length : glm::dvec3(0);
}

// Directions beside a stroke by the share of its length.
class StrokeFrame {
public:
    explicit StrokeFrame(const Incision& cut) : stroke_(cut.stroke)
    {
        lengths_.push_back(0);
        for (std::size_t i = 1; i < stroke_.size(); ++i)
            lengths_.push_back(lengths_.back() + glm::distance(stroke_[i].p, stroke_[i - 1].p));
    }
    glm::dvec3 normal(double share) const
    {
        const std::size_t i = segment(share);
        return flap_unit(stroke_[i].normal + stroke_[i - 1].normal);
    }
    // Unit, along the skin. Over three segments, as strokes of hands are not even.
    glm::dvec3 right(double share) const
    {
        const std::size_t i = segment(share), last = stroke_.size() - 1;
        const glm::dvec3 along = stroke_[std::min(i + 1, last)].p - stroke_[i > 1 ? i - 2 : 0].p;
        return flap_unit(glm::cross(along, normal(share)));
    }

private:
    std::size_t segment(double share) const
    {
        const auto after = std::ranges::upper_bound(lengths_, share * lengths_.back());
        return std::clamp<std::size_t>(static_cast<std::size_t>(after - lengths_.begin()), 1,
                                       lengths_.size() - 1);
    }
    const std::vector<SurfacePoint>& stroke_;
    std::vector<double> lengths_;
};

// A SideField is the effect of one incision on the slots of one of its sides.
struct SideField {
    std::vector<float> amounts, shares; // by slot; amount: of half the width, 0 on the other side

    SideField(const IncisedMesh& incised, const StrokeFrame& frame, std::uint32_t incision,
              double width, IncisionSide side)
        : amounts(incised.slots, 0),
          shares(incised.slots, 0)
    {
        std::vector<glm::dvec3> moves(incised.slots, glm::dvec3(0));
        std::vector<double> weights(incised.slots, 0), sums(incised.slots, 0);
        for (const IncisedMesh::Term& term : incised.terms) {
            if (term.incision != incision) continue;
            const double by = static_cast<double>(glm::length(term.move));
            moves[term.slot] += glm::dvec3(term.move);
            weights[term.slot] += by;
            sums[term.slot] += by * static_cast<double>(term.share);
        }
        for (std::size_t s = 0; s < moves.size(); ++s) {
            if (!(weights[s] > 0)) continue;
            const double share = sums[s] / weights[s];
            const bool right = glm::dot(moves[s], frame.right(share)) > 0;
            if (right != (side == IncisionSide::right)) continue;
            amounts[s] = static_cast<float>(std::min(1.0, 2 * glm::length(moves[s]) / width));
            shares[s] = static_cast<float>(share);
        }
    }
};

// The turn that takes one unit direction to another, of a third one.
glm::dvec3 turned_along(const glm::dvec3& v, const glm::dvec3& from, const glm::dvec3& to)
{
    const glm::dvec3 k = glm::cross(from, to);
    const double cosine = glm::dot(from, to);
    if (!(cosine > -0.999)) return v;
    return v * cosine + glm::cross(k, v) + k * (glm::dot(k, v) / (1 + cosine));
}

// Finds the skin on flaps, and the triangles round it.
void find_skin(IncisedFlaps& out, const IncisedMesh& incised)
{
    const Mesh& rest = *incised.rest;
    if (rest.normals.empty() || out.lifted.empty()) return;
    std::vector<char> on_flap(incised.slots, 0);
    for (const IncisedFlaps::Lifted& each : out.lifted) on_flap[each.slot] = 1;
    std::vector<std::uint32_t> moved_of(incised.first_wall_vertex, no_number),
        skin_of(incised.first_wall_vertex, no_number), group_of(incised.slots, no_number);
    std::uint32_t groups = 0;
    for (std::size_t i = 0; i < incised.moved.size(); ++i) {
        const std::uint32_t v = incised.moved[i], slot = incised.slot_of_moved[i];
        if (v >= incised.first_wall_vertex) continue;
        moved_of[v] = static_cast<std::uint32_t>(i);
        if (!on_flap[slot]) continue;
        if (group_of[slot] == no_number) group_of[slot] = groups++;
        skin_of[v] = static_cast<std::uint32_t>(out.skin.size());
        out.skin.push_back(v);
        out.group_of_skin.push_back(group_of[slot]);
    }
    out.group_normals.assign(groups, glm::dvec3(0));
    for (std::size_t f = 0; f < incised.first_wall_face; ++f) {
        const std::uint32_t* const c = rest.corners.data() + rest.face_begin[f];
        const std::size_t count = rest.face_begin[f + 1] - rest.face_begin[f];
        if (std::none_of(c, c + count, [&](std::uint32_t v) { return skin_of[v] != no_number; }))
            continue;
        for (std::size_t k = 2; k < count; ++k) {
            const std::uint32_t corners[3] = {c[0], c[k - 1], c[k]};
            const glm::dvec3 a = rest.positions[corners[0]], b = rest.positions[corners[1]],
                             d = rest.positions[corners[2]];
            for (const std::uint32_t v : corners) {
                out.corners.push_back({v, moved_of[v], skin_of[v]});
                if (skin_of[v] != no_number)
                    out.group_normals[out.group_of_skin[skin_of[v]]] += glm::cross(b - a, d - a);
            }
        }
    }
    for (glm::dvec3& each : out.group_normals) each = flap_unit(each);
}

} // namespace

IncisedFlaps flaps_of(const IncisedMesh& incised, std::span<const Incision> incisions,
                      std::span<const FlapPlace> places)
{
    IncisedFlaps out;
    for (std::size_t f = 0; f < places.size(); ++f) {
        const FlapPlace& place = places[f];
        out.lengths.push_back(0);
        out.backs.emplace_back(0);
        const Incision &a = incisions[place.first], &b = incisions[place.second];
        if (!(a.width > 0) || !(b.width > 0)) continue;
        const StrokeFrame of_a(a), of_b(b);
        const SideField field_a(incised, of_a, place.first, a.width, place.side_of_first),
            field_b(incised, of_b, place.second, b.width, place.side_of_second);
        double most = 0;
        std::size_t tip = 0;
        for (std::size_t s = 0; s < incised.slots; ++s)
            if (const double w = static_cast<double>(field_a.amounts[s] * field_b.amounts[s]);
                w > most)
                most = w, tip = s;
        if (!(most > least_weight)) continue;
        for (std::size_t s = 0; s < incised.slots; ++s) {
            const double w = static_cast<double>(field_a.amounts[s] * field_b.amounts[s]) / most;
            if (!(w > 1e-6)) continue;
            const float sa = field_a.shares[s], sb = field_b.shares[s];
            out.lifted.push_back({static_cast<std::uint32_t>(s),
                                  static_cast<std::uint32_t>(f),
                                  static_cast<float>(lift_weight(w)),
                                  glm::vec3(flap_unit(of_a.normal(static_cast<double>(sa)) +
                                                      of_b.normal(static_cast<double>(sb)))),
                                  {place.first, place.second},
                                  {sa, sb}});
        }
        const auto into = [&](const StrokeFrame& frame, float share, IncisionSide side) {
            return frame.right(static_cast<double>(share)) *
                   (side == IncisionSide::right ? 1.0 : -1.0);
        };
        const glm::dvec3 from_a = into(of_a, field_a.shares[tip], place.side_of_first);
        const glm::dvec3 back =
            flap_unit(from_a + into(of_b, field_b.shares[tip], place.side_of_second));
        out.backs.back() = glm::vec3(back);
        out.lengths.back() =
            std::min(reach_of(a, length_of(a.stroke)), reach_of(b, length_of(b.stroke))) /
            std::max(0.3, glm::dot(back, from_a));
    }
    find_skin(out, incised);
    return out;
}

std::vector<glm::dvec3> lifted_moves(const IncisedMesh& incised, const IncisedFlaps& flaps,
                                     std::span<const double> lifts,
                                     std::span<const IncisionOpening> openings)
{
    std::vector<glm::dvec3> moves(incised.slots, glm::dvec3(0));
    std::vector<double> backs;
    for (std::size_t f = 0; f < lifts.size(); ++f) {
        const double length = flaps.lengths[f], high = std::min(lifts[f], length);
        backs.push_back(most_back * (length - std::sqrt(length * length - high * high)));
    }
    for (const IncisedFlaps::Lifted& each : flaps.lifted) {
        const double lift = lifts[each.flap];
        if (lift == 0) continue;
        double open = 1;
        for (int k = 0; k < 2; ++k)
            open *= share_at(openings[each.incisions[k]], static_cast<double>(each.shares[k]));
        const double weight = lift_weight(open) * static_cast<double>(each.weight);
        moves[each.slot] += weight * (lift * glm::dvec3(each.up) +
                                      backs[each.flap] * glm::dvec3(flaps.backs[each.flap]));
    }
    return moves;
}

std::vector<glm::vec3> turned_normals(const IncisedMesh& incised, const IncisedFlaps& flaps,
                                      std::span<const double> lifts,
                                      std::span<const glm::vec3> positions)
{
    const Mesh& rest = *incised.rest;
    std::vector<glm::vec3> out;
    out.reserve(flaps.skin.size());
    for (const std::uint32_t v : flaps.skin) out.push_back(rest.normals[v]);
    if (std::ranges::all_of(lifts, [](double lift) { return lift == 0; })) return out;
    std::vector<glm::dvec3> now(flaps.group_normals.size(), glm::dvec3(0));
    for (std::size_t t = 0; t + 2 < flaps.corners.size(); t += 3) {
        glm::dvec3 p[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const IncisedFlaps::SkinCorner& c = flaps.corners[t + k];
            p[k] = c.moved == no_number ? rest.positions[c.vertex] : positions[c.moved];
        }
        const glm::dvec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
        for (std::size_t k = 0; k < 3; ++k)
            if (const std::uint32_t s = flaps.corners[t + k].skin; s != no_number)
                now[flaps.group_of_skin[s]] += n;
    }
    for (glm::dvec3& each : now) each = flap_unit(each);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const std::uint32_t g = flaps.group_of_skin[i];
        if (now[g] == glm::dvec3(0) || flaps.group_normals[g] == glm::dvec3(0)) continue;
        out[i] = glm::vec3(turned_along(glm::dvec3(out[i]), flaps.group_normals[g], now[g]));
    }
    return out;
}

} // namespace trivar
