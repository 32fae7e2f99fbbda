// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/codec/codec.h"

#include <cstdint>
#include <span>

namespace trivar {

// Decode like Codec::decode, but in this process and silently, with libpng and libjpeg, which every
// browser trusts with files of strangers. The head was found right before (kinds.h). They may throw
// Rejected, with the rest of a sentence.
DecodeResult png_pixels(const DecodeTask& task, const TakeRows& take);
DecodeResult jpeg_pixels(const DecodeTask& task, const TakeRows& take);

// A PNG file, RGBA, with tags as its text chunks: 8 bits a channel or 16.
std::string png_file(const EncodeTask& task);

} // namespace trivar
