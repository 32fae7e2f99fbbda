// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/edits/edits.h"

#include "core/base/rejected.h"
#include "core/document/bases.h"

#include <cmath>
#include <fmt/format.h>
#include <map>

namespace trivar {
namespace {

// Largest id. Every object ever made has an id, except undone ones; this is far beyond what a
// person makes.
constexpr Id last_id = 100000;

} // namespace

std::size_t entry_index(const Document& document, Id id, std::size_t count, int number,
                        std::string_view entries)
{
    if (number < 1 || static_cast<std::size_t>(number) > count)
        throw Rejected(fmt::format("{} has {} {}, and none of number {}", named(document, id),
                                   count, entries, number));
    return static_cast<std::size_t>(number - 1);
}

const Tiling& tiling_of(const Document& document, Id id)
{
    const Object& layer = object(document, id);
    if (!layer.tiles)
        throw Rejected(named(id, layer) + " is no layer of tiles; paint with it first");
    return *layer.tiles;
}

Document with_added(Document document, Object object)
{
    if (document.next_id >= last_id)
        throw Rejected(fmt::format("a scene holds at most {} objects in its life", last_id));
    document.objects.set(document.next_id, make_ref(std::move(object)));
    ++document.next_id;
    return document;
}

std::set<Id> distinct(const Document& document, const std::vector<Id>& ids)
{
    if (ids.empty()) throw Rejected("field \"objects\" names no object");
    std::set<Id> result;
    for (const Id id : ids) {
        object(document, id);
        if (!result.insert(id).second)
            throw Rejected(fmt::format("field \"objects\" names object {} twice", id));
    }
    return result;
}

std::set<Id> with_contents(const Document& document, std::set<Id> ids)
{
    for (const auto& [id, ref] : document.objects)
        for (Id parent = ref->parent; parent != 0; parent = object(document, parent).parent)
            if (ids.contains(parent)) {
                ids.insert(id);
                break;
            }
    return ids;
}

std::set<Id> depending_on(const Document& document, const std::set<Id>& ids)
{
    std::map<Id, std::vector<Id>> above;
    for (const auto& [other, ref] : document.objects) {
        for (const BaseUse& each : bases_of(*ref)) above[each.base].push_back(other);
        for (const Id lattice : lattices_round(document, other)) above[lattice].push_back(other);
    }
    std::set<Id> result(ids);
    std::vector<Id> open(ids.begin(), ids.end());
    while (!open.empty()) {
        const Id lower = open.back();
        open.pop_back();
        for (const Id upper : above[lower])
            if (result.insert(upper).second) open.push_back(upper);
    }
    return result;
}

void refuse_other_kind(const Document& document, Id id, std::string_view help)
{
    throw Rejected(fmt::format("field \"object\": {} is not {}", named(document, id),
                               help.substr(std::string_view("id of ").size())));
}

void check_has_volume(const Object& o, Id id)
{
    if (!o.stroke && !kind_of(o).has_cage)
        throw Rejected(fmt::format("object {} ({}) has no volume; place it on a stroke, or put a "
                                   "lattice round it",
                                   id, o.name));
}

void check_bent(const Document& document, Id id)
{
    if (!object(document, id).stroke && lattices_round(document, id).empty())
        throw Rejected(named(document, id) +
                       " is neither placed on a stroke nor in a lattice, so nothing bends it");
}

void check_has_surface(const Document& document, Id id, std::string_view verb)
{
    if (!kind_of(document, id).has_surface)
        throw Rejected(fmt::format("{} has no surface of its own; {} the objects in it",
                                   named(document, id), verb));
}

void check_placed(const Object& o, Id id)
{
    if (!o.stroke) throw Rejected(named(id, o) + " is not placed; use place first");
}

void check_transform(const Transform& transform)
{
    for (int i = 0; i < 3; ++i)
        if (std::abs(transform.scale[i]) < 1e-9)
            throw Rejected("field \"scale\" is 0 along an axis, which would flatten the object");
}

Transform decomposed(const glm::dmat4& matrix)
{
    const glm::dvec3 x(matrix[0]), y(matrix[1]), z(matrix[2]);
    Transform result;
    result.translation = glm::dvec3(matrix[3]);
    result.scale = {glm::length(x), glm::length(y), glm::length(z)};
    if (glm::dot(glm::cross(x, y), z) < 0) result.scale.x = -result.scale.x;
    // Solves Rz Ry Rx as in Transform::matrix for the angles, from the orthonormalised columns.
    const glm::dvec3 r0 = x / result.scale.x;
    const glm::dvec3 r1 =
        glm::normalize(y / result.scale.y - r0 * glm::dot(r0, y) / result.scale.y);
    const glm::dvec3 r2 = glm::cross(r0, r1);
    const double sin_y = glm::clamp(-r0.z, -1.0, 1.0);
    if (std::abs(sin_y) < 1 - 1e-12)
        result.rotation_deg = {std::atan2(r1.z, r2.z), std::asin(sin_y), std::atan2(r0.y, r0.x)};
    else // X and Z turn about the same axis: all of it is given to X
        result.rotation_deg = {std::copysign(1.0, sin_y) * std::atan2(r1.x, r1.y), std::asin(sin_y),
                               0};
    result.rotation_deg = glm::degrees(result.rotation_deg);
    return result;
}

} // namespace trivar
