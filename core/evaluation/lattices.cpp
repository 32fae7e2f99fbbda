// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/lattices.h"

#include "core/document/parameters.h"
#include "core/evaluation/told_steps.h"
#include "core/placement/box_volume.h"

#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

// The part before a further volume: what bent it so far is in its vertices, and no mirror stands
// between them and the world.
Part before_bending(const Part& part)
{
    Part out = part;
    if (part.bent) out = {.rest = part.mesh(), .key = part.key};
    if (glm::determinant(glm::dmat3(out.to_world)) >= 0) return out;
    return {.rest = make_ref(transformed(*out.mesh(), out.to_world)), .key = part.key};
}

} // namespace

Ref<ShapedVolume> LatticeVolume::in_world(const LatticeShape& shape, const StepInput& input)
{
    const std::vector<Ref<VolumeEdit>>& shaping = input.object.shaping;
    if (!at_rest_ || shape_ != shape) {
        at_rest_ = make_ref(place_box(shape.size, shape.grid, shape.orders));
        shape_ = shape;
        shaped_ = nullptr;
    }
    if (!shaped_ || shaping_ != shaping) {
        shaped_ = timed(input.timings, "shape",
                        [&] { return shaper_(at_rest_, shaping, input.progress); });
        shaping_ = shaping;
        mapped_ = nullptr;
    }
    const glm::dmat4 to_world = trivar::to_world(input.document, input.id);
    if (!mapped_ || to_world_ != to_world) {
        mapped_ = make_ref(mapped(*shaped_, to_world));
        to_world_ = to_world;
    }
    return mapped_;
}

Ref<Stage> LatticeVolume::operator()(const Ref<Stage>& before, const StepInput& input)
{
    const auto* lattice = std::get_if<LatticeShape>(&input.object.source);
    if (!lattice) return before;
    const Ref<ShapedVolume> volume = in_world(*lattice, input);
    return known_({before, volume}, [&] {
        Stage stage = *before;
        stage.placement = volume->placement;
        stage.shaped = volume;
        tell_of_steps(*volume, stage.notices);
        return make_ref(std::move(stage));
    });
}

Ref<Stage> InLattices::operator()(const Ref<Stage>& before, const StepInput& input)
{
    std::vector<Ref<ShapedVolume>> lattices;
    for (const Id id : lattices_round(input.document, input.id))
        lattices.push_back(input.done.at(id)->shaped);
    if (lattices.empty()) return before;
    return known_({before, lattices}, [&] {
        Stage stage = *before;
        put_back(bent(with_points(std::move(stage.parts), stage.curves), lattices), stage.parts,
                 stage.curves);
        return make_ref(std::move(stage));
    });
}

std::vector<Part> InLattices::bent(std::vector<Part> parts,
                                   const std::vector<Ref<ShapedVolume>>& lattices)
{
    bendings_.resize(lattices.size());
    for (std::size_t l = 0; l < lattices.size(); ++l) {
        const Ref<Placement>& placement = lattices[l]->placement;
        const Ref<Lattice> volume(placement, &placement->volume);
        bendings_[l].begin();
        for (Part& part : parts) {
            const Part before = before_bending(part);
            const Embedding embedding{placement->embedding.to_uvw * before.to_world,
                                      before.to_world};
            part = bendings_[l](before, embedding, volume, part.bent != nullptr);
        }
        bendings_[l].end();
    }
    return parts;
}

} // namespace trivar
