// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/codec/codec.h"

namespace trivar {

// The codec for picture files. The first call opens trivar-codec.so, which takes a seventh of a
// second. Throws Rejected where that file is missing, with the rest of a sentence.
const Codec& picture_codec();

} // namespace trivar
