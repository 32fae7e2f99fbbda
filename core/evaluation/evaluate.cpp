// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/evaluate.h"

#include "core/base/digest.h"
#include "core/base/mistake.h"
#include "core/base/parallel.h"
#include "core/base/recent.h"
#include "core/base/rejected.h"
#include "core/document/bases.h"
#include "core/document/parameters.h"
#include "core/evaluation/far_places.h"
#include "core/stages/inside_material.h"
#include "core/stages/shapes.h"
#include "core/stages/shown_volume.h"
#include "core/steps/bending/lattices.h"
#include "core/tetrahedra/tetrahedra_shaper.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <typeinfo>

namespace trivar {
namespace {

// Lists the objects that an object depends on: its hosts, the base that it is painted on, and the
// lattices that bend it.
std::vector<Id> comes_from(const Document& document, Id id)
{
    std::vector<Id> out = lattices_round(document, id);
    for (const BaseUse& each : bases_of(object(document, id))) out.push_back(each.base);
    return out;
}

// Lists the objects to evaluate, each after those it depends on: the visible ones and their hosts.
// It is not recursive, because a hostile file may stack objects by the thousand.
std::vector<Id> order_of(const Document& document)
{
    struct OpenObject {
        Id id;
        std::size_t next;
        std::vector<Id> before;
    };
    std::vector<Id> order;
    std::set<Id> seen;
    std::vector<OpenObject> open;
    for (const auto& [root, ref] : document.objects) {
        if (!visible(document, root) || !seen.insert(root).second) continue;
        open.push_back({root, 0, comes_from(document, root)});
        while (!open.empty()) {
            OpenObject& last = open.back();
            if (last.next >= last.before.size()) {
                order.push_back(last.id);
                open.pop_back();
            } else if (const Id before = last.before[last.next++]; seen.insert(before).second)
                open.push_back({before, 0, comes_from(document, before)});
        }
    }
    return order;
}

// Repeats one plain material for each material that the shape has, but for those of `layers`.
Ref<std::vector<Material>> surfaced(std::vector<Material> own, const Surfacing& surfacing,
                                    std::size_t layers)
{
    for (std::size_t i = 0; i + layers < own.size(); ++i) {
        const bool double_sided = own[i].double_sided;
        own[i] = material_of(surfacing);
        own[i].double_sided = double_sided;
    }
    return make_ref(std::move(own));
}

void add_control_points(Box& box, const Lattice& volume)
{
    const std::array<Knots, 3>& axes = volume.displacement.axes;
    for (int i = 0; i < axes[0].count(); ++i)
        for (int j = 0; j < axes[1].count(); ++j)
            for (int k = 0; k < axes[2].count(); ++k) box.add(control_point(volume, i, j, k));
}

void add_control_points(Box& box, const TetrahedraEffects& effects)
{
    const SimplexVolume& volume = *effects.tetrahedra->volume;
    const std::vector<glm::dvec3>& rest = volume.layers.front()->rest();
    for (std::size_t i = 0; i < rest.size(); ++i)
        box.add(glm::dvec3(effects.tetrahedra_to_world *
                           glm::dvec4(rest[i] + volume.displacements[i], 1)));
}

// The first stage holds the shape of the object's source, before any step.
Stage begun(const Ref<Shape>& shape)
{
    Stage stage;
    stage.shape = shape;
    stage.notices = shape->notices;
    stage.lacks = shape->lacks;
    return stage;
}

EvaluatedObject finished(Id id, const Ref<Stage>& stage, const Object& object)
{
    EvaluatedObject result;
    static_cast<Stage&>(result) = *stage;
    result.id = id;
    for (const Clip& clip : stage->shape->model->clips) result.clips.push_back(clip.name);
    const Ref<std::vector<Material>>& own = stage->shape->materials;
    result.materials = object.surfacing ? surfaced(*own, *object.surfacing, stage->layers) : own;
    if (stage->mixed_materials) {
        std::vector<Material> all = *result.materials;
        all.insert(all.end(), stage->mixed_materials->begin(), stage->mixed_materials->end());
        result.materials = make_ref(std::move(all));
    }
    const bool has_cage = kind_of(object).has_cage;
    result.bounds = Lazy<Box>([stage, has_cage] {
        Box box;
        for (const Part& part : with_points(stage->parts, stage->curves))
            box.add(bounds_in_world(part));
        if (has_cage) add_control_points(box, *stage->seen_cage());
        if (stage->tetrahedra) add_control_points(box, *stage);
        if (stage->shape->volume)
            for (const glm::dvec3& p : stage->shape->volume->seen_corners(stage->own_to_world))
                box.add(p);
        return box;
    });
    return result;
}

// The steps of one object that failed, where that is told.
class Failures {
public:
    Failures(OnFailure on_failure, Id object) : on_failure_(on_failure), object_(object) {}

    // Whether the work of that step came to its end.
    template <class Work> bool without_failure(const char* step, Work&& work)
    {
        if (on_failure_ == OnFailure::pass_on) return work(), true;
        try {
            work();
            return true;
        } catch (const Cancelled&) {
            throw;
        } catch (const std::exception& trouble) {
            all_.push_back({object_, step, words_of(trouble), is_mistake(trouble)});
            return false;
        }
    }
    const std::vector<FailedStep>& all() const { return all_; }

private:
    OnFailure on_failure_;
    Id object_;
    std::vector<FailedStep> all_;
};

// Returns the stage with notices of the failed steps.
Stage told_of(const Stage& stage, const std::vector<FailedStep>& failed)
{
    Stage out = stage;
    for (const FailedStep& each : failed) {
        out.lacks.push_back(
            fmt::format("{}. The step is kept, and the object is shown without it", each.words));
        out.notices.push_back(out.lacks.back());
    }
    return out;
}

} // namespace

struct Evaluator::Cache {
    struct ObjectCache { // of one object
        Ref<Object> object;
        Ref<Shape> shape;
        Recent<Ref<Shape>, Ref<Stage>> begun;
        std::vector<std::unique_ptr<Step>> steps = all_steps();
        Recent<std::pair<Ref<Stage>, std::vector<FailedStep>>, Ref<Stage>> told;
        Recent<std::pair<Ref<Stage>, std::optional<Surfacing>>, Ref<EvaluatedObject>> finished;
        Recent<std::pair<Ref<EvaluatedObject>, glm::dvec3>, Ref<EvaluatedObject>> moved;
    };
    Cache(Ref<AssetStore> store, ShutIncisions shut, OnFailure manner)
        : assets(store),
          shapes(std::move(store)),
          shut_incisions(shut),
          on_failure(manner)
    {
    }
    // Forgets results that neither the document nor a kept result uses. An object that undo brings
    // back is computed again.
    void forget_unused(const Document& document)
    {
        std::erase_if(objects, [&](const auto& o) { return !document.objects.contains(o.first); });
        ray_meshes.forget_unused();
        shapes.forget_unused();
    }

    Ref<AssetStore> assets;
    Shapes shapes;
    RayMeshes ray_meshes;
    std::map<Id, ObjectCache> objects;
    ShutIncisions shut_incisions;
    FarPlaces far_places;
    OnFailure on_failure;
};

Evaluator::Evaluator(Ref<AssetStore> assets, ShutIncisions shut, OnFailure on_failure)
    : cache_(std::make_unique<Cache>(std::move(assets), shut, on_failure))
{
}

Evaluator::~Evaluator() = default;

Evaluation Evaluator::operator()(const Document& still, double frame, const Progress& progress)
{
    const Document far = document_at(still, frame);
    Evaluation result;
    std::map<Id, Ref<EvaluatedObject>> done;
    std::vector<Id> order = order_of(far);
    std::erase_if(order, [&](Id id) { return !kind_of(far, id).has_shape; });
    std::map<Id, Failures> failed;
    for (const Id id : order) {
        const Ref<Object>& ref = far.objects.at(id);
        Cache::ObjectCache& kept = cache_->objects[id];
        Failures& failures = failed.try_emplace(id, cache_->on_failure, id).first->second;
        if ((!kept.object || !kept.shape || kept.object->source != ref->source ||
             kept.shape->empty()) && // a missing file may have come back
            !failures.without_failure("its shape", [&] {
                kept.shape = cache_->shapes(ref->source, result.timings, progress);
            }))
            kept.shape = make_ref(shape_of(make_ref(Model{})));
        kept.object = ref;
    }
    const auto shape_of = [&](Id id) -> const Shape& { return *cache_->objects.at(id).shape; };
    const auto laid = [&](Id id) { return object(far, id).stroke.has_value(); };
    const FarPlaces::Near near = cache_->far_places(far, order, shape_of);
    const Document& document = near.document;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Id id = order[i];
        const Ref<Object>& ref = document.objects.at(id);
        report(progress, static_cast<double>(i) / static_cast<double>(order.size()), ref->name);
        Cache::ObjectCache& kept = cache_->objects.at(id);
        Failures& failures = failed.at(id);
        const StepInput input{document,
                              id,
                              *ref,
                              frame,
                              done,
                              cache_->ray_meshes,
                              result.timings,
                              progress,
                              *cache_->assets,
                              cache_->shut_incisions};
        Ref<Stage> stage = kept.begun(kept.shape, [&] { return make_ref(begun(kept.shape)); });
        for (std::size_t k = 0; k < kept.steps.size(); ++k) {
            Step& step = *kept.steps[k];
            if (!failures.without_failure(typeid(step).name(), [&] { stage = step(stage, input); }))
                kept.steps[k] = std::move(all_steps()[k]); // with nothing half-made
        }
        if (!failures.all().empty()) {
            stage = kept.told({stage, failures.all()},
                              [&] { return make_ref(told_of(*stage, failures.all())); });
            std::ranges::copy(failures.all(), std::back_inserter(result.failed));
        }
        const Ref<EvaluatedObject>& object = kept.finished(
            {stage, ref->surfacing}, [&] { return make_ref(finished(id, stage, *ref)); });
        done.emplace(id, object);
        if (!visible(document, id)) continue;
        const auto moved = near.moved_by.find(id);
        result.objects.emplace(
            id, moved == near.moved_by.end() ? object : kept.moved({object, moved->second}, [&] {
                return make_ref(
                    finished(id, make_ref(moved_on(*object, moved->second, id, laid)), *ref));
            }));
    }
    cache_->forget_unused(document);
    return result;
}

void deform_parts(Evaluation& evaluated, bool with_tiles)
{
    std::vector<Part> parts; // whose vertices nobody asked for yet
    std::size_t vertices = 0;
    for (const auto& [id, object] : evaluated.objects)
        for (Part& part : with_points(object->parts, object->curves))
            if (!is_deformed(part) && (with_tiles || !part.drawn_from_tiles())) {
                vertices += part.vertex_count();
                parts.push_back(std::move(part));
            }
    if (parts.empty()) return;
    timed(evaluated.timings, "deform", [&] {
        parallel_blocks(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) parts[i].mesh();
        });
    });
    evaluated.timings.add("deform", 0, vertices);
}

std::string digest(const Evaluation& evaluated)
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
        for (const CurvePart& part : ref->curves) {
            digest.add(part.points.to_world);
            digest.add(std::span<const glm::vec3>(part.points.mesh()->positions));
            digest.add(std::span<const std::uint32_t>(part.curves->begin));
        }
    }
    return digest.hex();
}

} // namespace trivar
