// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"
#include "core/document/object.h"
#include "core/document/object_map.h"
#include "core/document/render_settings.h"

#include <map>
#include <string>
#include <vector>

namespace trivar {

// The frames of a scene. Which of them is the present one is no part of it.
struct Time {
    int first_frame = 1, last_frame = 240;
    double frames_per_second = 24;
    bool operator==(const Time&) const = default;
};

// All causes, no effects. Copies share what they have in common.
struct Document {
    ObjectMap objects;
    Id next_id = 1;
    std::map<std::string, Camera> kept_views;
    Ref<RenderSettings> render = make_ref(RenderSettings{});
    Time time = {};
    Ref<std::vector<Track>> tracks = make_ref(std::vector<Track>{}); // of its own numbers
    // The order of the outliner's rows where it was arranged; the others follow by id.
    Ref<std::vector<Id>> rows = make_ref(std::vector<Id>{});
    // Whether nothing of one was made anew in the other: what they have in common is the same, not
    // just equal. O(number of objects).
    bool operator==(const Document&) const = default;
};

// The object, or Rejected naming the id.
const Object& object(const Document& document, Id id);
bool is_lattice(const Document& document, Id id); // false also where there is no such object
// "object 3 (Snake)", for a sentence; a long name is cut.
std::string named(Id id, const Object& object);
std::string named(const Document& document, Id id);
bool visible(const Document& document, Id id); // neither it nor a parent is hidden
bool locked(const Document& document, Id id);  // it or a parent is
// Ids of the lattices that an object stands in, the innermost first.
std::vector<Id> lattices_round(const Document& document, Id id);
// All objects in the order of the outliner's rows, whatever is in which group.
std::vector<Id> in_row_order(const Document& document);
// The object's transform under its parents'. What is placed lies in the world without it.
glm::dmat4 to_world(const Document& document, Id id);

} // namespace trivar
