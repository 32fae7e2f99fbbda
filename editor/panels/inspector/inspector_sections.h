// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "ui/theme.h"

#include <vector>

namespace trivar {

struct Editor;

// An InspectorSection is a part of the inspector, for the objects to which it applies.
struct InspectorSection {
    bool (*applies)(const Document& document, Id id);
    void (*draw)(Editor& editor, const ui::Theme& theme, Id id);
};

// All sections from top to bottom. A step of an object that has rows of its own is a line here; the
// numbers of all others stand in the last section.
const std::vector<InspectorSection>& inspector_sections();

} // namespace trivar
