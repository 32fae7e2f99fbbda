// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/document/asset_store.h"
#include "core/evaluation/on_failure.h"
#include "core/stages/evaluated.h"
#include "core/stages/step.h"

#include <memory>

namespace trivar {

// An Evaluator evaluates documents one after another and keeps what is still true. Results are
// cached by the identity of what they came from, so a drag computes only what it touches, and the
// last few states of each object are kept for undo. A placed object is evaluated after the objects
// on which it lies and sees them deformed. Hidden objects are not in the result but still carry
// what lies on them: hiding a table does not drop the snake. Only what others lie on is deformed:
// who needs the meshes asks the parts. Not thread-safe; may live on a thread of its own. Throws
// Cancelled; trouble with single objects is in their notices.
class Evaluator {
public:
    explicit Evaluator(Ref<AssetStore> assets, ShutIncisions shut = ShutIncisions::vanish,
                       OnFailure on_failure = OnFailure::pass_on);
    ~Evaluator();
    // Evaluates at a frame of the document's time, which may lie between two frames; without a
    // frame, at the first one. The result does not depend on earlier evaluations.
    Evaluation operator()(const Document& document, double frame, const Progress& progress = {});
    Evaluation operator()(const Document& document, const Progress& progress = {})
    {
        return (*this)(document, document.time.first_frame, progress);
    }

private:
    struct Cache;
    std::unique_ptr<Cache> cache_;
};

// Deforms, by the processor, all parts that are not deformed yet; the timings get the time that
// took. Tiles are drawn without that, and bent only where they are asked for.
void deform_parts(Evaluation& evaluated, bool with_tiles = false);

// The digest of every deformed position, normal and index, in the order of ids; also of curves
// where there are any.
std::string digest(const Evaluation& evaluated);

// The whole scene as one model to write to a file: a node for each object, in that of its group.
// Where an object has several parts or curves, these are nodes below it.
Model model_of(const Evaluation& evaluated, const Document& document);
// The name of a part in such a file: its object's, followed by that of its mesh if there are
// several.
std::string name_of_part(const EvaluatedObject& effects, const Object& object, const PartKey& key);

} // namespace trivar
