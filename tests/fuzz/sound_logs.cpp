// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/sound_logs.h"

#include "core/base/text.h"
#include "core/files/formats.h"
#include "tests/support/rigged.h"

#include <algorithm>
#include <filesystem>

namespace trivar::testing {
namespace {

constexpr const char* small_scene = R"({"trivar":1,"units":"m","up":"z"}
{"do":"add_box","name":"Table","size":[4,4,0.5],"segments":[4,4,1],"note":"The table."}
{"do":"add_sphere","name":"Ball","radius":0.4,"segments":12,"rings":6}
{"do":"import","path":"bar.glb","name":"Bar","transform":{"translation":[0,2,0],"scale":[0.2,0.2,0.2]}}
{"do":"place","object":2,"camera":{"eye":[0,-4,4],"target":[0,0,0],"fov_y":0.6,"size_px":[1280,720]},"samples":[[440,360,0,1],[540,370,0.2,1],[640,365,0.4,0.5],[740,360,0.6,1],[840,370,0.8,1]],"parameters":{"grid":[9,4,3],"fill":0.6,"width_profile":[[0,1],[1,0.5]]},"onto":[1]}
{"do":"press","object":2,"radius":0.2,"samples":[[0.5,0.5,1,0.05],[0.6,0.5,1,0.05]]}
{"do":"move_points","object":2,"points":[[2,1,2],[3,1,2]],"by":[0,0,0.02],"of":[9,4,3]}
{"do":"set_travel","objects":[2],"speed":0.5,"ends":"loop","followers":1,"gap":0.3}
{"do":"play_clip","objects":[3],"clip":"bend","repeat":"loop"}
{"do":"add_cylinder","name":"Post","radius":0.3,"height":1,"segments":12,"stacks":2,"transform":{"translation":[1.5,0,0.75]}}
{"do":"add_plane","name":"Flag","size":[1,0.2],"segments":[6,1]}
{"do":"place_round","object":5,"around":4,"level":0.1,"parameters":{"grid":[9,4,3]}}
{"do":"set_material","objects":[1,4],"base_color":[0.4,0.3,0.2,1],"solid":"wood"}
{"do":"group","objects":[1,4],"name":"Furniture"}
{"do":"animate","of":[{"object":3,"tracks":[{"parameter":"transform.translation.z","keys":[{"frame":1,"value":0},{"frame":48,"value":1,"tween":"linear"},{"frame":96,"value":0.5}],"repeat":"loop"}]}]}
{"do":"hide","objects":[5]}
{"undo":true}
{"redo":true}
{"do":"show","objects":[5]}
{"do":"save_camera","name":"picture","camera":{"eye":[4,-6,3],"target":[0,0,0],"fov_y":0.6,"size_px":[640,360]}}
{"do":"set_time","first_frame":1,"last_frame":48,"frames_per_second":24}
{"do":"set_render","look":"clay","sun_azimuth":-0.7}
{"undo":true}
)";

std::vector<FileSet> stored(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(TRIVAR_SOURCE_DIR / folder))
        if (entry.path().extension() == ".trivar") paths.push_back(entry.path());
    std::ranges::sort(paths);
    std::vector<FileSet> out;
    for (const auto& path : paths)
        out.push_back({{path.filename().string(), read_text_file(path.string())}});
    return out;
}

} // namespace

std::vector<FileSet> sound_logs()
{
    std::vector<FileSet> out;
    for (const char* folder : {"assets/scenes", "tests/logs/versions", "tests/logs/real"})
        for (FileSet& set : stored(folder)) out.push_back(std::move(set));
    const FileSet small{{"small.trivar", small_scene}, {"bar.glb", write_glb(rigged_model())}};
    out.insert(out.end(), out.size(), small); // as many: it alone is evaluated
    return out;
}

} // namespace trivar::testing
