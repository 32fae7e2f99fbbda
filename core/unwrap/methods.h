// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

// The method by which charts are laid flat.
enum class UnwrapMethod {
    conformal, // keeps angles
    rigid,     // keeps lengths as well as it can, and angles less
};

} // namespace trivar
