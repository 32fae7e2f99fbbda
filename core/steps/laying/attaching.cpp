// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/laying/attaching.h"

#include "core/mesh/barycentric.h"
#include "core/placement/placement.h"
#include "core/placement/view.h"
#include "core/rays/ray_scene.h"
#include "core/stages/stroke_motion.h"

#include <algorithm>
#include <map>

namespace trivar {
namespace {

AttachedSample anchored(const Hit& hit, const RayScene& scene, const Support& support, int host)
{
    const RayScene::Entry& entry = scene.entries()[static_cast<std::size_t>(hit.entry)];
    const glm::uvec3 corners = entry.mesh->triangles()[static_cast<std::size_t>(hit.triangle)];
    std::array<glm::dvec3, 3> in_scene, at_rest;
    const Mesh& rest =
        support.rest && support.rest->vertex_count() == entry.mesh->mesh().vertex_count()
            ? *support.rest
            : entry.mesh->mesh();
    for (int k = 0; k < 3; ++k) {
        const auto K = static_cast<std::size_t>(k);
        in_scene[K] =
            glm::dvec3(entry.to_world * glm::dvec4(entry.mesh->mesh().positions[corners[k]], 1));
        at_rest[K] = glm::dvec3(rest.positions[corners[k]]);
    }
    const glm::dvec3 shares = barycentric(hit.p_world, in_scene);
    const glm::dmat4 to_own = glm::inverse(support.own_to_drawn);
    const glm::dvec3 normal = glm::transpose(glm::dmat3(support.own_to_drawn)) * hit.normal;
    AttachedSample out{host, support.part.key.mesh, support.part.key.member};
    out.rest = shares.x * at_rest[0] + shares.y * at_rest[1] + shares.z * at_rest[2];
    out.drawn = glm::dvec3(to_own * glm::dvec4(hit.p_world, 1));
    out.normal = glm::length(normal) > 0 ? glm::normalize(normal) : glm::dvec3(0);
    return out;
}

} // namespace

glm::dmat4 stroke_to_world(const Stage& laid)
{
    return laid.stroke_motion ? laid.stroke_motion->to_world : glm::dmat4(1);
}

Sketch stroke_now(const Stage& laid, const PlacementStep& step)
{
    return laid.stroke_motion ? laid.stroke_motion->sketch : step.sketch;
}

std::optional<Attachment> hosts_now(const Stage& laid, const PlacementStep& step)
{
    if (!step.attach || !laid.stroke_motion || !laid.supports) return {};
    const std::vector<AttachedHost>& known = step.attach->hosts;
    Attachment out;
    const auto add = [&](Id id) {
        const auto support = std::ranges::find(*laid.supports, id, &Support::id);
        if (id == 0 || support == laid.supports->end() || // the ground is never a host
            std::ranges::find(out.hosts, id, &AttachedHost::object) != out.hosts.end())
            return;
        const auto host = std::ranges::find(known, id, &AttachedHost::object);
        out.hosts.push_back(
            attached_host(id, support->own_to_drawn, host != known.end() && host->touched));
    };
    add(known[main_host(*step.attach)].object);
    for (const Support& support : *laid.supports) add(support.id);
    if (out.hosts.empty()) return {};
    return out;
}

std::optional<Attachment> attachment_of(const EvaluatedObject& laid, const Sketch& sketch,
                                        bool skip_back_faces)
{
    if (!laid.lies_on || !laid.supports || !laid.stroke_placement()) return {};
    const RayScene& scene = *laid.lies_on;
    const std::vector<Support>& supports = *laid.supports;
    Attachment out;
    std::map<Id, int> number; // of each host in the list
    for (const Support& support : supports)
        if (support.id != 0 && // the ground is never a host
            number.emplace(support.id, static_cast<int>(out.hosts.size())).second)
            out.hosts.push_back(attached_host(support.id, support.own_to_drawn, false));
    const View view(sketch.camera);
    std::vector<Ray> rays;
    for (const StrokeSample& sample : sketch.samples) rays.push_back(view.ray(sample.p_px));
    // The strip is in the world, where its hosts carried it; the rays are in the space of the
    // stroke.
    const bool moved = laid.stroke_motion && laid.stroke_motion->moved();
    const glm::dmat4 back = moved ? glm::inverse(laid.stroke_motion->to_world) : glm::dmat4(1);
    for (const StripNode& node : laid.stroke_placement()->nodes)
        if (node.contact != Contact::missed) // beyond an edge it lies on nothing that is seen there
            rays.push_back(view.ray_to(glm::dvec3(back * glm::dvec4(node.p_world, 1))));
    const std::vector<std::optional<Hit>> hits = scene.hits(rays, skip_back_faces);
    bool any = false;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const bool is_sample = i < sketch.samples.size();
        if (is_sample) out.samples.emplace_back();
        if (!hits[i]) continue;
        const Support& support = supports[static_cast<std::size_t>(hits[i]->entry)];
        if (support.id == 0) continue;
        const int host = number.at(support.id);
        out.hosts[static_cast<std::size_t>(host)].touched = true;
        any = true;
        if (is_sample) out.samples.back() = anchored(*hits[i], scene, support, host);
    }
    if (any) return out;
    // A stroke that lies on nothing but the ground stays there, whatever is moved near it.
    const bool on_ground = std::ranges::find(supports, 0, &Support::id) != supports.end();
    if (!on_ground || out.hosts.empty()) return {};
    out.samples.clear();
    return out;
}

} // namespace trivar
