// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/headless.h"

#include <algorithm>
#include <epoxy/gl.h>

namespace trivar::ui {

HeadlessFrames::HeadlessFrames(glm::ivec2 size_px, const ThemeOptions& options)
    : gui_(options),
      size_px_(size_px),
      options_(options)
{
    make_target();
}

void HeadlessFrames::make_target()
{
    glGenTextures(1, &color_);
    glBindTexture(GL_TEXTURE_2D, color_);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, size_px_.x, size_px_.y);
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_, 0);
}

void HeadlessFrames::drop_target()
{
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &color_);
}

HeadlessFrames::~HeadlessFrames()
{
    drop_target();
}

void HeadlessFrames::lose_context(const std::function<void()>& forget)
{
    forget();
    gui_.forget_gpu();
    drop_target();
    context_.reset();
    context_.emplace();
    make_target();
}

void HeadlessFrames::frames(int count, const DrawFrame& body)
{
    const DrawFrame into_image = [&](Frame& frame) {
        body(frame);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_); // the body may have drawn elsewhere
    };
    for (int i = 0; i < count; ++i) {
        const Frame frame = gui_.frame(size_px_, time_s_, false, into_image);
        const float scale = combined_scale(options_.scale, frame.interface_scale);
        if (scale != gui_.theme().scale || frame.look != gui_.theme().look)
            gui_.set_theme({scale, frame.look});
        pace_.drawn(frame);
        time_s_ += 1.0 / 60;
        ++count_;
    }
}

int HeadlessFrames::settle(const DrawFrame& body, int limit)
{
    pace_.input_came();
    int drawn = 0;
    for (; drawn < limit && pace_.wait_s(time_s_) < 1e9; ++drawn) {
        time_s_ += pace_.wait_s(time_s_);
        frames(1, body);
    }
    return drawn;
}

Image HeadlessFrames::picture() const
{
    Image image{.name = "frame", .size_px = size_px_, .rgba = {}, .source_bytes = {}, .mime = {}};
    const auto row = static_cast<std::size_t>(size_px_.x) * 4;
    std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(size_px_.y));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_px_.x, size_px_.y, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.data());
    image.rgba.reserve(upside_down.size());
    for (std::size_t y = static_cast<std::size_t>(size_px_.y); y-- > 0;)
        for (std::size_t x = 0; x < row; ++x)
            image.rgba.push_back(x % 4 == 3 ? 255 : upside_down[y * row + x]);
    return image;
}

} // namespace trivar::ui
