// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/recent.h"
#include "core/lines/level_drawing.h"
#include "core/stages/evaluated.h"
#include "gpu/curve.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace trivar {

// A VolumeView says which volume data are seen, and from where: what lines belong to.
struct VolumeView {
    Ref<ShownVolume> volume;
    glm::dmat4 to_world{1}; // of the object's model
    Camera camera;
    int id = 0; // of the object
    bool operator==(const VolumeView&) const = default;
};

// The lines of volume data in one view.
struct SeenLines {
    std::vector<gpu::Curve> curves;
    ProofGaps gaps; // of certified lines
};
// What is remembered of the lines of an object's levels from view to view, by layer.
struct LineMemory {
    std::map<std::string, LineIds> ids;
    std::map<std::string, std::vector<std::uint64_t>> kept;
};
// How the levels are drawn that want certified lines.
enum class LineProof { as_wanted, none };
// `wider` is the width of a line in pixels per pixel of a picture of the usual height. 0.25 us per
// point of the curves, and 4 ns per triangle that they may cross; certified ones take a second
// where a volume has 256 samples an axis. The progress is called from any thread. With a memory,
// those lines of a share that were shown in the view before stay rather than others.
SeenLines lines_of(const VolumeView& view, float wider, LineProof proof,
                   const Progress& progress = {}, LineMemory* memory = nullptr);

// VolumeLines draws the silhouettes of the levels that objects of volume data show, seen from a
// camera. It keeps those of the last few views. Where a level shows a share of its lines, those
// that were shown in the view before stay rather than others, so that they do not come and go while
// the view turns.
class VolumeLines {
public:
    // as_wanted: at once, for files. none: quick lines, but where others were given.
    LineProof proof = LineProof::as_wanted;
    // The curves of an object whose model `to_world` puts into the world. Empty for what is no
    // volume data.
    const std::vector<gpu::Curve>& operator()(const EvaluatedObject& object,
                                              const glm::dmat4& to_world, const Camera& camera,
                                              float wider);
    using Given = std::vector<std::pair<VolumeView, SeenLines>>;
    void give(Given lines) { given_ = std::move(lines); } // in place of those given before

private:
    Recent<VolumeView, std::vector<gpu::Curve>> known_{16};
    Given given_;
    std::map<int, LineMemory> memories_; // by object, of those that show a share of their lines
};

} // namespace trivar
