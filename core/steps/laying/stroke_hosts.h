// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/stages/stroke_motion.h"
#include "core/steps/laying/mesh_anchor.h"

namespace trivar {

// A HostNow is an object that carries an attached stroke, as it is now.
struct HostNow {
    const AttachedHost* host;
    const EvaluatedObject* object; // null: it is not there, or shows nothing
    std::vector<Part> parts;       // in its own space
    glm::dmat4 stood{1}, moved{1}; // how it stood; from there to where it stands
    glm::dmat4 own_to_drawn{1};    // as it is in the space of the stroke
    bool unmoved = false;          // it stands there as it did
};

struct SampleFoot { // of a sample
    std::optional<AnchorPlace> now;
    glm::dvec3 drawn{0}; // in the space of the stroke
};

// StrokeHosts are all hosts of a stroke, and where its samples stand on them.
struct StrokeHosts {
    const Attachment& attachment;
    std::vector<HostNow> hosts;
    std::size_t main;             // whose motion the stroke makes
    std::vector<SampleFoot> feet; // by sample
    Box drawn;                    // round the feet on the main host as they were drawn

    const HostNow& main_host() const { return hosts[main]; }
    const HostNow& host_of(std::size_t sample) const
    {
        return hosts[static_cast<std::size_t>(attachment.samples[sample].host)];
    }
    bool is_on_main(std::size_t sample) const
    {
        return attachment.samples[sample].host == static_cast<int>(main);
    }
};
// `hosts` are those of the attachment, null where one is not there. The result refers to both.
StrokeHosts stroke_hosts(const Attachment& attachment,
                         const std::vector<Ref<EvaluatedObject>>& hosts, MeshAnchors& anchors,
                         const StepInput& input);

// A point where an affine matrix takes it.
inline glm::dvec3 taken_by(const glm::dmat4& matrix, const glm::dvec3& p)
{
    return glm::dvec3(matrix * glm::dvec4(p, 1));
}

} // namespace trivar
