// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/split/shown_cut.h"

#include "core/split/cut_sheet.h"

#include <algorithm>

namespace trivar {

ShownCut shown_cut(const Cutting& cutting, std::size_t number, const EvaluatedObject& object)
{
    const std::vector<PlainCut>& cuts = cutting.cuts;
    const PlainCut& cut = cuts[number];
    Box whole;
    for (const Part& part : object.whole())
        for (const glm::dvec3& corner : bounds_in_world(part).corners()) whole.add(corner);
    const auto to_world = [&](const glm::dvec3& p) {
        return glm::dvec3(object.own_to_world * glm::dvec4(p, 1));
    };
    const glm::dvec3 uvw = CutSheet(cut, glm::inverse(object.own_to_world)).uvw(whole.center());
    const glm::dvec3 drawn = CutSheet(cut, glm::dmat4(1)).point({uvw.y, uvw.z});
    // The same point before any gap, and the sides on which it is
    glm::dvec3 p = drawn;
    std::array<unsigned, 2> sides{0, 0};
    unsigned made = 0; // those of the same step, and of the one before
    for (std::size_t i = 0; i < cuts.size(); ++i)
        if (cuts[i].parted <= cut.parted && cuts[i].cuts()) made |= 1u << i;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        if ((made >> i & 1u) == 0) continue;
        const CutSheet sheet(cuts[i], glm::dmat4(1));
        for (unsigned half = 0; half < 2; ++half) {
            const glm::dvec3 off = drawn_off(cuts[i], sides[half], made);
            const bool above = i == number ? half == 1 : sheet.height(sheet.uvw(p + off)) >= 0;
            sides[half] |= (above ? 1u : 0u) << i;
        }
        if (i < number && i < cut.opened.size())
            p -= (sides[0] >> i & 1u) != 0 ? cut.opened[i] : -cut.opened[i];
    }
    ShownCut out{{p, p}};
    for (std::size_t half = 0; half < 2; ++half) {
        out.faces[half] =
            to_world(out.faces[half] + off_by_sides(object.cuts_open, sides[half], made));
    }
    out.middle = cut.keep == CutKeep::above   ? out.faces[1]
                 : cut.keep == CutKeep::below ? out.faces[0]
                                              : (out.faces[0] + out.faces[1]) / 2.0;
    out.beside = out.middle - to_world(drawn);
    return out;
}

} // namespace trivar
