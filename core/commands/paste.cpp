// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/paste.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/commands/cutting/split.h"
#include "core/commands/edits/edits.h"
#include "core/commands/edits/numbering.h"
#include "core/commands/json_text.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/shape.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/commands/tiles/mask_tiles.h"
#include "core/commands/tiles/mix_tiles.h"
#include "core/commands/tiles/tiles.h"
#include "core/document/band.h"
#include "core/document/bases.h"
#include "core/document/parameters.h"
#include "core/placement/round.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <utility>

namespace trivar {
namespace {

using CopiedIds = std::map<Id, Id>; // by the ids at the place where they were copied

Object object_of(const CopiedObject& copy, const CopiedIds& made)
{
    Object out = copy.value;
    check_values(out);
    if (const auto* file = std::get_if<ImportedFile>(&out.source); file && file->path.empty())
        throw Rejected("field \"path\" names no file");
    if (out.name.empty()) throw Rejected("field \"name\" is empty");
    const auto parent = made.find(out.parent);
    if (out.parent != 0 && parent == made.end())
        throw Rejected(fmt::format("field \"parent\": no object {} comes before {}", out.parent,
                                   excerpt(out.name)));
    if (out.parent != 0) out.parent = parent->second;
    if (out.shaping.size() > most_shaping_steps)
        throw Rejected(
            fmt::format("field \"shaping\": {} is shaped in {} steps; at most {} are allowed",
                        out.name, out.shaping.size(), most_shaping_steps));
    for (const Ref<VolumeEdit>& edit : out.shaping) check(*edit);
    return out;
}

// The object before it is laid, painted, parted and animated.
Object bare(Object o)
{
    o.stroke.reset();
    o.tiles.reset();
    o.splitting.reset();
    o.travel = {};
    o.tracks = {};
    if (!kind_of(o).has_cage) o.shaping.clear();
    if (!kind_of(o).has_clips) o.playing = {};
    return o;
}

// Finds the supports of a copy that has the bases it is to have here.
std::vector<Id> supports_of(const PlacementStep& stroke, const Document& document)
{
    std::vector<Id> bases = stroke.onto;
    if (stroke.round)
        std::erase_if(bases, [&](Id id) {
            const Object& base = object(document, id);
            if (base.stroke) return true;
            return stroke.round->normal ? !kind_of(base).has_surface
                                        : !band_round(base.source, 0, glm::dmat4(1));
        });
    return bases;
}

Document laid(Document document, Id id, const Object& copy, const std::vector<Id>& bases)
{
    const PlacementStep& p = *copy.stroke;
    if (p.round && bases.empty()) return document;
    if (p.round)
        document = applied(std::move(document), PlaceRound{id, bases.front(), p.round->level,
                                                           p.parameters, p.round->normal});
    else if (!bases.empty() || !possible_bases(document, id).empty())
        document = applied(std::move(document), Place{id, p.sketch, p.parameters, bases, p.attach});
    else
        return document;
    document = with_changed(std::move(document), id, [&](Object& o) { o.shaping = copy.shaping; });
    if (copy.travel == Travel{}) return document;
    return applied(std::move(document), SetTravel{{id}, copy.travel});
}

// Makes a copy a layer of tiles if its base was copied too or is in the scene.
Document painted(Document document, Id id, Tiling tiling)
{
    for (const Ref<TileStroke>& stroke : tiling.strokes) check(*stroke);
    if (tiling.base == 0) return document;
    if (tiling.masks.size() > most_masks)
        throw Rejected(fmt::format("field \"masks\" has {} entries but at most {} are taken",
                                   tiling.masks.size(), most_masks));
    for (const TileMask& mask : tiling.masks) check_mask(document, id, mask);
    const double weight = std::exchange(tiling.weight, 1);
    const Id into = std::exchange(tiling.into, 0);
    std::vector<MixedTile> others = std::exchange(tiling.others, {});
    document = with_tiling(std::move(document), id, std::move(tiling));
    document = with_mix(std::move(document), id, weight, std::move(others));
    return with_morph(std::move(document), id, into);
}

// Adds tracks, except those of parameters that the copy does not have.
Document animated(Document document, Id id, std::vector<Track> tracks)
{
    const std::vector<Parameter> known = parameters(object(document, id));
    std::erase_if(tracks, [&](const Track& track) {
        return std::ranges::find(known, track.parameter, &Parameter::name) == known.end();
    });
    if (tracks.empty()) return document;
    return applied(std::move(document), Animate{{{id, std::move(tracks)}}});
}

CopiedObject copy_of(const Document& document, Id id, bool inside, const std::string& folder)
{
    CopiedObject copy{id, object(document, id), {}};
    Object& o = copy.value;
    if (!inside && o.parent != 0 && !o.stroke) o.transform = decomposed(to_world(document, id));
    if (!inside) o.parent = 0;
    if (!o.stroke) o.travel = {};
    if (!kind_of(o).has_clips) o.playing = {};
    if (o.tiles && !document.objects.contains(o.tiles->base)) o.tiles.reset();
    each_file(o, [&](const auto& file, auto&) {
        if (file.kind != FileKind::font && !file.path.empty())
            file.path = (std::filesystem::path(folder) / file.path).lexically_normal().string();
    });
    for (const BaseUse& use : bases_of(o))
        if (const auto base = document.objects.find(use.base); base != document.objects.end())
            copy.names.try_emplace(use.base, base->second->name);
    return copy;
}

} // namespace

KnownObject known(const KnownNames& names, Id id)
{
    const auto found = names.find(id);
    return {id, found == names.end() ? std::string() : found->second};
}

bool CopiedObject::operator==(const CopiedObject& other) const
{
    return this == &other || value_json(*this) == value_json(other);
}

void refuse_second_shape(std::string_view field)
{
    throw Rejected(
        fmt::format("field \"{}\": its object has another shape and can have one", field));
}

Document applied(Document document, const Paste& command)
{
    if (command.copies.empty()) throw Rejected("field \"copies\" names no object");
    const Document before = document;
    Numbering names(before);
    CopiedIds made;
    for (const CopiedObject& copy : command.copies) {
        Object pasted = bare(object_of(copy, made));
        if (pasted.parent == 0) pasted.name = names.unique(pasted.name);
        if (!made.emplace(copy.object, document.next_id).second)
            throw Rejected(fmt::format("field \"copies\" has object {} twice", copy.object));
        document = with_added(std::move(document), std::move(pasted));
    }
    for (const auto& [copied_id, id] : made) check_own_depth(document, id);
    // A copy depends on the copy of what it did, or on the object itself if the scene has it.
    std::vector<std::pair<Id, Object>> wanted;
    for (const CopiedObject& copy : command.copies) {
        const auto here = [&](Id base) -> Id {
            if (const auto copied = made.find(base); copied != made.end()) return copied->second;
            const auto there = before.objects.find(base);
            const auto name = copy.names.find(base);
            return there != before.objects.end() && name != copy.names.end() &&
                           there->second->name == name->second
                       ? base
                       : 0;
        };
        const Id id = made.at(copy.object);
        wanted.emplace_back(id, with_bases(copy.value, here));
        if (const Object& o = object(document, id); !bases_of(o).empty())
            document.objects.set(id, make_ref(with_bases(o, here)));
    }
    // Copies with known supports are placed first; a copy laid over everything then leaves out
    // those that lie on it.
    for (const bool known : {true, false})
        for (const auto& [id, copy] : wanted) {
            if (!copy.stroke) continue;
            const std::vector<Id> bases = supports_of(*copy.stroke, document);
            if (bases.empty() != known) document = laid(std::move(document), id, copy, bases);
        }
    for (const auto& [id, copy] : wanted)
        if (copy.tiles) document = painted(std::move(document), id, *copy.tiles);
    for (const auto& [id, copy] : wanted)
        if (copy.splitting && !copy.splitting->obstacles.empty())
            document = applied(std::move(document), Split{{id}, *copy.splitting});
    for (const auto& [copied_id, id] : made)
        if (const Object& o = object(document, id);
            o.refining && !o.stroke && lattices_round(document, id).empty())
            document = with_changed(std::move(document), id,
                                    [](Object& changed) { changed.refining.reset(); });
    for (const auto& [id, copy] : wanted) document = animated(std::move(document), id, copy.tracks);
    return document;
}

StepTitle title(const Paste&, const StepDocuments& step)
{
    std::vector<Id> ids;
    for (const auto& [id, each] : step.after.objects)
        if (id >= step.before.next_id && each->parent < step.before.next_id) ids.push_back(id);
    return {"Paste " + names_in(step.after, ids), {}};
}

Paste copied(const Document& document, const std::vector<Id>& ids, const std::string& folder)
{
    Paste paste;
    std::set<Id> chosen;
    for (const Id id : ids)
        if (document.objects.contains(id)) chosen.insert(id);
    const std::set<Id> all = with_contents(document, chosen);
    std::map<Id, std::vector<Id>> inside; // by group, 0: those in no group that is copied
    for (const Id row : in_row_order(document)) {
        const Id parent = object(document, row).parent;
        if (all.contains(row)) inside[all.contains(parent) ? parent : 0].push_back(row);
    }
    const auto add = [&](auto&& self, Id group) -> void {
        for (const Id id : inside[group]) {
            paste.copies.push_back(copy_of(document, id, group != 0, folder));
            self(self, id); // groups come before their contents
        }
    };
    add(add, 0);
    return paste;
}

} // namespace trivar
