// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <limits>
#include <type_traits>

namespace trivar {

// The vector with the length 1; `otherwise` where its length is 0 or no finite number.
template <int N, class T>
glm::vec<N, T> unit_or(const glm::vec<N, T>& v,
                       const std::type_identity_t<glm::vec<N, T>>& otherwise)
{
    const T length = glm::length(v);
    return length > 0 && length < std::numeric_limits<T>::infinity() ? v / length : otherwise;
}

inline glm::dvec3 unit_or_zero(const glm::dvec3& v)
{
    return unit_or(v, glm::dvec3(0));
}

} // namespace trivar
