// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/film.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/base/whole_numbers.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

bool same_faces(const Mesh& a, const Mesh& b)
{
    return a.vertex_count() == b.vertex_count() && a.corners == b.corners &&
           a.face_begin == b.face_begin;
}

Document unrefined(Document document)
{
    std::vector<Id> refined;
    for (const auto& [id, object] : document.objects)
        if (object->refining) refined.push_back(id);
    for (const Id id : refined) {
        Object changed = object(document, id);
        changed.refining.reset();
        document.objects.set(id, make_ref(std::move(changed)));
    }
    return document;
}

} // namespace

FrameRange frame_range(const std::string& text, const Time& time)
{
    if (text.empty()) return {time.first_frame, time.last_frame};
    const std::vector<int> n = whole_numbers(text, ':');
    if (n.empty() || n.size() > 2)
        throw Rejected(fmt::format("--frames {}: must be A:B, such as 1:240", text));
    const FrameRange out{n.front(), n.back()};
    if (out.last < out.first)
        throw Rejected(fmt::format("--frames {}: must go up, such as 1:240", text));
    if (out.first < time.first_frame || out.last > time.last_frame)
        throw Rejected(fmt::format("--frames {}: the scene's frames are {} to {}", text,
                                   time.first_frame, time.last_frame));
    return out;
}

const Part& FilmStrip::first() const
{
    return **std::ranges::find_if(shown, [](const Part* part) { return part != nullptr; });
}

bool FilmStrip::bent() const
{
    return std::ranges::any_of(shown, [](const Part* part) { return part && part->bent; });
}

bool FilmStrip::posed() const
{
    return std::ranges::any_of(shown, [](const Part* part) { return part && part->posed; });
}

std::vector<double> moments_of(const FrameRange& range, int per_frame)
{
    std::vector<double> out;
    for (int frame = range.first; frame < range.last; ++frame)
        for (int k = 0; k < per_frame; ++k)
            out.push_back(frame + static_cast<double>(k) / per_frame);
    out.push_back(range.last);
    return out;
}

Film film_of(const Document& document, const Ref<AssetStore>& assets, std::vector<double> moments,
             const Progress& progress)
{
    Film film;
    film.moments = std::move(moments);
    const Document plain = unrefined(document);
    Evaluator evaluator(assets);
    for (std::size_t i = 0; i < film.moments.size(); ++i) {
        report(progress, static_cast<double>(i) / static_cast<double>(film.moments.size()),
               "going through the frames");
        film.evaluated.push_back(evaluator(plain, film.moments[i]));
    }
    std::map<std::pair<Id, int>, FilmStrip> strips;
    for (std::size_t i = 0; i < film.moments.size(); ++i)
        for (const auto& [id, ref] : film.evaluated[i].objects)
            for (const Part& part : ref->parts) {
                FilmStrip& strip = strips[{id, part.slot}];
                if (strip.shown.empty()) {
                    strip = {id, part.slot, object(document, id).name,
                             std::vector<const Part*>(film.moments.size()), ref->materials};
                } else if (const Part& first = strip.first();
                           first.rest != part.rest && !same_faces(*first.rest, *part.rest)) {
                    throw Rejected(fmt::format(
                        "{}: its triangles are others at frame {} than before, so it is not one "
                        "mesh that moves; take the keys of what changes them away",
                        printable(strip.name), shortest(film.moments[i])));
                }
                strip.shown[i] = &part;
            }
    for (auto& [key, strip] : strips) film.strips.push_back(std::move(strip));
    return film;
}

Mesh mesh_in_world(const Part& part)
{
    const Mesh before = part.posed ? posed(*part.rest, part.posed->pose) : *part.rest;
    return part.bent ? deform(before, part.bent->embedding, *part.bent->volume)
                     : transformed(before, part.to_world);
}

} // namespace trivar
