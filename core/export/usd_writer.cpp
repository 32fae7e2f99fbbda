// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/usd_writer.h"

#include "core/export/usd_curves.h"
#include "core/export/usd_text.h"
#include "core/files/growing_file.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace trivar {
namespace {

std::string usd_material(const Material& m, std::size_t number)
{
    const std::string path = fmt::format("/Scene/Materials/Material_{}", number);
    return fmt::format("        def Material \"Material_{0}\"\n        {{\n"
                       "            token outputs:surface.connect = <{1}/Surface.outputs:surface>\n"
                       "            def Shader \"Surface\"\n            {{\n"
                       "                uniform token info:id = \"UsdPreviewSurface\"\n"
                       "                color3f inputs:diffuseColor = {2}\n"
                       "                color3f inputs:emissiveColor = {3}\n"
                       "                float inputs:metallic = {4}\n"
                       "                float inputs:roughness = {5}\n"
                       "                float inputs:opacity = {6}\n"
                       "                token outputs:surface\n            }}\n        }}\n",
                       number, path, usd_tuple(glm::vec3(m.base_color)), usd_tuple(m.emissive),
                       usd_number(m.metallic), usd_number(m.roughness), usd_number(m.base_color.w));
}

class UsdStrip {
public:
    UsdStrip(const Film& film, const FilmStrip& strip, GrowingFile& file)
        : film_(film),
          strip_(strip),
          file_(file)
    {
    }

    void write(std::size_t number, std::size_t first_material, const Progress& progress)
    {
        const Mesh& mesh = *strip_.first().rest;
        file_.append(fmt::format("    def Mesh \"{}\" (\n"
                                 "        prepend apiSchemas = [\"MaterialBindingAPI\"]\n    )\n"
                                 "    {{\n        uniform token subdivisionScheme = \"none\"\n",
                                 usd_name(strip_.name, number)));
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
        write_materials(mesh, first_material);
        file_.append("    }\n");
    }

private:
    void line(const std::string& text) { file_.append("        " + text + "\n"); }
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

    void write_materials(const Mesh& mesh, std::size_t first)
    {
        std::map<std::uint32_t, std::vector<std::uint32_t>> faces;
        for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
            faces[mesh.face_material.empty() ? 0 : mesh.face_material[f]].push_back(f);
        const auto bound = [&](std::uint32_t material) {
            return fmt::format("rel material:binding = </Scene/Materials/Material_{}>",
                               first + material);
        };
        if (faces.size() == 1) line(bound(faces.begin()->first));
        if (!faces.empty()) {
            const std::uint32_t material = faces.begin()->first;
            if (material < strip_.materials->size())
                line("color3f[] primvars:displayColor = [" +
                     usd_tuple(glm::vec3((*strip_.materials)[material].base_color)) + "]");
        }
        if (faces.size() < 2) return;
        line("uniform token subsetFamily:materialBind:familyType = \"partition\"");
        for (const auto& [material, of_it] : faces)
            file_.append(fmt::format(
                "        def GeomSubset \"Subset_{}\" (\n"
                "            prepend apiSchemas = [\"MaterialBindingAPI\"]\n        )\n        {{\n"
                "            uniform token elementType = \"face\"\n"
                "            uniform token familyName = \"materialBind\"\n"
                "            int[] indices = {}\n            {}\n        }}\n",
                material, usd_list(of_it), bound(material)));
    }

    const Film& film_;
    const FilmStrip& strip_;
    GrowingFile& file_;
};

} // namespace

void write_usda(const Film& film, const std::vector<CurveStrip>& curves, double frames_per_second,
                const std::string& path, const Progress& progress)
{
    GrowingFile file(path);
    file.append(fmt::format("#usda 1.0\n(\n    defaultPrim = \"Scene\"\n    upAxis = \"Z\"\n"
                            "    metersPerUnit = 1\n    timeCodesPerSecond = {0}\n"
                            "    framesPerSecond = {0}\n    startTimeCode = {1}\n"
                            "    endTimeCode = {2}\n)\n\ndef Xform \"Scene\"\n{{\n"
                            "    def Scope \"Materials\"\n    {{\n",
                            shortest(frames_per_second), shortest(film.moments.front()),
                            shortest(film.moments.back())));
    std::map<Ref<std::vector<Material>>, std::size_t> first_of; // only for lookup
    std::size_t materials = 0;
    const auto add_materials = [&](const Ref<std::vector<Material>>& own) {
        if (!first_of.try_emplace(own, materials).second) return;
        for (const Material& material : *own) file.append(usd_material(material, materials++));
    };
    for (const FilmStrip& strip : film.strips) add_materials(strip.materials);
    for (const CurveStrip& strip : curves) add_materials(strip.materials);
    file.append("    }\n");
    for (std::size_t s = 0; s < film.strips.size(); ++s) {
        const auto count = static_cast<double>(film.strips.size());
        const auto done = static_cast<double>(s);
        UsdStrip(film, film.strips[s], file)
            .write(s, first_of.at(film.strips[s].materials),
                   part_of(progress, done / count, (done + 1) / count));
    }
    std::size_t number = film.strips.size();
    for (const CurveStrip& strip : curves)
        number = add_usd_curves(file, film, strip, number, first_of.at(strip.materials));
    file.append("}\n");
    file.finish();
}

} // namespace trivar
