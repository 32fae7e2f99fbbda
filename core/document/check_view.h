// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"

namespace trivar {

// Throws Rejected for a camera that looks nowhere.
void check_view(const Camera& camera);

} // namespace trivar
