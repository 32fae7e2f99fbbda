// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <nlohmann/json_fwd.hpp>

// These functions serve the sources that read lines of a log as JSON.

namespace trivar {

// Reads one JSON object without repeated keys. Throws Rejected.
nlohmann::json parse_object(std::string_view line);
// Throws Rejected if the field exists and is no text.
std::string text_field(const nlohmann::json& object, const std::string& name);
Command command_from(const nlohmann::json& object);

} // namespace trivar
