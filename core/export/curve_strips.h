// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/film.h"

namespace trivar {

// Some curves of an object through all moments of a film.
struct CurveStrip {
    Id object = 0;
    std::string name;
    std::vector<const CurvePart*> shown; // by moment; null: they are not shown then
    Ref<std::vector<Material>> materials;
    const CurvePart& first() const; // that is shown
    bool rests() const;             // is the same whenever it is shown
    bool is_rigid() const;          // no volume bends it, so that it moves as a whole
    bool always_shown() const;
};
// By object and key.
std::vector<CurveStrip> curve_strips(const Film& film, const Document& document);

// That the curves of these objects are left out, and why; empty: there are none.
std::string which_curves_are_left_out(const std::vector<std::string>& names,
                                      const std::string& why);

} // namespace trivar
