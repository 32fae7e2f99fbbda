// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/bending/lattices.h"

#include "core/base/number_text.h"
#include "core/document/parameters.h"
#include "core/placement/box_volume.h"
#include "core/stages/standing.h"
#include "core/stages/told_steps.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// Bakes all earlier volumes and mirrors into the vertices of a part, so that another volume can
// bend it.
Part before_bending(const Part& part)
{
    Part out = part;
    if (part.bent)
        out = {.rest = part.mesh(), .key = part.key, .bounds = bounding_box(*part.mesh())};
    if (glm::determinant(glm::dmat3(out.to_world)) >= 0) return out;
    const Ref<Mesh> turned = make_ref(transformed(*out.mesh(), out.to_world));
    return {.rest = turned, .key = part.key, .bounds = bounding_box(*turned)};
}

} // namespace

Ref<ShapedVolume> LatticeStep::in_world(const LatticeShape& shape, const StepInput& input)
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

Ref<Stage> LatticeStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    const auto* lattice = std::get_if<LatticeShape>(&input.object.source);
    if (!lattice) return before;
    const Ref<ShapedVolume> volume = in_world(*lattice, input);
    return known_({before, volume}, [&] {
        Stage stage = *before;
        if (before->placement) {
            const glm::dmat4 to_model = glm::dmat4(glm::dmat3(input.object.transform.matrix())) *
                                        glm::inverse(to_world(input.document, input.id));
            stage.lattice_stroke = make_ref(
                LatticeStroke{before->placement, embedded(before->placement->embedding, to_model)});
            stage.bent_cage = bent_cage({volume->placement, &volume->placement->volume},
                                        {bending_volume(*stage.lattice_stroke)});
        }
        stage.placement = volume->placement;
        stage.shaped = volume;
        tell_of_steps(*volume, stage.notices);
        constexpr double flat = 1e-4; // of the longest side
        for (int axis = 0; axis < 3; ++axis)
            if (lattice->size[axis] <
                flat * std::max({lattice->size.x, lattice->size.y, lattice->size.z}))
                stage.notices.push_back(
                    fmt::format("it is flat along {}, so it bends nothing out of its plane; give "
                                "it a size there",
                                "XYZ"[axis]));
        return make_ref(std::move(stage));
    });
}

Ref<Stage> BendingStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    const std::vector<BendingVolume> volumes = volumes_round(input.document, input.id, input.done);
    if (volumes.empty()) return before;
    return known_({before, volumes}, [&] {
        Stage stage = *before;
        if (stage.placement) {
            std::vector<BendingVolume> all = volumes;
            if (stage.lattice_stroke)
                all.insert(all.begin(), bending_volume(*stage.lattice_stroke));
            stage.bent_cage =
                bent_cage({stage.placement, &stage.placement->volume}, std::move(all));
        }
        put_back(bent(with_points(std::move(stage.parts), stage.curves), volumes), stage.parts,
                 stage.curves);
        tell_what_is_outside(volumes, stage.notices);
        return make_ref(std::move(stage));
    });
}

void BendingStep::tell_what_is_outside(const std::vector<BendingVolume>& volumes,
                                       std::vector<std::string>& notices) const
{
    for (std::size_t l = 0; l < volumes.size(); ++l) {
        if (!volumes[l].tetrahedra) continue;
        const SimplexBending::Reach reach = simplex_bendings_[l].reach();
        if (reach.outside > 0)
            notices.push_back(
                fmt::format("{} of its {} points are outside of the tetrahedra that bend it, which "
                            "move them little or not at all",
                            with_commas(reach.outside), with_commas(reach.points)));
    }
}

// Extends the volume once for all parts, so that touching parts stay together.
Ref<Lattice> BendingStep::reaching_round(const std::vector<Part>& parts,
                                         const BendingVolume& volume)
{
    if (!volume.goes_on) return volume.volume;
    Box uvw;
    for (const Part& part : parts)
        if (!part.bounds.empty())
            for (const glm::dvec3& corner : part.bounds.corners())
                uvw.add(
                    glm::dvec3(volume.embedding.to_uvw * part.to_world * glm::dvec4(corner, 1)));
    const Ref<Lattice> out = reaching(volume, uvw);
    if (out == volume.volume) return out;
    return longer_({volume.volume, *out}, [&] { return out; });
}

std::vector<Part> BendingStep::bent(std::vector<Part> parts,
                                    const std::vector<BendingVolume>& volumes)
{
    bendings_.resize(volumes.size());
    simplex_bendings_.resize(volumes.size());
    for (std::size_t l = 0; l < volumes.size(); ++l) {
        std::vector<Part> before;
        for (const Part& part : parts) before.push_back(before_bending(part));
        if (volumes[l].tetrahedra) {
            simplex_bendings_[l].begin();
            for (std::size_t p = 0; p < parts.size(); ++p)
                parts[p] = simplex_bendings_[l](before[p], *volumes[l].tetrahedra);
            simplex_bendings_[l].end();
            continue;
        }
        const Ref<Lattice> volume = reaching_round(before, volumes[l]);
        bendings_[l].begin();
        for (std::size_t p = 0; p < parts.size(); ++p)
            parts[p] = bendings_[l](before[p], embedded(volumes[l].embedding, before[p].to_world),
                                    volume, parts[p].bent ? make_ref(parts[p]) : nullptr);
        bendings_[l].end();
    }
    return parts;
}

} // namespace trivar
