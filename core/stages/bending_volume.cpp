// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/bending_volume.h"

#include "core/document/document.h"
#include "core/ffd/prolong.h"
#include "core/placement/placement.h"
#include "core/tetrahedra/tetrahedra_shaper.h"

namespace trivar {
namespace {

Lattice bent(Lattice cage, const BendingVolume& by)
{
    const std::array<Knots, 3>& axes = cage.displacement.axes;
    std::vector<PointMove> moves;
    Box uvw;
    for (int i = 0; i < axes[0].count(); ++i)
        for (int j = 0; j < axes[1].count(); ++j)
            for (int k = 0; k < axes[2].count(); ++k) {
                moves.push_back({{i, j, k}, control_point(cage, i, j, k)});
                uvw.add(glm::dvec3(by.embedding.to_uvw * glm::dvec4(moves.back().by, 1)));
            }
    if (by.tetrahedra) {
        for (PointMove& move : moves) move.by = trivar::bent(*by.tetrahedra, move.by) - move.by;
        return moved(std::move(cage), moves);
    }
    const Ref<Lattice> volume = reaching(by, uvw);
    for (PointMove& move : moves) {
        const glm::dvec4 p(move.by, 1);
        move.by = glm::dvec3(by.embedding.to_rest * p) +
                  evaluate(volume->displacement, glm::dvec3(by.embedding.to_uvw * p)).value -
                  move.by;
    }
    return moved(std::move(cage), moves);
}

} // namespace

BendingVolume bending_volume(const LatticeStroke& stroke)
{
    return {{stroke.placement, &stroke.placement->volume}, stroke.embedding, true};
}

std::vector<BendingVolume> volumes_round(const Document& document, Id id,
                                         const std::map<Id, Ref<EvaluatedObject>>& done)
{
    std::vector<BendingVolume> out;
    for (const Id lattice : lattices_round(document, id)) {
        const auto found = done.find(lattice);
        if (found == done.end()) continue;
        if (const EvaluatedObject& it = *found->second; it.tetrahedra)
            out.push_back(
                {.volume = nullptr,
                 .embedding = {},
                 .tetrahedra = TetrahedraInWorld{it.tetrahedra->volume, it.tetrahedra_to_world}});
        if (!found->second->placement) continue;
        const Ref<Placement>& box = found->second->placement;
        out.push_back({{box, &box->volume}, {box->embedding.to_uvw, glm::dmat4(1)}});
        if (found->second->lattice_stroke)
            out.push_back(bending_volume(*found->second->lattice_stroke));
    }
    return out;
}

Ref<Lattice> reaching(const BendingVolume& volume, const Box& uvw)
{
    if (!volume.goes_on) return volume.volume;
    Lattice longer = prolonged_round(*volume.volume, uvw);
    return longer == *volume.volume ? volume.volume : make_ref(std::move(longer));
}

Ref<Lazy<Ref<Lattice>>> bent_cage(Ref<Lattice> cage, std::vector<BendingVolume> volumes)
{
    constexpr std::size_t most_points = 20000;
    return make_ref(Lazy<Ref<Lattice>>([cage = std::move(cage), volumes = std::move(volumes)] {
        if (cage->displacement.points.size() > most_points) return cage;
        Lattice out = *cage;
        for (const BendingVolume& each : volumes) out = bent(std::move(out), each);
        return make_ref(std::move(out));
    }));
}

} // namespace trivar
