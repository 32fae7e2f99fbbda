// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/command.h"

namespace trivar {

// See the design: propose replaces the pending proposal and always works on the last committed
// document; a drag is many proposals and one commit. There is no inverse code: undo returns to a
// document that is still held.
//
//   class History {
//       explicit History(Document start = {});
//       const Document& document() const;     // the proposal's if there is one
//       const Document& committed() const;
//       void propose(Command), commit(), cancel(); bool undo(), redo();
//       const std::vector<Step>& steps() const; std::size_t position() const;
//   };

} // namespace trivar
