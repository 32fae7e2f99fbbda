// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/export/animated_files.h"

#include <cstdint>
#include <cstdlib>

// Any bytes are the claims of a file that moves, or Rejected. What was read can be told, is written
// and must read back the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        const trivar::FilmCertificate read =
            trivar::film_certificate_from_json(std::string(data, data + size));
        trivar::summary(read);
        trivar::not_certified(read);
        const std::string text = trivar::to_json(read);
        if (trivar::to_json(trivar::film_certificate_from_json(text)) != text) std::abort();
    } catch (const trivar::Rejected&) {
        return 0;
    }
    return 0;
}
