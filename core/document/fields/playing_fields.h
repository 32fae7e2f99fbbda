// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/field.h"

namespace trivar {

template <> struct FieldsOf<Playing> {
    static void fields(auto& p, auto&& field)
    {
        field("clip", p.clip, "name of a clip in its file; empty: it stands as it came");
        field("speed", p.speed, "of the clip's own speed; negative: backwards", between(-1e3, 1e3));
        field("repeat", p.repeat,
              "what comes after the clip's end: nothing, the clip again, or the way back");
        field("offset", p.offset, "seconds into the clip at the start frame", between(-1e6, 1e6));
        field("start_frame", p.start_frame, "the frame from which on it moves",
              between(-999999, 999999));
        field(
            "foot_lock", p.foot_lock,
            "in step with its travel: it goes on as far as keeps its planted feet where they are, "
            "whatever its speed says",
            later);
    }
};

} // namespace trivar
