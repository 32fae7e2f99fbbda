// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/drawing/hand_edits.h"
#include "core/drawing/svg.h"
#include "core/drawing/svg_update.h"

#include <cstdlib>

namespace {

// Two layers with a line each, one of them hidden, as the seeds have them.
trivar::DrawingSheet drawing()
{
    std::vector<trivar::Stroke> strokes(2);
    for (std::size_t k = 0; k < 2; ++k) {
        for (int i = 0; i < 4; ++i) {
            const auto x = static_cast<float>(10 * i);
            strokes[k].points.push_back({.at = {x, 10}, .depth = x, .slope = x, .p = {x, 10, 0}});
        }
        strokes[k].id = k + 1;
        strokes[k].hidden = k == 1;
    }
    const trivar::LineStyle style{.taper = 0, .hidden = trivar::HiddenLines::dashed};
    return {{{"bone", trivar::inked(std::vector{strokes[0]}, style)},
             {"skin & hair", trivar::inked(std::vector{strokes[1]}, style)}},
            {64, 48}};
}

} // namespace

// Any bytes are an .svg that a hand edited, or Rejected. A drawing that was written into one is
// found again in it. Written once more, it may find lines that only the new list names; from then
// on nothing changes.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const trivar::SvgParts parts = trivar::svg_parts(drawing());
        const std::string once = trivar::updated_svg(text, parts);
        if (once.empty()) return 0;
        const std::string twice = trivar::updated_svg(once, parts);
        if (trivar::updated_svg(twice, parts) != twice) std::abort();
        if (!trivar::hand_edits_of(once)) std::abort();
    } catch (const trivar::Rejected&) {
    }
    return 0;
}
