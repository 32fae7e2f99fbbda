// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/command_line/silhouette.h"

namespace CLI {
class App;
}

namespace trivar {

// Adds `trivar silhouette` with its options, which are written to `o`.
CLI::App* add_silhouette(CLI::App& app, SilhouetteCommand& o);

} // namespace trivar
