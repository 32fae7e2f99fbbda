// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

#include <functional>

// The parameters of a document are the numbers that change in time where they have keys. Their
// names are the fields of the commands that set them, joined by dots; lists and vectors are
// numbered from 0 or named x, y, z, w: "transform.translation.z", "placement.width_profile.2.y",
// "shaping.0.press.radius". Switches count as 0 and 1, choices from 0 in the order in which they
// are listed. Files, letters, strokes, the choice of control points, the size of pictures and
// values that themselves describe a course in time are no parameters.

namespace trivar {

struct Parameter {
    enum class Kind { number, whole, choice, on_off };
    std::string name;
    double value = 0;
    double lo = 0, hi = 0; // inclusive
    Kind kind = Kind::number;
    std::vector<std::string_view> choices = {}; // of a choice, by value
    Unit unit = Unit::none;
    std::string_view yes = "on", no = "off"; // the words for a switch's values
    // Whether there is nothing between two values, so that each stays until the next key.
    bool stays() const { return kind != Kind::number; }
    bool operator==(const Parameter&) const = default;
};

// The track in the form that suits the parameter: with whole values and steps where the parameter
// stays.
Track as_taken(Track track, const Parameter& parameter);

// All parameters that the object has at present, in the order of the panels.
std::vector<Parameter> parameters(const Object& object);
// The parameters of the scene itself: "render.exposure", "camera.NAME.eye.x" of a kept view.
std::vector<Parameter> scene_parameters(const Document& document);

// A new value for some parameters; empty where the value stays.
using NewValue = std::function<std::optional<double>(const std::string& name)>;
// Values beyond a range are limited to its end, and no value makes a scale 0. Names that do not
// exist are ignored.
Object with_values(Object object, const NewValue& value);
Document with_scene_values(Document document, const NewValue& value);

// The document with the values of its tracks at that frame; objects without tracks keep their
// pointer. A second call changes nothing. O(#numbers of objects with tracks).
Document document_at(const Document& document, double frame);

} // namespace trivar
