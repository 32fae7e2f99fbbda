// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/common_mesh.h"
#include "core/certificate/film_certificate.h"

namespace trivar {

// An AnimatedExport is a film as one model that moves by itself, with the claims for that model.
struct AnimatedExport {
    Film film;   // at the moments at which it was compared; one strip per claim
    Model model; // nodes, skins, morph targets and one clip; its extras hold the claims
    FilmCertificate certificate;
    std::vector<CommonMesh> common; // of the parts that a volume deforms; other parts have none
    std::string left_out = {}; // a sentence that names the curves that were left out; empty: none
};

} // namespace trivar
