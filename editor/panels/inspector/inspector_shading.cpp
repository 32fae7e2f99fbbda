// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/shade.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/panels.h"

namespace trivar {

void draw_shading(Editor& editor, const ui::Theme& theme, const std::vector<Id>& ids)
{
    if (ids.empty() || !ui::section(theme, "Shading")) return;
    std::vector<FaceShading> all;
    for (const Id id : ids)
        all.push_back(object(editor.session.document(), id).shading.value_or(FaceShading{}));
    FaceShading active = all.back();
    ValueRows rows{theme};
    FieldRows<FaceShading> fields(rows, active, "", all);
    fields(&FaceShading::way);
    ui::rows_if(theme, active.way == ShadingWay::by_angle, "Only for shading by angle.",
                [&] { fields(&FaceShading::angle_deg); });
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return Shade{ids, active}; });
}

} // namespace trivar
