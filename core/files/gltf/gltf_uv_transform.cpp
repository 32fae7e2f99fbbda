// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/gltf_uv_transform.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace trivar {
namespace {

std::optional<GltfEntry> transform_part(const GltfEntry& extensions)
{
    return extensions.part("KHR_texture_transform");
}

double within_reach(double value)
{
    return std::clamp(value, -1e6, 1e6);
}

UvTransform uv_transform_of(const GltfEntry& texture)
{
    UvTransform out;
    const auto extensions = texture.part("extensions");
    if (!extensions) return out;
    const auto part = transform_part(*extensions);
    if (!part) return out;
    const std::vector<double> offset = part->numbers("offset", 2),
                              scale = part->numbers("scale", 2);
    for (int i = 0; i < 2; ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (!offset.empty()) out.offset[i] = within_reach(offset[at]);
        if (!scale.empty()) out.scale[i] = within_reach(scale[at]);
    }
    out.rotation = within_reach(part->number("rotation", 0));
    return out;
}

} // namespace

glm::vec2 UvTransform::operator()(const glm::vec2& uv) const
{
    const glm::dvec2 p = glm::dvec2(uv) * scale;
    const double c = std::cos(rotation), s = std::sin(rotation);
    return glm::vec2(offset + glm::dvec2(c * p.x + s * p.y, c * p.y - s * p.x));
}

std::size_t uv_set_of(const GltfEntry& texture)
{
    const std::size_t own = texture.size("texCoord");
    const auto extensions = texture.part("extensions");
    if (!extensions) return own;
    const auto part = transform_part(*extensions);
    return part ? part->size("texCoord", own) : own;
}

UvTransforms uv_transforms(const GltfEntry& material, CountedNotices& notices)
{
    std::array<std::optional<UvTransform>, most_uv_sets> found;
    const auto add = [&](const GltfEntry& owner, const char* name) {
        const auto texture = owner.part(name);
        if (!texture) return;
        const std::size_t set = std::min(uv_set_of(*texture), most_uv_sets - 1);
        const UvTransform own = uv_transform_of(*texture);
        if (!found[set])
            found[set] = own;
        else if (!(own == *found[set]))
            notices.add("the transform of one texture was left out, because another texture on the "
                        "same coordinates has a different one",
                        "the transforms of {0} textures were left out, because other textures on "
                        "the same coordinates have different ones");
    };
    if (const auto pbr = material.part("pbrMetallicRoughness")) {
        add(*pbr, "baseColorTexture");
        add(*pbr, "metallicRoughnessTexture");
    }
    for (const char* name : {"normalTexture", "occlusionTexture", "emissiveTexture"})
        add(material, name);
    UvTransforms out;
    for (std::size_t set = 0; set < most_uv_sets; ++set)
        out[set] = found[set].value_or(UvTransform{});
    return out;
}

} // namespace trivar
