// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/glb_materials.h"

#include "core/files/formats.h"
#include "core/files/gltf/glb_accessors.h"
#include "core/files/pictures/image.h"

#include <algorithm>
#include <map>

namespace trivar {

class GlbMaterials::Written {
public:
    Written(const std::vector<Material>& materials, GlbAccessors& to)
        : materials_(materials),
          to_(to)
    {
    }
    void add_all();
    std::size_t on(std::size_t number, std::size_t uv_sets);
    bool emissive_strength() const { return emissive_strength_; }

private:
    GlbEntries written(const Material& m);
    void put_texture(GlbEntries& into, const char* key, const Texture& texture);
    // The index of an entry in one of the lists of the file; a new entry is added.
    std::size_t index_of(const char* list, const GlbEntries& entry);
    std::size_t image_index(const Ref<Image>& image);

    const std::vector<Material>& materials_;
    GlbAccessors& to_;
    std::map<const Image*, std::size_t> images_; // only for lookup, never iterated
    bool emissive_strength_ = false;
};

void GlbMaterials::Written::add_all()
{
    for (const Material& material : materials_) {
        GlbEntries entry = written(material); // adds to other lists, so its own is looked up after
        to_.json["materials"].push_back(std::move(entry));
    }
}

std::size_t GlbMaterials::Written::on(std::size_t number, std::size_t uv_sets)
{
    Material shown = materials_[number];
    bool all = true;
    for (Texture* texture :
         {&shown.base_color_texture, &shown.metallic_roughness_texture, &shown.normal_texture,
          &shown.occlusion_texture, &shown.emissive_texture})
        if (texture->image && static_cast<std::size_t>(texture->uv_set) >= uv_sets) {
            *texture = {};
            all = false;
        }
    if (all) return number;
    const GlbEntries entry = written(shown);
    return index_of("materials", entry);
}

GlbEntries GlbMaterials::Written::written(const Material& m)
{
    GlbEntries result;
    if (!m.name.empty()) result["name"] = m.name;
    GlbEntries pbr{{"baseColorFactor",
                    {plain(m.base_color.x), plain(m.base_color.y), plain(m.base_color.z),
                     plain(m.base_color.w)}},
                   {"metallicFactor", plain(m.metallic)},
                   {"roughnessFactor", plain(m.roughness)}};
    put_texture(pbr, "baseColorTexture", m.base_color_texture);
    put_texture(pbr, "metallicRoughnessTexture", m.metallic_roughness_texture);
    result["pbrMetallicRoughness"] = std::move(pbr);
    put_texture(result, "normalTexture", m.normal_texture);
    if (m.normal_texture.image && m.normal_scale != 1)
        result["normalTexture"]["scale"] = plain(m.normal_scale);
    put_texture(result, "occlusionTexture", m.occlusion_texture);
    put_texture(result, "emissiveTexture", m.emissive_texture);
    const float strongest = std::max({m.emissive.x, m.emissive.y, m.emissive.z});
    if (strongest > 0) {
        const glm::vec3 color = m.emissive / std::max(strongest, 1.0f);
        result["emissiveFactor"] = {plain(color.x), plain(color.y), plain(color.z)};
    }
    if (strongest > 1) {
        emissive_strength_ = true;
        result["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] =
            plain(strongest);
    }
    if (m.alpha == Material::Alpha::mask) {
        result["alphaMode"] = "MASK";
        result["alphaCutoff"] = plain(m.alpha_cutoff);
    }
    if (m.alpha == Material::Alpha::blend) result["alphaMode"] = "BLEND";
    if (m.double_sided) result["doubleSided"] = true;
    return result;
}

void GlbMaterials::Written::put_texture(GlbEntries& into, const char* key, const Texture& texture)
{
    if (!texture.image) return;
    const int clamp = 33071, repeat = 10497;
    const GlbEntries sampler{{"wrapS", texture.repeat_u ? repeat : clamp},
                             {"wrapT", texture.repeat_v ? repeat : clamp}};
    const GlbEntries entry{{"sampler", index_of("samplers", sampler)},
                           {"source", image_index(texture.image)}};
    into[key]["index"] = index_of("textures", entry);
    if (texture.uv_set != 0) into[key]["texCoord"] = texture.uv_set;
}

// Returns the index of an entry in one of the lists of the file; a new entry is added.
std::size_t GlbMaterials::Written::index_of(const char* list, const GlbEntries& entry)
{
    GlbEntries& entries = to_.json[list];
    const auto at = std::find(entries.begin(), entries.end(), entry);
    if (at != entries.end()) return static_cast<std::size_t>(at - entries.begin());
    entries.push_back(entry);
    return entries.size() - 1;
}

std::size_t GlbMaterials::Written::image_index(const Ref<Image>& image)
{
    const auto [at, added] = images_.emplace(image.get(), images_.size());
    if (!added) return at->second;
    const bool kept = as_it_came(*image);
    const std::string bytes = kept ? image->source_bytes : encoded_image(*image, ".png");
    GlbEntries entry;
    if (!image->name.empty()) entry["name"] = image->name;
    entry["bufferView"] = to_.add_view(bytes.data(), bytes.size(), 0);
    entry["mimeType"] = kept ? image->mime : "image/png";
    to_.json["images"].push_back(std::move(entry));
    return at->second;
}

GlbMaterials::GlbMaterials(const std::vector<Material>& materials, GlbAccessors& to)
    : written_(std::make_unique<Written>(materials, to))
{
}

GlbMaterials::~GlbMaterials() = default;

void GlbMaterials::add_all()
{
    written_->add_all();
}

std::size_t GlbMaterials::on(std::size_t number, std::size_t uv_sets)
{
    return written_->on(number, uv_sets);
}

bool GlbMaterials::emissive_strength() const
{
    return written_->emissive_strength();
}

} // namespace trivar
