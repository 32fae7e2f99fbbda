// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/incising.h"

#include "core/base/mean_scale.h"
#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/base/share_along.h"
#include "core/stages/inside_material.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace trivar {
namespace {

constexpr double reach_of_strokes = 0.01; // of the diagonal of the skin
constexpr double hardly_narrowed = 0.995; // share of the width
constexpr double much_narrowed = 0.5;     // share of the opening or of the depth at a place
constexpr const char* off_the_mesh = "it leaves the surface";

// The way of strokes from the model to one of its meshes.
struct ToMesh {
    explicit ToMesh(const glm::dmat4& to_model)
        : points(glm::inverse(to_model)),
          normals(glm::transpose(glm::dmat3(to_model))),
          metres(mean_scale(to_model))
    {
    }
    SurfacePoint operator()(const SurfacePoint& on_model) const
    {
        SurfacePoint out{glm::dvec3(points * glm::dvec4(on_model.p, 1)), normals * on_model.normal};
        const double length = glm::length(out.normal);
        out.normal = length > 0 ? out.normal / length : on_model.normal;
        return out;
    }
    Incision operator()(Incision on_model) const
    {
        for (SurfacePoint& each : on_model.stroke) each = (*this)(each);
        on_model.depth /= metres;
        on_model.width /= metres;
        on_model.reach /= metres;
        on_model.bevel /= metres;
        return on_model;
    }

    glm::dmat4 points;
    glm::dmat3 normals;
    double metres; // on the model, of a unit of the mesh
};

using PartOfIncision = IncisingStep::PartOfIncision;

// Divides an incision into parts, by the mesh on which each part of its stroke lies.
std::vector<PartOfIncision> parts_by_mesh(const Incision& cut, std::size_t number,
                                          const std::vector<std::size_t>& mesh_of_point)
{
    std::vector<PartOfIncision> out;
    const double whole = length_of(cut.stroke);
    double length = 0;
    for (std::size_t i = 0; i < cut.stroke.size(); ++i) {
        if (i > 0) length += glm::distance(cut.stroke[i - 1].p, cut.stroke[i].p);
        const std::size_t mesh = mesh_of_point[i];
        const double share = whole > 0 ? length / whole : 0;
        auto part = std::ranges::find(out, mesh, &PartOfIncision::mesh);
        if (part == out.end()) {
            part = out.insert(part, {number, mesh, share, share, cut});
            part->cut.stroke.clear();
        }
        part->to = share;
        part->cut.stroke.push_back(cut.stroke[i]);
    }
    if (out.size() == 1) out[0].from = 0, out[0].to = 1;
    return out;
}

// Adds the outcome of one more part of an incision.
void add(IncisingEffects::OfIncision& told, const PartOfIncision& part,
         const IncisedMesh::Outcome& outcome, double metres)
{
    const bool first = !(told.length > 0);
    if (!outcome.refusal.empty()) {
        if (first) told.refusal = outcome.refusal;
        return;
    }
    told.refusal.clear();
    told.length += outcome.length * metres;
    told.depth = std::max(told.depth, outcome.depth * metres);
    told.widest = first ? outcome.widest : std::max(told.widest, outcome.widest);
    told.least = std::min(told.least, outcome.least);
    told.least_depth = std::min(told.least_depth, outcome.least_depth);
    if (!outcome.shortfall.empty()) told.shortfall = outcome.shortfall;
    if (!outcome.notice.empty()) told.notice = outcome.notice;
    if (!first)
        told.notice = "it goes over several meshes, and each has its part";
    else if (part.from > 0 || part.to < 1)
        if (told.notice.empty()) told.notice = "it ends where the surface does";
}

// Whether keys or a blade may open any of these incisions.
bool change_in_time(const Object& object, const std::vector<PartOfIncision>& incisions)
{
    return std::ranges::any_of(incisions, [&](const PartOfIncision& part) {
        const std::string of_incision = fmt::format("incising.cuts.{}.", part.number);
        return object.incising->cuts[part.number].blade != 0 ||
               std::ranges::any_of(object.tracks, [&](const Track& t) {
                   return t.parameter.starts_with(of_incision);
               });
    });
}

// Returns only the values on which the topology and the numbering of walls depend.
Incising without_openings(Incising incising)
{
    for (NamedIncision& each : incising.cuts) {
        each.name.clear();
        each.opening = {};
        each.blade = 0;
    }
    incising.flaps.clear();
    for (IncisionLayer& layer : incising.layers) layer = {.depth = layer.depth};
    return incising;
}

InciseOptions options_for(const Incising& incising, std::size_t first_material, double metres)
{
    InciseOptions out;
    out.rows = incising.rows;
    out.reach = reach_of_strokes;
    for (const IncisionLayer& layer : incising.layers)
        out.layers.push_back(
            {layer.depth / metres, static_cast<std::uint32_t>(first_material + out.layers.size())});
    return out;
}

std::string told_as(const Incising& incising, std::size_t i)
{
    const std::string& name = incising.cuts[i].name;
    return name.empty() ? fmt::format("incision {}", i + 1) : fmt::format("\"{}\"", name);
}

void tell_of_incisions(Stage& stage, const Incising& incising)
{
    for (std::size_t i = 0; i < incising.cuts.size(); ++i) {
        if (incising.cuts[i].hidden) continue;
        const IncisingEffects::OfIncision& of = stage.incisions[i];
        if (of.refusal.empty() && !of.notice.empty())
            stage.notices.push_back(
                fmt::format("{} is cut in part: {}", told_as(incising, i), of.notice));
        if (!of.refusal.empty())
            stage.notices.push_back(
                fmt::format("{} is left out: {}", told_as(incising, i), of.refusal));
        else if (!of.shortfall.empty())
            stage.notices.push_back(fmt::format(
                "{} {}: {}", told_as(incising, i),
                incising.cuts[i].cut.floor == Incision::Floor::through ? "does not go through"
                                                                       : "keeps its piece",
                of.shortfall));
        else if (of.widest < hardly_narrowed)
            stage.notices.push_back(
                fmt::format("{} opens to {} of its width, because its walls would meet "
                            "beyond; reduce its width or its depth",
                            told_as(incising, i), percent_text(of.widest)));
        else if (of.least < much_narrowed)
            stage.notices.push_back(
                fmt::format("{} opens less at a place, because its walls would meet there",
                            told_as(incising, i)));
        else if (of.least_depth < much_narrowed)
            stage.notices.push_back(
                fmt::format("{} is shallower at a place, where the body has room for {} of "
                            "its depth",
                            told_as(incising, i), percent_text(of.least_depth)));
    }
}

// Where a flap lies, by the incisions of a wound; nothing: not in that wound.
std::optional<FlapPlace> place_of(const PeeledFlap& flap,
                                  const std::vector<PartOfIncision>& incisions)
{
    const auto of = [&](int number) {
        return std::ranges::find(incisions, static_cast<std::size_t>(number) - 1,
                                 &PartOfIncision::number);
    };
    const auto first = of(flap.first), second = of(flap.second);
    if (first == incisions.end() || second == incisions.end()) return {};
    return FlapPlace{static_cast<std::uint32_t>(first - incisions.begin()),
                     static_cast<std::uint32_t>(second - incisions.begin()), flap.side_of_first,
                     flap.side_of_second};
}

void tell_of_flaps(Stage& stage, const Incising& incising, const std::vector<char>& lifted)
{
    for (std::size_t k = 0; k < lifted.size(); ++k) {
        const PeeledFlap& flap = incising.flaps[k];
        const auto a = static_cast<std::size_t>(flap.first) - 1,
                   b = static_cast<std::size_t>(flap.second) - 1;
        if (!lifted[k] && !incising.cuts[a].hidden && !incising.cuts[b].hidden)
            stage.notices.push_back(fmt::format("flap {} is not raised: {} and {} do not cross",
                                                k + 1, told_as(incising, a), told_as(incising, b)));
    }
}

// Where the origin of an object is at the frame; of one that a stroke lays, where its middle is.
glm::dvec3 place_of_blade(Id id, const StepInput& input)
{
    const auto found = input.done.find(id);
    if (found != input.done.end() && found->second->stroke_placement() &&
        !found->second->has_no_geometry())
        return found->second->bounds->center();
    return glm::dvec3(to_world(input.document, id)[3]);
}

// The share of a stroke's length at its place nearest to p.
double share_near(const std::vector<SurfacePoint>& stroke, const glm::dvec3& p)
{
    double length = 0, at = 0, nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < stroke.size(); ++i) {
        const glm::dvec3 a = stroke[i - 1].p, way = stroke[i].p - a;
        const double t = share_along(p, a, way), far = glm::length(way);
        if (const double away = glm::distance(a + t * way, p); away < nearest) {
            nearest = away;
            at = length + t * far;
        }
        length += far;
    }
    return length > 0 ? at / length : 1;
}

// The incisions as their blades open them. The object is taken where its transform puts it.
Incising opened_by_blades(Incising incising, const StepInput& input)
{
    std::optional<glm::dmat4> to_own;
    for (NamedIncision& each : incising.cuts) {
        if (each.blade == 0 || !input.document.objects.contains(each.blade)) continue;
        if (!to_own) to_own = glm::inverse(to_world(input.document, input.id));
        const glm::dvec3 at =
            glm::dvec3(*to_own * glm::dvec4(place_of_blade(each.blade, input), 1));
        each.opening.to = std::min(each.opening.to, share_near(each.cut.stroke, at));
    }
    return incising;
}

} // namespace

Ref<SlitSkin> IncisingStep::skin_of(const Ref<Mesh>& mesh, const StepInput& input)
{
    return skins_(mesh, [&] {
        const Ref<RayMesh> rays = input.ray_meshes(mesh, input.timings);
        return timed(input.timings, "incise",
                     [&] { return std::make_shared<const SlitSkin>(rays); });
    });
}

IncisingStep::Wounds IncisingStep::wounds_in(const Shape& shape, const Incising& incising,
                                             const StepInput& input)
{
    const std::size_t meshes = shape.meshes.size();
    skins_.keep(meshes + 2);
    std::vector<ToMesh> ways;
    std::vector<Ref<SlitSkin>> skins;
    for (const Shape::NodeMesh& hung : shape.meshes) {
        ways.emplace_back(hung.to_model);
        skins.push_back(skin_of(hung.rest, input));
    }
    // Returns the distances of points from a mesh, metres on the model; infinite: they do not lie
    // on it.
    const auto distances = [&](std::size_t m, std::span<const SurfacePoint> points) {
        std::vector<SurfacePoint> there;
        for (const SurfacePoint& each : points) there.push_back(ways[m](each));
        const auto places = skins[m]->locate(there, reach_of_strokes * skins[m]->diagonal());
        std::vector<double> out(points.size(), std::numeric_limits<double>::infinity());
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!places[i]) continue;
            const glm::uvec3& t = skins[m]->triangle(places[i]->triangle);
            glm::dvec3 p(0);
            for (int k = 0; k < 3; ++k) p += places[i]->weights[k] * skins[m]->position(t[k]);
            out[i] =
                glm::length(glm::dvec3(shape.meshes[m].to_model * glm::dvec4(p, 1)) - points[i].p);
        }
        return out;
    };
    // Returns the mesh on which each point of a stroke lies: that of the point before if it does,
    // else the nearest, else still that; `meshes`: none.
    const auto meshes_under = [&](const std::vector<SurfacePoint>& stroke) {
        std::vector<std::size_t> out(stroke.size(), 0);
        std::vector<std::vector<double>> away(meshes); // of all points, by mesh that was found
        for (std::size_t i = 0; i < stroke.size() && meshes > 1; ++i) {
            out[i] = i > 0 ? out[i - 1] : meshes;
            if (out[i] < meshes && std::isfinite(away[out[i]][i])) continue;
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t m = 0; m < meshes; ++m)
                if (const double d = distances(m, std::span(&stroke[i], 1)).front(); d < least) {
                    least = d;
                    out[i] = m;
                }
            if (out[i] < meshes && away[out[i]].empty()) away[out[i]] = distances(out[i], stroke);
        }
        return out;
    };

    Wounds out;
    out.told.resize(incising.cuts.size());
    std::vector<std::vector<PartOfIncision>> of_mesh(meshes);
    for (std::size_t i = 0; i < incising.cuts.size(); ++i) {
        if (incising.cuts[i].hidden) continue;
        const Incision& cut = incising.cuts[i].cut;
        for (PartOfIncision& part : parts_by_mesh(cut, i, meshes_under(cut.stroke)))
            if (part.mesh < meshes && part.to > part.from) // not of points at one place
                of_mesh[part.mesh].push_back(std::move(part));
        out.told[i].refusal = off_the_mesh; // until it is known better
    }
    for (std::size_t m = 0; m < meshes; ++m) {
        if (of_mesh[m].empty()) continue;
        std::vector<Incision> cuts;
        for (const PartOfIncision& part : of_mesh[m]) {
            cuts.push_back(ways[m](part.cut));
            // Rows of all incisions share steps of the deepest one's depth, so that none may be
            // deeper than any body
            cuts.back().depth = std::min(cuts.back().depth, 0.5 * skins[m]->diagonal());
        }
        const InciseOptions options =
            options_for(incising, shape.materials->size(), ways[m].metres);
        try {
            const Ref<IncisedMesh> incised = timed(input.timings, "incise", [&] {
                return make_ref(incise(*skins[m], cuts, options, made_, input.progress));
            });
            for (std::size_t k = 0; k < cuts.size(); ++k)
                add(out.told[of_mesh[m][k].number], of_mesh[m][k], incised->outcomes[k],
                    ways[m].metres);
            if (incised->rest != incised->original)
                out.all.push_back({m, incised, of_mesh[m], cuts, ways[m].metres,
                                   std::make_shared<const Extent>(incised->rest)});
        } catch (const Rejected& error) {
            for (const PartOfIncision& part : of_mesh[m])
                if (!(out.told[part.number].length > 0))
                    out.told[part.number].refusal = error.what();
        }
    }
    return out;
}

const IncisingStep::Frames& IncisingStep::frames_of(const Wound& wound,
                                                    const std::vector<FlapPlace>& places,
                                                    const StepInput& input)
{
    return frames_({wound.incised, places}, [&] {
        return timed(input.timings, "incise", [&] {
            Ref<IncisedFlaps> flaps;
            if (!places.empty()) flaps = make_ref(flaps_of(*wound.incised, wound.cuts, places));
            return Frames{flaps, std::make_shared<const OpenedFrames>(wound.incised, flaps)};
        });
    });
}

Ref<Stage> IncisingStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    if (!input.object.incising || before->shape->meshes.empty()) return before;
    const std::optional<Incising> incising = opened_by_blades(*input.object.incising, input);
    return known_({before, *incising}, [&] {
        const Shape& whole = *before->shape;
        const Incising cut = without_openings(*incising);
        const Ref<Wounds> wounds =
            wounds_({before->shape, cut}, [&] { return make_ref(wounds_in(whole, cut, input)); });
        Stage out = *before;
        out.incisions = wounds->told;
        for (std::size_t i = 0; i < incising->cuts.size(); ++i)
            out.incisions[i].open_to = incising->cuts[i].opening.to;
        tell_of_incisions(out, *incising);
        Shape shape = whole;
        open_.keep(3 * (wounds->all.size() + 1));
        frames_.keep(2 * (wounds->all.size() + 1));
        std::vector<char> lifted(incising->flaps.size(), 0);
        for (const Wound& wound : wounds->all) {
            std::vector<IncisionOpening> openings;
            std::vector<std::size_t> incisions;
            for (const PartOfIncision& part : wound.incisions) {
                openings.push_back(part.opened(incising->cuts[part.number].opening));
                incisions.push_back(part.number);
            }
            std::vector<FlapPlace> places;
            std::vector<double> lifts;
            std::vector<std::size_t> numbers;
            for (std::size_t k = 0; k < incising->flaps.size(); ++k)
                if (const auto place = place_of(incising->flaps[k], wound.incisions)) {
                    places.push_back(*place);
                    lifts.push_back(incising->flaps[k].lift / wound.metres);
                    numbers.push_back(k);
                }
            const Frames& made = frames_of(wound, places, input);
            for (std::size_t k = 0; k < numbers.size(); ++k)
                lifted[numbers[k]] = made.flaps->lengths[k] > 0;
            const OpenMesh& open = open_({made.frames, openings, lifts}, [&] {
                return timed(input.timings, "incise", [&] {
                    if (!is_open(*wound.incised, openings) &&
                        input.shut_incisions == ShutIncisions::stay &&
                        change_in_time(input.object, wound.incisions))
                        return OpenMesh{wound.incised->rest, wound.rest};
                    const OpenedFrames::Frame frame = (*made.frames)(openings, lifts);
                    return OpenMesh{frame.mesh, std::make_shared<const Extent>(
                                                    frame.mesh, *wound.rest, frame.box)};
                });
            });
            if (open.mesh == wound.incised->original) continue;
            Shape::NodeMesh& hung = shape.meshes[wound.mesh];
            out.incised_meshes.push_back({hung.slot, wound.incised, std::move(incisions)});
            hung.rest = open.mesh;
            hung.extent = open.extent;
            if (hung.posed) hung.posed = posed_later(open.mesh, hung.posed->pose);
            if (const std::optional<Box> box =
                    open.extent->posed(hung.posed ? &hung.posed->pose : nullptr))
                hung.bounds = *box;
            out.uncut = before;
        }
        tell_of_flaps(out, *incising, lifted);
        if (!out.uncut) return make_ref(std::move(out)); // the shape is the same value
        if (!incising->layers.empty()) {
            std::vector<Material> materials = *whole.materials;
            for (const IncisionLayer& layer : incising->layers) {
                materials.push_back(material_of(layer.look));
                materials.back().name = layer.name;
            }
            out.layers = incising->layers.size();
            shape.materials = make_ref(std::move(materials));
        }
        out.shape = make_ref(std::move(shape));
        return make_ref(std::move(out));
    });
}

} // namespace trivar
