// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patches/tile_kernel.h"

namespace trivar {
namespace {

template <std::size_t N, class T>
std::array<std::vector<float>, N> by_component(const std::vector<T>& values)
{
    std::array<std::vector<float>, N> out;
    if (values.empty()) return out;
    for (std::size_t k = 0; k < N; ++k) {
        out[k].reserve(values.size() + TileVertices::slack);
        for (const T& value : values) out[k].push_back(value[static_cast<int>(k)]);
        out[k].resize(values.size() + TileVertices::slack, out[k].back());
    }
    return out;
}

} // namespace

TileVertices::TileVertices(const Mesh& unit)
    : position(by_component<3>(unit.positions)),
      normal(by_component<3>(unit.normals)),
      tangent(by_component<4>(unit.tangents)),
      count(unit.vertex_count())
{
}

} // namespace trivar
