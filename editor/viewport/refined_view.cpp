// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/viewport/refined_view.h"

#include "core/base/number_text.h"
#include "ui/widgets.h"

#include <fmt/format.h>

namespace trivar {

void RefinedView::follow(Session& session, double tolerance_px, bool moving, double time_s)
{
    bool changed = session.evaluation() != evaluation_;
    if (auto result = session.evaluator().poll_view(); result && tolerance_px > 0) {
        done_s_ = result->request.asked_s;
        finished_ = std::move(result);
        changed = true;
    }
    if (finished_ && finished_->mistake)
        std::rethrow_exception(std::exchange(finished_->mistake, nullptr));
    tolerance_px_ = tolerance_px;
    if (tolerance_px <= 0) {
        changed = changed || finished_;
        finished_.reset();
        wanted_ = {};
    }
    if (changed) merge(session);
    const WantedView now{&session.evaluator(), session.evaluation(), session.view.camera,
                         tolerance_px};
    if (tolerance_px > 0 && !moving && now != wanted_) {
        wanted_ = now;
        asked_s_ = time_s;
        session.evaluator().submit_view({session.evaluated(), session.view.camera, tolerance_px,
                                         session.deform_on_processor, time_s});
    }
    current_ = now == wanted_;
}

void RefinedView::merge(const Session& session)
{
    const auto before = std::move(seen_.objects);
    seen_ = session.evaluated();
    if (finished_)
        for (auto& [id, object] : seen_.objects) {
            const auto& from = finished_->request.evaluated.objects;
            const auto found = from.find(id);
            if (found != from.end() && found->second == object)
                object = finished_->seen.evaluated.objects.at(id);
        }
    if (evaluation_ == session.evaluation() && before == seen_.objects) return;
    evaluation_ = session.evaluation();
    ++number_;
}

std::vector<Id> RefinedView::split(const Evaluation& evaluated) const
{
    std::vector<Id> out;
    for (const auto& [id, object] : seen_.objects)
        if (const auto found = evaluated.objects.find(id);
            found != evaluated.objects.end() && found->second != object)
            out.push_back(id);
    return out;
}

std::string RefinedView::words(double time_s) const
{
    constexpr double patience_s = 0.3; // it is said of no moment of a camera's way
    if (tolerance_px_ <= 0) return {};
    const std::string within = fmt::format("within {} px", number_text(tolerance_px_));
    if (!finished_ || finished_->request.tolerance_px != tolerance_px_ ||
        (!up_to_date() && time_s - done_s_ > patience_s))
        return "Refining to " + within;
    const SeenEffects& seen = finished_->seen;
    if (seen.triangles == 0) return {};
    if (seen.open == 0)
        return "W" + within.substr(1) + ": " + with_commas(seen.triangles) + " triangles";
    return with_commas(seen.open) + " of " + with_commas(seen.triangles) + " triangles are not " +
           within;
}

} // namespace trivar
