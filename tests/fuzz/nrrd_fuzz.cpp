// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/read_any_volume.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    return trivar::testing::read_any_volume(data, size, "fuzz.nrrd");
}
