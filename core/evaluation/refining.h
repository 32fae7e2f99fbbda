// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/laying.h"

namespace trivar {

// Refines what lies in a volume, for the frame that it lies there in, and keeps the last few
// results. Stage: refine.
class RefiningLaid {
public:
    Ref<Laid> operator()(const Ref<Laid>& laid, const Refining& refining, Timings& timings,
                         const Progress& progress = {});

private:
    struct Known {
        Ref<Laid> laid;
        Refining refining;
        Ref<Laid> refined;
    };
    std::vector<Known> known_; // the latest first
};

// Parts that lie in one volume with their triangles split, in that volume. Throws Rejected as
// refine() does.
struct SplitParts {
    Ref<Refined> refined;
    std::vector<Part> parts;
};
SplitParts split(const std::vector<Part>& parts, const RefineOptions& options,
                 const Progress& progress = {});

// What is to be said of it: what is not certified, and why. Empty: all of it is.
std::string notice_of(const Refined& refined, const Refining& refining);

} // namespace trivar
