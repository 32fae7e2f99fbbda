// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/view_refining.h"
#include "editor/jobs/worker.h"

#include <exception>

namespace trivar {

// A BackgroundEvaluator evaluates documents on a thread of its own, so that the window never waits.
// A new document replaces one that still waits: only the latest counts. The current one is finished
// first, so that a drag always shows something new. Frame thread only.
class BackgroundEvaluator {
public:
    // The other thread calls `wake` when there is a result or progress.
    BackgroundEvaluator(Ref<AssetStore> assets, std::function<void()> wake,
                        OnFailure on_failure = OnFailure::pass_on);

    // Returns the document's ticket: 1, 2, ... Parts are deformed on this thread if wanted, else by
    // whoever asks for them.
    long submit(Document document, double frame, bool deform_parts = true);

    struct Result {
        long ticket = 0;
        Evaluation evaluated;
        std::string problem;                  // why there is no result; empty: there is one
        bool stopped = false;                 // that is why
        std::exception_ptr mistake = nullptr; // of Trivar, which is why; null: it is none
    };
    std::optional<Result> poll(); // what was finished since the last call

    // A ViewRequest asks to split effects as finely as a camera wants them, whenever there is no
    // document to evaluate; a document that comes meanwhile is evaluated first. The newest request
    // counts here, too.
    struct ViewRequest {
        Evaluation evaluated;
        Camera camera;
        double tolerance_px = 1;
        bool deform_parts = true;
        double asked_s = 0; // on the asker's clock
    };
    void submit_view(ViewRequest request);
    struct SeenResult {
        ViewRequest request;
        SeenEffects seen; // as asked for where they could not be split
        std::exception_ptr mistake = nullptr;
    };
    std::optional<SeenResult> poll_view(); // what was finished since the last call

    struct Status {
        bool busy = false;  // a document is evaluated, or waits
        double seconds = 0; // since the present evaluation began
        double fraction = -1;
        std::string stage;
    };
    Status status() const;
    void cancel(); // the present evaluation; its result is a problem

private:
    void take_in();

    Evaluator evaluator_; // both are touched by the other thread only
    ViewRefining view_refining_;
    std::optional<Result> finished_;
    std::shared_ptr<const ViewRequest> view_; // that is not done
    bool view_begun_ = false;                 // the worker has it, and no document
    std::optional<SeenResult> view_finished_;
    long submitted_ = 0;
    Worker worker_; // last: it stops before the rest goes
};

} // namespace trivar
