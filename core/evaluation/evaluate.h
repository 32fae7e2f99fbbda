// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/document/asset_store.h"
#include "core/document/document.h"
#include "core/evaluation/part.h"
#include "core/evaluation/walk.h"
#include "core/placement/shaper.h"
#include "core/refinement/refine.h"

#include <memory>

namespace trivar {

struct EvaluatedObject {
    Id id = 0;
    std::vector<Part> parts;
    Ref<std::vector<Material>> materials; // what face_material indexes
    Ref<Placement> placement;             // null where nothing was placed
    Ref<ShapedVolume> shaped;             // null where nothing was done to its volume
    Ref<Refined> refined;                 // null where its triangles are those of the model
    Ref<Journey> journey;                 // null where it does not travel
    Ref<Walk> walk;                       // null where its feet are not locked to that
    Ref<RayScene> lies_on;                // what its stroke falls on; null where there is none
    Lazy<Box> bounds;                     // world; asking for it deforms the parts
    std::vector<std::string> clips;       // what its file lets it play
    std::vector<std::string> notices;     // a missing file, a stroke that misses now
    std::vector<std::string> lacks;       // of those, why something is not here, as in Shape
    // Why the stroke gave nothing, as a sentence for the user; the object then stands undeformed
    // where its transform says. A tool shows it and does not commit. Empty: it lies, or has none.
    std::string rejected;
};

// The effects of a document. Objects that did not change keep their pointer.
struct Evaluated {
    std::map<Id, Ref<EvaluatedObject>> objects; // visible ones
    // Of this evaluation: import, subdivide, rays, springs, lift, volume, and deform, as far as the
    // parts were deformed for it.
    Timings timings;
};

// Evaluates documents one after another and keeps what is still true: results are cached by the
// identity of what they came from, so a drag recomputes only what it touches, and the last few
// states of each object are kept for undo. What is placed comes after what it lies on and sees it
// deformed. Hidden objects are not in the result but still carry what lies on them: hiding a
// table does not drop the snake. Deforms nothing but what others lie on: who needs the meshes asks
// the parts. Not thread-safe; may live on a thread of its own. Throws
// Cancelled; trouble with single objects is in their notices.
class Evaluator {
public:
    explicit Evaluator(Ref<AssetStore> assets);
    ~Evaluator();
    // At a frame of the document's time, or between two: what it shows does not depend on what was
    // evaluated before. Without a frame: at the first one.
    Evaluated operator()(const Document& document, double frame, const Progress& progress = {});
    Evaluated operator()(const Document& document, const Progress& progress = {})
    {
        return (*this)(document, document.time.first_frame, progress);
    }

private:
    struct Cache;
    std::unique_ptr<Cache> cache_;
};

// Deforms, by the processor, all parts that were not yet; what that took is added to the timings.
void deform_parts(Evaluated& evaluated);

// Digest of every deformed position, normal and index, in the order of ids.
std::string digest(const Evaluated& evaluated);

// All of it as one model to write to a file: a node a part, named as the objects are.
Model model_of(const Evaluated& evaluated, const Document& document);

} // namespace trivar
