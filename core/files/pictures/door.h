// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/codec/codec.h"

namespace trivar {

// What knows picture files. Opens trivar-codec.so when it is called first, which takes a seventh of
// a second. Throws Rejected where that file is missing, the rest of a sentence.
const Codec& picture_codec();

} // namespace trivar
