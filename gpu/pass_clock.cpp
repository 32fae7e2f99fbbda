// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/pass_clock.h"

#include "gpu/context.h"

#include <epoxy/gl.h>

namespace trivar::gpu {
namespace {

void wait_for_draws()
{
    const GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    while (glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, 1'000'000'000) == GL_TIMEOUT_EXPIRED)
        ;
    glDeleteSync(fence);
}

GLuint stamp()
{
    GLuint query = 0;
    glGenQueries(1, &query);
    glQueryCounter(query, GL_TIMESTAMP);
    return query;
}

GLuint64 stamped_ns(GLuint query)
{
    GLuint64 time_ns = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &time_ns);
    return time_ns;
}

} // namespace

PassClock::PassClock() : software_(is_software()) {}

PassClock::~PassClock()
{
    forget();
}

void PassClock::forget()
{
    for (const Span& span : spans_)
        for (const unsigned query : {span.from, span.to})
            if (query) glDeleteQueries(1, &query);
    spans_.clear();
}

void PassClock::start_picture()
{
    forget();
    timings_ = {};
}

std::size_t PassClock::begin(const char* name, std::size_t vertices)
{
    Span span;
    span.name = name;
    span.vertices = vertices;
    if (software_)
        span.start = std::chrono::steady_clock::now();
    else
        span.from = stamp();
    spans_.push_back(span);
    return spans_.size() - 1;
}

void PassClock::end(std::size_t at)
{
    if (!software_) {
        spans_[at].to = stamp();
        return;
    }
    wait_for_draws();
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - spans_[at].start;
    timings_.add(spans_[at].name, spent.count(), spans_[at].vertices);
}

const Timings& PassClock::timings()
{
    if (!software_) {
        for (const Span& span : spans_)
            timings_.add(span.name,
                         static_cast<double>(stamped_ns(span.to) - stamped_ns(span.from)) / 1e6,
                         span.vertices);
        forget();
    }
    return timings_;
}

} // namespace trivar::gpu
