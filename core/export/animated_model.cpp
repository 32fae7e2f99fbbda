// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/animated_model.h"

#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/certificate/places_in_file.h"
#include "core/certificate/sag.h"
#include "core/certificate/target_keys.h"
#include "core/document/document_digest.h"
#include "core/export/animated_nodes.h"
#include "core/steps/lacking.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <numeric>

namespace trivar {
namespace {

// Shares of the tolerance: for flat triangles, and for the motion between moments. The keys get the
// rest.
constexpr double share_of_space = 0.4, share_of_between = 0.4;
constexpr double share_of_sag = 0.2; // where the motion between moments is measured only
constexpr double no_less = 0.6;      // of the sag with half as many moments, or more do not help
constexpr int most_moments = 16;     // per frame
constexpr int measured_moments = 4;  // per frame, where the motion between moments is measured only

bool moves_by_itself(const FilmStrip& strip)
{
    const Part& first = strip.first();
    return std::ranges::any_of(strip.shown, [&](const Part* part) {
        return part && (part->to_world != first.to_world || part->posed != first.posed ||
                        part->rest != first.rest);
    });
}

bool plays_by_itself(const Document& document, const FilmStrip& strip)
{
    return !strip.bent() && !object(document, strip.object).playing.clip.empty();
}

// A BentObject lists the strips of an object that a volume deforms at all times at which they are
// shown.
struct BentObject {
    std::vector<const FilmStrip*> strips;
    std::unique_ptr<MotionBound> motion;
    std::vector<std::vector<double>> bounds; // by strip and moment: up to the next
};

struct FilmPlan {
    Film film;
    int per_frame = 1;
    double between = 0; // the greatest bound of what is proven between moments
    std::map<Id, BentObject> bent;
};

bool always_bent(const FilmStrip& strip)
{
    return std::ranges::all_of(strip.shown,
                               [](const Part* part) { return !part || part->bent != nullptr; });
}

void bound_between(FilmPlan& plan, const Progress& progress)
{
    const Film& film = plan.film;
    double done = 0;
    for (auto& [id, object] : plan.bent) {
        report(progress, done++ / static_cast<double>(plan.bent.size()), "bounding the motion");
        object.bounds.assign(object.strips.size(), std::vector<double>(film.moments.size(), 0));
        for (std::size_t i = 0; i + 1 < film.moments.size(); ++i) {
            report(progress, done / static_cast<double>(plan.bent.size() + 1),
                   "bounding the motion");
            for (std::size_t s = 0; s < object.strips.size(); ++s) {
                const Part *a = object.strips[s]->shown[i], *b = object.strips[s]->shown[i + 1];
                if (a && b) // a part appears and disappears only at a moment
                    object.bounds[s][i] = (*object.motion)(
                        *film.evaluated[i].objects.at(id), *a, film.moments[i],
                        *film.evaluated[i + 1].objects.at(id), *b, film.moments[i + 1]);
            }
        }
    }
}

FilmPlan planned(const AnimatedScene& scene, const Ref<AssetStore>& assets,
                 const Progress& progress)
{
    double sag_before = std::numeric_limits<double>::infinity(), done = 0;
    for (int per_frame = 1;; per_frame *= 2) {
        // Half of the remaining progress is given to each round, as their number is not known
        const Progress reading = part_of(progress, done, done + (1 - done) / 4),
                       bounding = part_of(progress, done + (1 - done) / 4, (1 + done) / 2);
        done = (1 + done) / 2;
        FilmPlan plan;
        plan.per_frame = per_frame;
        plan.film = film_of(scene.document, assets, moments_of(scene.frames, per_frame), reading);
        if (scene.whole) check_whole(lacks(plan.film, scene.document));
        bool measured = false;
        double sag = 0;
        const auto measure = [&](const FilmStrip& strip) {
            measured = true;
            if (per_frame >= measured_moments) sag = std::max(sag, sag_between_moments(strip));
        };
        for (const FilmStrip& strip : plan.film.strips)
            if (always_bent(strip)) {
                BentObject& object = plan.bent[strip.object];
                object.strips.push_back(&strip);
                if (!object.motion)
                    object.motion =
                        std::make_unique<MotionBound>(scene.document, strip.object, *assets);
            } else if (plays_by_itself(scene.document, strip)) {
                measured = true; // its channels are copied unchanged
            } else if (moves_by_itself(strip) || strip.bent()) {
                measure(strip);
            }
        bound_between(plan, bounding);
        if (scene.frames.first == scene.frames.last) return plan;
        double& most = plan.between;
        for (const auto& [id, object] : plan.bent)
            for (std::size_t s = 0; s < object.strips.size(); ++s) {
                for (const double bound : object.bounds[s])
                    if (std::isfinite(bound)) most = std::max(most, bound);
                if (!std::ranges::all_of(object.bounds[s],
                                         [](double b) { return std::isfinite(b); }))
                    measure(*object.strips[s]);
            }
        const bool enough = most <= share_of_between * scene.tolerance &&
                            (sag <= share_of_sag * scene.tolerance || sag > no_less * sag_before) &&
                            (!measured || per_frame >= measured_moments);
        const bool no_more = per_frame >= most_moments || 2 * plan.film.kept > most_kept;
        if (enough || no_more) return plan;
        if (per_frame >= measured_moments) sag_before = sag;
    }
}

// Computes the error that keys may add at each moment: the rest of the tolerance.
std::vector<double> allowed_by(const AnimatedScene& scene, const std::vector<double>& space,
                               const std::vector<double>& between)
{
    std::vector<double> out(space.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double around = std::max(i > 0 ? between[i - 1] : 0, between[i]);
        const double left = scene.tolerance - space[i] - around;
        out[i] = left > 0 ? left : share_of_between * scene.tolerance;
    }
    return out;
}

void claim_targets(FilmCertificate::PartClaim& claim, const MotionBound& motion,
                   const std::vector<double>& space, const std::vector<double>& bounds,
                   const std::vector<double>& off)
{
    claim.space = *std::ranges::max_element(space);
    const auto jumps = std::ranges::count_if(bounds, [](double b) { return std::isinf(b); });
    claim.unproven = motion.unknown();
    if (claim.unproven.empty() && jumps > 0)
        claim.unproven = std::to_string(jumps) + " of " + std::to_string(bounds.size() - 1) +
                         " ways from one moment to the next are not bounded: it jumps, or its "
                         "clip, its stroke or its guard says too little";
    for (std::size_t i = 0; i < off.size(); ++i) {
        const double next = i + 1 < off.size() ? space[i + 1] + off[i + 1] : 0;
        const double step = std::isfinite(bounds[i]) ? bounds[i] : 0;
        claim.motion = std::max(claim.motion, step);
        claim.bound = std::max(claim.bound, std::max(space[i] + off[i], next) + step);
    }
}

// The next of 1, 2, 5, 10 and so on.
double next_round(double value)
{
    const double unit = std::pow(10, std::floor(std::log10(value)));
    for (const double factor : {1, 2, 5})
        if (factor * unit >= value) return factor * unit;
    return 10 * unit;
}

// Measures how far meshes on nodes are from their true places at the moments: the error of keys, of
// single precision and of skinning.
void measure_nodes(const AnimatedScene& scene, AnimatedExport& out, const Progress& progress)
{
    std::vector<FilmCertificate::PartClaim>& claims = out.certificate.parts;
    const Model& model = out.model;
    std::vector<const Channel*> weights;
    for (const FilmCertificate::PartClaim& claim : claims)
        weights.push_back(weights_of_node(model, claim.node));
    std::vector<double> far(claims.size(), 0);
    const std::vector<double>& moments = out.film.moments;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        report(progress, static_cast<double>(i) / static_cast<double>(moments.size()),
               "measuring nodes");
        std::vector<std::size_t> parts;
        for (std::size_t p = 0; p < claims.size(); ++p)
            if (!out.common[p].mesh && out.film.strips[p].shown[i] && claims[p].way != "still")
                parts.push_back(p);
        if (parts.empty()) continue;
        const double time_s = (moments[i] - scene.frames.first) / out.certificate.frames_per_second;
        const Stance stance =
            stance_at(model, model.clips.empty() ? nullptr : &model.clips.front(), time_s);
        parallel_blocks(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const std::size_t p = parts[k];
                const std::vector<glm::dvec3> file = places_in_file(model, claims[p].node, stance,
                                                                    weights[p], time_s),
                                              there = places_in_scene(*out.film.strips[p].shown[i]);
                for (std::size_t v = 0; v < there.size(); ++v) {
                    const double off = glm::distance(file[v], there[v]);
                    if (!(off <= claims[p].bound))
                        claims[p].bound =
                            std::isfinite(off) ? off : std::numeric_limits<double>::infinity();
                    far[p] = std::max(far[p], glm::length(there[v]));
                }
            }
        });
    }
    for (std::size_t p = 0; p < claims.size(); ++p)
        if (const double least = 0x1p-21 * far[p];
            claims[p].bound > 0 && !(scene.tolerance > least) && !out.common[p].mesh)
            throw Rejected(fmt::format("a tolerance of {} m is finer than the precision of the "
                                       "coordinates here; use more than {} m",
                                       number_text(scene.tolerance), number_text(least)));
}

} // namespace

AnimatedExport animated_export(const AnimatedScene& asked, const Ref<AssetStore>& assets,
                               const Progress& progress)
{
    AnimatedScene scene = asked;
    if (asked.tolerance == 0) scene.tolerance = default_tolerance;
    if (!(scene.tolerance > 0 && scene.tolerance <= most_tolerance))
        throw Rejected(
            fmt::format("the tolerance must be above 0 m and at most {} m", most_tolerance));
    FilmPlan plan = planned(scene, assets, part_of(progress, 0, 0.2));
    if (const double least = plan.between / share_of_between;
        asked.tolerance == 0 && least > scene.tolerance && least <= most_tolerance) {
        scene.tolerance = next_round(least);
        plan = planned(scene, assets, part_of(progress, 0.2, 0.3));
    }
    AnimatedExport out;
    out.film = std::move(plan.film); // strips keep their addresses
    const Film& film = out.film;
    const std::vector<CurveStrip> curves = curve_strips(film, scene.document);
    if (film.strips.empty() && curves.empty()) throw Rejected("there is nothing visible to export");
    const double per_second = scene.document.time.frames_per_second;
    std::vector<float> times_s;
    for (const double moment : film.moments)
        times_s.push_back(static_cast<float>((moment - scene.frames.first) / per_second));

    FilmCertificate& certificate = out.certificate;
    certificate = {.tolerance = scene.tolerance,
                   .first_frame = scene.frames.first,
                   .last_frame = scene.frames.last,
                   .frames_per_second = per_second,
                   .log = std::filesystem::path(scene.log).filename().string(),
                   .scene = digest(scene.document)};
    out.common.resize(film.strips.size());
    const auto index_of = [&](const FilmStrip* strip) {
        return static_cast<std::size_t>(strip - film.strips.data());
    };
    std::vector<const std::vector<double>*> bounds(film.strips.size(), nullptr);
    double done = 0;
    for (auto& [id, object] : plan.bent) {
        const double share = 0.5 / static_cast<double>(plan.bent.size());
        std::vector<CommonMesh> common =
            common_meshes(film, object.strips, *object.motion, share_of_space * scene.tolerance,
                          part_of(progress, 0.3 + done, 0.3 + done + share));
        done += share;
        for (std::size_t s = 0; s < object.strips.size(); ++s) {
            out.common[index_of(object.strips[s])] = std::move(common[s]);
            bounds[index_of(object.strips[s])] = &object.bounds[s];
        }
    }
    AnimatedNodes nodes(film, scene.document, *assets, times_s, scene.tolerance);
    constexpr std::size_t at_once = 16; // parts in memory at once
    const std::vector<double> free(film.moments.size(), share_of_between * scene.tolerance);
    const std::vector<double> nothing(film.moments.size(), 0);
    for (std::size_t first = 0; first < film.strips.size(); first += at_once) {
        report(progress,
               0.8 + 0.1 * static_cast<double>(first) / static_cast<double>(film.strips.size()),
               "choosing keys");
        const std::size_t end = std::min(first + at_once, film.strips.size());
        std::vector<TargetKeys> keys(end - first);
        parallel_blocks(end - first, 1, [&](std::size_t begin, std::size_t stop) {
            for (std::size_t s = begin; s < stop; ++s)
                if (const CommonMesh& common = out.common[first + s]; common.mesh)
                    keys[s] =
                        target_keys(film, film.strips[first + s], common,
                                    allowed_by(scene, common.space, *bounds[first + s]), times_s);
        });
        for (std::size_t s = first; s < end; ++s) {
            const FilmStrip& strip = film.strips[s];
            FilmCertificate::PartClaim claim{
                .object = strip.object, .part = strip.number, .name = strip.name};
            claim.moments = plan.per_frame;
            CommonMesh& common = out.common[s];
            if (common.mesh) {
                claim.triangles_before = common.triangles_before;
                claim_targets(claim, *plan.bent.at(strip.object).motion, common.space, *bounds[s],
                              keys[s - first].off);
                nodes.add_targets(strip, std::move(keys[s - first]), claim);
            } else if (strip.bent() || strip.reshaped() || !nodes.add_moving(strip, claim)) {
                // Copies the vertices of the part at the moments.
                common.mesh = make_ref(in_triangles(*strip.first().rest));
                common.space = nothing;
                TargetKeys own = target_keys(film, strip, common, free, times_s);
                claim = {.object = strip.object, .part = strip.number, .name = strip.name};
                claim.moments = plan.per_frame;
                claim.triangles_before = common.mesh->face_count();
                claim.unproven = strip.bent()       ? "it lies on its stroke in some frames only"
                                 : strip.reshaped() ? "keys change its shape"
                                                    : "it shears, which no node can";
                claim.bound = *std::ranges::max_element(own.off);
                nodes.add_targets(strip, std::move(own), claim);
            }
            certificate.parts.push_back(std::move(claim));
        }
    }
    std::vector<std::string> bending;
    for (const CurveStrip& strip : curves)
        if (!nodes.add_curves(strip)) bending.push_back(strip.name);
    out.left_out = which_curves_are_left_out(
        bending, "a .glb has none that bend or shear in time; a .usda has");
    if (const std::string zoom = nodes.add_camera(); !zoom.empty())
        out.left_out += (out.left_out.empty() ? "" : "; ") + zoom;
    out.model = nodes.finished();
    measure_nodes(scene, out, part_of(progress, 0.9, 1));
    for (const FilmCertificate::PartClaim& part : certificate.parts)
        certificate.bound = std::max(certificate.bound, part.bound);
    out.model.extras = to_json(certificate);
    return out;
}

} // namespace trivar
