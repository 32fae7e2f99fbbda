// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/words/step_title.h"
#include "core/document/fields/track_fields.h"

namespace trivar {

struct ObjectTracks {
    Id object = 0;
    std::vector<Track> tracks;
    bool operator==(const ObjectTracks&) const = default;
};
template <> struct FieldsOf<ObjectTracks> {
    static constexpr std::string_view told_as = "[object's tracks](#objects-tracks)",
                                      about = "What of one object goes from key to key.";
    static void fields(auto& t, auto&& field)
    {
        field("object", t.object, "id; 0: the scene, with its picture and bookmarks",
              any_value.names_object());
        field("tracks", t.tracks, "one per parameter, replacing its earlier track", required);
    }
};
struct Animate {
    static constexpr std::string_view
        verb = "animate",
        summary = "Animate parameters of objects or of the scene with keys.";
    std::vector<ObjectTracks> of;
    bool operator==(const Animate&) const = default;
    static void fields(auto& c, auto&& field)
    {
        field("of", c.of, "tracks of objects, each object once", required);
    }
};
Document applied(Document document, const Animate& command);
StepTitle title(const Animate& c, const StepDocuments& step);

} // namespace trivar
