// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/document.h"

#include "core/base/digest.h"
#include "core/base/rejected.h"
#include "core/document/fields/object_fields.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trivar {
namespace {

// Exact for quarter turns, so that a model turned by 90 degrees keeps its coordinates' bits.
struct Turn {
    double cosine, sine;
};
Turn turn(double degrees)
{
    const double quarters = degrees / 90;
    if (quarters == std::floor(quarters) && std::abs(quarters) < 1e9) {
        static constexpr std::array<Turn, 4> exact{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        const auto step = static_cast<long long>(quarters) % 4;
        return exact[static_cast<std::size_t>((step + 4) % 4)];
    }
    const double radians = glm::radians(degrees);
    return {std::cos(radians), std::sin(radians)};
}

template <class T> void add(Digest& digest, const T& value)
{
    if constexpr (Nested<T>)
        each_field(value, [&](std::string_view name, const auto& field, std::string_view = {},
                              const Rule& rule = {}) {
            if (rule.later) { // named, since it may be missing
                if (field == std::remove_cvref_t<decltype(field)>{}) return;
                digest.add_text(name);
            }
            add(digest, field);
        });
    else if constexpr (std::is_convertible_v<T, std::string_view>)
        digest.add_text(value);
    else if constexpr (is_optional<T>) {
        digest.add(value.has_value());
        if (value) add(digest, *value);
    } else if constexpr (is_list<T>) {
        digest.add(static_cast<std::uint64_t>(value.size()));
        if constexpr (is_list<typename T::value_type> || Nested<typename T::value_type>)
            for (const auto& entry : value) add(digest, entry);
        else
            digest.add(std::span<const typename T::value_type>(value));
    } else
        digest.add(value);
}

void add(Digest& digest, const Object& object)
{
    add(digest, object.name);
    digest.add(static_cast<std::uint64_t>(object.source.index()));
    std::visit(
        [&](const auto& source) {
            if constexpr (!std::is_same_v<decltype(source), const GroupShape&>) add(digest, source);
        },
        object.source);
    add(digest, object.transform);
    digest.add(object.surfacing.has_value());
    if (object.surfacing) {
        digest.add(object.surfacing->base_color);
        digest.add(object.surfacing->metallic);
        digest.add(object.surfacing->roughness);
        if (const Solid solid = object.surfacing->solid; solid != Solid::none) digest.add(solid);
    }
    digest.add(object.parent);
    digest.add(object.hidden);
    if (object.locked) digest.add_text("locked"); // there were scenes without it
    digest.add(object.placement.has_value());
    if (object.placement) {
        add(digest, object.placement->sketch);
        add(digest, object.placement->parameters);
        add(digest, object.placement->onto);
        if (object.placement->round) { // there were scenes without it
            digest.add_text("round");
            digest.add(object.placement->level);
        }
    }
    if (!object.shaping.empty()) { // there were scenes without it
        digest.add_text("shaping");
        for (const Ref<VolumeEdit>& edit : object.shaping) add(digest, *edit);
    }
    if (object.travel != Travel{}) { // there were scenes without it
        digest.add_text("travel");
        add(digest, object.travel);
    }
    if (object.playing != Playing{}) { // there were scenes without it
        digest.add_text("playing");
        add(digest, object.playing);
    }
    if (object.refining) { // there were scenes without it
        digest.add_text("refining");
        add(digest, *object.refining);
    }
    if (!object.tracks.empty()) { // there were scenes without it
        digest.add_text("tracks");
        add(digest, object.tracks);
    }
}

} // namespace

glm::dmat4 Transform::matrix() const
{
    const auto [cx, sx] = turn(rotation_deg.x);
    const auto [cy, sy] = turn(rotation_deg.y);
    const auto [cz, sz] = turn(rotation_deg.z);
    // The columns of Rz Ry Rx.
    const glm::dvec3 x{cy * cz, cy * sz, -sy};
    const glm::dvec3 y{sx * sy * cz - cx * sz, sx * sy * sz + cx * cz, sx * cy};
    const glm::dvec3 z{cx * sy * cz + sx * sz, cx * sy * sz - sx * cz, cx * cy};
    return {glm::dvec4(x * scale.x, 0), glm::dvec4(y * scale.y, 0), glm::dvec4(z * scale.z, 0),
            glm::dvec4(translation, 1)};
}

const Object& object(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    if (found == document.objects.end()) throw Rejected("there is no object " + std::to_string(id));
    return *found->second;
}

bool visible(const Document& document, Id id)
{
    for (; id != 0; id = object(document, id).parent)
        if (object(document, id).hidden) return false;
    return true;
}

bool locked(const Document& document, Id id)
{
    for (; id != 0; id = object(document, id).parent)
        if (object(document, id).locked) return true;
    return false;
}

std::vector<Id> in_row_order(const Document& document)
{
    std::vector<Id> ids, arranged(*document.rows);
    ids.reserve(document.objects.size());
    for (const Id id : arranged)
        if (document.objects.contains(id)) ids.push_back(id);
    std::sort(arranged.begin(), arranged.end());
    for (const auto& [id, ref] : document.objects)
        if (!std::binary_search(arranged.begin(), arranged.end(), id)) ids.push_back(id);
    return ids;
}

glm::dmat4 to_world(const Document& document, Id id)
{
    glm::dmat4 matrix(1);
    for (; id != 0; id = object(document, id).parent)
        matrix = object(document, id).transform.matrix() * matrix;
    return matrix;
}

std::string digest(const Document& document)
{
    Digest digest;
    for (const auto& [id, ref] : document.objects) {
        digest.add(id);
        add(digest, *ref);
    }
    digest.add(document.next_id);
    for (const auto& [name, camera] : document.bookmarks) {
        digest.add_text(name);
        add(digest, camera);
    }
    add(digest, *document.render);
    if (!document.rows->empty()) add(digest, *document.rows);
    if (document.time != Time{}) { // there were scenes without it
        digest.add_text("time");
        add(digest, document.time);
    }
    if (!document.tracks->empty()) {
        digest.add_text("tracks");
        add(digest, *document.tracks);
    }
    return digest.hex();
}

} // namespace trivar
