// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/gltf/gltf_accessor.h"

#include "core/base/number_text.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>

namespace trivar {
namespace {

// The component types of glTF 2.0, section 3.6.2.2.
enum : std::size_t {
    signed_byte = 5120,
    unsigned_byte = 5121,
    signed_short = 5122,
    unsigned_short = 5123,
    unsigned_int = 5125,
    single_float = 5126
};

std::size_t bytes_of(std::size_t component_type)
{
    switch (component_type) {
    case signed_byte:
    case unsigned_byte: return 1;
    case signed_short:
    case unsigned_short: return 2;
    case unsigned_int:
    case single_float: return 4;
    default: return 0;
    }
}

std::size_t components_of(std::string_view type)
{
    using Type = std::pair<std::string_view, std::size_t>;
    for (const auto& [name, components] :
         {Type("SCALAR", 1), Type("VEC2", 2), Type("VEC3", 3), Type("VEC4", 4), Type("MAT4", 16)})
        if (type == name) return components;
    return 0;
}

template <class T> double loaded(const char* at)
{
    T value;
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
}

double loaded(std::size_t component_type, const char* at)
{
    switch (component_type) {
    case signed_byte: return loaded<std::int8_t>(at);
    case unsigned_byte: return loaded<std::uint8_t>(at);
    case signed_short: return loaded<std::int16_t>(at);
    case unsigned_short: return loaded<std::uint16_t>(at);
    case unsigned_int: return loaded<std::uint32_t>(at);
    default: return loaded<float>(at);
    }
}

double normalized(std::size_t component_type, double value)
{
    switch (component_type) {
    case signed_byte: return std::max(value / 127, -1.0);
    case unsigned_byte: return value / 255;
    case signed_short: return std::max(value / 32767, -1.0);
    case unsigned_short: return value / 65535;
    default: return value;
    }
}

} // namespace

GltfEntry GltfAccessors::accessor(const GltfEntry& owner, const char* name) const
{
    return file_.named(owner, name, "accessors", "accessor");
}

GltfAccessors::Layout GltfAccessors::layout(const GltfEntry& accessor) const
{
    const Layout out{accessor.needed_size("count"), components_of(accessor.needed_text("type")),
                     accessor.needed_size("componentType")};
    if (out.components == 0)
        accessor.fail(fmt::format("'type' is '{}', but must be SCALAR, VEC2, VEC3, VEC4 or MAT4",
                                  printable(accessor.text("type").substr(0, 20))));
    if (bytes_of(out.component_type) == 0)
        accessor.fail(fmt::format("'componentType' is {}, but must be 5120, 5121, 5122, 5123, 5125 "
                                  "or 5126",
                                  out.component_type));
    return out;
}

void GltfAccessors::each_in_view(const GltfEntry& place, const Layout& layout, const Use& use) const
{
    if (layout.count == 0) return;
    const std::string_view bytes = file_.view(place, "bufferView");
    const GltfEntry view = file_.named(place, "bufferView", "bufferViews", "bufferView");
    const std::size_t component = bytes_of(layout.component_type);
    const std::size_t element = component * layout.components;
    const std::size_t stride = view.size("byteStride", element), offset = place.size("byteOffset");
    if (stride < element)
        view.fail(fmt::format("'byteStride' is {}, but one element has {} bytes", stride, element));
    // This form cannot overflow.
    if (offset > bytes.size() || bytes.size() - offset < element ||
        layout.count - 1 > (bytes.size() - offset - element) / stride)
        place.fail(fmt::format("its {} elements of {} bytes reach past the end of its buffer view, "
                               "which has {} bytes",
                               with_commas(layout.count), element, with_commas(bytes.size())));
    for (std::size_t i = 0; i < layout.count; ++i) {
        const char* at = bytes.data() + offset + i * stride;
        for (std::size_t c = 0; c < layout.components; ++c)
            use(i, c, loaded(layout.component_type, at + c * component));
    }
}

void GltfAccessors::each(const GltfEntry& accessor, const Layout& layout, const Use& use) const
{
    if (accessor.index("bufferView") >= 0) each_in_view(accessor, layout, use);
    const std::optional<GltfEntry> sparse = accessor.part("sparse");
    if (!sparse) return;
    const std::size_t count = sparse->needed_size("count");
    if (count > layout.count)
        sparse->fail(fmt::format("'count' is {}, but its accessor has {} elements", count,
                                 with_commas(layout.count)));
    const GltfEntry indices = sparse->needed_part("indices"),
                    values = sparse->needed_part("values");
    const Layout of_indices{count, 1, indices.needed_size("componentType")};
    if (bytes_of(of_indices.component_type) == 0)
        indices.fail("'componentType' must be 5121, 5123 or 5125");
    std::vector<std::size_t> at(count);
    each_in_view(indices, of_indices, [&](std::size_t i, std::size_t, double value) {
        if (!(value >= 0 && value < static_cast<double>(layout.count)))
            indices.fail(fmt::format("one is {}, but its accessor has {} elements", value,
                                     with_commas(layout.count)));
        at[i] = static_cast<std::size_t>(value);
    });
    each_in_view(values, {count, layout.components, layout.component_type},
                 [&](std::size_t i, std::size_t c, double value) { use(at[i], c, value); });
}

GltfAccessors::Table GltfAccessors::floats(const GltfEntry& owner, const char* name)
{
    const GltfEntry entry = accessor(owner, name);
    const Layout from = layout(entry);
    // A table is copied into another of its size, so that its memory counts twice.
    file_.account(entry, from.count, "elements", 2 * sizeof(float) * from.components);
    Table table{from.count, from.components, std::vector<float>(from.count * from.components, 0)};
    const bool fractions = entry.flag("normalized");
    each(entry, from, [&](std::size_t i, std::size_t c, double value) {
        if (fractions) value = normalized(from.component_type, value);
        float& to = table.values[i * from.components + c];
        to = std::isfinite(value) ? static_cast<float>(value) : 0.0f;
        if (!std::isfinite(value)) ++table.not_finite;
    });
    return table;
}

std::optional<std::size_t> GltfAccessors::zeros(const GltfEntry& owner, const char* name) const
{
    const GltfEntry entry = accessor(owner, name);
    if (entry.index("bufferView") >= 0 || entry.has("sparse")) return {};
    return layout(entry).count;
}

bool GltfAccessors::holds_floats(const GltfEntry& owner, const char* name) const
{
    return layout(accessor(owner, name)).component_type == single_float;
}

std::vector<std::uint32_t> GltfAccessors::indices(const GltfEntry& owner, const char* name,
                                                  std::size_t limit)
{
    const GltfEntry entry = accessor(owner, name);
    const Layout from = layout(entry);
    if (from.components != 1 || from.component_type == single_float)
        entry.fail("it lists vertices, so it must hold single whole numbers");
    file_.account(entry, from.count, "elements", sizeof(std::uint32_t));
    std::vector<std::uint32_t> result(from.count, 0);
    if (from.count > 0 && limit == 0) entry.fail("it asks for vertices, but there are none");
    each(entry, from, [&](std::size_t i, std::size_t, double value) {
        if (!(value >= 0 && value < static_cast<double>(limit)))
            entry.fail(fmt::format("it asks for vertex {}, but the last is {}", number_text(value),
                                   with_commas(limit - 1)));
        result[i] = static_cast<std::uint32_t>(value);
    });
    return result;
}

} // namespace trivar
