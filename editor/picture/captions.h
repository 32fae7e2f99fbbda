// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"
#include "core/mesh/deep_image.h"
#include "ui/paint.h"

#include <span>

namespace trivar {

// A Caption is the text under an object of a picture, with points of the object, in the world, that
// tell its place.
struct Caption {
    std::string title, words;
    std::vector<glm::dvec3> points;
};

// The captions of all refined objects that are not hidden here: the number of triangles, how they
// were split, and the certified error, rounded up. Some hundred points each, deformed when asked
// for.
std::vector<Caption> captions_of(const Evaluation& evaluated, const Document& document,
                                 std::span<const Id> hidden_here = {});

// A CaptionPlace is the place of a label in the picture: under the middle of its object, inside of
// the view, and below other labels where they would overlap. There is none for an object behind the
// eye.
struct CaptionPlace {
    const Caption* caption = nullptr;
    ui::Rect rect;
};
std::vector<CaptionPlace> caption_places(const std::vector<Caption>& captions, const ui::Rect& view,
                                         const Camera& camera, const ui::Theme& theme);
void paint_captions(const std::vector<Caption>& captions, const ui::Rect& view,
                    const Camera& camera, const ui::Theme& theme);

// Draws the captions over a finished picture of that camera, in the current OpenGL context; their
// size follows the picture's. Returns the picture unchanged where there are none. Throws Rejected
// where fonts are missing.
Image with_captions(Image image, const std::vector<Caption>& captions, const Camera& camera,
                    const RenderSettings& settings);
DeepImage with_captions(DeepImage image, const std::vector<Caption>& captions, const Camera& camera,
                        const RenderSettings& settings);

} // namespace trivar
