// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace trivar {

// Their data is wrong: one sentence for the user that says where, what is wrong and, where it
// helps, what would be right. Thrown before anything changed.
struct Rejected : std::runtime_error {
    using runtime_error::runtime_error;
};

// The user stopped a long operation. Nothing changed.
struct Cancelled : std::runtime_error {
    Cancelled() : runtime_error("cancelled") {}
};

} // namespace trivar
