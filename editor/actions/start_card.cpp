// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/start_card.h"

#include "editor/editor.h"

namespace trivar {

bool shows_welcome(const Editor& editor)
{
    const Session& session = editor.session;
    if (editor.start_card.asked == session.scenes()) return true;
    if (editor.preferences.at_start == "empty") return false;
    return session.document().objects.empty() && session.scene().as_opened() &&
           editor.start_card.left != session.scenes() && !session.jobs().status();
}

} // namespace trivar
