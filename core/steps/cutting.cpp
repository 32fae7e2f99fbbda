// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/cutting.h"

#include "core/base/number_text.h"
#include "core/split/cut_side.h"
#include "core/split/sever.h"
#include "core/stages/base_of_tiles.h"
#include "core/stages/inside_material.h"
#include "core/stages/tile_pieces.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// A piece is numbered by its sides, by a bit for whole tiles, and in higher bits by what was cut,
// from 1 on.
constexpr int sides_bits = 16;
constexpr std::int64_t tiles_bit = 1 << sides_bits, numbers_per_part = 2 * tiles_bit;

// The number of what a piece was cut from, once or several times.
std::int64_t first_number(std::int64_t piece)
{
    while (piece >= numbers_per_part) piece = piece / numbers_per_part - 1;
    return piece;
}

bool drops(CutKeep keep, bool above)
{
    return keep != CutKeep::both && (keep == CutKeep::above) != above;
}

bool has(unsigned bits, std::size_t i)
{
    return (bits >> i & 1u) != 0;
}

bool keeps(const CuttingStep::PiecesKey& key, unsigned sides)
{
    for (std::size_t i = 0; i < key.cutting.cuts.size(); ++i)
        if (has(key.made, i) && drops(key.cutting.cuts[i].keep, has(sides, i))) return false;
    return true;
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

// Cuts a mesh at all surfaces, one after the other.
std::vector<CuttingStep::Piece> mesh_pieces(const Mesh& mesh, const Ref<Mesh>& rest,
                                            const CuttingStep::Whole& whole,
                                            const CuttingStep::PiecesKey& key,
                                            CuttingStep::Pieces& facts)
{
    struct Cutoff {
        Mesh mesh;
        unsigned sides = 0;
        bool whole = true;
    };
    std::vector<Cutoff> all(1);
    all[0].mesh = with_places(mesh, rest);
    all[0].sides = whole.above;
    SeverOptions options;
    options.tolerance = key.cutting.tolerance / key.metres;
    options.capped = key.cutting.capped;
    options.material =
        key.material.value_or(mesh.face_material.empty() ? 0 : mesh.face_material.front());
    for (std::size_t i = 0; i < key.cutting.cuts.size(); ++i) {
        const PlainCut& cut = key.cutting.cuts[i];
        if (!has(key.made, i)) continue;
        std::vector<Cutoff> next;
        for (Cutoff& each : all) {
            // Through the piece where it stood when the cut was drawn
            const glm::dvec3 off = drawn_off(cut, each.sides, key.made | key.earlier);
            const CutSheet sheet(cut, glm::translate(glm::dmat4(1), off) * whole.to_own);
            Unsevered where;
            std::optional<Severed> made = sever(each.mesh, sheet, options, where);
            if (!made) {
                facts.touches |= (where.touched ? 1u : 0u) << i;
                if (drops(cut.keep, where.above)) continue;
                each.sides |= (where.above ? 1u : 0u) << i;
                next.push_back(std::move(each));
                continue;
            }
            facts.goes_through |= 1u << i;
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
            out.push_back(cut_piece(std::move(each.mesh), each.sides, rest != nullptr));
    }
    return out;
}

// On which sides of the cuts all of a box is; none: a cut may go through it.
std::optional<unsigned> sides_of(const Box& box, const CuttingStep::Whole& whole,
                                 const CuttingStep::PiecesKey& key,
                                 const std::vector<CutSheet>& sheets)
{
    const glm::dmat3 from_own = glm::inverse(glm::dmat3(whole.to_own));
    unsigned out = whole.above;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        if (!has(key.made, i)) continue;
        const glm::dvec3 off =
            from_own * drawn_off(key.cutting.cuts[i], out, key.made | key.earlier);
        const std::optional<bool> above = side_of({box.lo + off, box.hi + off}, sheets[i]);
        if (!above) return std::nullopt;
        out |= (*above ? 1u : 0u) << i;
    }
    return out;
}

std::vector<CuttingStep::Piece> cut_pieces(const CuttingStep::Whole& whole,
                                           const CuttingStep::PiecesKey& key,
                                           CuttingStep::Pieces& facts)
{
    if (!whole.tiles) return mesh_pieces(*whole.mesh, whole.rest, whole, key, facts);
    std::vector<CutSheet> sheets;
    for (const PlainCut& cut : key.cutting.cuts) sheets.emplace_back(cut, whole.to_own);
    const TilePieces tiles = tile_pieces(
        whole.tiles, whole.alone,
        [&](const Box& hull) { return sides_of(hull, whole, key, sheets); },
        [&](unsigned sides) { return keeps(key, sides); });
    std::vector<CuttingStep::Piece> out;
    for (const auto& [sides, set] : tiles.whole) {
        out.push_back({.sides = sides});
        if (set != whole.tiles) out.back().tiles = set;
    }
    if (!tiles.crossed) return out;
    for (CuttingStep::Piece& each : mesh_pieces(*tiles.crossed, nullptr, whole, key, facts)) {
        if (!each.mesh && whole.alone) { // it was not cut: hulls are larger than tiles
            each.mesh = tiles.crossed;
            each.bounds = bounding_box(*tiles.crossed);
        }
        out.push_back(std::move(each));
    }
    return out;
}

// Cuts of an object or of what its tiles are painted on, and the space that they are in.
struct CutsOf {
    Cutting cutting;
    glm::dmat4 own_to_world{1};
    bool own = true; // not those of the base of a layer of tiles
};

// Where the part above each cut that is made goes in the world: by half of its gap along its
// normal.
std::vector<glm::dvec3> half_gaps(const CutsOf& cuts, unsigned made)
{
    const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(cuts.own_to_world)));
    std::vector<glm::dvec3> out;
    for (const PlainCut& cut : cuts.cutting.cuts) {
        const bool moves = has(made, out.size()) && cut.gap != 0 && cut.keep == CutKeep::both;
        out.push_back(moves ? cut.gap / 2 * glm::normalize(normals * glm::normalize(cut.normal))
                            : glm::dvec3(0));
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

PartKey key_of(const Part& part, const CuttingStep::Piece& piece)
{
    PartKey key = part.key;
    key.piece = (key.piece + 1) * numbers_per_part + (piece.tiles ? tiles_bit : 0) + piece.sides;
    return key;
}

Part part_for(const Part& part, const CuttingStep::Whole& whole, const CuttingStep::Piece& piece,
              const glm::dvec3& way, bool refined)
{
    if (piece.tiles) {
        Part out = part_of(piece.tiles, key_of(part, piece));
        out.to_world = part.to_world;
        return moved_by(std::move(out), way);
    }
    if (!piece.mesh) {
        // The facts of refined parts go by their numbers, which are others now
        if (!part.bent || (way == glm::dvec3(0) && !refined)) return moved_by(part, way);
        return moved_by(baked(part, whole.mesh, whole.rest), way);
    }
    Part out = baked(part, piece.mesh, piece.rest);
    out.key = key_of(part, piece);
    return moved_by(std::move(out), way);
}

void tell_of_normals(Stage& stage, const CutsOf& cuts, bool of_parted, unsigned made)
{
    for (std::size_t i = 0; i < cuts.cutting.cuts.size() && cuts.own; ++i)
        if (cuts.cutting.cuts[i].parted == of_parted && !has(made, i))
            stage.notices.emplace_back(
                "the normal of a cut is 0 at this frame, so that it cuts nothing");
}

void tell_of_cuts(Stage& stage, const CuttingStep::Pieces& pieces, const CutsOf& cuts)
{
    const Cutting& cutting = cuts.cutting;
    for (std::size_t i = 0; i < cutting.cuts.size() && cuts.own; ++i)
        if (has(pieces.touches & ~pieces.goes_through, i))
            stage.notices.push_back(fmt::format(
                "its cut {} only touches it, so nothing comes off; move the cut into it", i + 1));
    stage.cut_error = std::max(stage.cut_error, pieces.off);
    stage.pieces = stage.parts.size();
    std::ranges::move(notices_of(pieces.caps), std::back_inserter(stage.notices));
    if (pieces.off > cutting.tolerance)
        stage.notices.push_back(fmt::format("its cut is up to {} m from what was drawn, more "
                                            "than its tolerance",
                                            number_text(pieces.off)));
}

// Returns the cuts of an object in their order: those of the bases of a layer of tiles come first.
std::vector<CutsOf> cuts_of(const Stage& stage, const StepInput& input)
{
    const auto is_cut = [](const Object& o) { return o.cutting.has_value(); };
    std::vector<CutsOf> out;
    if (is_cut(input.object)) out.push_back({*input.object.cutting, stage.own_to_world, true});
    for (Id base = base_that(input.document, input.object, is_cut); base != 0;
         base = base_that(input.document, object(input.document, base), is_cut)) {
        const auto found = input.done.find(base);
        if (found == input.done.end()) continue;
        out.push_back({*object(input.document, base).cutting, found->second->own_to_world, false});
        out.back().cutting.inside =
            Filling::none; // tiles are not made of what their base is made of
    }
    std::ranges::reverse(out);
    return out;
}

// The cuts that a step makes, by bits. Keys can take the direction of a cut away; it then cuts
// nothing.
unsigned made_by(bool of_parted, const Cutting& cutting)
{
    unsigned out = 0;
    for (std::size_t i = 0; i < cutting.cuts.size(); ++i)
        if (cutting.cuts[i].parted == of_parted && cutting.cuts[i].cuts()) out |= 1u << i;
    return out;
}

// A part and where it was before the gaps of earlier cuts.
//  - base: the number of what has the cuts, in the order of cuts_of(); the same in both steps
//  - open: where the part above each of the earlier cuts went, in the world
CuttingStep::Whole whole_of(const Part& part, std::size_t base, const glm::dmat4& own_to_world,
                            const std::vector<glm::dvec3>& open, bool filled, Timings& timings)
{
    CuttingStep::Whole out;
    if (base < part.above_cuts.size()) out.above = part.above_cuts[base];
    if (part.drawn_from_tiles()) {
        out.tiles = part.tiles;
        out.alone =
            first_number(part.key.piece) == 0; // tiles of strands and covers share their borders
    } else {
        out.mesh = mesh_of(part, timings);
        if (filled && (part.bent || part.posed))
            out.rest = part.rest;
        else if (filled)
            out.rest = part.before_split;
    }
    const glm::dmat4 now = moved_by(part, -off_by_sides(open, out.above)).to_world;
    if (now != own_to_world) out.to_own = glm::inverse(own_to_world) * now;
    return out;
}

// The stage after some cuts; `known` is what the same cuts made before.
Ref<Stage> cut_stage(const Ref<Stage>& before, const CutsOf& cuts, std::size_t base, bool of_parted,
                     const StepInput& input, CuttingStep::Known& known)
{
    using Piece = CuttingStep::Piece;
    using Pieces = CuttingStep::Pieces;
    const glm::dmat4 own_to_world = cuts.own_to_world;
    if (before->parts.empty() ||
        std::ranges::find(cuts.cutting.cuts, of_parted, &PlainCut::parted) ==
            cuts.cutting.cuts.end() ||
        !(std::abs(glm::determinant(glm::dmat3(own_to_world))) > 0))
        return before;
    const bool filled = is_filled(*before, cuts.cutting.inside, input.object.surfacing);
    return known.stages({before, cuts.cutting, own_to_world, filled}, [&] {
        Stage out = *before;
        const Cutting& cutting = cuts.cutting;
        const unsigned made_now = made_by(of_parted, cutting);
        const unsigned earlier = of_parted ? made_by(false, cutting) : 0;
        const unsigned later = of_parted ? 0 : made_by(true, cutting);
        tell_of_normals(out, cuts, of_parted, made_now);
        const std::vector<glm::dvec3> gaps = half_gaps(cuts, made_now);
        const std::vector<glm::dvec3> open = half_gaps(cuts, earlier);
        const InsideMaterial inside = inside_material(*before, cutting.inside);
        CuttingStep::PiecesKey key{{}, cutting, made_now, earlier, 1, inside.number};
        if (input.object.tiles && cutting.inside == Filling::none) key.material.reset();
        for (PlainCut& cut : key.cutting.cuts) cut.gap = 0;
        const glm::dmat3 axes(own_to_world);
        key.metres = std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
        for (const Part& part : before->parts)
            key.parts.push_back(whole_of(part, base, own_to_world, open, filled, input.timings));
        const Ref<Pieces> pieces = timed(input.timings, "cut", [&] {
            return known.pieces(key, [&] {
                Pieces made;
                for (const CuttingStep::Whole& whole : key.parts)
                    made.of_parts.push_back(cut_pieces(whole, key, made));
                return make_ref(std::move(made));
            });
        });
        const bool is_cut = std::ranges::any_of(pieces->of_parts, [](const auto& of) {
            return of.size() != 1 || of[0].mesh || of[0].tiles;
        });
        out.parts.clear();
        for (std::size_t p = 0; p < before->parts.size(); ++p)
            for (const Piece& piece : pieces->of_parts[p]) {
                const glm::dvec3 way = off_by_sides(gaps, piece.sides);
                out.parts.push_back(part_for(before->parts[p], key.parts[p], piece, way,
                                             is_cut && before->refined));
                if (later == 0) continue;
                out.parts.back().above_cuts.resize(base + 1);
                out.parts.back().above_cuts[base] = piece.sides;
            }
        if (cuts.own) {
            out.cuts_open.resize(gaps.size(), glm::dvec3(0));
            for (std::size_t i = 0; i < gaps.size(); ++i)
                out.cuts_open[i] += glm::inverse(glm::dmat3(own_to_world)) * gaps[i];
        }
        if (is_cut) out.mixed_materials = inside.beside;
        // Tiles are laid on what was there before, and then are cut with it
        if (out.parts != before->parts) out.whole_parts = before->whole();
        tell_of_cuts(out, *pieces, cuts);
        if (out.parts.empty() && cuts.own)
            out.notices.emplace_back("its cuts keep nothing of it; keep the other side of one");
        return make_ref(std::move(out));
    });
}

} // namespace

Ref<Stage> CuttingStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    if (before->parts.empty()) return before;
    std::vector<CutsOf> all = cuts_of(*before, input);
    known_.resize(all.size());
    Ref<Stage> out = before;
    for (std::size_t i = 0; i < all.size(); ++i)
        out = cut_stage(out, all[i], i, of_parted_, input, known_[i]);
    return out;
}

} // namespace trivar
