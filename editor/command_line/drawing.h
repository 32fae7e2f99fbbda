// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/rejected.h"
#include "editor/command_line/status.h"
#include "editor/picture/still.h"
#include "gpu/context.h"

#include <optional>
#include <set>

namespace trivar {

// WrongUsage reports a value that an option does not accept: status 2.
struct WrongUsage : Rejected {
    using Rejected::Rejected;
};
// Reads such a value, before anything else is looked at.
template <class Read> auto option_value(Read read)
{
    try {
        return read();
    } catch (const Rejected& why) {
        throw WrongUsage(why.what());
    }
}

// DrawingOptions say how the commands draw, as they are typed.
struct DrawingOptions {
    std::string size = "1280x720", camera, quality = "standard", deform = "processor", shaders;
};
// Throws WrongUsage.
glm::ivec2 picture_size(const std::string& text);
StillOptions still_options(const DrawingOptions& options);
// The shaders of the options; null: those of the program. Throws Rejected where there are none.
Ref<gpu::ShaderTexts> shaders_of(const DrawingOptions& options);

// Throws Rejected where the scene has no kept view of the given name.
void check_camera(const DrawingOptions& options, const Document& document);

// A Drawing makes pictures without a window, one after another. Throws Rejected where there is no
// OpenGL.
class Drawing {
public:
    Drawing(const DrawingOptions& options, const Streams& streams);
    // The kept view that the options name, which check_camera() found, or else picture_camera().
    Camera camera(const Evaluation& evaluated, const Document& document) const;
    const Still& draw(const Evaluation& evaluated, const Document& shown, const Camera& camera,
                      bool deep = false);

private:
    void say_once(const std::string& sentence);
    std::string named_camera_;
    StillOptions options_;
    const Streams& streams_;
    gpu::HeadlessContext context_;
    Still still_;
    std::set<std::string> said_;
};

} // namespace trivar
