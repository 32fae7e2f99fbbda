// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/film.h"

namespace trivar {

// A CurveStrip is some curves of an object through all moments of a film.
struct CurveStrip {
    Id object = 0;
    std::string name;
    std::vector<const CurvePart*> shown; // by moment; null: they are not shown
    Ref<std::vector<Material>> materials;
    const CurvePart& first() const; // the curves at the first moment that shows them
    bool rests() const;             // whether they are the same at all moments that show them
    bool is_rigid() const;          // whether no volume deforms them, so that they move as a whole
    bool always_shown() const;
};
// The curve strips, by object and key.
std::vector<CurveStrip> curve_strips(const Film& film, const Document& document);

// A sentence that says which objects' curves are left out, and why; empty: none.
std::string which_curves_are_left_out(const std::vector<std::string>& names,
                                      const std::string& why);

} // namespace trivar
