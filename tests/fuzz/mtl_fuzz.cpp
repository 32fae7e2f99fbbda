// SPDX-License-Identifier: GPL-3.0-or-later
// A material library, and its text as the words that name libraries.
#include "core/base/rejected.h"
#include "core/files/formats.h"
#include "core/files/wavefront/wavefront_names.h"

#include <cstddef>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    // Where names are looked for, and no picture is.
    trivar::FolderFiles files(".");
    trivar::libraries_named(text.substr(0, text.find('\n')), files);
    try {
        trivar::read_mtl({text, "fuzz.mtl", "."});
    } catch (const trivar::Rejected&) {
    }
    return 0;
}
