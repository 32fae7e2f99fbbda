// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"

#include <memory>

namespace trivar {

struct GlbAccessors;

// GlbMaterials writes the materials of a model with their textures and pictures into a GLB file.
class GlbMaterials {
public:
    GlbMaterials(const std::vector<Material>& materials, GlbAccessors& to); // both must outlive it
    ~GlbMaterials();

    void add_all();
    // The number in the file of a material on vertices with that many sets of texture coordinates:
    // textures that need others are left out there, as glTF allows none.
    std::size_t on(std::size_t number, std::size_t uv_sets);
    // Whether KHR_materials_emissive_strength is used.
    bool emissive_strength() const;

private:
    class Written;
    std::unique_ptr<Written> written_;
};

} // namespace trivar
