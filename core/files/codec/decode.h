// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/codec/codec.h"

namespace trivar {

// What stands behind the door. None of these throws.
DecodeResult decode_picture(const DecodeTask& task, const TakeRows& take);

} // namespace trivar
