// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/copied_object.h"
#include "core/commands/edits/edits.h"
#include "core/commands/every_command.h"

namespace trivar {
namespace {

// Does what the commands that give a value to an object check of it.
template <class T> void check_own(const T& value)
{
    if constexpr (is_choice<T>)
        std::visit([](const auto& chosen) { check_own(chosen); }, value);
    else if constexpr (is_optional<T>) {
        if (value) check_own(*value);
    } else if constexpr (std::is_same_v<T, Transform>)
        check_transform(value);
    else if constexpr (requires { check(value); })
        check(value);
}

} // namespace

void check_values(const Object& object)
{
    each_field(object, [](std::string_view, const auto& value, auto&&...) { check_own(value); });
}

} // namespace trivar
