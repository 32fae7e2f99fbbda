// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace trivar {

// Rejected reports wrong data of the user: one sentence that says where, what is wrong and, where
// it helps, what would be right. It is thrown before anything changed.
struct Rejected : std::runtime_error {
    using runtime_error::runtime_error;
};

// Cancelled reports that the user stopped a long operation. Nothing changed.
struct Cancelled : std::runtime_error {
    Cancelled() : runtime_error("cancelled") {}
};

} // namespace trivar
