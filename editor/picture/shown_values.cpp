// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/shown_values.h"

#include "core/base/rejected.h"
#include "core/ffd/volume_change.h"
#include "core/steps/bending/refining.h"
#include "editor/picture/checker.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

std::vector<float> bounds_at_vertices(const EvaluatedObject& object, std::size_t part,
                                      const Refining& refining)
{
    if (object.refined) return object.refined->parts.at(part).bound_at;
    const Part& as_it_is = object.parts[part];
    try {
        return bounded(as_it_is, {.tolerance_world = refining.tolerance, .method = refining.method})
            .parts.at(0)
            .bound_at;
    } catch (const Rejected&) {
        return {}; // finer than single precision
    }
}

} // namespace

Ref<std::vector<float>> ShownValues::kept(const Part& part, const By& by, auto&& work_out)
{
    if (!part.bent) return nullptr;
    const std::pair key(part.bent.get(), by);
    if (const auto found = known_.find(key);
        found != known_.end() && found->second.alive.lock() == part.bent)
        return found->second.values;
    std::erase_if(known_, [](const auto& known) { return known.second.alive.expired(); });
    std::vector<float> values = work_out();
    const auto out = values.empty() ? nullptr : make_ref(std::move(values));
    known_[key] = {part.bent, out};
    return out;
}

Ref<std::vector<float>> ShownValues::stretch_of(const Part& part)
{
    return kept(part, {}, [&] {
        std::vector<float> factors =
            volume_change(*part.before_volume(), part.bent->embedding, *part.bent->volume);
        std::vector<float> sizes(factors.size());
        std::ranges::transform(factors, sizes.begin(), [](float f) { return std::abs(f); });
        const auto middle = sizes.begin() + std::ssize(sizes) / 2;
        std::ranges::nth_element(sizes, middle);
        if (middle != sizes.end() && *middle > 0)
            for (float& f : factors) f /= *middle;
        return factors;
    });
}

Ref<std::vector<float>> ShownValues::error_of(const EvaluatedObject& object, std::size_t part,
                                              const Refining& refining)
{
    const By by(refining.tolerance, refining.method, refining.rule);
    return kept(object.parts.at(part), by, [&] {
        std::vector<float> values = bounds_at_vertices(object, part, refining);
        // Between a vertex and one of which nothing is known, colours are to be numbers, too; and
        // what is nothing at all is not folded.
        constexpr float least = 1e-3f, most = 1e6f;
        const auto tolerance = static_cast<float>(refining.tolerance);
        for (float& v : values) v = std::clamp(v / tolerance, least, most);
        return values;
    });
}

Ref<std::vector<float>> ShownValues::uvs_of(const EvaluatedObject& object, std::size_t part,
                                            UvMeasure measure)
{
    if (object.parts.at(part).drawn_from_tiles()) return nullptr;
    double usual = 1;
    if (measure == UvMeasure::areas) {
        UvAreas all;
        for (const Part& each : object.parts) {
            if (each.drawn_from_tiles()) continue;
            const Ref<Mesh>& mesh = each.rest;
            KnownAreas& known = areas_[mesh.get()];
            if (known.alive.lock() != mesh) known = {mesh, uv_areas(*mesh)};
            all.of_texture += known.areas.of_texture;
            all.of_surface += known.areas.of_surface;
        }
        if (all.of_texture > 0 && all.of_surface > 0) usual = all.of_texture / all.of_surface;
        std::erase_if(areas_, [](const auto& known) { return known.second.alive.expired(); });
    }
    const Ref<Mesh>& mesh = object.parts[part].rest;
    KnownUvs& known = uvs_[{mesh.get(), measure, usual}];
    if (known.alive.lock() != mesh) {
        std::vector<float> values = uv_values(*mesh, measure, usual);
        known = {mesh, values.empty() ? nullptr : make_ref(std::move(values))};
    }
    const Ref<std::vector<float>> out = known.values;
    std::erase_if(uvs_, [](const auto& each) { return each.second.alive.expired(); });
    return out;
}

Ref<std::vector<Material>> ShownValues::checkered(std::size_t count)
{
    Ref<std::vector<Material>>& known = checkered_[count];
    if (!known) known = make_ref(std::vector<Material>(count, checker_material()));
    return known;
}

std::optional<double> shown_tolerance(const Document& document)
{
    std::optional<double> common;
    for (const auto& [id, object] : document.objects) {
        if (!object->stroke || !visible(document, id)) continue;
        const double its = object->refining.value_or(Refining{}).tolerance;
        if (common && *common != its) return std::nullopt;
        common = its;
    }
    return common.value_or(Refining{}.tolerance);
}

} // namespace trivar
