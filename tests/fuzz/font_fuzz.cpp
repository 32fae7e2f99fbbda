// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/mesh/closed_body.h"
#include "core/text/text_shape.h"

#include <cstdlib>

// Makes a body of a font's letters, closed if they are: accents, two directions, missing ones, with
// a bevel.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    using namespace trivar;
    try {
        const Font font(std::string(reinterpret_cast<const char*>(data), size), 0, "fuzz.ttf");
        const TextBody body = text_body({.text = "AB f\u00e9\n\u05d0\u05d1 \u0628\u0629",
                                         .bevel = 0.01,
                                         .bevel_steps = 2,
                                         .tolerance = 0.02,
                                         .max_edge = 0.5},
                                        font);
        if (body.mesh.face_count() > 0 && !is_closed_body(body.mesh)) std::abort();
    } catch (const Rejected&) {
    }
    return 0;
}
