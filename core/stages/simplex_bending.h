// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/part.h"
#include "core/simplex/simplex_rows.h"
#include "core/simplex/simplex_volume.h"

namespace trivar {

// A TetrahedraInWorld is a volume of tetrahedra where it stands.
struct TetrahedraInWorld {
    Ref<SimplexVolume> volume;
    glm::dmat4 to_world{1};
    bool operator==(const TetrahedraInWorld&) const = default;
};

// Returns where such a volume moves a point of the world.
glm::dvec3 bent(const TetrahedraInWorld& volume, const glm::dvec3& p_world);

// A SimplexBinding is a mesh bound to the functions of a volume. Where the volume has cuts, the
// mesh is cut there, too.
struct SimplexBinding {
    SimplexBinding(const Ref<Mesh>& from, const glm::dmat4& to_domain,
                   std::span<const Ref<SimplexBasis<3>>> layers);
    Ref<Mesh> mesh;
    std::vector<glm::vec3> in_domain; // #V, where functions are taken
    SimplexRows rows;
};

// A SimplexBending deforms the same parts again and again while a volume changes its control
// points, and binds their vertices to it only once: about 4 us per vertex, then as long as
// SimplexRows::displaced takes. Normals and tangents follow by the exact derivative. A part of
// which no vertex is reached by a displacement stays as it is, to the bit.
class SimplexBending {
public:
    // Parts that are deformed between begin() and end() are remembered for the next time.
    void begin() { used_.clear(); }
    Part operator()(const Part& part, const TetrahedraInWorld& volume);
    void end() { bound_ = std::move(used_); }
    // Reach counts the vertices of all parts that were bent last: those in the domain, and beyond
    // it.
    struct Reach {
        std::size_t points = 0, outside = 0;
    };
    Reach reach() const;

private:
    struct BoundPart {
        Part part;
        std::vector<Ref<SimplexBasis<3>>> layers;
        glm::dmat4 to_world{1};
        Lazy<SimplexBinding> binding;
    };
    std::vector<BoundPart> bound_, used_;
};

} // namespace trivar
