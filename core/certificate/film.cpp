// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/film.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/base/whole_numbers.h"
#include "core/evaluation/pattern_colors.h"
#include "core/steps/lacking.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <set>

namespace trivar {
namespace {

// Counts the parts that differ from the evaluation before.
std::size_t others(const Evaluation& now, const Evaluation* before)
{
    std::size_t out = 0;
    for (const auto& [id, ref] : now.objects) {
        const bool same = before && before->objects.contains(id) && before->objects.at(id) == ref;
        if (!same) out += ref->parts.size();
    }
    return out;
}

void check_kept(std::size_t kept, std::size_t moments)
{
    if (kept > most_kept)
        throw Rejected(fmt::format("{} moments of this scene need more than {} parts in memory; "
                                   "export fewer frames at once",
                                   moments, most_kept));
}

// Finds the piece that has the triangles of the part, or adds a new one.
FilmStrip& piece_of(std::vector<FilmStrip>& pieces, const Part& part, double frame)
{
    const auto has_them = [&](const FilmStrip& strip) {
        const Ref<Mesh>& rest = strip.first().rest;
        return rest == part.rest || same_faces(*rest, *part.rest);
    };
    if (const auto found = std::ranges::find_if(pieces, has_them); found != pieces.end())
        return *found;
    FilmStrip next = pieces.front();
    constexpr std::size_t most_pieces = 1000;
    if (pieces.size() >= most_pieces)
        throw Rejected(fmt::format("{}: its triangles change more than {} times, and every change "
                                   "makes another mesh; remove the keys that change them",
                                   printable(next.name), most_pieces));
    next.piece = static_cast<int>(pieces.size());
    next.name += fmt::format(" from frame {}", shortest(frame));
    std::ranges::fill(next.shown, nullptr);
    pieces.push_back(std::move(next));
    return pieces.back();
}

} // namespace

bool same_faces(const Mesh& a, const Mesh& b)
{
    return a.vertex_count() == b.vertex_count() && a.corners == b.corners &&
           a.face_begin == b.face_begin;
}

FrameRange frame_range(const std::string& text, const Time& time)
{
    if (text.empty()) return {time.first_frame, time.last_frame};
    const std::vector<int> n = whole_numbers(text, ':');
    if (n.empty() || n.size() > 2)
        throw Rejected(fmt::format("--frames {}: must be A:B, such as 1:240", text));
    const FrameRange out{n.front(), n.back()};
    if (out.last < out.first)
        throw Rejected(fmt::format(
            "--frames {}: the last frame comes before the first; write A:B, such as 1:240", text));
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

bool FilmStrip::reshaped() const
{
    const Ref<Mesh>& rest = first().rest;
    return std::ranges::any_of(shown, [&](const Part* part) { return part && part->rest != rest; });
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

Film film_of(const Document& document, const Ref<AssetStore>& assets, std::vector<double> moments,
             const Progress& progress)
{
    Film film;
    film.moments = std::move(moments);
    film.kept = film.moments.size();
    check_kept(film.kept, film.moments.size());
    const Document plain = unrefined(document);
    Evaluator evaluator(assets, ShutIncisions::stay);
    PatternColors patterns;
    for (std::size_t i = 0; i < film.moments.size(); ++i) {
        report(progress, static_cast<double>(i) / static_cast<double>(film.moments.size()),
               "going through the frames");
        film.evaluated.push_back(patterns(evaluator(plain, film.moments[i])));
        film.kept += others(film.evaluated[i], i > 0 ? &film.evaluated[i - 1] : nullptr);
        check_kept(film.kept, film.moments.size());
    }
    std::map<std::pair<Id, PartKey>, std::vector<FilmStrip>> strips;
    for (std::size_t i = 0; i < film.moments.size(); ++i)
        for (const auto& [id, ref] : film.evaluated[i].objects)
            for (const Part& part : ref->parts) {
                std::vector<FilmStrip>& pieces = strips[{id, part.key}];
                if (pieces.empty()) {
                    pieces.push_back({.object = id,
                                      .key = part.key,
                                      .name = object(document, id).name,
                                      .shown = std::vector<const Part*>(film.moments.size()),
                                      .materials = ref->materials});
                    pieces.front().shown[i] = &part;
                } else {
                    piece_of(pieces, part, film.moments[i]).shown[i] = &part;
                }
            }
    Id of = 0;
    int number = 0;
    for (auto& [key, pieces] : strips) {
        number = key.first == of ? number + 1 : 0;
        of = key.first;
        for (FilmStrip& piece : pieces) piece.number = number;
        std::ranges::move(pieces, std::back_inserter(film.strips));
    }
    return film;
}

std::vector<std::string> lacks(const Film& film, const Document& document)
{
    std::vector<std::string> out;
    std::set<std::string> said;
    for (const Evaluation& evaluated : film.evaluated)
        for (std::string& sentence : lacks(evaluated, document))
            if (said.insert(sentence).second) out.push_back(std::move(sentence));
    return out;
}

Mesh mesh_in_world(const Part& part)
{
    const Mesh before = part.posed ? posed(*part.rest, part.posed->pose) : *part.rest;
    return part.bent ? deform(before, part.bent->embedding, *part.bent->volume)
                     : transformed(before, part.to_world);
}

} // namespace trivar
