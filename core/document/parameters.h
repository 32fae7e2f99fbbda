// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

#include <functional>

// The numbers of a document that change in time where they have keys, by name: the fields of the
// commands that set them, joined by dots, lists and vectors by numbers from 0 and x, y, z, w:
// "transform.translation.z", "placement.width_profile.2.y", "shaping.0.press.radius". Switches
// count as 0 and 1, choices from 0 in the order in which they are listed. Files, letters, strokes,
// which control points were moved, the size of pictures and what itself says how something goes in
// time stay as they are.

namespace trivar {

struct Parameter {
    enum class Kind { number, whole, choice, on_off };
    std::string name;
    double value = 0;
    double lo = 0, hi = 0; // inclusive
    Kind kind = Kind::number;
    std::vector<std::string_view> choices = {}; // of a choice, by value
    Unit unit = Unit::none;
    std::string_view yes = "on", no = "off"; // of a switch, what it says
    // There is nothing between two values: each stays until the next key.
    bool stays() const { return kind != Kind::number; }
    bool operator==(const Parameter&) const = default;
};

// The track as it counts for that parameter: where this stays, whole values and steps between.
Track as_taken(Track track, const Parameter& parameter);

// All that the object has at present, in the order of the panels.
std::vector<Parameter> parameters(const Object& object);
// Those of the scene itself: "render.exposure", "camera.NAME.eye.x" of a kept view.
std::vector<Parameter> scene_parameters(const Document& document);

// A new value for some of them: nothing where it stays.
using NewValue = std::function<std::optional<double>(const std::string& name)>;
// Values beyond a range are taken to its end, and none makes a scale 0. Names that are not there
// count for nothing.
Object with_values(Object object, const NewValue& value);
Document with_scene_values(Document document, const NewValue& value);

// The document as its tracks have it at that frame; objects without tracks keep their pointer. To
// do it again changes nothing. O(numbers of what has tracks).
Document document_at(const Document& document, double frame);

} // namespace trivar
