// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf_accessor.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <tiny_gltf.h>

namespace trivar {
namespace {

std::size_t bytes_of(int component_type)
{
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT: return 4;
    default: return 0;
    }
}

template <class T> double loaded(const unsigned char* at)
{
    T value;
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
}

double loaded(int component_type, const unsigned char* at)
{
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return loaded<std::int8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return loaded<std::uint8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_SHORT: return loaded<std::int16_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return loaded<std::uint16_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return loaded<std::uint32_t>(at);
    default: return loaded<float>(at);
    }
}

double normalized(int component_type, double value)
{
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return std::max(value / 127, -1.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return value / 255;
    case TINYGLTF_COMPONENT_TYPE_SHORT: return std::max(value / 32767, -1.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return value / 65535;
    default: return value;
    }
}

} // namespace

GltfAccessors::GltfAccessors(const tinygltf::Model& gltf, std::string name)
    : gltf_(gltf),
      name_(std::move(name)),
      values_left_(1 << 20)
{
    for (const tinygltf::Buffer& buffer : gltf.buffers) values_left_ += 16 * buffer.data.size();
}

void GltfAccessors::fail(int accessor, const std::string& what) const
{
    throw Rejected(fmt::format("{}: accessor {} {}", name_, accessor, what));
}

GltfAccessors::Bytes GltfAccessors::view(int index) const
{
    if (index < 0 || static_cast<std::size_t>(index) >= gltf_.bufferViews.size())
        throw Rejected(fmt::format("{}: there is no buffer view {}", name_, index));
    const tinygltf::BufferView& view = gltf_.bufferViews[static_cast<std::size_t>(index)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= gltf_.buffers.size())
        throw Rejected(fmt::format("{}: buffer view {} names buffer {}, which is not there", name_,
                                   index, view.buffer));
    const auto& data = gltf_.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
        throw Rejected(
            fmt::format("{}: buffer view {} reaches past the end of its buffer", name_, index));
    return {data.data() + view.byteOffset, view.byteLength};
}

GltfAccessors::Layout GltfAccessors::checked_layout(int index)
{
    if (index < 0 || static_cast<std::size_t>(index) >= gltf_.accessors.size())
        fail(index, "is asked for and not there");
    const tinygltf::Accessor& a = gltf_.accessors[static_cast<std::size_t>(index)];
    Layout layout{a.bufferView, a.byteOffset, a.count, 0, a.componentType};
    switch (a.type) {
    case TINYGLTF_TYPE_SCALAR: layout.components = 1; break;
    case TINYGLTF_TYPE_VEC2: layout.components = 2; break;
    case TINYGLTF_TYPE_VEC3: layout.components = 3; break;
    case TINYGLTF_TYPE_VEC4: layout.components = 4; break;
    case TINYGLTF_TYPE_MAT4: layout.components = 16; break;
    default: fail(index, "is neither a scalar, a vector nor a matrix of 4 x 4");
    }
    if (bytes_of(a.componentType) == 0) fail(index, "has no component type that is known");
    if (a.count > values_left_ / layout.components)
        fail(index, fmt::format("has {} elements, and with what was read before more than the file "
                                "accounts for",
                                a.count));
    values_left_ -= a.count * layout.components;
    return layout;
}

void GltfAccessors::each(const Layout& layout, int accessor,
                         const std::function<void(std::size_t, std::size_t, double)>& use) const
{
    if (layout.count == 0) return;
    const Bytes bytes = view(layout.buffer_view);
    const std::size_t component = bytes_of(layout.component_type);
    const std::size_t element = component * layout.components;
    std::size_t stride = gltf_.bufferViews[static_cast<std::size_t>(layout.buffer_view)].byteStride;
    if (stride == 0) stride = element;
    // Written so that no product can overflow.
    if (stride < element || layout.byte_offset > bytes.size ||
        bytes.size - layout.byte_offset < element ||
        layout.count - 1 > (bytes.size - layout.byte_offset - element) / stride)
        fail(accessor, "reaches past the end of its buffer view");
    for (std::size_t i = 0; i < layout.count; ++i) {
        const unsigned char* at = bytes.data + layout.byte_offset + i * stride;
        for (std::size_t c = 0; c < layout.components; ++c)
            use(i, c, loaded(layout.component_type, at + c * component));
    }
}

GltfAccessors::Table GltfAccessors::floats(int index)
{
    const Layout layout = checked_layout(index);
    const tinygltf::Accessor& accessor = gltf_.accessors[static_cast<std::size_t>(index)];
    Table table{layout.count, layout.components,
                std::vector<float>(layout.count * layout.components, 0.0f)};
    const auto put = [&](std::size_t i, std::size_t c, double value) {
        if (accessor.normalized) value = normalized(layout.component_type, value);
        if (!std::isfinite(value))
            fail(index, fmt::format("has no finite number at element {}", i));
        table.values[i * layout.components + c] = static_cast<float>(value);
    };
    if (layout.buffer_view >= 0)
        each(layout, index, put);
    else if (!accessor.sparse.isSparse)
        fail(index, "has no buffer view");
    if (!accessor.sparse.isSparse) return table;

    const auto& sparse = accessor.sparse;
    if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > layout.count ||
        sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0)
        fail(index, "has impossible sparse values");
    const auto count = static_cast<std::size_t>(sparse.count);
    if (bytes_of(sparse.indices.componentType) == 0) fail(index, "has impossible sparse indices");
    std::vector<std::size_t> at(count);
    each({sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count, 1,
          sparse.indices.componentType},
         index, [&](std::size_t i, std::size_t, double value) {
             if (!(value >= 0 && value < static_cast<double>(layout.count)))
                 fail(index, "has a sparse index out of range");
             at[i] = static_cast<std::size_t>(value);
         });
    each({sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count,
          layout.components, layout.component_type},
         index, [&](std::size_t i, std::size_t c, double value) { put(at[i], c, value); });
    return table;
}

std::vector<std::uint32_t> GltfAccessors::indices(int index, std::size_t limit)
{
    const Layout layout = checked_layout(index);
    if (layout.components != 1 || layout.component_type == TINYGLTF_COMPONENT_TYPE_FLOAT)
        fail(index, "gives vertex indices and holds something else");
    if (gltf_.accessors[static_cast<std::size_t>(index)].sparse.isSparse)
        fail(index, "gives vertex indices sparsely, which cannot be read");
    std::vector<std::uint32_t> result(layout.count);
    each(layout, index, [&](std::size_t i, std::size_t, double value) {
        if (!(value >= 0 && value < static_cast<double>(limit)))
            fail(index, fmt::format("asks for vertex {:.0f}, there are {}", value, limit));
        result[i] = static_cast<std::uint32_t>(value);
    });
    return result;
}

} // namespace trivar
