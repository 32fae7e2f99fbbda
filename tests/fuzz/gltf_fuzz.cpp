// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/read_any.h"

#include <cstring>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    // One program for both containers: the first bytes tell.
    const bool binary = size >= 4 && std::memcmp(data, "glTF", 4) == 0;
    return trivar::testing::read_any(data, size, binary ? "fuzz.glb" : "fuzz.gltf");
}
