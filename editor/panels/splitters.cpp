// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/panels.h"

#include "ui/splitter.h"

#include <algorithm>

namespace trivar {

void drag_splitters(Editor& editor, ui::Frame& frame, const Layout& layout)
{
    if (editor.only_view || editor.files.asking()) return;
    const ui::Theme& theme = frame.theme;
    const Preferences usual;
    Preferences& p = editor.preferences;
    const float line = theme.size.hairline;
    // Hidden, the dock is dragged back in from the window's edge.
    const float x = layout.dock ? layout.outliner.lo.x - line : frame.size_px.x - line;
    const ui::Splitter dock = ui::splitter(frame, "dock splitter",
                                           {{x, layout.strip.lo.y}, {x + line, layout.strip.hi.y}});
    if (dock.restored) {
        p.dock = usual.dock;
        p.show_dock = true;
    } else if (dock.dragged) {
        const double wanted = (frame.size_px.x - dock.at) / theme.scale;
        p.show_dock = wanted > narrowest_dock / 2;
        if (p.show_dock) p.dock = std::clamp<double>(wanted, narrowest_dock, widest_dock);
    }
    const float top = layout.timeline.lo.y - line;
    const ui::Splitter timeline = ui::splitter(
        frame, "timeline splitter", {{layout.view.lo.x, top}, {layout.view.hi.x, top + line}});
    if (timeline.restored) {
        p.timeline = usual.timeline;
        p.timeline_open = true;
    } else if (timeline.dragged) {
        const double wanted = (layout.timeline.hi.y - timeline.at) / theme.scale;
        p.timeline_open = wanted > lowest_timeline / 2;
        if (p.timeline_open) { // no more than the window has room for
            p.timeline = std::max<double>(wanted, lowest_timeline);
            const Layout got = layout_of(theme, frame.size_px, p, editor.tools.size());
            p.timeline = std::clamp<double>(got.timeline.height() / theme.scale, lowest_timeline,
                                            p.timeline);
        }
    }
    if (!layout.dock) return;
    const float y = layout.outliner.hi.y;
    const ui::Splitter outliner = ui::splitter(
        frame, "outliner splitter", {{layout.outliner.lo.x, y}, {layout.outliner.hi.x, y + line}});
    if (outliner.restored) p.outliner = usual.outliner;
    if (outliner.dragged)
        p.outliner = std::clamp<double>((outliner.at - layout.outliner.lo.y) / theme.scale,
                                        lowest_outliner, 4000);
}

} // namespace trivar
