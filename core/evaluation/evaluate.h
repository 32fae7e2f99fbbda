// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/document/asset_store.h"
#include "core/evaluation/evaluated.h"

#include <memory>

namespace trivar {

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
    Evaluation operator()(const Document& document, double frame, const Progress& progress = {});
    Evaluation operator()(const Document& document, const Progress& progress = {})
    {
        return (*this)(document, document.time.first_frame, progress);
    }

private:
    struct Cache;
    std::unique_ptr<Cache> cache_;
};

// Deforms, by the processor, all parts that were not yet; what that took is added to the timings.
void deform_parts(Evaluation& evaluated);

// Digest of every deformed position, normal and index, in the order of ids; of curves, too, where
// there are any.
std::string digest(const Evaluation& evaluated);

// All of it as one model to write to a file: a node a part, and behind these a node for each curve
// part, named as the objects are.
Model model_of(const Evaluation& evaluated, const Document& document);

} // namespace trivar
