// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/codec/codec.h"

namespace trivar {

// The function that trivar-codec.so exports. It throws nothing.
DecodeResult decode_picture(const DecodeTask& task, const TakeRows& take);

} // namespace trivar
