// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/color.h"
#include "core/files/file_bytes.h"
#include "core/files/flattened.h"
#include "core/files/formats.h"

#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <set>

namespace trivar {
namespace {

// Makes a name that a line of the format can hold. Materials may have blanks in it; other names end
// there for some programs.
std::string plain_name(std::string name, const std::string& otherwise, bool blanks = false)
{
    for (std::size_t i = 0; i < name.size(); ++i) {
        const bool inside = i > 0 && i + 1 < name.size() && blanks;
        const auto c = static_cast<unsigned char>(name[i]);
        if (c < ' ' || (c == ' ' && !inside)) name[i] = '_';
        if (c == '\\' && i + 1 == name.size()) name[i] = '_'; // or it would go on in the next line
    }
    return name.empty() ? otherwise : name;
}

// Returns the name of the file from which a picture came, with the ending of its format; empty if
// it cannot be the name of a file beside an OBJ.
std::string own_name(const Image& image)
{
    constexpr std::size_t longest = 100;
    std::string name = image.name.substr(image.name.find_last_of("/\\") + 1);
    if (name.empty() || name.size() > longest || name.front() == '-' || name.front() == '.' ||
        name.find('#') != name.npos || name != plain_name(name, "", true))
        return {};
    const std::string ending = extension_of(name);
    const bool jpeg = image.mime == "image/jpeg";
    if (jpeg ? ending == ".jpg" || ending == ".jpeg" : ending == ".png") return name;
    return name + (jpeg ? ".jpg" : ".png");
}

class ObjWriter {
public:
    ObjWriter(const Model& model, const std::string& stem, const IsFree& is_free)
        : model_(model),
          stem_(stem),
          is_free_(is_free),
          origin_(z_to_y * glm::dvec4(far_origin(model), 1))
    {
    }

    ObjFiles write()
    {
        write_materials();
        files_.mtl_name = plain_name(stem_, "model") + ".mtl";
        fmt::format_to(to(), "# Trivar\nmtllib {}\n", files_.mtl_name);
        for (std::size_t n = 0; n < model_.nodes.size(); ++n) {
            const Node& node = model_.nodes[n];
            if (node.mesh < 0 && node.curves < 0) continue;
            const glm::dmat4 matrix = glm::translate(glm::dmat4(1), -origin_) * z_to_y *
                                      node_to_model(model_, static_cast<int>(n));
            fmt::format_to(to(), "o {}\n", plain_name(node.name, fmt::format("object_{}", n)));
            if (node.mesh >= 0)
                write_mesh(
                    transformed(*model_.meshes.at(static_cast<std::size_t>(node.mesh)), matrix));
            if (node.curves >= 0)
                write_curves(
                    transformed(*model_.curves.at(static_cast<std::size_t>(node.curves)), matrix));
        }
        files_.obj = fmt::to_string(out_);
        return std::move(files_);
    }

private:
    std::back_insert_iterator<fmt::memory_buffer> to() { return std::back_inserter(out_); }

    void write_mesh(const Mesh& mesh)
    {
        // One v is written per point, so that seams are closed when the file is read again, but
        // where a point has two colours.
        std::vector<std::uint32_t> v_of_point(mesh.vertex_count() ? point_count(mesh) : 0, none);
        std::vector<std::uint32_t> v_of(mesh.vertex_count());
        std::uint32_t v_count = 0;
        std::vector<std::uint32_t> written; // the vertex of each v
        const auto same = [&](std::uint32_t i, std::uint32_t j) {
            return mesh.positions[i] == mesh.positions[j] &&
                   (mesh.colors.empty() || mesh.colors[i] == mesh.colors[j]);
        };
        for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i) {
            const glm::vec3& p = mesh.positions[i];
            std::uint32_t& known = v_of_point[mesh.point(i)];
            if (known == none || !same(written[known], i)) {
                known = v_count++;
                written.push_back(i);
                write_place(p);
                if (!mesh.colors.empty()) write_color(mesh.colors[i]);
                fmt::format_to(to(), "\n");
            }
            v_of[i] = known;
        }
        if (!mesh.uvs.empty())
            for (const glm::vec2& uv : mesh.uvs[0]) fmt::format_to(to(), "vt {} {}\n", uv.x, uv.y);
        for (const glm::vec3& n : mesh.normals)
            fmt::format_to(to(), "vn {} {} {}\n", n.x, n.y, n.z);
        write_faces(mesh, v_of);
        v_base_ += v_count;
        vt_base_ += mesh.uvs.empty() ? 0 : mesh.vertex_count();
        vn_base_ += mesh.normals.size();
    }

    void write_place(const glm::vec3& p)
    {
        fmt::format_to(to(), "v ");
        add_place(out_, p, origin_);
    }

    // Writes the colour behind the position, as displayed, which is how most programs read it.
    void write_color(const glm::vec4& linear)
    {
        const glm::vec3 c = srgb_from_linear(glm::clamp(glm::vec3(linear), 0.0f, 1.0f));
        fmt::format_to(to(), " {} {} {}", c.x, c.y, c.z);
    }

    void write_faces(const Mesh& mesh, const std::vector<std::uint32_t>& v_of)
    {
        std::uint32_t material = none, group = none;
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            use_material(mesh.face_material.empty() ? 0 : mesh.face_material[f], material);
            if (!mesh.face_group.empty() && mesh.face_group[f] != group) {
                group = mesh.face_group[f];
                fmt::format_to(to(), "g {}\n",
                               plain_name(mesh.group_names[group], fmt::format("g{}", group)));
            }
            fmt::format_to(to(), "f");
            for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
                const std::uint32_t i = mesh.corners[c];
                fmt::format_to(to(), " {}", v_base_ + v_of[i] + 1);
                if (!mesh.uvs.empty())
                    fmt::format_to(to(), "/{}", vt_base_ + i + 1);
                else if (!mesh.normals.empty())
                    fmt::format_to(to(), "/");
                if (!mesh.normals.empty()) fmt::format_to(to(), "/{}", vn_base_ + i + 1);
            }
            fmt::format_to(to(), "\n");
        }
    }

    // Writes the curves. The last point of a closed line is its first one.
    void write_curves(const Curves& curves)
    {
        const std::vector<glm::vec3>& points = curves.points->positions;
        std::uint32_t material = none;
        for (std::size_t l = 0; l < curves.line_count(); ++l) {
            const std::uint32_t first = curves.begin[l], end = curves.begin[l + 1];
            const bool closed = end - first > 3 && points[first] == points[end - 1];
            const std::uint32_t written = end - first - (closed ? 1 : 0);
            for (std::uint32_t i = first; i < first + written; ++i)
                write_place(points[i]), out_.push_back('\n');
            use_material(curves.material_of(l), material);
            fmt::format_to(to(), "l");
            for (std::uint32_t i = 0; i < end - first; ++i)
                fmt::format_to(to(), " {}", v_base_ + i % written + 1);
            fmt::format_to(to(), "\n");
            v_base_ += written;
        }
    }

    void use_material(std::uint32_t wanted, std::uint32_t& now)
    {
        if (wanted != now && wanted < material_names_.size())
            fmt::format_to(to(), "usemtl {}\n", material_names_[wanted]);
        now = wanted;
    }

    void write_materials()
    {
        std::set<std::string> taken;
        for (std::size_t i = 0; i < model_.materials.size(); ++i) {
            const Material& m = model_.materials[i];
            std::string name = plain_name(m.name, fmt::format("material_{}", i), true);
            if (!taken.insert(name).second) {
                name += fmt::format("_{}", i);
                taken.insert(name);
            }
            material_names_.push_back(name);
            const glm::vec4& kd = m.base_color;
            // Ns is for readers that do not know Pr; mtl_reader.cpp has the formula.
            const double r4 = std::pow(std::max(m.roughness, 0.05f), 4);
            files_.mtl +=
                fmt::format("newmtl {}\nKd {} {} {}\nd {}\nKe {} {} {}\nNs {}\nPr {}\n"
                            "Pm {}\n",
                            name, kd.x, kd.y, kd.z, kd.w, m.emissive.x, m.emissive.y, m.emissive.z,
                            static_cast<float>(2 / r4 - 2), m.roughness, m.metallic);
            write_texture("map_Kd", m.base_color_texture);
            write_texture("map_Ke", m.emissive_texture);
            write_texture("norm", m.normal_texture);
            files_.mtl += '\n';
        }
    }

    void write_texture(const char* keyword, const Texture& texture)
    {
        if (!texture.image) return;
        const auto [at, added] = image_names_.emplace(texture.image.get(), "");
        if (added) {
            at->second = file_name(*texture.image);
            files_.images.emplace_back(at->second, texture.image);
        }
        files_.mtl += fmt::format("{} {}\n", keyword, at->second);
    }

    std::string file_name(const Image& image)
    {
        if (as_it_came(image))
            if (std::string own = own_name(image);
                !own.empty() && (!is_free_ || is_free_(own, image)) && taken_.insert(own).second)
                return own;
        const char* ending = image.mime == "image/jpeg" ? "jpg" : "png";
        for (std::size_t number = files_.images.size();; ++number)
            if (std::string name =
                    fmt::format("{}_{}.{}", plain_name(stem_, "model"), number, ending);
                taken_.insert(name).second)
                return name;
    }

    static constexpr std::uint32_t none = ~0u;
    static constexpr glm::dmat4 z_to_y{1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};
    const Model& model_;
    const std::string& stem_;
    const IsFree& is_free_;
    std::set<std::string> taken_; // names of pictures
    glm::dvec3 origin_;           // of what is written
    ObjFiles files_;
    fmt::memory_buffer out_;
    std::vector<std::string> material_names_;
    std::map<const Image*, std::string> image_names_; // only for lookup, never iterated
    std::size_t v_base_ = 0, vt_base_ = 0, vn_base_ = 0;
};

} // namespace

ObjFiles write_obj(const Model& model, const std::string& stem, const IsFree& is_free)
{
    return ObjWriter(model, stem, is_free).write();
}

} // namespace trivar
