// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/jobs/job.h"

#include "core/base/mistake.h"
#include "core/base/rejected.h"

namespace trivar {

void Jobs::start(Job job)
{
    queue_.push_back(std::move(job));
    next();
}

void Jobs::next()
{
    if (queue_.empty() || worker_.busy()) return;
    Job job = std::move(queue_.front());
    queue_.pop_front(); // a job without a thread is not tried again
    worker_.start(
        [work = std::move(job.work), lost = job.when_lost](const Progress& progress) -> Finish {
            try {
                return work(progress);
            } catch (const Cancelled&) {
                return {};
            } catch (const std::exception& trouble) {
                return [lost, words = words_of(trouble),
                        mistake = is_mistake(trouble) ? std::current_exception() : nullptr] {
                    if (lost) lost(words);
                    if (mistake) std::rethrow_exception(mistake);
                };
            }
        },
        std::move(job.what));
}

void Jobs::poll()
{
    worker_.poll();
    next(); // in the next frame where this one ended by an exception
}

std::optional<Worker::Status> Jobs::status() const
{
    if (!worker_.busy()) return std::nullopt;
    return worker_.status();
}

} // namespace trivar
