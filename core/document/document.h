// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/base/render_settings.h"
#include "core/document/object.h"
#include "core/document/object_map.h"

#include <map>
#include <string>
#include <vector>

namespace trivar {

// Time holds the frames of a scene. The present frame is not part of the scene.
struct Time {
    int first_frame = 1, last_frame = 240;
    double frames_per_second = 24;
    bool operator==(const Time&) const = default;
};

// A Document holds all causes and no effects. Copies share what they have in common.
struct Document {
    ObjectMap objects;
    Id next_id = 1;
    std::map<std::string, Camera> kept_views;
    Ref<RenderSettings> render = make_ref(RenderSettings{});
    Time time = {};
    Ref<std::vector<Track>> tracks = make_ref(std::vector<Track>{}); // of the scene's own numbers
    // The order of the outliner's rows as a person arranged it; all other objects follow by id.
    Ref<std::vector<Id>> rows = make_ref(std::vector<Id>{});
    // Whether two documents share everything: what they have in common is the same object in
    // memory, not only equal. O(#objects).
    bool operator==(const Document&) const = default;
};

// The object with that id. Throws Rejected, naming the id, where there is none.
const Object& object(const Document& document, Id id);
inline const ObjectKind& kind_of(const Object& object)
{
    return std::visit(
        []<class Shape>(const Shape&) -> const ObjectKind& { return object_kind<Shape>; },
        object.source);
}
inline const ObjectKind& kind_of(const Document& document, Id id) // throws as object() does
{
    return kind_of(object(document, id));
}
// Returns the shape of an object; null: there is no such object, or it is of another kind.
template <class Shape> const Shape* made_of(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    return found == document.objects.end() ? nullptr : std::get_if<Shape>(&found->second->source);
}
bool is_lattice(const Document& document, Id id); // false also where there is no such object
// "object 3 (Snake)", for a sentence; a long name is cut.
std::string named(Id id, const Object& object);
std::string named(const Document& document, Id id);
bool visible(const Document& document, Id id); // neither the object nor a parent is hidden
bool locked(const Document& document, Id id);  // the object or a parent is locked
// The ids of the lattices in which an object stands, the innermost first.
std::vector<Id> lattices_round(const Document& document, Id id);
// All objects in the order of the outliner's rows, in groups or not.
std::vector<Id> in_row_order(const Document& document);
// The object's transform with those of its parents. A placed object lies in the world without it.
glm::dmat4 to_world(const Document& document, Id id);

} // namespace trivar
