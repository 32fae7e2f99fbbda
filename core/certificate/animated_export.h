// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/common_mesh.h"
#include "core/certificate/film_certificate.h"

namespace trivar {

// A film as one model that moves by itself, with what is claimed of it.
struct AnimatedExport {
    Film film;   // at the moments at which it was compared; a strip for each claim
    Model model; // nodes, skins, morph targets and one clip; a claim in its extras
    FilmCertificate certificate;
    std::vector<CommonMesh> common; // of what a volume deforms; else without a mesh
    std::string left_out = {};      // which curves, as a sentence; empty: none
};

} // namespace trivar
