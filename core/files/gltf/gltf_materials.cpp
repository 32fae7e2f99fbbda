// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/gltf_materials.h"

#include "core/files/gltf/gltf_pictures.h"
#include "core/files/gltf/gltf_uv_transform.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr int max_uv_set = 7;

float unit(double value)
{
    return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

class MaterialReader {
public:
    MaterialReader(const GltfFile& file, CountedNotices& notices)
        : file_(file),
          notices_(notices),
          pictures_(file, notices)
    {
    }

    Material read(const GltfEntry& from)
    {
        Material m;
        m.name = from.text("name");
        m.base_color = glm::vec4(1);
        m.metallic = m.roughness = 1;
        if (const auto pbr = from.part("pbrMetallicRoughness")) {
            const std::vector<double> color = pbr->numbers("baseColorFactor", 4);
            for (std::size_t i = 0; i < color.size(); ++i)
                m.base_color[static_cast<int>(i)] = unit(color[i]);
            m.metallic = unit(pbr->number("metallicFactor", 1));
            m.roughness = unit(pbr->number("roughnessFactor", 1));
            m.base_color_texture = texture(*pbr, "baseColorTexture");
            m.metallic_roughness_texture = texture(*pbr, "metallicRoughnessTexture");
        }
        m.normal_texture = texture(from, "normalTexture");
        m.occlusion_texture = texture(from, "occlusionTexture");
        m.emissive_texture = texture(from, "emissiveTexture");
        if (const auto normal = from.part("normalTexture"))
            m.normal_scale =
                static_cast<float>(std::clamp(normal->number("scale", 1), -100.0, 100.0));
        const std::vector<double> emissive = from.numbers("emissiveFactor", 3);
        const double strength = emissive_strength(from);
        for (std::size_t i = 0; i < emissive.size(); ++i)
            m.emissive[static_cast<int>(i)] =
                static_cast<float>(std::clamp(emissive[i] * strength, 0.0, 1e6));
        const std::string_view alpha = from.text("alphaMode");
        m.alpha = alpha == "MASK"    ? Material::Alpha::mask
                  : alpha == "BLEND" ? Material::Alpha::blend
                                     : Material::Alpha::opaque;
        m.alpha_cutoff = unit(from.number("alphaCutoff", 0.5));
        m.double_sided = from.flag("doubleSided");
        return m;
    }

private:
    static double emissive_strength(const GltfEntry& material)
    {
        const auto extensions = material.part("extensions");
        const auto strength =
            extensions ? extensions->part("KHR_materials_emissive_strength") : std::nullopt;
        return strength ? strength->number("emissiveStrength", 1) : 1;
    }

    // Reads a texture with the settings of the material that uses it.
    Texture texture(const GltfEntry& material, const char* name)
    {
        const auto use = material.part(name);
        if (!use) return {};
        const std::size_t index = use->size("index", ~std::size_t{0});
        if (index >= file_.root().count("textures")) {
            notices_.add("one texture that a material names does not exist",
                         "{0} textures that materials name do not exist");
            return {};
        }
        const auto [known, fresh] = textures_.try_emplace(index);
        if (fresh) known->second = read_texture(file_.root().item("textures", "texture", index));
        Texture out = known->second;
        if (!out.image) return {};
        const std::size_t uv_set = uv_set_of(*use);
        out.uv_set = static_cast<int>(std::min<std::size_t>(uv_set, max_uv_set));
        if (uv_set > max_uv_set)
            notices_.add("one texture uses a set of texture coordinates beyond the eighth; the "
                         "eighth is used instead",
                         "{0} textures use sets of texture coordinates beyond the eighth; the "
                         "eighth is used instead");
        return out;
    }

    Texture read_texture(const GltfEntry& from)
    {
        Texture out;
        const auto source = picture_of(from);
        if (!source) return out;
        if (*source >= file_.root().count("images")) {
            notices_.add("one texture names a picture that does not exist",
                         "{0} textures name pictures that do not exist");
            return out;
        }
        out.image = pictures_.picture(*source);
        if (const int sampler = from.index("sampler"); sampler >= 0)
            set_wrapping(out, static_cast<std::size_t>(sampler));
        return out;
    }

    // Returns the index of the picture of a texture. A texture may have a picture in the format of
    // an extension and, beside it, one in a core format.
    std::optional<std::size_t> picture_of(const GltfEntry& texture)
    {
        if (texture.index("source") >= 0) return texture.size("source");
        const auto extensions = texture.part("extensions");
        const auto webp = extensions ? extensions->part("EXT_texture_webp") : std::nullopt;
        if (webp && webp->index("source") >= 0) return webp->size("source");
        const std::vector<std::string> others =
            extensions ? extensions->names() : std::vector<std::string>();
        if (others.empty())
            notices_.add("one texture names no picture", "{0} textures name no pictures");
        else
            notices_.add("one texture has its picture only in a kind that cannot be read, {1}",
                         "{0} textures have their pictures only in kinds that cannot be read, {1} "
                         "for one",
                         1, others.front());
        return {};
    }

    void set_wrapping(Texture& out, std::size_t index)
    {
        constexpr std::size_t clamp = 33071, mirrored = 33648, repeat = 10497;
        if (index >= file_.root().count("samplers")) {
            notices_.add("one texture names a sampler that does not exist, so the texture repeats",
                         "{0} textures name samplers that do not exist, so the textures repeat");
            return;
        }
        const GltfEntry sampler = file_.root().item("samplers", "sampler", index);
        const std::size_t u = sampler.size("wrapS", repeat), v = sampler.size("wrapT", repeat);
        out.repeat_u = u != clamp;
        out.repeat_v = v != clamp;
        if (u == mirrored || v == mirrored)
            notices_.add("one texture is mirrored where it repeats, which was left out",
                         "{0} textures are mirrored where they repeat, which was left out");
    }

    const GltfFile& file_;
    CountedNotices& notices_;
    GltfPictures pictures_;
    std::map<std::size_t, Texture> textures_; // by index
};

} // namespace

std::vector<Material> gltf_materials(GltfFile& file, CountedNotices& notices)
{
    const std::size_t count = file.root().count("materials");
    constexpr std::size_t material_bytes = 450;
    file.account(file.root(), count, "materials", material_bytes);
    MaterialReader reader(file, notices);
    std::vector<Material> out;
    out.reserve(count + 1); // a plain one may be added
    file.root().each("materials", "material",
                     [&](const GltfEntry& each) { out.push_back(reader.read(each)); });
    return out;
}

} // namespace trivar
