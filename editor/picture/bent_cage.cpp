// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/bent_cage.h"

namespace trivar {

Ref<Lattice> bent_cage(const Evaluation& evaluated, const Document& document,
                       const EvaluatedObject& of)
{
    constexpr std::size_t most_points = 20000; // of which each is bent anew in every frame
    const Ref<Lattice> own(of.placement, &of.placement->volume);
    const bool known = document.objects.contains(of.id); // the evaluation may be a moment behind
    if (!known || own->displacement.points.size() > most_points) return own;
    const std::vector<Id> lattices = lattices_round(document, of.id);
    if (lattices.empty()) return own;
    Lattice cage = *own;
    const std::array<Knots, 3>& axes = cage.displacement.axes;
    for (const Id id : lattices) {
        const auto round = evaluated.objects.find(id);
        if (round == evaluated.objects.end() || !round->second->placement) continue;
        const Placement& bends = *round->second->placement;
        std::vector<PointMove> moves;
        for (int i = 0; i < axes[0].count(); ++i)
            for (int j = 0; j < axes[1].count(); ++j)
                for (int k = 0; k < axes[2].count(); ++k) {
                    const glm::dvec3 p = control_point(cage, i, j, k);
                    const glm::dvec3 uvw(bends.embedding.to_uvw * glm::dvec4(p, 1));
                    moves.push_back({{i, j, k}, evaluate(bends.volume, uvw).value - p});
                }
        cage = moved(std::move(cage), moves);
    }
    return make_ref(std::move(cage));
}

} // namespace trivar
