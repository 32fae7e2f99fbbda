// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/curves.h"

#include "core/base/rejected.h"

#include <fmt/format.h>

namespace trivar {

Curves transformed(const Curves& curves, const glm::dmat4& matrix)
{
    return {make_ref(transformed(*curves.points, matrix)), curves.begin, curves.material};
}

void validate(const Curves& curves, const std::string& name)
{
    validate(*curves.points, name);
    bool whole = curves.begin.front() == 0 && curves.begin.back() == curves.point_count() &&
                 (curves.material.empty() || curves.material.size() == curves.line_count());
    for (std::size_t l = 0; l < curves.line_count(); ++l)
        whole = whole && curves.begin[l] + 2 <= curves.begin[l + 1];
    if (!whole) throw Rejected(name + ": one of its curves has fewer than two points");
}

} // namespace trivar
