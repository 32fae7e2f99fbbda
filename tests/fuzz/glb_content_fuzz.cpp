// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/certificate/certificate.h"
#include "core/ffd/lattice.h"
#include "core/files/formats.h"
#include "core/files/gltf/glb_content.h"
#include "core/files/gltf/glb_differences.h"
#include "core/mesh/primitives.h"

#include <cstdint>
#include <cstdlib>

namespace {

// A bent box: what the seed is an export of.
const trivar::Part& bent_box()
{
    static const trivar::Part part = [] {
        const trivar::Knots knots = trivar::Knots::uniform(3, 4);
        trivar::Lattice lattice = trivar::lattice_at_rest({knots, knots, knots}, glm::dmat4(1));
        lattice.displacement.points[5] = {0.1, 0.2, 0.3};
        trivar::Part out{.rest = trivar::make_ref(trivar::box_mesh({1, 1, 1}, {1, 1, 1}))};
        out.bent = trivar::make_ref(trivar::Deformation{
            {}, trivar::make_ref(std::move(lattice)), trivar::Lazy<trivar::Ref<trivar::Mesh>>([] {
                return trivar::Ref<trivar::Mesh>();
            })});
        return out;
    }();
    return part;
}

// Returns the file that others are compared with.
const std::string& plain_box()
{
    static const std::string bytes =
        trivar::write_glb(trivar::single_mesh_model("box", trivar::box_mesh({1, 1, 1}, {1, 1, 1})));
    return bytes;
}

} // namespace

// Any bytes are a file that can be compared and whose claim can be looked at, or Rejected. A
// certificate that was read is written and must read back the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        const std::string bytes(data, data + size);
        if (trivar::glb_differences(bytes, plain_box()).size() > 6) std::abort();
        const trivar::GlbContent content = trivar::glb_content_of(bytes, "fuzz");
        for (const trivar::GlbContent::Node& node : content.nodes) {
            for (const std::uint32_t corner : node.corners)
                if (corner >= node.positions.size()) std::abort();
            trivar::sampled(bent_box(), node.positions, node.corners, 2);
        }
        const std::string text = trivar::to_json(trivar::certificate_from_json(content.extras));
        if (trivar::to_json(trivar::certificate_from_json(text)) != text) std::abort();
    } catch (const trivar::Rejected&) {
        return 0;
    }
    return 0;
}
