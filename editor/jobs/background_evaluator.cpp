// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/jobs/background_evaluator.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"

namespace trivar {
namespace {

BackgroundEvaluator::Result evaluated(Evaluator& evaluator, const Document& document, double frame,
                                      bool deform, const Progress& progress)
{
    BackgroundEvaluator::Result result;
    try {
        result.evaluated = evaluator(document, frame, progress);
        if (deform) deform_parts(result.evaluated);
    } catch (const Cancelled&) {
        result.problem = "The picture shows the scene as it was before.";
        result.stopped = true;
    } catch (const std::exception& trouble) {
        result.problem = words_of(trouble);
        if (is_mistake(trouble)) result.mistake = std::current_exception();
    }
    return result;
}

BackgroundEvaluator::SeenResult refined(ViewRefining& refining,
                                        const BackgroundEvaluator::ViewRequest& request,
                                        const Progress& progress)
{
    BackgroundEvaluator::SeenResult result{request, {}, {}};
    try {
        result.seen = refining(request.evaluated, request.camera, request.tolerance_px, progress);
        if (request.deform_parts) deform_parts(result.seen.evaluated);
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& trouble) { // of memory, as it may be: then as they are
        if (is_mistake(trouble)) result.mistake = std::current_exception();
        result.seen.evaluated = request.evaluated;
    }
    return result;
}

} // namespace

BackgroundEvaluator::BackgroundEvaluator(Ref<AssetStore> assets, std::function<void()> wake,
                                         OnFailure on_failure)
    : evaluator_(std::move(assets), ShutIncisions::vanish, on_failure),
      worker_(std::move(wake))
{
}

long BackgroundEvaluator::submit(Document document, double frame, bool deform_parts)
{
    take_in();
    if (std::exchange(view_begun_, false)) worker_.drop(); // it begins anew after the document
    const long ticket = ++submitted_;
    worker_.start(
        [this, ticket, document = std::move(document), frame,
         deform_parts](const Progress& progress) -> Worker::Finish {
            Result result = evaluated(evaluator_, document, frame, deform_parts, progress);
            result.ticket = ticket;
            return [this, result = std::move(result)]() mutable { finished_ = std::move(result); };
        },
        "Evaluating");
    return ticket;
}

void BackgroundEvaluator::submit_view(ViewRequest request)
{
    view_ = std::make_shared<const ViewRequest>(std::move(request));
    take_in();
}

void BackgroundEvaluator::take_in()
{
    worker_.poll();
    if (!view_ || worker_.busy()) return;
    view_begun_ = true;
    worker_.start([this, view = view_](const Progress& progress) -> Worker::Finish {
        return [this, view, result = refined(view_refining_, *view, progress)]() mutable {
            view_finished_ = std::move(result);
            view_begun_ = false;
            if (view_ == view) view_.reset();
        };
    });
}

std::optional<BackgroundEvaluator::Result> BackgroundEvaluator::poll()
{
    take_in();
    return std::exchange(finished_, std::nullopt);
}

std::optional<BackgroundEvaluator::SeenResult> BackgroundEvaluator::poll_view()
{
    take_in();
    return std::exchange(view_finished_, std::nullopt);
}

BackgroundEvaluator::Status BackgroundEvaluator::status() const
{
    Worker::Status status = worker_.status();
    if (status.done || view_begun_) return {};
    return {true, status.seconds, status.fraction, std::move(status.stage)};
}

void BackgroundEvaluator::cancel()
{
    if (!view_begun_) worker_.cancel();
}

} // namespace trivar
