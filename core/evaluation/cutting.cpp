// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/cutting.h"

#include "core/evaluation/inside_material.h"
#include "core/split/sever.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// A piece is numbered by its sides, and in higher bits by what was cut, from 1 on.
constexpr int sides_bits = 16;

bool drops(CutKeep keep, bool above)
{
    return keep != CutKeep::both && (keep == CutKeep::above) != above;
}

// The mesh with the places of another one's vertices as its morph target, to be taken back from
// every piece.
Mesh with_places(const Mesh& mesh, const Ref<Mesh>& rest)
{
    Mesh out = mesh;
    out.influences.clear();
    out.morph_targets.clear();
    if (rest) out.morph_targets.push_back({rest->positions, {}, {}});
    return out;
}

CuttingStep::Piece cut_piece(Mesh mesh, unsigned sides, bool has_rest)
{
    CuttingStep::Piece out;
    out.sides = sides;
    if (has_rest) {
        Mesh rest = mesh;
        rest.positions = mesh.morph_targets.at(0).positions;
        rest.morph_targets.clear();
        out.rest = make_ref(std::move(rest));
    }
    mesh.morph_targets.clear();
    for (const glm::vec3& p : mesh.positions) out.bounds.add(glm::dvec3(p));
    out.mesh = make_ref(std::move(mesh));
    return out;
}

// Cuts one part at all surfaces, one after the other.
std::vector<CuttingStep::Piece> cut_pieces(const CuttingStep::Whole& whole,
                                           const CuttingStep::PiecesKey& key,
                                           CuttingStep::Pieces& facts)
{
    struct Cutoff {
        Mesh mesh;
        unsigned sides = 0;
        bool whole = true;
    };
    std::vector<Cutoff> all(1);
    all[0].mesh = with_places(*whole.mesh, whole.rest);
    SeverOptions options;
    options.tolerance = key.cutting.tolerance / key.metres;
    options.capped = key.cutting.capped;
    options.material = key.material;
    for (std::size_t i = 0; i < key.cutting.cuts.size(); ++i) {
        const PlainCut& cut = key.cutting.cuts[i];
        const CutSheet sheet(cut, whole.to_own);
        std::vector<Cutoff> next;
        for (Cutoff& each : all) {
            bool above = false;
            std::optional<Severed> made = sever(each.mesh, sheet, options, above);
            if (!made) {
                if (drops(cut.keep, above)) continue;
                each.sides |= (above ? 1u : 0u) << i;
                next.push_back(std::move(each));
                continue;
            }
            facts.caps.open += made->open;
            facts.caps.gaps += made->gaps;
            facts.caps.fans += made->fans;
            facts.off = std::max(facts.off, made->off * key.metres);
            for (const unsigned side : {0u, 1u})
                if (Mesh& half = made->halves[side];
                    half.face_count() > 0 && !drops(cut.keep, side == 1))
                    next.push_back({std::move(half), each.sides | side << i, false});
        }
        all = std::move(next);
    }
    std::vector<CuttingStep::Piece> out;
    for (Cutoff& each : all) {
        if (each.whole)
            out.push_back({.sides = each.sides});
        else
            out.push_back(cut_piece(std::move(each.mesh), each.sides, whole.rest != nullptr));
    }
    return out;
}

// Where the pieces on each side go: the gaps of all cuts, halved, along their normals in the world.
glm::dvec3 way_of(unsigned sides, const Cutting& cutting, const glm::dmat4& own_to_world)
{
    const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(own_to_world)));
    glm::dvec3 out(0);
    for (std::size_t i = 0; i < cutting.cuts.size(); ++i) {
        const PlainCut& cut = cutting.cuts[i];
        if (cut.gap == 0 || cut.keep != CutKeep::both) continue;
        const double way = (sides >> i & 1u) != 0 ? cut.gap / 2 : -cut.gap / 2;
        out += way * glm::normalize(normals * glm::normalize(cut.normal));
    }
    return out;
}

Part moved_by(Part part, const glm::dvec3& way)
{
    part.to_world[3] += glm::dvec4(way, 0);
    return part;
}

// A part that is nothing but a mesh in place of one that a volume or a pose deforms.
Part baked(const Part& part, Ref<Mesh> mesh, const Ref<Mesh>& rest)
{
    Part out;
    out.rest = std::move(mesh);
    out.to_world = part.to_world;
    out.key = part.key;
    out.before_split = rest;
    for (const glm::vec3& p : out.rest->positions) out.bounds.add(glm::dvec3(p));
    return out;
}

Part part_for(const Part& part, const CuttingStep::Whole& whole, const CuttingStep::Piece& piece,
              const glm::dvec3& way, bool refined)
{
    if (!piece.mesh) {
        // The facts of refined parts go by their numbers, which are others now
        if (!part.bent || (way == glm::dvec3(0) && !refined)) return moved_by(part, way);
        return moved_by(baked(part, whole.mesh, whole.rest), way);
    }
    Part out = baked(part, piece.mesh, piece.rest);
    out.key.piece = (part.key.piece + 1) * (1 << sides_bits) + static_cast<int>(piece.sides);
    return moved_by(std::move(out), way);
}

void tell_of_cuts(Stage& stage, const CuttingStep::Pieces& pieces, const Cutting& cutting)
{
    stage.cut_off = pieces.off;
    stage.pieces = stage.parts.size();
    if (stage.parts.empty())
        stage.notices.emplace_back("its cuts keep nothing of it; keep the other side of one");
    std::ranges::move(notices_of(pieces.caps), std::back_inserter(stage.notices));
    if (pieces.off > cutting.tolerance)
        stage.notices.push_back(fmt::format("its cut is up to {:.3g} m from what was drawn, more "
                                            "than its tolerance",
                                            pieces.off));
}

// What can cut at this frame: keys can take the direction away.
Cutting present(Cutting cutting, Stage& stage)
{
    const auto blunt = [](const PlainCut& cut) { return !(glm::length(cut.normal) > 1e-9); };
    if (std::erase_if(cutting.cuts, blunt) > 0)
        stage.notices.emplace_back(
            "the normal of a cut is 0 at this frame, so that it cuts nothing");
    return cutting;
}

} // namespace

Ref<Stage> CuttingStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    if (!input.object.cutting || before->parts.empty()) return before;
    const glm::dmat4& own_to_world = before->own_to_world;
    if (!(std::abs(glm::determinant(glm::dmat3(own_to_world))) > 0)) return before;
    const bool filled = is_filled(*before, input.object.cutting->inside, input.object.surfacing);
    return known_({before, *input.object.cutting, filled}, [&] {
        Stage out = *before;
        const Cutting cutting = present(*input.object.cutting, out);
        const InsideMaterial inside = inside_material(*before, cutting.inside);
        PiecesKey key{{}, cutting, 1, inside.number};
        for (PlainCut& cut : key.cutting.cuts) cut.gap = 0;
        const glm::dmat3 axes(own_to_world);
        key.metres = std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
        for (const Part& part : before->parts) {
            Whole whole{mesh_of(part, input.timings), nullptr, glm::dmat4(1)};
            if (filled && (part.bent || part.posed)) whole.rest = part.rest;
            if (part.to_world != own_to_world)
                whole.to_own = glm::inverse(own_to_world) * part.to_world;
            key.parts.push_back(std::move(whole));
        }
        const Ref<Pieces> pieces = timed(input.timings, "cut", [&] {
            return pieces_(key, [&] {
                Pieces made;
                for (const Whole& whole : key.parts)
                    made.of_parts.push_back(cut_pieces(whole, key, made));
                return make_ref(std::move(made));
            });
        });
        const bool is_cut = std::ranges::any_of(
            pieces->of_parts, [](const auto& of) { return of.size() != 1 || of[0].mesh; });
        out.parts.clear();
        for (std::size_t p = 0; p < before->parts.size(); ++p)
            for (const Piece& piece : pieces->of_parts[p]) {
                const glm::dvec3 way = way_of(piece.sides, cutting, own_to_world);
                out.parts.push_back(part_for(before->parts[p], key.parts[p], piece, way,
                                             is_cut && before->refined));
            }
        if (is_cut) {
            out.whole_parts = before->parts;
            out.mixed_materials = inside.beside;
        }
        tell_of_cuts(out, *pieces, cutting);
        return make_ref(std::move(out));
    });
}

} // namespace trivar
