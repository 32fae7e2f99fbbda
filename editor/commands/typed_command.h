// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/log.h"

#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// A command as a person types it. Either a line of the scene file, {"do":"rename",...}, or
//
//   rename object=Snake name=Viper
//   transform object=3 translation=[0,0,1.5]
//   edit_placement object=Snake parameters.width=0.24
//
// Values are JSON or bare words, dots reach into what is nested, objects go by name or number. In
// the short form a transform, a material, a placement and the picture keep what is not typed.
LogLine typed_line(std::string_view text, const Document& document); // throws Rejected

// The inverse, in the short form.
std::string typed_text(const Command& command, const Document& document);

// The command with other values of some fields, each as JSON; objects by name or number. Where that
// changes the objects, values that are not given are those of the new objects. Throws Rejected.
struct TypedValue {
    std::string field, json; // "parameters.width", "0.24"
};
Command typed_values(const Command& otherwise, const std::vector<TypedValue>& values,
                     const Document& document);

// Whether a field of that name holds the number of an object, or those of several.
bool names_object(std::string_view field);
bool names_objects(std::string_view field);

// A Completion is the text with its last word continued as far as it is certain, and the possible
// next words: verbs, then the fields of the verb, then names of objects.
struct Completion {
    std::string text;
    std::vector<std::string> words; // more than one: the choice that is left
};
Completion completed(std::string_view text, const Document& document);

} // namespace trivar
