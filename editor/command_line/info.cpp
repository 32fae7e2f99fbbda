// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/info.h"

#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/document/document_digest.h"
#include "core/document/named_files.h"
#include "core/files/file_bytes.h"
#include "core/files/pictures/image.h"
#include "core/files/read_model.h"
#include "core/mesh/extent.h"
#include "core/mesh/pose.h"
#include "core/scene/log.h"
#include "core/voxels/dicom_series.h"
#include "core/voxels/image_stack.h"
#include "core/voxels/read_volume.h"
#include "core/voxels/segments.h"
#include "core/voxels/usual_level.h"
#include "editor/files/volume_names.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace trivar {
namespace {

using Facts = nlohmann::ordered_json; // name to value, in the order they are said

Facts model_facts(const std::string& path)
{
    const Model model = read_model(path, {.normals_of_faces = false}); // its own vertices
    if (too_large(model))
        throw Rejected(fmt::format("{}: its coordinates are {}", path, too_large_words));
    std::size_t vertices = 0, faces = 0, triangles = 0, uv_sets = 0, images = 0;
    std::size_t targets = 0;
    bool colors = false, creases = false;
    for (const Ref<Mesh>& mesh : model.meshes) {
        vertices += mesh->vertex_count();
        faces += mesh->face_count();
        triangles += mesh->corners.size() - 2 * mesh->face_count();
        uv_sets = std::max(uv_sets, mesh->uvs.size());
        colors = colors || !mesh->colors.empty();
        creases = creases || !mesh->creases.empty();
        targets += mesh->morph_targets.size();
    }
    std::size_t shown = 0; // triangles of all instances of the meshes
    for (const Node& node : model.nodes)
        if (node.mesh >= 0) {
            const Mesh& mesh = *model.meshes[static_cast<std::size_t>(node.mesh)];
            shown += mesh.corners.size() - 2 * mesh.face_count();
        }
    for (const Material& m : model.materials)
        for (const Texture* texture :
             {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture,
              &m.occlusion_texture, &m.emissive_texture})
            images += texture->image ? 1 : 0;
    const glm::dvec3 size = bounding_box(model).size();
    Facts clips = Facts::array();
    for (const Clip& clip : model.clips)
        clips.push_back({{"name", clip.name}, {"seconds", clip.end_s - clip.begin_s}});
    Facts facts{{"kind", "model"},
                {"meshes", model.meshes.size()},
                {"nodes", model.nodes.size()},
                {"vertices", vertices},
                {"faces", faces},
                {"triangles", triangles},
                {"triangles_shown", shown},
                {"curves", line_count(model)},
                {"materials", model.materials.size()},
                {"textures", images},
                {"uv_sets", uv_sets},
                {"vertex_colors", colors},
                {"creases", creases},
                {"skins", model.skins.size()},
                {"morph_targets", targets},
                {"clips", clips},
                {"size_m", {size.x, size.y, size.z}},
                {"hash", file_hash(path)}};
    if (!model.notices.empty()) facts["repaired"] = model.notices;
    return facts;
}

Facts three(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

// Describes a volume; one that does not fit into half of the memory by its head alone.
Facts volume_facts(const std::string& path)
{
    constexpr double millimetres = 1e3;
    ReadVolumeOptions options;
    options.memory_bytes = std::max(physical_bytes() / 2, std::uint64_t{1} << 28);
    options.if_too_large = TooLarge::head;
    const ReadVolume read = read_volume(path, options);
    const VoxelGrid& grid = read.grid;
    const VolumeSummary summary = summary_of(grid);
    Facts directions = Facts::array();
    for (int k = 0; k < 3; ++k)
        directions.push_back(three(glm::normalize(glm::dvec3(grid.to_metres[k]))));
    Facts facts{{"kind", "volume data"},
                {"size", {grid.size.x, grid.size.y, grid.size.z}},
                {"type", summary.type},
                {"spacing_mm", three(summary.spacing_mm)},
                {"size_mm", three(summary.spacing_mm * glm::dvec3(grid.size))},
                {"directions", directions},
                {"origin_mm", three(millimetres * glm::dvec3(grid.to_metres[3]))},
                {"files", read.companions.size() + 1}};
    if (!grid.value_unit.empty()) facts["unit"] = grid.value_unit;
    if (grid.bytes() > 0) {
        facts["range"] = {summary.least, summary.greatest};
        facts["suggested_levels"] = usual_levels(summary, grid);
        facts["bytes"] = summary.bytes;
    }
    for (const VolumeSegment& segment : segments_of(path))
        facts["segments"].push_back(fmt::format("{} ({})", segment.name, segment.value));
    if (std::filesystem::is_directory(path)) {
        facts["files"] = read.companions.size();
        if (const auto series = dicom_series_in(path); !series.empty()) facts["series"] = series;
    }
    if (!grid.notices.empty()) facts["notices"] = grid.notices;
    return facts;
}

Facts image_facts(const std::string& path, PictureReader& pictures)
{
    const Image image = pictures.read(path);
    return {{"kind", "image"}, {"width_px", image.size_px.x}, {"height_px", image.size_px.y}};
}

Facts scene_facts(const std::string& path)
{
    const Log log = read_log(read_text_file(path), path);
    const History history = replay(log);
    const Document& document = history.document();
    std::vector<std::string> files, kept_views;
    std::size_t placed = 0;
    for (const auto& [id, ref] : document.objects) {
        for (FileUse& file : files_named(*ref)) files.push_back(std::move(file.path));
        placed += ref->stroke ? 1 : 0;
    }
    for (const auto& [name, camera] : document.kept_views) kept_views.push_back(name);
    Facts facts{{"kind", "scene"},
                {"steps", history.position()},
                {"undone_steps", history.steps().size() - history.position()},
                {"objects", document.objects.size()},
                {"placed", placed},
                {"files", files},
                {"points_of_view", kept_views},
                {"digest", digest(document)}};
    if (!log.notice.empty()) facts["notice"] = log.notice;
    return facts;
}

Facts facts_of(const std::string& path, PictureReader& pictures)
{
    const std::string extension = extension_of(path);
    static constexpr std::array<std::string_view, 6> models{".obj", ".ply",  ".stl",
                                                            ".off", ".gltf", ".glb"};
    if (extension == ".trivar") return scene_facts(path);
    if (std::ranges::find(models, extension) != models.end()) return model_facts(path);
    if (may_be_slice(path)) return image_facts(path, pictures);
    if (is_volume(path)) return volume_facts(path);
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return image_facts(path, pictures);
    try {
        return image_facts(path, pictures);
    } catch (const Rejected&) {
        throw Rejected(path + ": this is no file that Trivar reads: a scene (.trivar), a model "
                              "(glTF, OBJ, PLY, STL, OFF), volume data (NRRD, NIfTI, MetaImage, "
                              "VTK, DICOM, raw, a folder of slices) or a picture (PNG, JPEG, WebP, "
                              "TIFF, EXR and others)");
    }
}

std::string plain(const Facts& value)
{
    if (value.is_string()) return value.get<std::string>();
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (value.is_number_float()) return number_text(value.get<double>(), {.digits = 4});
    if (value.is_object()) // a clip
        return fmt::format("{} ({} s)", value.at("name").get<std::string>(),
                           number_text(value.at("seconds").get<double>()));
    if (!value.is_array()) return value.dump();
    std::string text;
    for (const Facts& entry : value) text += (text.empty() ? "" : ", ") + plain(entry);
    return text.empty() ? "none" : text;
}

} // namespace

Status run_info(const InfoOptions& options, const Streams& streams)
{
    Status status = Status::done;
    Facts all = Facts::array();
    PictureReader pictures;
    for (const std::string& path : options.files) {
        Facts facts{{"file", path}};
        try {
            facts.update(facts_of(path, pictures));
        } catch (const Rejected& error) {
            streams.talk << "trivar: " << error.what() << "\n";
            status = Status::rejected;
            continue;
        }
        if (!options.json)
            for (const auto& [name, value] : facts.items()) {
                std::string words = name;
                std::ranges::replace(words, '_', ' ');
                // Sentences have a line each
                for (const Facts& line : name == "repaired" || name == "notices" ||
                                                 name == "series" || name == "directions"
                                             ? value
                                             : Facts::array({value}))
                    streams.out << fmt::format("{:<16} {}\n", std::exchange(words, ""),
                                               plain(line));
            }
        if (!options.json && path != options.files.back()) streams.out << "\n";
        all.push_back(std::move(facts));
    }
    if (options.json)
        streams.out << all.dump(2, ' ', false, Facts::error_handler_t::replace) << "\n";
    return status;
}

} // namespace trivar
