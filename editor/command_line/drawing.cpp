// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/drawing.h"

#include "core/base/whole_numbers.h"
#include "editor/picture/picture.h"
#include "gpu/shader_folder.h"
#include "ui/camera_control.h"

#include <fmt/format.h>

namespace trivar {
namespace {

gpu::Level level_of(const std::string& text)
{
    if (const auto level = gpu::level_named(text)) return *level;
    throw WrongUsage("--quality " + text + ": must be draft, standard or high");
}

gpu::DeformBy deform_of(const std::string& text)
{
    if (const auto by = gpu::deform_named(text)) return *by;
    throw WrongUsage("--deform " + text +
                     ": must be processor, one_phase, two_phases, differences, raised or filtered");
}

} // namespace

glm::ivec2 picture_size(const std::string& text)
{
    constexpr int most_px = 16384;
    const std::vector<int> n = whole_numbers(text, 'x');
    if (n.size() == 2 && n[0] >= 1 && n[1] >= 1 && n[0] <= most_px && n[1] <= most_px)
        return {n[0], n[1]};
    throw WrongUsage("--size " + text + ": must be WIDTHxHEIGHT, such as 1280x720, up to 16384");
}

StillOptions still_options(const DrawingOptions& options)
{
    StillOptions out;
    out.size_px = picture_size(options.size);
    out.level = level_of(options.quality);
    out.deform = deform_of(options.deform);
    return out;
}

Ref<gpu::ShaderTexts> shaders_of(const DrawingOptions& options)
{
    if (options.shaders.empty()) return {};
    return gpu::ShaderFolder(options.shaders).texts(0);
}

void check_camera(const DrawingOptions& options, const Document& document)
{
    if (!options.camera.empty() && !document.kept_views.contains(options.camera))
        throw Rejected(
            fmt::format("--camera {}: the scene has no bookmark of that name", options.camera));
}

Drawing::Drawing(const DrawingOptions& options, const Streams& streams)
    : named_camera_(options.camera),
      options_(still_options(options)),
      streams_(streams)
{
    options_.shaders = shaders_of(options);
}

void Drawing::say_once(const std::string& sentence)
{
    if (said_.insert(sentence).second) streams_.talk << "trivar: " << sentence << "\n";
}

Camera Drawing::camera(const Evaluation& evaluated, const Document& document) const
{
    if (named_camera_.empty()) return picture_camera(evaluated, document, options_.size_px);
    return ui::reshaped(document.kept_views.at(named_camera_), options_.size_px);
}

const Still& Drawing::draw(const Evaluation& evaluated, const Document& shown, const Camera& camera,
                           bool deep)
{
    options_.deep = deep;
    still_.draw(evaluated, shown, camera, options_);
    const gpu::Renderer& renderer = still_.renderer();
    if (!renderer.notice().empty()) say_once("deformed by the processor: " + renderer.notice());
    if (!renderer.shader_trouble().empty())
        say_once("the program's own shader is used: " + renderer.shader_trouble());
    return still_;
}

} // namespace trivar
