// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/hands/start_scenes.h"

#include "core/files/write_model.h"
#include "core/scene/log.h"
#include "tests/fuzz/sound_models.h"
#include "tests/support/fixtures.h"
#include "tests/voxels/volume_writers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace trivar::testing {
namespace {

namespace fs = std::filesystem;

constexpr const char* start_name = "start.trivar";

constexpr const char* any_body = "QGRSDTMCKLY"; // tools that work on any

StartScene scene_of(const std::string& lines, const std::string& tools = any_body, int main = 0,
                    const FileSet& beside = {})
{
    StartScene out{{{start_name, log_header() + lines}}, tools, main};
    out.files.insert(out.files.end(), beside.begin(), beside.end());
    return out;
}

constexpr const char* floor_line =
    R"({"do":"add_plane","name":"Floor","size":[6,6],"segments":[8,8]}
)";
constexpr const char* ball_line =
    R"({"do":"add_sphere","name":"Ball","radius":1,"segments":24,"rings":12,"transform":{"translation":[0,0,1]}}
)";
constexpr const char* bar_line =
    R"({"do":"add_box","name":"Bar","size":[1.2,0.3,0.3],"segments":[6,2,2],"transform":{"translation":[0,0,2.6]}}
)";
constexpr const char* stroke_over_ball =
    R"({"do":"place","object":3,"camera":{"eye":[0,-5,4],"target":[0,0,0.8],"fov_y":0.6,"size_px":[1280,720]},"samples":[[480,300,0,1],[560,290,0.2,1],[640,285,0.4,1],[720,290,0.6,1],[800,300,0.8,1]],"onto":[2],"parameters":{"grid":[9,4,3]}}
)";
constexpr const char* incision_line =
    R"({"do":"incise","object":1,"stroke":[{"p":[-0.5,-0.85,0.1],"normal":[-0.5,-0.85,0.1]},{"p":[0,-0.99,0.1],"normal":[0,-1,0.1]},{"p":[0.5,-0.85,0.1],"normal":[0.5,-0.85,0.1]}]}
)";

std::vector<StartScene> bodies()
{
    const std::string floor = floor_line, ball = ball_line, bar = bar_line;
    const std::string laid = floor + ball + bar + stroke_over_ball;
    return {
        scene_of(floor + ball + bar, "DDTCKGRS", 2),
        scene_of(ball, "CCKYVL"),
        scene_of(ball + incision_line, "CCCGK"),
        scene_of(laid, "DDPPVC", 2),
        scene_of(laid + R"({"do":"set_travel","objects":[3],"speed":0.4,"ends":"loop"}
{"do":"press","object":3,"radius":0.2,"samples":[[0.5,0.5,1,0.05],[0.6,0.5,1,0.05]]}
)",
                 "DPVGK", 2),
        scene_of(
            ball + bar +
                R"({"do":"cut","objects":[1],"cuts":[{"point":[0,0,0.2],"normal":[0.1,0,1],"gap":0.2}]}
)",
            "KKKC"),
        scene_of(R"({"do":"add_torus","radius":0.8,"tube":0.3,"segments":[24,12]}
{"do":"add_cylinder","name":"Post","radius":0.15,"height":3,"segments":12,"stacks":4,"transform":{"translation":[0.8,0,0]}}
{"do":"split","objects":[1],"obstacles":[{"object":2}],"opening":[1,0,0],"way":[0,1,0]}
)",
                 "KKGRCD"),
        scene_of(
            ball + bar +
                R"({"do":"add_lattice","objects":[1],"size":[2.2,2.2,2.2],"transform":{"translation":[0,0,1]}}
{"do":"move_points","object":3,"points":[[3,1,2],[3,2,2]],"by":[0.4,0,0.2]}
)",
            "VVPPCK"),
        scene_of(
            ball +
                R"({"do":"add_tetrahedra","objects":[1],"size":[2.2,2.2,2.2],"transform":{"translation":[0,0,1]}}
)",
            "YYYV", 1),
        scene_of(R"({"do":"add_box","name":"Cube","size":[1.5,1.5,1.5],"segments":[1,1,1]}
{"do":"add_box","name":"Stud","size":[0.2,0.2,0.1],"segments":[1,1,1],"transform":{"translation":[2,0,0]}}
{"do":"cover_with_tiles","object":2,"base":1,"size":0.3}
)",
                 "TTMGK", 1),
        scene_of(
            ball +
                R"({"do":"add_box","name":"Stud","size":[0.2,0.2,0.1],"segments":[1,1,1],"transform":{"translation":[2,0,0]}}
{"do":"paint_tiles","object":2,"base":1,"brush":"line","radius":0.2,"size":0.15,"samples":[{"p":[-0.5,-0.85,0.1],"normal":[-0.5,-0.85,0.1]},{"p":[0,-0.99,0.1],"normal":[0,-1,0.1]},{"p":[0.5,-0.85,0.1],"normal":[0.5,-0.85,0.1]}]}
)",
            "TTTMC", 1),
        scene_of(R"({"do":"add_moebius","radius":0.8,"width":0.5,"segments":[32,4]}
{"do":"add_cylinder","name":"Worm","radius":0.1,"height":1,"segments":10,"stacks":6,"transform":{"translation":[0,0,1.2]}}
)",
                 "DDTCK", 1),
        scene_of(
            R"({"do":"add_text","name":"Word","text":"Ag8","size":0.8,"depth":0.2,"max_edge":0.3,"tolerance":0.02}
)" + ball,
            "DKCLT"),
        scene_of(floor + R"({"do":"add_teapot","height":0.8,"resolution":4}
{"do":"unwrap","objects":[2]}
{"do":"add_box","name":"Crate","size":[0.8,0.8,0.8],"segments":[2,2,2],"transform":{"translation":[1.4,0,0.4]}}
{"do":"group","objects":[2,3],"name":"Things"}
{"do":"animate","of":[{"object":3,"tracks":[{"parameter":"transform.translation.z","keys":[{"frame":1,"value":0.4},{"frame":48,"value":1}],"repeat":"loop"}]}]}
)",
                 "GRSTKD", 1),
        scene_of(""),
    };
}

std::string import_line(const std::string& path, const std::string& more = {})
{
    return fmt::format("{{\"do\":\"import\",\"path\":\"{}\"{}}}\n", path, more);
}

std::vector<StartScene> models()
{
    std::vector<StartScene> out;
    const std::vector<Model> sound = sound_models();
    for (std::size_t i = 0; i < sound.size(); ++i) {
        const std::string name = fmt::format("model{}.glb", i);
        out.push_back(
            scene_of(floor_line + import_line(name), any_body, 1, {{name, write_glb(sound[i])}}));
    }
    const std::string folder = std::string(TRIVAR_BINARY_DIR) + "/assets/models/";
    for (const char* name : {"tile_stud", "tile_scale", "tile_chain", "ant", "trunk", "teapot"})
        out.push_back(
            scene_of(ball_line + import_line(folder + name + ".glb",
                                             R"(,"transform":{"translation":[0,0,2.2]})")));
    return out;
}

// Values that fall from the middle to the border, with a hollow.
std::string ball_of_values(int n)
{
    std::vector<std::uint8_t> samples;
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const double r =
                    2.0 / n * glm::length(glm::dvec3(i, j, k) - glm::dvec3((n - 1) / 2.0));
                samples.push_back(static_cast<std::uint8_t>(
                    std::clamp(100 * (1 - r) - (r < 0.3 ? 60 : 0), 0.0, 255.0)));
            }
    VoxelGrid grid;
    grid.size = glm::ivec3(n);
    grid.samples = samples;
    grid.to_metres = glm::dmat4(glm::dmat3(2.0 / n));
    return write_nrrd(grid);
}

std::vector<StartScene> volumes()
{
    const FileSet ball{{"ball.nrrd", ball_of_values(14)}};
    std::vector<StartScene> out;
    for (const char* levels : {R"([{"value":40}])", R"([{"value":30},{"value":55}])", "[]"})
        out.push_back(scene_of(
            fmt::format(R"({{"do":"add_volume","path":"ball.nrrd","levels":{}}})", levels) + '\n' +
                floor_line,
            "LLQGKCDT", 0, ball));
    return out;
}

std::vector<StartScene> real()
{
    const std::string folder = real_data_folder();
    std::vector<StartScene> out;
    if (folder.empty()) return out;
    std::vector<std::string> paths;
    for (const char* beneath : {"meshes", "animated", "found3"})
        for (const auto& each : fs::recursive_directory_iterator(fs::path(folder) / beneath)) {
            constexpr std::array known{".obj", ".off", ".ply", ".stl", ".glb", ".gltf"};
            constexpr std::uintmax_t most_bytes = 2000000; // a case takes seconds
            if (std::ranges::count(known, each.path().extension().string()) > 0 &&
                each.file_size() < most_bytes)
                paths.push_back(each.path().string());
        }
    std::ranges::sort(paths);
    for (const std::string& path : paths)
        out.push_back(
            scene_of(import_line(path) + R"({"do":"add_box","name":"Box","size":[0.3,0.3,0.3]}
)"));
    for (const char* path : {"volumes/anatomical.nii", "volumes/ironProt.vtk"})
        out.push_back(
            scene_of(fmt::format(R"({{"do":"add_volume","path":"{}/{}"}})", folder, path) + '\n'));
    return out;
}

} // namespace

std::vector<StartScene> start_scenes(const std::string& kind)
{
    if (kind == "bodies") return bodies();
    if (kind == "models") return models();
    if (kind == "volumes") return volumes();
    return real();
}

} // namespace trivar::testing
