// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/glb_accessors.h"
#include "core/mesh/model.h"

#include <map>

namespace trivar {

// GlbMaterials writes the materials of a model with their textures and pictures into a GLB file.
class GlbMaterials {
public:
    GlbMaterials(const std::vector<Material>& materials, GlbAccessors& to)
        : materials_(materials),
          to_(to)
    {
    }

    void add_all();
    // The number in the file of a material on vertices with that many sets of texture coordinates:
    // textures that need others are left out there, as glTF allows none.
    std::size_t on(std::size_t number, std::size_t uv_sets);
    // Whether KHR_materials_emissive_strength is used.
    bool emissive_strength() const { return emissive_strength_; }

private:
    GlbEntries written(const Material& m);
    void put_texture(GlbEntries& into, const char* key, const Texture& texture);
    std::size_t index_of(const char* list, const GlbEntries& entry);
    std::size_t image_index(const Ref<Image>& image);

    const std::vector<Material>& materials_;
    GlbAccessors& to_;
    std::map<const Image*, std::size_t> images_; // only for lookup, never iterated
    bool emissive_strength_ = false;
};

} // namespace trivar
