// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"
#include "core/mesh/deep_image.h"
#include "ui/paint.h"

#include <span>

namespace trivar {

// What is written under an object of a picture, and points of it, world, that tell where that is.
struct Caption {
    std::string title, words;
    std::vector<glm::dvec3> points;
};

// Of all that is refined and not aside: how many triangles there are now, how they were split, and
// what of their error is certified, rounded up. Some hundred points each, deformed when asked.
std::vector<Caption> captions_of(const Evaluation& evaluated, const Document& document,
                                 std::span<const Id> hidden_here = {});

// The labels in the picture: each under the middle of what it speaks of, inside of the view, below
// the other ones where they would overlap. Nothing where that is behind the eye.
struct CaptionPlace {
    const Caption* caption = nullptr;
    ui::Rect rect;
};
std::vector<CaptionPlace> caption_places(const std::vector<Caption>& captions, const ui::Rect& view,
                                         const Camera& camera, const ui::Theme& theme);
void paint_captions(const std::vector<Caption>& captions, const ui::Rect& view,
                    const Camera& camera, const ui::Theme& theme);

// The same over a finished picture that was drawn with that camera, their size by the picture's, in
// the current OpenGL context. The picture as it is where there are none. Throws Rejected where
// fonts are missing.
Image with_captions(Image image, const std::vector<Caption>& captions, const Camera& camera,
                    const RenderSettings& settings);
DeepImage with_captions(DeepImage image, const std::vector<Caption>& captions, const Camera& camera,
                        const RenderSettings& settings);

} // namespace trivar
