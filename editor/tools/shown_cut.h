// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluated.h"
#include "core/split/cut_sheet.h"

namespace trivar {

// Where a cut is seen, amid the pieces that gaps have moved. World.
struct ShownCut {
    std::array<glm::dvec3, 2> faces; // a point of the cut on what is below it, and above
    glm::dvec3 middle{0};            // amid those that stay
    glm::dvec3 beside{0};            // from the cut's own place to where it is seen
};
inline ShownCut shown_cut(const Cutting& cutting, std::size_t number, const EvaluatedObject& object)
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
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        if (cuts[i].parted != cut.parted || !(glm::length(cuts[i].normal) > 1e-9)) continue;
        const CutSheet sheet(cuts[i], glm::dmat4(1));
        for (unsigned half = 0; half < 2; ++half) {
            const glm::dvec3 off = drawn_off(cuts[i], sides[half], ~0u);
            const bool above = i == number ? half == 1 : sheet.height(sheet.uvw(p + off)) >= 0;
            sides[half] |= (above ? 1u : 0u) << i;
        }
        if (i < number && i < cut.opened.size())
            p -= (sides[0] >> i & 1u) != 0 ? cut.opened[i] : -cut.opened[i];
    }
    ShownCut out{{p, p}};
    for (std::size_t half = 0; half < 2; ++half) {
        for (std::size_t i = 0; i < std::min(cuts.size(), object.cuts_open.size()); ++i)
            if (cuts[i].parted == cut.parted)
                out.faces[half] +=
                    (sides[half] >> i & 1u) != 0 ? object.cuts_open[i] : -object.cuts_open[i];
        out.faces[half] = to_world(out.faces[half]);
    }
    out.middle = cut.keep == CutKeep::above   ? out.faces[1]
                 : cut.keep == CutKeep::below ? out.faces[0]
                                              : (out.faces[0] + out.faces[1]) / 2.0;
    out.beside = out.middle - to_world(drawn);
    return out;
}

} // namespace trivar
