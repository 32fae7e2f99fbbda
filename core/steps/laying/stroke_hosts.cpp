// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/laying/stroke_hosts.h"

#include <algorithm>

namespace trivar {
namespace {

// Returns the parts of an object in its own space; parts that a lattice bent or whose triangles
// were split meanwhile are as they are in the world now.
std::vector<Part> own_parts(const EvaluatedObject& object)
{
    const auto same_mesh = [](const Part& a, const Part& b) {
        return a.rest == b.rest && a.posed == b.posed && !a.bent == !b.bent;
    };
    if (std::ranges::equal(object.own_parts, object.whole(), same_mesh)) return object.own_parts;
    std::vector<Part> out = object.whole();
    if (object.own_to_world == glm::dmat4(1)) return out;
    const glm::dmat4 back = glm::inverse(object.own_to_world);
    for (Part& part : out) part.to_world = back * part.to_world;
    return out;
}

} // namespace

StrokeHosts stroke_hosts(const Attachment& attachment,
                         const std::vector<Ref<EvaluatedObject>>& hosts, MeshAnchors& anchors,
                         const StepInput& input)
{
    StrokeHosts out{attachment, {}, main_host(attachment), {}, {}};
    for (std::size_t h = 0; h < hosts.size(); ++h) {
        HostNow now{&attachment.hosts[h], nullptr, {}, attachment.hosts[h].stood()};
        if (hosts[h] && !hosts[h]->parts.empty()) {
            now.object = hosts[h].get();
            now.parts = own_parts(*hosts[h]);
            now.moved = now.object->own_to_world == now.stood
                            ? glm::dmat4(1)
                            : now.object->own_to_world * glm::inverse(now.stood);
        }
        out.hosts.push_back(std::move(now));
    }
    out.feet.resize(attachment.samples.size());
    for (std::size_t i = 0; i < out.feet.size(); ++i) {
        const AttachedSample& sample = attachment.samples[i];
        if (sample.host < 0) continue;
        const HostNow& now = out.host_of(i);
        SampleFoot& foot = out.feet[i];
        if (now.object) foot.now = anchors(sample, i, *now.object, now.parts, input);
        foot.drawn = taken_by(now.stood, sample.drawn);
        if (out.is_on_main(i)) out.drawn.add(foot.drawn);
    }
    const HostNow& main = out.main_host();
    if (out.drawn.empty())
        for (const Part& part : main.parts)
            for (const glm::dvec3& corner : part.bounds.corners())
                out.drawn.add(taken_by(main.stood * part.to_world, corner));
    return out;
}

} // namespace trivar
