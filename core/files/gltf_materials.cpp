// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf_materials.h"

#include "core/base/rejected.h"
#include "core/files/image.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <tiny_gltf.h>

namespace trivar {
namespace {

Ref<Image> decoded(const tinygltf::Image& image, std::size_t index, const GltfAccessors& accessors,
                   const std::string& name, std::vector<std::string>& notices)
{
    const std::string label = !image.name.empty()  ? image.name
                              : !image.uri.empty() ? image.uri
                                                   : fmt::format("picture {}", index);
    try {
        std::string_view bytes(reinterpret_cast<const char*>(image.image.data()),
                               image.image.size());
        if (image.bufferView >= 0) {
            const GltfAccessors::Bytes view = accessors.view(image.bufferView);
            bytes = {reinterpret_cast<const char*>(view.data), view.size};
        }
        if (bytes.empty()) return nullptr; // not found: said when the file was loaded
        Image result = read_image_bytes(bytes, label);
        return make_ref(std::move(result));
    } catch (const Rejected& rejected) {
        notices.push_back(fmt::format("{}: {}", name, rejected.what()));
        return nullptr;
    }
}

class MaterialReader {
public:
    MaterialReader(const tinygltf::Model& gltf, std::vector<Ref<Image>> images)
        : gltf_(gltf),
          images_(std::move(images))
    {
    }

    Material read(const tinygltf::Material& from)
    {
        Material m;
        m.name = from.name;
        const auto& pbr = from.pbrMetallicRoughness;
        for (int i = 0; i < 4; ++i) m.base_color[i] = unit(at(pbr.baseColorFactor, i, 1), 1);
        m.metallic = unit(pbr.metallicFactor, 1);
        m.roughness = unit(pbr.roughnessFactor, 1);
        double strength = 1;
        if (const auto e = from.extensions.find("KHR_materials_emissive_strength");
            e != from.extensions.end() && e->second.Has("emissiveStrength") &&
            e->second.Get("emissiveStrength").IsNumber())
            strength = e->second.Get("emissiveStrength").GetNumberAsDouble();
        for (int i = 0; i < 3; ++i) {
            const double value = at(from.emissiveFactor, i, 0) * strength;
            m.emissive[i] = value > 0 ? static_cast<float>(std::min(value, 1e6)) : 0.0f;
        }
        m.normal_scale = std::isfinite(from.normalTexture.scale)
                             ? static_cast<float>(std::clamp(from.normalTexture.scale, -100., 100.))
                             : 1.0f;
        m.alpha = from.alphaMode == "MASK"    ? Material::Alpha::mask
                  : from.alphaMode == "BLEND" ? Material::Alpha::blend
                                              : Material::Alpha::opaque;
        m.alpha_cutoff = unit(from.alphaCutoff, 0.5f);
        m.double_sided = from.doubleSided;
        m.base_color_texture = texture(pbr.baseColorTexture);
        m.metallic_roughness_texture = texture(pbr.metallicRoughnessTexture);
        m.normal_texture = texture(from.normalTexture);
        m.occlusion_texture = texture(from.occlusionTexture);
        m.emissive_texture = texture(from.emissiveTexture);
        return m;
    }

    bool transforms_left_out() const { return transforms_left_out_; }

private:
    static double at(const std::vector<double>& values, int i, double otherwise)
    {
        const auto index = static_cast<std::size_t>(i);
        return index < values.size() ? values[index] : otherwise;
    }
    static float unit(double value, float otherwise)
    {
        return std::isfinite(value) ? static_cast<float>(std::clamp(value, 0.0, 1.0)) : otherwise;
    }

    template <class Info> Texture texture(const Info& info)
    {
        Texture result;
        if (info.index < 0 || static_cast<std::size_t>(info.index) >= gltf_.textures.size())
            return result;
        const tinygltf::Texture& from = gltf_.textures[static_cast<std::size_t>(info.index)];
        if (from.source < 0 || static_cast<std::size_t>(from.source) >= images_.size())
            return result;
        result.image = images_[static_cast<std::size_t>(from.source)];
        result.uv_set = std::clamp(info.texCoord, 0, 7);
        if (from.sampler >= 0 && static_cast<std::size_t>(from.sampler) < gltf_.samplers.size()) {
            const auto& sampler = gltf_.samplers[static_cast<std::size_t>(from.sampler)];
            result.repeat_u = sampler.wrapS != TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
            result.repeat_v = sampler.wrapT != TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
        }
        transforms_left_out_ |= info.extensions.contains("KHR_texture_transform");
        return result;
    }

    const tinygltf::Model& gltf_;
    std::vector<Ref<Image>> images_;
    bool transforms_left_out_ = false;
};

} // namespace

void add_gltf_materials(Model& model, const tinygltf::Model& gltf, const GltfAccessors& accessors,
                        const std::string& name)
{
    std::vector<Ref<Image>> images;
    for (const tinygltf::Image& image : gltf.images)
        images.push_back(decoded(image, images.size(), accessors, name, model.notices));
    MaterialReader reader(gltf, std::move(images));
    for (const tinygltf::Material& material : gltf.materials)
        model.materials.push_back(reader.read(material));
    if (reader.transforms_left_out())
        model.notices.push_back(name + ": the textures' own transforms were left out");
}

} // namespace trivar
