// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/document_digest.h"
#include "core/scene/log.h"

#include <cstdint>
#include <cstdlib>

// Any bytes are a log that is read and applied, or Rejected. What was accepted is written and
// must read back to the same document.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(data, data + size);
    try {
        const trivar::History history = trivar::replay(trivar::read_log(text, "fuzz"));
        const std::string again = trivar::log_text(history);
        const trivar::History copy = trivar::replay(trivar::read_log(again, "again"));
        if (trivar::digest(copy.document()) != trivar::digest(history.document())) std::abort();
        if (trivar::log_text(copy) != again) std::abort();
    } catch (const trivar::Rejected&) {
        return 0;
    }
    return 0;
}
