// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/drawing/drawing_file.h"
#include "core/files/file_bytes.h"
#include "core/scene_lines/line_sheet.h"
#include "editor/files/files.h"
#include "editor/session/session_facts.h"
#include "editor/words/file_words.h"

#include <fmt/format.h>

namespace trivar {

void Files::write_lines_to(const std::string& path)
{
    session_->jobs().start(
        {"Drawing " + file_name(path),
         [this, path, document = session_->document(), evaluated = session_->evaluated(),
          camera = camera_for_pictures(*session_)](const Progress& progress) -> Jobs::Finish {
             report(progress, 0.1, "finding lines");
             const auto [sheet, edited, notices] = line_sheet(
                 evaluated, document, camera, edits_to_keep(path), part_of(progress, 0.1, 0.9));
             if (sheet.layers.empty())
                 throw Rejected("no line is seen; give an object lines, or add volume data");
             write_bytes(path, drawing_bytes(sheet, drawing_format(path)));
             std::size_t lines = 0;
             for (const DrawingLayer& layer : sheet.layers) lines += layer.lines.size();
             std::string words = fmt::format("{} lines in {} layer{}.", lines, sheet.layers.size(),
                                             sheet.layers.size() == 1 ? "" : "s");
             if (edited.done + edited.lost + edited.added > 0)
                 words += ' ' + words_of(edited) + '.';
             for (const std::string& notice : notices) words += ' ' + notice + '.';
             return [this, path, words] {
                 session_->notices.say(ui::NoticeKind::good, "Drew " + file_name(path), words);
             };
         },
         [this, path](const std::string& why) {
             session_->notices.say(ui::NoticeKind::error, file_name(path) + " was not written",
                                   reason(why, path), {},
                                   {{"Try again...", [this, path] { ask_export(path); }}});
         }});
}

} // namespace trivar
