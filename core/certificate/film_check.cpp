// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/film_check.h"

#include "core/base/parallel.h"
#include "core/certificate/places_in_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace trivar {
namespace {

// Finds the part in this frame if it has the triangles of the file; null if not.
const Part* shown_in(const EvaluatedObject& object, const FilmStrip& strip)
{
    const Ref<Mesh>& rest = strip.first().rest;
    for (const Part& part : object.parts)
        if (part.key == strip.key)
            return part.rest == rest || same_faces(*part.rest, *rest) ? &part : nullptr;
    return nullptr;
}

void compare(FilmSample& sample, const CommonMesh& common, const Part& truth,
             const std::vector<glm::dvec3>& file, double frame, bool at_moment)
{
    const auto raise = [](double& most, double value) { // also to NaN
        if (!(value <= most))
            most = std::isfinite(value) ? value : std::numeric_limits<double>::infinity();
    };
    const auto add = [&](const glm::dvec3& shown, const glm::dvec3& true_place) {
        ++sample.samples;
        const double off = glm::distance(shown, true_place);
        if (at_moment) raise(sample.furthest_at_moments, off);
        raise(sample.reach, glm::length(true_place));
        if (off <= sample.furthest) return;
        raise(sample.furthest, off);
        sample.at_frame = frame;
    };
    if (!truth.bent) {
        const std::vector<glm::dvec3> scene = places_in_scene(truth);
        for (std::size_t v = 0; v < file.size(); ++v) add(file[v], scene[v]);
        return;
    }
    const Mesh flat = before_volume(common, truth);
    const auto there = [&](const glm::dvec3& p) {
        return deform(p, truth.bent->embedding, *truth.bent->volume).position_world;
    };
    for (std::size_t v = 0; v < file.size(); ++v)
        add(file[v], there(glm::dvec3(flat.positions[v])));
    for (std::size_t c = 0; c + 2 < flat.corners.size(); c += 3) {
        glm::dvec3 shown(0), middle(0);
        for (std::size_t k = 0; k < 3; ++k) {
            shown += file[flat.corners[c + k]] / 3.0;
            middle += glm::dvec3(flat.positions[flat.corners[c + k]]) / 3.0;
        }
        add(shown, there(middle));
    }
}

} // namespace

std::vector<FilmSample> sampled_film(const AnimatedExport& exported, const Document& document,
                                     const Ref<AssetStore>& assets, int per_frame,
                                     const Progress& progress)
{
    const FilmCertificate& claims = exported.certificate;
    const Document plain = unrefined(document);
    Evaluator evaluator(assets, ShutIncisions::stay);
    const std::vector<double>& moments = exported.film.moments;
    const std::vector<double> rate = moments_of({claims.first_frame, claims.last_frame}, per_frame);
    std::vector<double> frames = rate;
    if (!std::ranges::all_of(claims.parts, is_proven)) {
        frames.clear();
        std::ranges::set_union(rate, moments, std::back_inserter(frames));
    }
    const Model& model = exported.model;
    const Clip* clip = model.clips.empty() ? nullptr : &model.clips.front();
    std::vector<FilmSample> out(claims.parts.size());
    std::vector<const Channel*> weights;
    for (const FilmCertificate::PartClaim& claim : claims.parts)
        weights.push_back(weights_of_node(model, claim.node));
    // A Comparison holds the last comparison of a part and its number of samples, so that a part at
    // rest is compared once.
    struct Comparison {
        Ref<EvaluatedObject> object;
        const Part* part = nullptr;
        std::size_t samples = 0;
    };
    std::vector<Comparison> last(out.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const double frame = frames[i];
        report(progress, static_cast<double>(i) / static_cast<double>(frames.size()), "comparing");
        const Evaluation now = evaluator(plain, frame);
        const double time_s = (frame - claims.first_frame) / claims.frames_per_second;
        const Stance stance = stance_at(model, clip, time_s);
        const auto after = std::ranges::lower_bound(moments, frame);
        const auto next = static_cast<std::size_t>(after - moments.begin());
        const bool at_moment = *after == frame, at_rate = std::ranges::binary_search(rate, frame);
        const std::size_t before = at_moment ? next : next - 1;
        parallel_blocks(out.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t p = begin; p < end; ++p) {
                const bool proven = is_proven(claims.parts[p]);
                if (proven && !at_rate) continue;
                const FilmStrip& strip = exported.film.strips[p];
                if (!strip.shown[before] || !strip.shown[next]) continue;
                const auto object = now.objects.find(strip.object);
                if (object == now.objects.end()) continue;
                const Part* truth = shown_in(*object->second, strip);
                if (!truth) continue;
                if (claims.parts[p].way == "still" && last[p].part == truth) {
                    out[p].samples += last[p].samples;
                    continue;
                }
                last[p] = {object->second, truth, out[p].samples};
                compare(out[p], exported.common[p], *truth,
                        places_in_file(model, claims.parts[p].node, stance, weights[p], time_s),
                        frame, at_moment && !proven);
                last[p].samples = out[p].samples - last[p].samples;
            }
        });
    }
    return out;
}

} // namespace trivar
