// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/headless.h"

#include "gpu/framebuffer.h"
#include "gpu/state_guard.h"

#include <algorithm>
#include <cstdint>
#include <epoxy/gl.h>
#include <imgui.h>

namespace trivar::ui {
namespace {

// The framebuffer's picture, first row on top, opaque.
Image read_back(unsigned framebuffer, glm::ivec2 size_px)
{
    Image image{.name = "frame", .size_px = size_px, .rgba = {}, .source_bytes = {}, .mime = {}};
    const auto row = static_cast<std::size_t>(size_px.x) * 4;
    std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(size_px.y));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_px.x, size_px.y, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.data());
    image.rgba.reserve(upside_down.size());
    for (std::size_t y = static_cast<std::size_t>(size_px.y); y-- > 0;)
        for (std::size_t x = 0; x < row; ++x)
            image.rgba.push_back(x % 4 == 3 ? 255 : upside_down[y * row + x]);
    return image;
}

// OtherInterface sets ImGui's context aside as long as it lives.
class OtherInterface {
public:
    OtherInterface() { ImGui::SetCurrentContext(nullptr); }
    ~OtherInterface() { ImGui::SetCurrentContext(before_); }
    OtherInterface(const OtherInterface&) = delete;
    OtherInterface& operator=(const OtherInterface&) = delete;

private:
    ImGuiContext* before_ = ImGui::GetCurrentContext();
};

} // namespace

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
    const glm::ivec2 size_px = little_ ? glm::ivec2(1) : size_px_;
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, size_px.x, size_px.y);
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

void HeadlessFrames::resize(glm::ivec2 size_px)
{
    drop_target();
    size_px_ = size_px;
    make_target();
}

void HeadlessFrames::draw_little()
{
    little_ = true;
    resize(size_px_);
}

void HeadlessFrames::draw_whole()
{
    little_ = false;
    resize(size_px_);
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
    return read_back(framebuffer_, size_px_);
}

Image drawn_over(const Image& image, const ThemeOptions& options, const DrawFrame& body)
{
    const gpu::StateGuard guard;
    const OtherInterface other;
    gpu::Texture2D below(GL_RGBA8, image.size_px), all(GL_RGBA8, image.size_px);
    below.write_rgba(image.rgba);
    const gpu::Framebuffer framebuffer({&all}, nullptr);
    Gui gui(options);
    framebuffer.bind();
    gui.frame(image.size_px, 0, false, [&](Frame& frame) {
        const auto name = static_cast<std::uintptr_t>(below.name());
        const ImVec2 size{frame.size_px.x, frame.size_px.y};
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize(size);
        ImGui::Begin("image", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs);
        ImGui::GetWindowDrawList()->PushClipRectFullScreen();
        ImGui::GetWindowDrawList()->AddImage(reinterpret_cast<ImTextureID>(name), {0, 0}, size);
        body(frame);
        ImGui::GetWindowDrawList()->PopClipRect();
        ImGui::End();
    });
    Image out = read_back(framebuffer.name(), image.size_px);
    out.name = image.name;
    return out;
}

} // namespace trivar::ui
