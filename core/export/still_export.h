// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/certificate.h"

namespace trivar {

// The same scene with everything that lies in a volume refined to a tolerance; other choices of
// refined objects stay, but for those that certify nothing.
Document refined_to(Document document, double tolerance);

// Of which scene an export is: as the log makes it, and which log that is.
struct ExportedScene {
    Document document;
    double tolerance = 0; // that all is refined to; 0: each object's own
    double frame = 1;
    std::string log; // the scene's file; empty: it has no name
    int lines = 0;   // of it, as in Certificate
};
// What is exported, and what is claimed of it, in the model's extras too. There is a claim where
// something is to be refined, or a tolerance was asked for.
struct Export {
    Model model;
    std::optional<Certificate> certificate;
};
// `evaluated` from the document, or from refined_to() of it where there is a tolerance.
Export export_of(const Evaluation& evaluated, const ExportedScene& scene);

} // namespace trivar
