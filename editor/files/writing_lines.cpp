// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/drawing/drawing_file.h"
#include "core/files/file_bytes.h"
#include "core/scene_lines/line_sheet.h"
#include "editor/files/files.h"
#include "editor/session/session_facts.h"
#include "editor/words/file_words.h"

#include <fmt/format.h>

#include <filesystem>

namespace trivar {
namespace {

// Reads the edits in an .svg that is about to be written anew; none if not drawn here. Throws
// Rejected for one that cannot be read, rather than lose what a person did to it.
HandEdits edits_of_earlier(const std::string& path)
{
    if (drawing_format(path) != DrawingFormat::svg || !std::filesystem::exists(path)) return {};
    try {
        return hand_edits_of(read_bytes(path, most_edited_bytes)).value_or(HandEdits{});
    } catch (const Rejected& rejected) {
        throw Rejected(fmt::format("{}; delete it first, or give another name", rejected.what()));
    }
}

} // namespace

void Files::write_lines_to(const std::string& path)
{
    session_->jobs().start(
        {"Drawing " + file_name(path),
         [this, path, document = session_->document(), evaluated = session_->evaluated(),
          camera = camera_for_pictures(*session_)](const Progress& progress) -> Jobs::Finish {
             report(progress, 0.1, "finding lines");
             const HandEdits edits = edits_of_earlier(path);
             const auto [drawn, notices] =
                 line_sheet(evaluated, document, camera, edits, part_of(progress, 0.1, 0.9));
             DrawingSheet sheet = drawn;
             const AppliedEdits edited = apply(edits, sheet);
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
