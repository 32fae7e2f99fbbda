// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/bending.h"

#include <algorithm>

namespace trivar {

Part in_volume(Part part, const Embedding& embedding, const Ref<Lattice>& volume,
               const Lazy<Deformer>& deformer, const Ref<Part>& inner)
{
    const Lazy<Ref<Mesh>> out([=] { return make_ref((*deformer)(*volume)); });
    part.to_world = glm::dmat4(1);
    part.bent = make_ref(Deformation{embedding, volume, out, inner});
    return part;
}

Lazy<Deformer> sorted_into(const Lattice& volume, const Part& part, const Embedding& embedding)
{
    return Lazy<Deformer>([=, axes = volume.displacement.axes] {
        return Deformer(part.before_volume(), embedding, axes);
    });
}

Part Bending::operator()(const Part& part, const Embedding& embedding, const Ref<Lattice>& volume,
                         const Ref<Part>& inner)
{
    const std::array<Knots, 3>& axes = volume->displacement.axes;
    const auto found = std::ranges::find_if(sorted_, [&](const SortedPart& s) {
        return s.part == part && s.embedding == embedding && s.axes == axes;
    });
    used_.push_back(found != sorted_.end()
                        ? *found
                        : SortedPart{part, embedding, axes, sorted_into(*volume, part, embedding)});
    return in_volume(part, embedding, volume, used_.back().deformer, inner);
}

} // namespace trivar
