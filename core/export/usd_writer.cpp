// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/usd_writer.h"

#include "core/base/text.h"
#include "core/export/usd_curves.h"
#include "core/export/usd_text.h"
#include "core/files/growing_file.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace trivar {
namespace {

// A colored material shows the displayColor of meshes in place of its own colour.
std::string usd_material(const Material& m, std::size_t number, bool colored)
{
    const std::string path = fmt::format("/Scene/Materials/Material_{}", number);
    const std::string color = colored ? fmt::format(".connect = <{}/Color.outputs:result>", path)
                                      : " = " + usd_tuple(glm::vec3(m.base_color));
    const std::string reader =
        !colored ? ""
                 : "            def Shader \"Color\"\n            {\n"
                   "                uniform token info:id = \"UsdPrimvarReader_float3\"\n"
                   "                string inputs:varname = \"displayColor\"\n"
                   "                float3 outputs:result\n            }\n";
    return fmt::format("        def Material \"Material_{0}\"\n        {{\n"
                       "            token outputs:surface.connect = <{1}/Surface.outputs:surface>\n"
                       "            def Shader \"Surface\"\n            {{\n"
                       "                uniform token info:id = \"UsdPreviewSurface\"\n"
                       "                color3f inputs:diffuseColor{2}\n"
                       "                color3f inputs:emissiveColor = {3}\n"
                       "                float inputs:metallic = {4}\n"
                       "                float inputs:roughness = {5}\n"
                       "                float inputs:opacity = {6}\n"
                       "                token outputs:surface\n            }}\n{7}        }}\n",
                       number, path, color, usd_tuple(m.emissive), usd_number(m.metallic),
                       usd_number(m.roughness), usd_number(m.base_color.w), reader);
}

// The colours of vertices times those of the materials of their faces; where faces of several have
// a vertex, of the first.
std::vector<glm::vec3> display_colors(const Mesh& mesh, const std::vector<Material>& materials)
{
    std::vector<glm::vec3> out(mesh.vertex_count(), glm::vec3(1));
    std::vector<bool> done(mesh.vertex_count(), false);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::size_t number = mesh.face_material.empty() ? 0 : mesh.face_material[f];
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            const std::uint32_t v = mesh.corners[c];
            if (done[v]) continue;
            done[v] = true;
            if (number < materials.size()) out[v] = glm::vec3(materials[number].base_color);
            if (!mesh.colors.empty()) out[v] *= glm::vec3(mesh.colors[v]);
        }
    }
    return out;
}

// Materials that are written, and which of them show the colours of meshes.
struct UsdMaterials {
    std::map<Ref<std::vector<Material>>, std::size_t> first; // only for lookup, as the next
    std::set<Ref<std::vector<Material>>> colored;
};

class UsdStrip {
public:
    // The margin is that of the prim's first line.
    UsdStrip(const Film& film, const FilmStrip& strip, GrowingFile& file,
             const std::string& margin = "    ")
        : film_(film),
          strip_(strip),
          file_(file),
          margin_(margin)
    {
    }

    void write(const std::string& name, const UsdMaterials& materials, const Progress& progress)
    {
        const Mesh& mesh = *strip_.first().rest;
        file_.append(fmt::format("{0}def Mesh \"{1}\" (\n"
                                 "{0}    prepend apiSchemas = [\"MaterialBindingAPI\"]\n{0})\n"
                                 "{0}{{\n{0}    uniform token subdivisionScheme = \"none\"\n",
                                 margin_, name));
        std::vector<std::uint32_t> counts;
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            counts.push_back(mesh.face_begin[f + 1] - mesh.face_begin[f]);
        line("int[] faceVertexCounts = " + usd_list(counts));
        line("int[] faceVertexIndices = " + usd_list(mesh.corners));
        if (!mesh.uvs.empty())
            line("texCoord2f[] primvars:st = " + usd_list(mesh.uvs.front()) +
                 " (\n            interpolation = \"vertex\"\n        )");
        if (strip_.bent() || strip_.posed() || strip_.reshaped())
            write_points(progress);
        else
            write_matrices();
        write_visibility();
        write_materials(mesh, materials.first.at(strip_.materials),
                        materials.colored.contains(strip_.materials));
        file_.append(margin_ + "}\n");
    }

private:
    void line(const std::string& text) { file_.append(margin_ + "    " + text + "\n"); }
    std::string frame(std::size_t moment) const { return usd_time(film_, moment); }

    void write_points(const Progress& progress)
    {
        const bool normals = !strip_.first().rest->normals.empty();
        std::string bent_normals;
        line("point3f[] points.timeSamples = {");
        for (std::size_t i = 0; i < film_.moments.size(); ++i) {
            report(progress, static_cast<double>(i) / static_cast<double>(film_.moments.size()),
                   "writing points");
            if (!strip_.shown[i]) continue;
            const Mesh mesh = mesh_in_world(*strip_.shown[i]);
            line("    " + frame(i) + ": " + usd_list(mesh.positions) + ",");
            if (normals)
                bent_normals += "            " + frame(i) + ": " + usd_list(mesh.normals) + ",\n";
        }
        line("}");
        if (!normals) return;
        line("normal3f[] normals.timeSamples = {");
        file_.append(bent_normals);
        line("}");
        line("normal3f[] normals (\n            interpolation = \"vertex\"\n        )");
    }

    void write_matrices()
    {
        const Mesh& mesh = *strip_.first().rest;
        line("point3f[] points = " + usd_list(mesh.positions));
        if (!mesh.normals.empty())
            line("normal3f[] normals = " + usd_list(mesh.normals) +
                 " (\n            interpolation = \"vertex\"\n        )");
        const glm::dmat4 first = strip_.first().to_world;
        const bool still = std::ranges::all_of(
            strip_.shown, [&](const Part* part) { return !part || part->to_world == first; });
        if (still) {
            line("matrix4d xformOp:transform = " + usd_matrix(first));
        } else {
            line("matrix4d xformOp:transform.timeSamples = {");
            for (std::size_t i = 0; i < film_.moments.size(); ++i)
                if (strip_.shown[i])
                    line("    " + frame(i) + ": " + usd_matrix(strip_.shown[i]->to_world) + ",");
            line("}");
        }
        line("uniform token[] xformOpOrder = [\"xformOp:transform\"]");
    }

    void write_visibility()
    {
        if (std::ranges::none_of(strip_.shown, [](const Part* part) { return !part; })) return;
        line("token visibility.timeSamples = {");
        for (std::size_t i = 0; i < film_.moments.size(); ++i)
            line(fmt::format("    {}: \"{}\",", frame(i),
                             strip_.shown[i] ? "inherited" : "invisible"));
        line("}");
    }

    void write_materials(const Mesh& mesh, std::size_t first, bool colored)
    {
        std::map<std::uint32_t, std::vector<std::uint32_t>> faces;
        for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
            faces[mesh.face_material.empty() ? 0 : mesh.face_material[f]].push_back(f);
        const auto bound = [&](std::uint32_t material) {
            return fmt::format("rel material:binding = </Scene/Materials/Material_{}>",
                               first + material);
        };
        if (faces.size() == 1) line(bound(faces.begin()->first));
        if (colored) {
            line("color3f[] primvars:displayColor = " +
                 usd_list(display_colors(mesh, *strip_.materials)) + " (\n            " +
                 "interpolation = \"vertex\"\n        )");
        } else if (!faces.empty()) {
            const std::uint32_t material = faces.begin()->first;
            if (material < strip_.materials->size())
                line("color3f[] primvars:displayColor = [" +
                     usd_tuple(glm::vec3((*strip_.materials)[material].base_color)) + "]");
        }
        if (faces.size() < 2) return;
        line("uniform token subsetFamily:materialBind:familyType = \"partition\"");
        for (const auto& [material, of_it] : faces)
            file_.append(fmt::format(
                "{0}    def GeomSubset \"Subset_{1}\" (\n"
                "{0}        prepend apiSchemas = [\"MaterialBindingAPI\"]\n{0}    )\n{0}    {{\n"
                "{0}        uniform token elementType = \"face\"\n"
                "{0}        uniform token familyName = \"materialBind\"\n"
                "{0}        int[] indices = {2}\n{0}        {3}\n{0}    }}\n",
                margin_, material, usd_list(of_it), bound(material)));
    }

    const Film& film_;
    const FilmStrip& strip_;
    GrowingFile& file_;
    std::string margin_;
};

} // namespace

void write_usda(const Film& film, const InstancedFilm& shown, const std::vector<CurveStrip>& curves,
                double frames_per_second, const std::string& path, const Progress& progress)
{
    GrowingFile file(path);
    file.append(fmt::format("#usda 1.0\n(\n    defaultPrim = \"Scene\"\n    upAxis = \"Z\"\n"
                            "    metersPerUnit = 1\n    timeCodesPerSecond = {0}\n"
                            "    framesPerSecond = {0}\n    startTimeCode = {1}\n"
                            "    endTimeCode = {2}\n)\n\ndef Xform \"Scene\"\n{{\n"
                            "    def Scope \"Materials\"\n    {{\n",
                            shortest(frames_per_second), shortest(film.moments.front()),
                            shortest(film.moments.back())));
    UsdMaterials materials;
    const auto note_colors = [&](const FilmStrip& strip) {
        if (!strip.first().rest->colors.empty()) materials.colored.insert(strip.materials);
    };
    for (const FilmStrip& strip : shown.strips) note_colors(strip);
    for (const UsdInstancer& each : shown.instancers) note_colors(each.mesh);
    std::size_t count_of_materials = 0;
    const auto add_materials = [&](const Ref<std::vector<Material>>& own) {
        if (!materials.first.try_emplace(own, count_of_materials).second) return;
        for (const Material& material : *own)
            file.append(
                usd_material(material, count_of_materials++, materials.colored.contains(own)));
    };
    for (const FilmStrip& strip : shown.strips) add_materials(strip.materials);
    for (const UsdInstancer& each : shown.instancers) add_materials(each.mesh.materials);
    for (const CurveStrip& strip : curves) add_materials(strip.materials);
    file.append("    }\n");
    std::size_t number = 0;
    const auto count = static_cast<double>(shown.strips.size());
    for (const FilmStrip& strip : shown.strips) {
        const auto done = static_cast<double>(number);
        UsdStrip(film, strip, file)
            .write(usd_name(strip.name, number++), materials,
                   part_of(progress, done / count, (done + 1) / count));
    }
    for (const UsdInstancer& each : shown.instancers) {
        const std::string name = usd_name(each.mesh.name, number++);
        begin_instancer(file, film, each, name);
        UsdStrip(film, each.mesh, file, "        ").write(name, materials, {});
        file.append("    }\n");
    }
    for (const CurveStrip& strip : curves)
        number = add_usd_curves(file, film, strip, number, materials.first.at(strip.materials));
    file.append("}\n");
    file.finish();
}

} // namespace trivar
