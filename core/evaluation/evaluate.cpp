// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/evaluate.h"

#include "core/base/digest.h"
#include "core/base/parallel.h"
#include "core/document/band.h"
#include "core/evaluation/lacking.h"
#include "core/document/parameters.h"
#include "core/evaluation/in_lattices.h"
#include "core/evaluation/laying.h"
#include "core/evaluation/posing.h"
#include "core/evaluation/refining.h"
#include "core/evaluation/walking.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// What an object lies on, and the lattices that bend it.
std::vector<Id> comes_from(const Document& document, Id id)
{
    std::vector<Id> out = lattices_round(document, id);
    if (const Object& o = object(document, id); o.placement)
        out.insert(out.end(), o.placement->onto.begin(), o.placement->onto.end());
    return out;
}

// The objects to evaluate, each after those it comes from: the visible ones and what carries them.
// Not recursive, for a hostile file may stack objects by the thousand.
std::vector<Id> order_of(const Document& document)
{
    struct Open {
        Id id;
        std::size_t next;
        std::vector<Id> before;
    };
    std::vector<Id> order;
    std::set<Id> seen;
    std::vector<Open> open;
    for (const auto& [root, ref] : document.objects) {
        if (!visible(document, root) || !seen.insert(root).second) continue;
        open.push_back({root, 0, comes_from(document, root)});
        while (!open.empty()) {
            Open& last = open.back();
            if (last.next >= last.before.size()) {
                order.push_back(last.id);
                open.pop_back();
            } else if (const Id before = last.before[last.next++]; seen.insert(before).second)
                open.push_back({before, 0, comes_from(document, before)});
        }
    }
    return order;
}

// What a placement goes round, if that is still there and stands free.
std::optional<Band> band_of(const Document& document, const PlacementStep& step)
{
    if (!step.round || step.onto.empty()) return {};
    const Object& base = object(document, step.onto.front());
    if (base.placement) return {};
    return band_round(base.source, step.round->level, to_world(document, step.onto.front()));
}

// One plain material, as often as the shape has materials of its own.
Ref<std::vector<Material>> surfaced(const std::vector<Material>& own, const Surfacing& surfacing)
{
    std::vector<Material> plain(own.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
        plain[i].base_color = surfacing.base_color;
        plain[i].metallic = surfacing.metallic;
        plain[i].roughness = surfacing.roughness;
        plain[i].solid = surfacing.solid;
        plain[i].double_sided = own[i].double_sided;
        if (surfacing.base_color.a < 1) plain[i].alpha = Material::Alpha::blend;
    }
    return make_ref(std::move(plain));
}

struct Causes { // all that one evaluated object comes from
    Ref<Shape> shape;
    Ref<Laid> laid;
    glm::dmat4 to_world{1};
    std::optional<Surfacing> surfacing;
    bool feet_on_nothing = false; // they are to be locked to a travel, and there is no stroke
    std::vector<Ref<ShapedVolume>> lattices = {}; // that it stands in, the innermost first
    Ref<ShapedVolume> box = nullptr;              // its own, where it is a lattice
    bool operator==(const Causes&) const = default;
};

void tell_of_steps(const ShapedVolume& shaped, std::vector<std::string>& notices)
{
    for (std::size_t i = 0; i < shaped.steps.size(); ++i)
        if (const std::string& notice = shaped.steps[i].notice; !notice.empty())
            notices.push_back(fmt::format("step {} of its shaping: {}", i + 1, notice));
}

void add_control_points(Box& box, const Lattice& volume)
{
    const std::array<Knots, 3>& axes = volume.displacement.axes;
    for (int i = 0; i < axes[0].count(); ++i)
        for (int j = 0; j < axes[1].count(); ++j)
            for (int k = 0; k < axes[2].count(); ++k) box.add(control_point(volume, i, j, k));
}

EvaluatedObject evaluated_object(Id id, const Causes& causes, InLattices& in_lattices)
{
    EvaluatedObject result;
    result.id = id;
    result.notices = causes.shape->notices;
    result.lacks = causes.shape->lacks;
    for (const Clip& clip : causes.shape->model->clips) result.clips.push_back(clip.name);
    if (causes.laid && causes.laid->placement) {
        result.placement = causes.laid->placement;
        result.shaped = causes.laid->shaped;
        result.lies_on = causes.laid->scene;
        result.parts = causes.laid->parts;
        result.refined = causes.laid->refined;
        if (!causes.laid->not_refined.empty()) result.notices.push_back(causes.laid->not_refined);
        result.journey = causes.laid->journey;
        result.walk = causes.laid->walk;
        if (result.walk && !result.walk->trouble.empty())
            result.notices.push_back(result.walk->trouble);
        if (result.walk && !result.walk->remark.empty())
            result.notices.push_back(result.walk->remark);
        if (result.journey && result.journey->travel().speed != 0 && !result.journey->has_room())
            result.notices.emplace_back(
                "it fills its whole stroke and has no room to travel; make its fill smaller");
        const std::vector<std::string> more = causes.laid->placement->report.all_notices();
        result.notices.insert(result.notices.end(), more.begin(), more.end());
        if (result.shaped) tell_of_steps(*result.shaped, result.notices);
    } else
        for (const Shape::Hung& hung : causes.shape->meshes)
            result.parts.push_back({hung.rest, causes.to_world * hung.to_model, hung.posed, nullptr,
                                    hung.slot, hung.bounds});
    if (causes.box) {
        result.placement = causes.box->placement;
        result.shaped = causes.box;
        tell_of_steps(*causes.box, result.notices);
    }
    leave_out_what_is_out_of_reach(result);
    result.parts = in_lattices(std::move(result.parts), causes.lattices);
    if (causes.feet_on_nothing)
        result.notices.emplace_back("its feet are locked to its travel, and it lies on no stroke");
    if (causes.laid && !causes.laid->rejected.empty()) {
        result.rejected = causes.laid->rejected;
        result.notices.push_back(result.rejected);
    }
    result.materials = causes.surfacing ? surfaced(*causes.shape->materials, *causes.surfacing)
                                        : causes.shape->materials;
    result.bounds = Lazy<Box>([parts = result.parts, volume = causes.box] {
        Box box;
        for (const Part& part : parts) box.add(bounding_box(*part.mesh(), part.to_world));
        if (volume) add_control_points(box, *volume->volume->volume);
        return box;
    });
    return result;
}

bool moves(const EvaluatedObject& object)
{
    return object.journey && object.journey->travel().speed != 0;
}

// What a stroke may fall on, and which of it travels.
struct Supports {
    std::vector<Support> all, still;
    std::vector<Ref<EvaluatedObject>> travelling;
};
Supports supports_of(const PlacementStep& step, const std::map<Id, Ref<EvaluatedObject>>& done)
{
    Supports out;
    for (const Id lower : step.onto) {
        const auto found = done.find(lower);
        if (found == done.end()) continue;
        const EvaluatedObject& object = *found->second;
        for (const Part& part : object.parts) {
            out.all.push_back({lower, part});
            if (!moves(object)) out.still.push_back({lower, part});
        }
        if (moves(object) && !object.parts.empty()) out.travelling.push_back(found->second);
    }
    return out;
}

// What travels counts in the frames in which it is where the strip is seen. So a stroke is not laid
// anew for all that passes by somewhere else.
bool travels_through(const Supports& supports, const Laid& without, const Camera& camera)
{
    return !without.placement ||
           std::ranges::any_of(supports.travelling, [&](const Ref<EvaluatedObject>& each) {
               return in_the_way(*each->bounds, *without.placement, camera);
           });
}

} // namespace

struct Evaluator::Cache {
    struct Kept {
        Ref<Object> object;
        Ref<Shape> shape;
        Laying laying;
        Posing posing;
        RefiningLaid refining;
        Walking walking;
        BoxVolume box;
        InLattices in_lattices;
        // What is laid, and all that follow it, as they have gone and stand by then.
        Ref<Laid> gone(const Object& o, const Ref<Laid>& laid, double playing_s,
                       double travelling_s);
        std::vector<std::pair<Causes, Ref<EvaluatedObject>>> results; // the latest first
    };
    explicit Cache(Ref<AssetStore> assets) : shapes(std::move(assets)) {}
    // What no object of the document and none of the kept results needs any more. An object that
    // is gone may come back by undo, but then it is computed anew.
    void forget_unused(const Document& document)
    {
        std::erase_if(objects, [&](const auto& o) { return !document.objects.contains(o.first); });
        std::set<Ref<Mesh>> meshes;
        for (const auto& [id, kept] : objects) kept.laying.add_meshes(meshes);
        ray_meshes.keep_only(meshes);
        shapes.forget_unused();
    }

    Shapes shapes;
    RayMeshes ray_meshes;
    std::map<Id, Kept> objects;
};

Ref<Laid> Evaluator::Cache::Kept::gone(const Object& o, const Ref<Laid>& laid, double playing_s,
                                       double travelling_s)
{
    const PlacementParameters& parameters = o.placement->parameters;
    const glm::dmat3 turned(o.transform.matrix());
    const Ref<Journey> journey = laying.journey(laid, o.travel, parameters);
    const Ref<Walk> walk = walking(shape, o.playing, laid, journey, parameters, turned);
    const auto clip = std::ranges::find(shape->model->clips, o.playing.clip, &Clip::name);
    const bool plays = clip != shape->model->clips.end();
    posing.keep(3 * static_cast<std::size_t>(o.travel.followers + 2));
    std::vector<Member> members;
    for (int k = 0; k <= o.travel.followers; ++k) {
        Member member{nullptr, journey ? journey->at(travelling_s, k) : Journey::Place{}};
        Playing playing = o.playing;
        if (plays) playing.offset += k * o.travel.phase * (clip->end_s - clip->begin_s);
        if (plays && walk && walk->trouble.empty())
            member.posed = posing.at(shape, *clip, walk->clip_time_s(playing, member.place.gone_u),
                                     walk->gait);
        else if (plays)
            member.posed = posing(shape, playing, playing_s);
        members.push_back(std::move(member));
    }
    return laying.moved(laid, members, turned, journey, parameters, walk);
}

Evaluator::Evaluator(Ref<AssetStore> assets) : cache_(std::make_unique<Cache>(std::move(assets))) {}

Evaluator::~Evaluator() = default;

Evaluated Evaluator::operator()(const Document& still, double frame, const Progress& progress)
{
    const Document document = document_at(still, frame);
    Evaluated result;
    std::map<Id, Ref<EvaluatedObject>> done;
    const std::vector<Id> order = order_of(document);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Id id = order[i];
        const Ref<Object>& ref = document.objects.at(id);
        if (std::holds_alternative<GroupShape>(ref->source)) continue;
        report(progress, static_cast<double>(i) / static_cast<double>(order.size()), ref->name);
        Cache::Kept& kept = cache_->objects[id];
        if (!kept.object || !kept.shape || kept.object->source != ref->source ||
            kept.shape->meshes.empty()) // a missing file may have come back
            kept.shape = cache_->shapes(ref->source, result.timings, progress);
        kept.object = ref;
        const auto seconds_since = [&](int start_frame) {
            return (frame - start_frame) / document.time.frames_per_second;
        };
        const double playing_s = seconds_since(ref->playing.start_frame);
        const Ref<Shape> posed = kept.posing(kept.shape, ref->playing, playing_s);
        Causes causes{posed, nullptr, to_world(document, id), ref->surfacing};
        causes.feet_on_nothing =
            !ref->placement && ref->playing.foot_lock && !ref->playing.clip.empty();
        if (const auto* lattice = std::get_if<LatticeShape>(&ref->source))
            causes.box =
                kept.box(*lattice, ref->shaping, causes.to_world, result.timings, progress);
        for (const Id round : lattices_round(document, id))
            causes.lattices.push_back(done.at(round)->shaped);
        if (ref->placement) {
            const auto laid_on = [&](const std::vector<Support>& supports) {
                return kept.laying(kept.shape, glm::dmat3(ref->transform.matrix()), *ref->placement,
                                   band_of(document, *ref->placement), ref->shaping, supports,
                                   cache_->ray_meshes, result.timings, progress);
            };
            const Supports supports = supports_of(*ref->placement, done);
            if (supports.travelling.empty() || supports.still.empty()) {
                causes.laid = laid_on(supports.all);
            } else {
                causes.laid = laid_on(supports.still);
                if (travels_through(supports, *causes.laid, ref->placement->sketch.camera))
                    causes.laid = laid_on(supports.all);
            }
            causes.laid =
                kept.gone(*ref, causes.laid, playing_s, seconds_since(ref->travel.start_frame));
            if (ref->refining)
                causes.laid = kept.refining(causes.laid, *ref->refining, result.timings, progress);
        }
        auto& results = kept.results;
        const auto found =
            std::ranges::find_if(results, [&](const auto& known) { return known.first == causes; });
        if (found != results.end())
            std::rotate(results.begin(), found, found + 1);
        else {
            Ref<EvaluatedObject> fresh = make_ref(evaluated_object(id, causes, kept.in_lattices));
            results.insert(results.begin(), {std::move(causes), std::move(fresh)});
            constexpr std::size_t kept_results = 3; // as Laying keeps
            if (results.size() > kept_results) results.pop_back();
        }
        done.emplace(id, results.front().second);
        if (visible(document, id)) result.objects.emplace(id, results.front().second);
    }
    cache_->forget_unused(document);
    return result;
}

void deform_parts(Evaluated& evaluated)
{
    std::vector<const Part*> parts; // whose vertices nobody asked for yet
    std::size_t vertices = 0;
    for (const auto& [id, object] : evaluated.objects)
        for (const Part& part : object->parts)
            if (!is_deformed(part)) {
                parts.push_back(&part);
                vertices += part.rest->vertex_count();
            }
    if (parts.empty()) return;
    timed(evaluated.timings, "deform", [&] {
        parallel_blocks(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) parts[i]->mesh();
        });
    });
    evaluated.timings.add("deform", 0, vertices);
}

std::string digest(const Evaluated& evaluated)
{
    Digest digest;
    for (const auto& [id, ref] : evaluated.objects) {
        digest.add(id);
        for (const Part& part : ref->parts) {
            digest.add(part.to_world);
            digest.add(std::span<const glm::vec3>(part.mesh()->positions));
            digest.add(std::span<const glm::vec3>(part.mesh()->normals));
            digest.add(std::span<const std::uint32_t>(part.mesh()->corners));
            digest.add(std::span<const std::uint32_t>(part.mesh()->face_begin));
        }
    }
    return digest.hex();
}

} // namespace trivar
