// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the pictures of docs/gallery/models anew, which the menu of models shows: each model alone,
// without a screen. Without arguments all of them, else those of the files that are named.

#include "core/commands/command.h"
#include "core/commands/objects/import.h"
#include "core/files/pictures/image.h"
#include "editor/actions/model_actions.h"
#include "editor/picture/picture.h"
#include "editor/picture/still.h"
#include "gpu/context.h"
#include "ui/camera_control.h"

#include <algorithm>
#include <cstdio>

namespace trivar {
namespace {

constexpr glm::ivec2 size_px{240, 146};
constexpr int finer = 4; // so many times drawn, and averaged

// Tiles lie flat, so they are seen from higher up.
glm::dvec3 direction_to_eye(const std::string& file)
{
    return glm::normalize(file.starts_with("tile_") ? glm::dvec3(0.45, -1, 0.85)
                                                    : glm::dvec3(0.45, -1, 0.55));
}

Image smaller(const Image& fine)
{
    Image out{.name = "", .size_px = size_px, .rgba = {}, .source_bytes = {}, .mime = {}};
    for (int y = 0; y < size_px.y; ++y)
        for (int x = 0; x < size_px.x; ++x)
            for (int channel = 0; channel < 4; ++channel) {
                int sum = 0;
                for (int i = 0; i < finer * finer; ++i) {
                    const int at = (finer * y + i / finer) * fine.size_px.x + finer * x + i % finer;
                    sum += fine.rgba[static_cast<std::size_t>(4 * at + channel)];
                }
                out.rgba.push_back(static_cast<std::uint8_t>(sum / (finer * finer)));
            }
    return out;
}

Image drawn(const std::string& file, Still& still)
{
    ImportModel import;
    import.file.path = file + ".glb";
    const Document document = after(Document{}, import);
    const auto assets = std::make_shared<const AssetStore>(TRIVAR_BINARY_DIR "/assets/models");
    const Evaluation evaluated = Evaluator(assets)(document);
    StillOptions options;
    options.size_px = finer * size_px;
    options.level = gpu::Level::high;
    Camera camera;
    camera.size_px = options.size_px;
    std::vector<glm::dvec3> points;
    for (const auto& [id, object] : evaluated.objects) add_points(points, *object);
    camera = ui::framed(ui::seen_from(camera, direction_to_eye(file)), points);
    still.draw(evaluated, document, camera, options);
    return smaller(still.image());
}

} // namespace
} // namespace trivar

int main(int count, char** arguments)
{
    const std::vector<std::string> asked(arguments + 1, arguments + count);
    const trivar::gpu::HeadlessContext context;
    trivar::Still still;
    for (const trivar::OwnModel& model : trivar::own_models()) {
        const std::string file = model.file;
        if (!asked.empty() && std::ranges::find(asked, file) == asked.end()) continue;
        const std::string path = TRIVAR_SOURCE_DIR "/docs/gallery/models/" + file + ".png";
        trivar::write_image(trivar::drawn(file, still), path);
        std::printf("%s\n", path.c_str());
    }
    return 0;
}
