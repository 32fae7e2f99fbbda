// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/command_nature.h"
#include "core/document/document.h"

#include <string>
#include <vector>

namespace trivar {

// A StepTitle says what a step did, as a person would say it: "Width of Snake" and "0.24 m".
struct StepTitle {
    std::string words;
    std::string number; // the most important number, with its unit; empty: there is none
    std::string text() const { return number.empty() ? words : words + " " + number; }
    bool operator==(const StepTitle&) const = default;
};

// StepDocuments are the documents before and after a command, for its title.
struct StepDocuments {
    const Document& before;
    const Document& after;

    std::string made() const;       // name of the first object that the command added
    const Object* was(Id id) const; // null: the object did not exist before
    const Object* is(Id id) const;  // null: the object does not exist now
};

// The name of an object, or "object 7" where there is none.
std::string name_in(const Document& document, Id id);
// "Snake", "Snake and Box", "3 objects".
std::string names_in(const Document& document, const std::vector<Id>& ids);

} // namespace trivar
