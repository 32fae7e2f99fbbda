// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/animate.h"
#include "core/commands/words/step_title.h"
#include "core/document/fields/playing_fields.h"

namespace trivar {

struct PlayClip {
    static constexpr std::string_view verb = "play_clip",
                                      summary =
                                          "Play an animation clip of imported models, or none.";
    static constexpr auto sets = &Object::playing;
    std::vector<Id> objects;
    Playing playing;
    std::vector<Playing> playings = {};
    bool operator==(const PlayClip&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("objects", c.objects, "ids of imported models", required.names_object());
        spread(c.playing, field);
        field("playings", c.playings,
              "one each, in the order of the objects, in place of these fields; empty: the same "
              "for all");
    }
};
Document applied(Document document, const PlayClip& command);
StepTitle title(const PlayClip& c, const StepDocuments& step);

} // namespace trivar
