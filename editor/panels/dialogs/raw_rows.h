// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/files/volume_offer.h"
#include "ui/theme.h"

namespace trivar {

inline constexpr int raw_row_count = 6; // of a file without a head

// Draws rows for facts that files of volume data lack: how the samples of a file without a head
// lie, and how far apart samples are. Returns whether they are to be read again.
bool draw_raw_rows(const ui::Theme& theme, VolumeOffer& offer);

} // namespace trivar
