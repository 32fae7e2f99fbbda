// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/far_places.h"

#include "core/base/joined_sets.h"
#include "core/document/bases.h"
#include "core/mesh/far_origin.h"
#include "core/split/split_field.h"
#include "core/steps/laying/following.h"

#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

bool counts_the_ground(const Object& object)
{
    return object.stroke && (object.stroke->parameters.on_ground ||
                             object.stroke->parameters.misses == Misses::ground);
}

// Returns a box that shows where an object stands. It is empty if the object's own transform does
// not decide that: it lies on a stroke, or its tiles lie on their base.
Box place_of(const Document& document, Id id, const Shape& shape)
{
    const Object& object = trivar::object(document, id);
    Box out;
    if (object.stroke || object.tiles) return out;
    const glm::dmat4 to_world = trivar::to_world(document, id);
    if (kind_of(object).bends_others) out.add(glm::dvec3(to_world[3]));
    const auto add = [&](const Box& box, const glm::dmat4& to_model) {
        if (box.empty()) return;
        const glm::dmat4 matrix = to_world * to_model;
        for (const glm::dvec3& corner : box.corners())
            out.add(glm::dvec3(matrix * glm::dvec4(corner, 1)));
    };
    for (const Shape::NodeMesh& hung : shape.meshes) add(hung.bounds, hung.to_model);
    for (const Shape::NodeCurves& hung : shape.curves) add(hung.bounds, hung.to_model);
    return out;
}

// The object without those whose copies stand among its tiles, wherever they stand themselves.
Object without_mixed(Object object)
{
    if (!object.tiles) return object;
    object.tiles->others.clear();
    object.tiles->into = 0;
    return object;
}

// Groups of objects that depend on each other, and where they stand.
class Companies {
public:
    explicit Companies(const Document& document) : sets_(document.objects.size())
    {
        for (const auto& [id, object] : document.objects) number_.emplace(id, number_.size());
        for (const auto& [id, object] : document.objects) {
            if (object->parent != 0) join(id, object->parent);
            for (const BaseUse& use : bases_of(without_mixed(*object))) join(id, use.base);
        }
    }
    std::uint32_t of(Id id) { return sets_.root(static_cast<std::uint32_t>(number_.at(id))); }

private:
    void join(Id a, Id b)
    {
        const auto x = number_.find(a), y = number_.find(b);
        if (x != number_.end() && y != number_.end())
            sets_.join(static_cast<std::uint32_t>(x->second),
                       static_cast<std::uint32_t>(y->second));
    }
    std::map<Id, std::size_t> number_;
    JoinedSets sets_;
};

glm::dmat4 shift(const glm::dvec3& by)
{
    return glm::translate(glm::dmat4(1), by);
}

// A matrix from a space to a space that both go along.
glm::dmat4 along(const glm::dmat4& matrix, const glm::dvec3& by)
{
    return shift(by) * matrix * shift(-by);
}

void move(Sketch& sketch, const glm::dvec3& by)
{
    sketch.camera.eye += by;
    sketch.camera.target += by;
}

Object moved(Object object, const glm::dvec3& by, const Document& document)
{
    if (object.parent == 0) object.transform.translation += by;
    if (!object.stroke) return object;
    move(object.stroke->sketch, by);
    if (!object.stroke->attach) return object;
    Attachment& attach = *object.stroke->attach;
    const auto laid = [&](std::size_t host) {
        const auto found = document.objects.find(attach.hosts[host].object);
        return found != document.objects.end() && found->second->stroke;
    };
    for (AttachedSample& sample : attach.samples)
        if (sample.host >= 0 && laid(static_cast<std::size_t>(sample.host))) sample.drawn += by;
    for (std::size_t h = 0; h < attach.hosts.size(); ++h) {
        AttachedHost& host = attach.hosts[h];
        const glm::dmat4 stood = host.stood();
        host.origin = glm::dvec3((laid(h) ? along(stood, by) : shift(by) * stood)[3]);
    }
    return object;
}

void move(Part& part, const glm::dvec3& by)
{
    part.to_world = shift(by) * part.to_world;
    if (!part.bent) return;
    Deformation bent = *part.bent; // its vertices stay where they are
    bent.embedding.to_rest = shift(by) * bent.embedding.to_rest;
    part.bent = make_ref(std::move(bent));
}

void move(std::vector<Support>& supports, const glm::dvec3& by, const std::function<bool(Id)>& laid)
{
    for (Support& each : supports) {
        move(each.part, by);
        each.own_to_drawn = each.id == 0 || laid(each.id) ? along(each.own_to_drawn, by)
                                                          : shift(by) * each.own_to_drawn;
    }
}

Ref<RayScene> moved(const RayScene& scene, const glm::dvec3& by)
{
    std::vector<RayScene::Entry> entries = scene.entries();
    for (RayScene::Entry& each : entries) each.to_world = shift(by) * each.to_world;
    return std::make_shared<const RayScene>(std::move(entries));
}

} // namespace

FarPlaces::Near FarPlaces::operator()(const Document& document, const std::vector<Id>& order,
                                      const std::function<const Shape&(Id)>& shape_of)
{
    std::map<Id, Box> place_of_object;
    bool any_is_far = false;
    for (const Id id : order) {
        const Box& place = place_of_object[id] = place_of(document, id, shape_of(id));
        any_is_far = any_is_far || far_origin(place) != glm::dvec3(0);
    }
    Near out{document};
    if (!any_is_far) {
        moved_.clear();
        return out;
    }
    // A few that are near keep all on which they depend where it is.
    Companies companies(document);
    std::map<std::uint32_t, Box> places;
    std::map<std::uint32_t, bool> on_ground;
    for (const Id id : order) {
        places[companies.of(id)].add(place_of_object.at(id));
        if (counts_the_ground(object(document, id))) on_ground[companies.of(id)] = true;
    }
    std::map<Id, Ref<Object>> kept;
    for (const auto& [id, object] : document.objects) {
        const std::uint32_t company = companies.of(id);
        const auto place = places.find(company);
        glm::dvec3 origin = place == places.end() ? glm::dvec3(0) : far_origin(place->second);
        if (on_ground.contains(company)) origin.z = 0;
        if (origin == glm::dvec3(0)) continue;
        Object there = moved(*object, -origin, document); // hangs on its hosts, too
        const auto known = moved_.find(id);
        const bool same = known != moved_.end() && *known->second == there;
        const Ref<Object> made = same ? known->second : make_ref(std::move(there));
        out.document.objects.set(id, made);
        out.moved_by.emplace(id, origin);
        kept.emplace(id, made);
    }
    moved_ = std::move(kept);
    return out;
}

Stage moved_on(Stage stage, const glm::dvec3& by, Id id, const std::function<bool(Id)>& laid)
{
    const glm::dmat4 there = shift(by);
    const auto move_all = [&](std::vector<Part>& parts) {
        for (Part& part : parts) move(part, by);
    };
    move_all(stage.parts);
    move_all(stage.whole_parts);
    for (CurvePart& curve : stage.curves) move(curve.points, by);
    if (stage.shaped) {
        const bool own = stage.placement == stage.shaped->placement;
        stage.shaped = carried(*stage.shaped, there);
        if (own)
            stage.placement = stage.shaped->placement;
        else if (stage.placement)
            stage.placement = make_ref(carried(*stage.placement, there));
    } else if (stage.placement) {
        stage.placement = make_ref(carried(*stage.placement, there));
    }
    if (stage.lattice_stroke)
        stage.lattice_stroke =
            make_ref(LatticeStroke{make_ref(carried(*stage.lattice_stroke->placement, there)),
                                   {stage.lattice_stroke->embedding.to_uvw * shift(-by),
                                    along(stage.lattice_stroke->embedding.to_rest, by)}});
    if (stage.bent_cage)
        stage.bent_cage = make_ref(Lazy<Ref<Lattice>>(
            [cage = stage.bent_cage, there] { return make_ref(mapped(***cage, there)); }));
    stage.tetrahedra_to_world = there * stage.tetrahedra_to_world;
    if (stage.lies_on) stage.lies_on = moved(*stage.lies_on, by);
    if (stage.supports) {
        std::vector<Support> supports = *stage.supports;
        move(supports, by, laid);
        stage.supports = make_ref(std::move(supports));
    }
    if (stage.stroke_motion) {
        StrokeMotion stroke_motion = *stage.stroke_motion;
        stroke_motion.to_world = along(stroke_motion.to_world, by);
        move(stroke_motion.sketch, by);
        move(stroke_motion.supports, by, laid);
        stage.stroke_motion = make_ref(std::move(stroke_motion));
    }
    stage.own_to_world = laid(id) ? along(stage.own_to_world, by) : there * stage.own_to_world;
    if (laid(id)) move_all(stage.own_parts);
    if (stage.split_field) {
        SplitField field = *stage.split_field;
        field.frame.origin += by;
        stage.split_field = make_ref(std::move(field));
    }
    return stage;
}

} // namespace trivar
