// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/common_mesh.h"

#include "core/mesh/adjacency.h"
#include "core/refinement/refine.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace trivar {
namespace {

constexpr double not_bounded = std::numeric_limits<double>::infinity();

// Adds the vertices of split edges; a vertex comes after the ones that it was split from.
void add_born(Mesh& mesh, const std::vector<BornVertex>& born)
{
    for (std::size_t i = 0; i < born.size();) {
        const std::size_t own = mesh.vertex_count();
        std::vector<BornVertex> round;
        while (i < born.size() && born[i].a < own && born[i].b < own) round.push_back(born[i++]);
        add_vertices(mesh, round);
    }
}

bool same_place(const Part& a, const Part& b)
{
    return a.rest == b.rest && a.posed == b.posed && a.bent->volume == b.bent->volume &&
           a.bent->embedding == b.bent->embedding;
}

// Bounds the rounding of vertices: a vertex is rounded once per split edge that led to it.
double rounding_of(const CommonMesh& common, const Mesh& mesh, double stretch)
{
    if (common.born.empty()) return 0;
    double far = 0;
    for (const glm::vec3& p : mesh.positions) far = std::max(far, glm::length(glm::dvec3(p)));
    constexpr double most_births = 20, of_a_birth = 0x1p-23;
    return most_births * of_a_birth * far * stretch;
}

// A Moment holds the visible meshes of one moment and their proven bounds.
class Moment {
public:
    Moment(const std::vector<const FilmStrip*>& strips, std::vector<CommonMesh>& common,
           MotionBound& motion, double tolerance, std::size_t moment)
        : strips_(strips),
          common_(common),
          motion_(motion),
          tolerance_(tolerance),
          moment_(moment)
    {
        for (std::size_t s = 0; s < strips.size(); ++s)
            if (const Part* part = strips[s]->shown[moment]; part && part->bent)
                shown_.push_back(s);
    }

    // Says whether an edge was split. Parts that a quick bound finds fine enough are left alone,
    // except those that may share edges with others.
    bool refined(const Progress& progress)
    {
        std::vector<RefinePart> parts;
        std::vector<double> rounding;
        std::vector<bool> enough;
        for (const std::size_t s : shown_) {
            const Part& part = *strips_[s]->shown[moment_];
            Mesh mesh = before_volume(common_[s], part);
            const double stretch = motion_.stretch(part);
            rounding.push_back(rounding_of(common_[s], mesh, stretch));
            double far = 0; // of a place in the world: it is rounded, too
            for (int c = 0; c < 3; ++c)
                far += std::abs(part.bent->embedding.to_rest[3][c]) + stretch_of(mesh, stretch);
            const double bound = motion_.space(part, mesh.positions, triangles(mesh)) +
                                 rounding.back() + far * 0x1p-23;
            common_[s].space[moment_] = bound;
            enough.push_back(bound <= tolerance_);
            parts.push_back({make_ref(std::move(mesh)), part.bent->embedding});
        }
        bool one_by_one = true;
        for (std::size_t i = 0; i < shown_.size(); ++i)
            one_by_one &= enough[i] || common_[shown_[i]].closed;
        if (std::ranges::all_of(enough, [](bool fine) { return fine; })) return false;
        const double most = *std::ranges::max_element(rounding);
        std::vector<RefinePart> coarse;
        std::vector<std::size_t> which;
        for (std::size_t i = 0; i < shown_.size(); ++i)
            if (!one_by_one || !enough[i]) {
                coarse.push_back(std::move(parts[i]));
                which.push_back(i);
            }
        RefineOptions options;
        options.tolerance_world = tolerance_ - most;
        options.budget = 20'000'000;
        const Lattice& volume = *strips_[shown_.front()]->shown[moment_]->bent->volume;
        const RefinementResult refined = refine(coarse, volume, options, progress);
        bool split = false;
        for (std::size_t i = 0; i < which.size(); ++i) {
            CommonMesh& common = common_[shown_[which[i]]];
            const RefinedPart& part = refined.parts[i];
            common.space[moment_] = part.bound + rounding[which[i]];
            if (part.born.empty()) continue;
            split = true;
            common.born.insert(common.born.end(), part.born.begin(), part.born.end());
            common.mesh = part.mesh;
        }
        return split;
    }

private:
    static double stretch_of(const Mesh& mesh, double stretch)
    {
        const Box box = bounding_box(mesh);
        return stretch * (glm::length(box.size()) + glm::length(box.center()));
    }

    const std::vector<const FilmStrip*>& strips_;
    std::vector<CommonMesh>& common_;
    MotionBound& motion_;
    double tolerance_;
    std::size_t moment_;
    std::vector<std::size_t> shown_;
};

} // namespace

Mesh in_triangles(const Mesh& mesh)
{
    const std::vector<glm::uvec3> all = triangles(mesh);
    Mesh out = mesh;
    out.corners.clear();
    out.face_begin = {0};
    out.face_material.clear();
    out.face_group.clear();
    out.group_names.clear();
    out.creases.clear();
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::size_t t = mesh.face_begin[f] - 2 * f; t < mesh.face_begin[f + 1] - 2 * (f + 1);
             ++t) {
            out.corners.insert(out.corners.end(), {all[t].x, all[t].y, all[t].z});
            out.face_begin.push_back(static_cast<std::uint32_t>(out.corners.size()));
            if (!mesh.face_material.empty()) out.face_material.push_back(mesh.face_material[f]);
        }
    return out;
}

Mesh before_volume(const CommonMesh& common, const Part& part)
{
    Mesh own = part.posed ? posed(*part.rest, part.posed->pose) : *part.rest;
    own.influences.clear();
    own.morph_targets.clear();
    add_born(own, common.born);
    own.corners = common.mesh->corners;
    own.face_begin = common.mesh->face_begin;
    own.face_material = common.mesh->face_material;
    own.face_group.clear();
    own.group_names.clear();
    own.creases.clear();
    return own;
}

std::vector<CommonMesh> common_meshes(const Film& film, const std::vector<const FilmStrip*>& strips,
                                      MotionBound& motion, double tolerance,
                                      const Progress& progress)
{
    std::vector<CommonMesh> out;
    const std::size_t count = film.moments.size();
    for (const FilmStrip* strip : strips) {
        CommonMesh common;
        common.mesh = make_ref(in_triangles(*strip->first().rest));
        common.space.assign(count, 0);
        common.triangles_before = common.mesh->face_count();
        common.closed = !Adjacency(*common.mesh).has_border();
        out.push_back(std::move(common));
    }
    const auto same_as_before = [&](std::size_t i) {
        return i > 0 && std::ranges::all_of(strips, [&](const FilmStrip* strip) {
                   const Part *a = strip->shown[i - 1], *b = strip->shown[i];
                   if (!a || !b || !a->bent || !b->bent) return a == b;
                   return same_place(*a, *b);
               });
    };
    // The result of a moment holds until something is split.
    std::size_t looked = 0;
    const auto tell = [&](double, std::string_view) {
        report(progress, static_cast<double>(looked) / static_cast<double>(count), "refining");
    };
    constexpr std::size_t most_rounds = 4;
    for (std::size_t step = 0; looked < count && step < most_rounds * count; ++step) {
        const std::size_t i = step % count;
        tell(0, {});
        const bool known = same_as_before(i) && looked > 0;
        if (known)
            for (CommonMesh& each : out) each.space[i] = each.space[i - 1];
        const bool split = !known && Moment(strips, out, motion, tolerance, i).refined(tell);
        looked = split ? 1 : looked + 1;
    }
    if (looked < count)
        for (CommonMesh& each : out) std::ranges::fill(each.space, not_bounded);
    return out;
}

} // namespace trivar
