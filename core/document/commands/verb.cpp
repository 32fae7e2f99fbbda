// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/command.h"

namespace trivar {

std::string_view verb(const Command& command)
{
    return std::visit([]<class C>(const C&) { return C::verb; }, command);
}

} // namespace trivar
