// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace trivar {

// Reads accessors of a glTF file whose numbers nobody has checked: every offset, stride, count and
// index is held against the bytes that are there. Throws Rejected, naming file and accessor.
class GltfAccessors {
public:
    GltfAccessors(const tinygltf::Model& gltf, std::string name);

    // count x components numbers, normalised integers as fractions, sparse values in place.
    struct Table {
        std::size_t count, components;
        std::vector<float> values;
    };
    Table floats(int accessor);
    // Vertex indices, each below `limit`.
    std::vector<std::uint32_t> indices(int accessor, std::size_t limit);

    // The bytes of a buffer view.
    struct Bytes {
        const unsigned char* data;
        std::size_t size;
    };
    Bytes view(int buffer_view) const;

private:
    struct Layout {
        int buffer_view;
        std::size_t byte_offset, count, components;
        int component_type;
    };
    void each(const Layout& layout, int accessor,
              const std::function<void(std::size_t i, std::size_t c, double value)>& use) const;
    Layout checked_layout(int accessor);
    [[noreturn]] void fail(int accessor, const std::string& what) const;

    const tinygltf::Model& gltf_;
    std::string name_;
    // Many primitives may read one accessor; what they read together stays in proportion to the
    // file, so that a small one cannot fill the memory.
    std::size_t values_left_;
};

} // namespace trivar
