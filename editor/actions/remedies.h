// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <optional>
#include <string>
#include <string_view>

namespace trivar {

// A Remedy is the command that a notice of an object advises.
struct Remedy {
    std::string words; // on its button
    Command command;
};

// Empty where no single command can do it.
std::optional<Remedy> remedy_of(const Document& document, Id id, std::string_view notice);

} // namespace trivar
