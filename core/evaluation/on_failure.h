// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace trivar {

// OnFailure says how an evaluation treats an exception, other than Cancelled, of a step of one
// object. It passes the exception on, so that a test stops at it; or it leaves the step out, and
// the object says so in its notices.
enum class OnFailure : std::uint8_t { pass_on, leave_out };

} // namespace trivar
