// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/preferences/preferences.h"

#include <cstdint>
#include <cstdlib>

// Any bytes are preferences, perhaps with odd ones; what they are read as is written as a text that
// is read as the same without any.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const trivar::ReadPreferences read = trivar::read_preferences(
        size == 0 ? std::string_view()
                  : std::string_view(reinterpret_cast<const char*>(data), size));
    const std::string text = text_of(read.preferences);
    const trivar::ReadPreferences again = trivar::read_preferences(text);
    if (!again.odd.empty() || text_of(again.preferences) != text) std::abort();
    return 0;
}
