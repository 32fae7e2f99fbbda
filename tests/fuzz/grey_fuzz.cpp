// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/files/pictures/image.h"
#include "core/mesh/height_sheet.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

// Any bytes that begin as a PNG or a JPEG are a picture of numbers, as masks and heights read it,
// or Rejected: as many as it says, all of them finite, also where they are read between pixels.
// The other kinds are read in a process of their own; manual_damaged_pictures damages them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0 || (data[0] != 0x89 && data[0] != 0xff)) return 0;
    try {
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        const trivar::GreyImage image = trivar::PictureReader().read_grey_bytes(bytes, "fuzz");
        if (image.values.size() !=
            static_cast<std::size_t>(image.size_px.x) * static_cast<std::size_t>(image.size_px.y))
            std::abort();
        for (const float value : image.values)
            if (!std::isfinite(value)) std::abort();
        for (const double at : {-1e300, -0.3, 0.0, 0.5, 1.0, 7.1, 1e300})
            for (const trivar::ImageEdge edge :
                 {trivar::ImageEdge::repeat, trivar::ImageEdge::stay})
                if (!std::isfinite(trivar::grey_at(image, {at, -at}, edge))) std::abort();
        const trivar::Mesh sheet = trivar::height_sheet(image, {.height = 0.5, .segments = 3});
        for (const glm::vec3& n : sheet.normals)
            if (!(std::abs(glm::length(n) - 1) < 1e-3f)) std::abort();
    } catch (const trivar::Rejected&) {
        return 0;
    }
    return 0;
}
