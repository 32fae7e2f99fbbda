// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/paste.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/commands/edits/edits.h"
#include "core/commands/edits/numbering.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/shape.h"
#include "core/commands/placement/place.h"
#include "core/commands/tiles/mask_tiles.h"
#include "core/commands/volumes/lattice.h"
#include "core/document/band.h"
#include "core/document/fields/object_fields.h"
#include "core/document/parameters.h"
#include "core/placement/round.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <typeindex>

namespace trivar {
namespace {

using CopiedIds = std::map<Id, Id>; // by the ids at the place where they were copied

// Gives fields of one value to those of another that have the same name and type.
void give_alike(const auto& from, auto& to)
{
    std::map<std::string_view, std::pair<std::type_index, const void*>> given;
    each_field(from, [&]<class T>(std::string_view name, const T& value, auto&&...) {
        given.insert({name, {typeid(T), &value}});
    });
    each_field(to, [&]<class T>(std::string_view name, T& value, auto&&...) {
        if (const auto found = given.find(name);
            found != given.end() && found->second.first == typeid(T))
            value = *static_cast<const T*>(found->second.second);
    });
}

// Calls visit(shape) for each field of a copy that can hold a shape.
void each_shape(auto& copy, auto&& visit)
{
    visit(copy.file);
    visit(copy.plane);
    visit(copy.box);
    visit(copy.sphere);
    visit(copy.cylinder);
    visit(copy.torus);
    visit(copy.moebius);
    visit(copy.teapot);
    visit(copy.text);
    visit(copy.lattice);
    visit(copy.heights);
    visit(copy.voxels);
    visit(copy.tetrahedra);
    visit(copy.sheet);
}

Source source_of(const CopiedObject& copy)
{
    Source source = GroupShape{};
    int shapes = 0;
    each_shape(copy, [&](const auto& shape) {
        if (!shape) return;
        source = *shape;
        ++shapes;
    });
    if (shapes > 1)
        throw Rejected(fmt::format("field \"copies\": object {} has {} shapes but can have one",
                                   copy.object, shapes));
    if (const auto* file = std::get_if<ImportedFile>(&source); file && file->path.empty())
        throw Rejected("field \"path\" names no file");
    if (const auto* text = std::get_if<TextShape>(&source)) check(*text);
    if (const auto* lattice = std::get_if<LatticeShape>(&source)) check(*lattice);
    if (const auto* heights = std::get_if<HeightShape>(&source)) check(*heights);
    if (const auto* voxels = std::get_if<VoxelShape>(&source)) check(*voxels);
    if (const auto* cells = std::get_if<TetrahedraShape>(&source)) check(*cells);
    return source;
}

// Returns the edits of the volume of a copy. Throws Rejected if one is not valid.
std::vector<Ref<VolumeEdit>> as_refs(const CopiedObject& copy)
{
    if (copy.shaping.size() > most_shaping_steps)
        throw Rejected(
            fmt::format("field \"shaping\": {} is shaped in {} steps; at most {} are allowed",
                        copy.name, copy.shaping.size(), most_shaping_steps));
    std::vector<Ref<VolumeEdit>> out;
    for (const VolumeEdit& edit : copy.shaping) {
        check(edit);
        out.push_back(make_ref(edit));
    }
    return out;
}

Object object_of(const CopiedObject& copy, const CopiedIds& made)
{
    check_transform(copy.transform);
    if (copy.refining) check(*copy.refining);
    if (copy.cutting) check(*copy.cutting);
    if (copy.incising) check(*copy.incising);
    if (copy.name.empty()) throw Rejected("field \"name\" is empty");
    const auto parent = made.find(copy.parent);
    if (copy.parent != 0 && parent == made.end())
        throw Rejected(fmt::format("field \"parent\": no object {} comes before {}", copy.parent,
                                   excerpt(copy.name)));
    Object out;
    give_alike(copy, out);
    out.source = source_of(copy);
    out.parent = copy.parent == 0 ? 0 : parent->second;
    if (copy.lattice) out.shaping = as_refs(copy);
    if (copy.file && copy.playing) out.playing = *copy.playing;
    return out;
}

// Finds the object that a copy refers to: the copy of it, or the object itself if the scene has it;
// 0 if neither.
Id here(const KnownObject& known, const Document& before, const CopiedIds& made)
{
    if (const auto copy = made.find(known.object); copy != made.end()) return copy->second;
    const auto there = before.objects.find(known.object);
    return there != before.objects.end() && there->second->name == known.name ? known.object : 0;
}

// Finds the supports of the copy: those of the original that were copied too, or that are in the
// scene.
std::vector<Id> supports_of(const CopiedPlacement& placement, const Document& before,
                            const Document& document, const CopiedIds& made)
{
    std::vector<Id> bases;
    for (const KnownObject& known : placement.onto)
        if (const Id id = here(known, before, made); id != 0) bases.push_back(id);
    if (placement.round)
        std::erase_if(bases, [&](Id id) {
            const Object& base = object(document, id);
            if (base.stroke) return true;
            return placement.normal ? holds_others(base.source)
                                    : !band_round(base.source, 0, glm::dmat4(1));
        });
    return bases;
}

Document laid(Document document, Id id, const CopiedObject& copy, const std::vector<Id>& bases,
              const CopiedIds& made)
{
    const CopiedPlacement& p = *copy.placement;
    if (p.round && bases.empty()) return document;
    std::optional<Attachment> attached;
    if (p.attach)
        attached = renumbered(*p.attach, [&](Id host) -> std::optional<Id> {
            const auto copied = made.find(host);
            const Id here = copied != made.end() ? copied->second : host;
            if (std::ranges::find(bases, here) == bases.end()) return {};
            return here;
        });
    if (p.round)
        document = applied(std::move(document),
                           PlaceRound{id, bases.front(), p.level, p.parameters, p.normal});
    else if (!bases.empty() || !possible_bases(document, id).empty())
        document = applied(std::move(document), Place{id, p.sketch, p.parameters, bases, attached});
    else
        return document;
    document = with_changed(std::move(document), id, [&](Object& o) { o.shaping = as_refs(copy); });
    if (!copy.travel) return document;
    return applied(std::move(document), SetTravel{{id}, *copy.travel});
}

// Makes a copy a layer of tiles if its base was copied too or is in the scene.
Document painted(Document document, Id id, const CopiedTiling& copied, const Document& before,
                 const CopiedIds& made)
{
    Tiling tiling{here(copied.base, before, made), copied.look, {}};
    tiling.cover = copied.cover;
    for (const TileStroke& stroke : copied.strokes) {
        check(stroke);
        tiling.strokes.push_back(make_ref(stroke));
    }
    if (tiling.base == 0) return document;
    std::vector<MixedTile> others;
    for (const CopiedMixedTile& each : copied.others)
        if (const Id other = here(each.tile, before, made); other != 0)
            others.push_back({other, each.weight});
    if (copied.masks.size() > most_masks)
        throw Rejected(fmt::format("field \"masks\" has {} entries but at most {} are taken",
                                   copied.masks.size(), most_masks));
    for (const CopiedMask& each : copied.masks) {
        TileMask mask = each.mask;
        mask.curve = each.around ? here(*each.around, before, made) : 0;
        check_mask(document, id, mask);
        tiling.masks.push_back(std::move(mask));
    }
    document = with_tiling(std::move(document), id, std::move(tiling));
    document = with_mix(std::move(document), id, copied.weight, std::move(others));
    return with_morph(std::move(document), id, copied.into ? here(*copied.into, before, made) : 0);
}

// Lets a copy be parted by those of its obstacles that were copied too or are in the scene.
Document parted(Document document, Id id, const CopiedSplitting& copied, const Document& before,
                const CopiedIds& made)
{
    Splitting splitting = copied.splitting;
    splitting.obstacles.clear();
    for (std::size_t i = 0; i < std::min(copied.known.size(), copied.splitting.obstacles.size());
         ++i)
        if (const Id obstacle = here(copied.known[i], before, made); obstacle != 0) {
            splitting.obstacles.push_back(copied.splitting.obstacles[i]);
            splitting.obstacles.back().object = obstacle;
        }
    if (splitting.obstacles.empty()) return document;
    return applied(std::move(document), Split{{id}, std::move(splitting)});
}

// Gives the incisions of a copy those of their blades that were copied too or are in the scene.
Document with_blades(Document document, Id id, const CopiedObject& copy, const Document& before,
                     const CopiedIds& made)
{
    return with_changed(std::move(document), id, [&](Object& o) {
        for (NamedIncision& each : o.incising->cuts) {
            const auto known = std::ranges::find(copy.blades, each.blade, &KnownObject::object);
            each.blade =
                each.blade == 0 || known == copy.blades.end() ? 0 : here(*known, before, made);
        }
    });
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
    const Object& each = object(document, id);
    CopiedObject copy;
    give_alike(each, copy);
    copy.object = id;
    each_shape(copy, [&]<class Shape>(std::optional<Shape>& shape) {
        if (const auto* own = std::get_if<Shape>(&each.source)) shape = *own;
    });
    if (copy.file)
        copy.file->path =
            (std::filesystem::path(folder) / copy.file->path).lexically_normal().string();
    if (copy.heights)
        copy.heights->image =
            (std::filesystem::path(folder) / copy.heights->image).lexically_normal().string();
    if (copy.voxels)
        copy.voxels->path =
            (std::filesystem::path(folder) / copy.voxels->path).lexically_normal().string();
    copy.transform = inside || each.parent == 0 || each.stroke ? each.transform
                                                               : decomposed(to_world(document, id));
    copy.parent = inside ? each.parent : 0;
    if (copy.file && each.playing != Playing{}) copy.playing = each.playing;
    copy.tracks = each.tracks;
    for (const Ref<VolumeEdit>& edit : each.shaping) copy.shaping.push_back(*edit);
    if (each.tiles && document.objects.contains(each.tiles->base)) {
        const Id base = each.tiles->base;
        copy.tiling = CopiedTiling{{base, object(document, base).name}, each.tiles->look, {}};
        for (const Ref<TileStroke>& stroke : each.tiles->strokes)
            copy.tiling->strokes.push_back(*stroke);
        copy.tiling->cover = each.tiles->cover;
        copy.tiling->weight = each.tiles->weight;
        if (const Id into = each.tiles->into; into != 0 && document.objects.contains(into))
            copy.tiling->into = {into, object(document, into).name};
        for (const TileMask& mask : each.tiles->masks) {
            CopiedMask& known = copy.tiling->masks.emplace_back(CopiedMask{mask});
            known.mask.curve = 0;
            if (!mask.image.empty())
                known.mask.image =
                    (std::filesystem::path(folder) / mask.image).lexically_normal().string();
            if (mask.curve != 0 && document.objects.contains(mask.curve))
                known.around = {mask.curve, object(document, mask.curve).name};
        }
        for (const MixedTile& mixed : each.tiles->others)
            if (document.objects.contains(mixed.object))
                copy.tiling->others.push_back(
                    {{mixed.object, object(document, mixed.object).name}, mixed.weight});
    }
    if (each.incising)
        for (const NamedIncision& cut : each.incising->cuts)
            if (cut.blade != 0 && document.objects.contains(cut.blade))
                copy.blades.push_back({cut.blade, object(document, cut.blade).name});
    if (each.splitting) {
        copy.splitting = CopiedSplitting{*each.splitting, {}};
        for (const ObstacleUse& by : each.splitting->obstacles)
            copy.splitting->known.push_back({by.object, object(document, by.object).name});
    }
    if (!each.stroke) return copy;
    copy.placement = {each.stroke->sketch,
                      each.stroke->parameters,
                      {},
                      each.stroke->round.has_value(),
                      each.stroke->round ? each.stroke->round->level : 0,
                      each.stroke->attach,
                      each.stroke->round ? each.stroke->round->normal : std::nullopt};
    for (const Id base : each.stroke->onto)
        copy.placement->onto.push_back({base, object(document, base).name});
    if (each.travel != Travel{}) copy.travel = each.travel;
    return copy;
}

} // namespace

Document applied(Document document, const Paste& command)
{
    if (command.copies.empty()) throw Rejected("field \"copies\" names no object");
    const Document before = document;
    Numbering names(before);
    CopiedIds made;
    for (const CopiedObject& copy : command.copies) {
        Object pasted = object_of(copy, made);
        if (pasted.parent == 0) pasted.name = names.unique(pasted.name);
        if (!made.emplace(copy.object, document.next_id).second)
            throw Rejected(fmt::format("field \"copies\" has object {} twice", copy.object));
        document = with_added(std::move(document), std::move(pasted));
    }
    for (const auto& [copied_id, id] : made) check_own_depth(document, id);
    // Copies with known supports are placed first; a copy laid over everything then leaves out
    // those that lie on it.
    for (const bool known : {true, false})
        for (const CopiedObject& copy : command.copies) {
            if (!copy.placement) continue;
            const std::vector<Id> bases = supports_of(*copy.placement, before, document, made);
            if (bases.empty() != known)
                document = laid(std::move(document), made.at(copy.object), copy, bases, made);
        }
    for (const CopiedObject& copy : command.copies)
        if (copy.tiling)
            document =
                painted(std::move(document), made.at(copy.object), *copy.tiling, before, made);
    for (const CopiedObject& copy : command.copies)
        if (copy.splitting)
            document =
                parted(std::move(document), made.at(copy.object), *copy.splitting, before, made);
    for (const CopiedObject& copy : command.copies)
        if (copy.incising)
            document = with_blades(std::move(document), made.at(copy.object), copy, before, made);
    for (const auto& [copied_id, id] : made)
        if (const Object& o = object(document, id);
            o.refining && !o.stroke && lattices_round(document, id).empty())
            document = with_changed(std::move(document), id,
                                    [](Object& changed) { changed.refining.reset(); });
    for (const CopiedObject& copy : command.copies)
        document = animated(std::move(document), made.at(copy.object), copy.tracks);
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
