// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/gltf/gltf_file.h"

#include <cstdint>

namespace trivar {

// GltfAccessors reads accessors of a glTF file whose numbers nobody has checked: every offset,
// stride, count and index is compared with the bytes that exist. An accessor is named by an entry
// and the entry's name for it, such as an attribute; messages contain both. Throws Rejected.
class GltfAccessors {
public:
    explicit GltfAccessors(GltfFile& file) : file_(file) {}
    GltfFile& file() const { return file_; }

    // A Table is count x components numbers, normalised integers as fractions, with sparse values
    // in place, and 0 where the file gives none. A number that is not finite becomes 0 and is
    // counted.
    struct Table {
        std::size_t count = 0, components = 0;
        std::vector<float> values = {};
        std::size_t not_finite = 0;
    };
    Table floats(const GltfEntry& owner, const char* name);
    // The number of zero elements of an accessor without a buffer; empty where it has one.
    std::optional<std::size_t> zeros(const GltfEntry& owner, const char* name) const;
    // Vertex indices, each below `limit`.
    std::vector<std::uint32_t> indices(const GltfEntry& owner, const char* name, std::size_t limit);
    bool holds_floats(const GltfEntry& owner, const char* name) const;

private:
    struct Layout {
        std::size_t count, components, component_type;
    };
    GltfEntry accessor(const GltfEntry& owner, const char* name) const;
    Layout layout(const GltfEntry& accessor) const;
    using Use = std::function<void(std::size_t i, std::size_t c, double value)>;
    void each_in_view(const GltfEntry& place, const Layout& layout, const Use& use) const;
    void each(const GltfEntry& accessor, const Layout& layout, const Use& use) const;

    GltfFile& file_;
};

} // namespace trivar
