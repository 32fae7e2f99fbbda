// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/still.h"

#include "editor/picture/picture.h"

#include <limits>

namespace trivar {

void Still::begin(const Evaluation& evaluated, const Document& document, const Camera& camera,
                  const StillOptions& options)
{
    camera_ = camera;
    settings_ = document.render;
    captions_ = settings_->captions ? captions_of(evaluated, document) : std::vector<Caption>{};
    gpu::Picture picture = picture_of(evaluated, document, camera, values_, options.deform);
    gpu::set_level(picture, options.level);
    picture.deep = options.deep;
    picture.shaders = options.shaders;
    renderer_.begin(picture, options.size_px);
}

void Still::draw(const Evaluation& evaluated, const Document& document, const Camera& camera,
                 const StillOptions& options)
{
    begin(evaluated, document, camera, options);
    while (!advance(std::numeric_limits<double>::max())) continue;
}

Image Still::image() const
{
    return with_captions(renderer_.image(), captions_, camera_, *settings_);
}

DeepImage Still::deep_image() const
{
    return with_captions(renderer_.deep_image(), captions_, camera_, *settings_);
}

} // namespace trivar
