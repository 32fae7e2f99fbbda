// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assets/make/texture.h"

namespace make {

// A grey picture that repeats, for masks and heights.
struct NamedPicture {
    std::string name;
    GreyPicture picture;
};
std::vector<NamedPicture> pictures();

void write_pictures(const std::string& folder); // FOLDER/NAME.png

} // namespace make
