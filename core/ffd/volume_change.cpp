// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/volume_change.h"

#include "core/base/parallel.h"

namespace trivar {

std::vector<float> volume_change(const Mesh& mesh, const Embedding& embedding,
                                 const Lattice& lattice)
{
    std::vector<float> out(mesh.vertex_count());
    constexpr std::size_t block = 512;
    parallel_blocks(out.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const auto at = deform(glm::dvec3(mesh.positions[v]), embedding, lattice);
            out[v] = static_cast<float>(glm::determinant(at.jacobian));
        }
    });
    return out;
}

} // namespace trivar
