// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/frames_export.h"

#include "core/base/rejected.h"
#include "core/export/animated_files.h"
#include "core/scene/files_read.h"
#include "editor/files/export_wish.h"
#include "editor/words/file_words.h"

#include <fmt/format.h>

namespace trivar {

void FramesExport::begin(ExportWish wish)
{
    const std::string path = wish.path, name = file_name(path);
    jobs_.start(
        {"Writing " + name,
         [this, path, name, wish = std::move(wish)](const Progress& progress) -> Jobs::Finish {
             try {
                 const AnimatedFile made = write_animated(
                     wish.scene, wish.assets, path, progress,
                     source_files(wish.scene.document, *wish.assets, wish.scene.log));
                 return [this, path, made, named = !wish.scene.log.empty()] {
                     tell(path, made, named);
                 };
             } catch (const Cancelled&) {
                 return [this, name] {
                     notices_.say(ui::NoticeKind::good, "The export was stopped",
                                  name + " was not written.");
                 };
             }
         },
         [this, path, name](const std::string& why) {
             notices_.say(ui::NoticeKind::error, name + " was not written", reason(why, path));
         }});
}

void FramesExport::tell(const std::string& path, const AnimatedFile& made, bool named)
{
    const std::string name = file_name(path);
    const std::string title =
        fmt::format("Exported {} frame{} to {}", made.frames, made.frames == 1 ? "" : "s", name);
    std::vector<std::string> lines;
    for (const std::string& sentence : made.lacks) lines.push_back("Left out: " + sentence);
    if (!made.left_out.empty()) lines.push_back(made.left_out + ".");
    const auto well = lines.empty() ? ui::NoticeKind::good : ui::NoticeKind::warning;
    for (const std::string& sentence : made.tiles) lines.push_back(sentence + ".");
    if (!made.certificate) {
        if (const std::size_t others = made.files.size() - 1; others > 0)
            lines.push_back(fmt::format("{} and {} more.", file_name(made.files.front()), others));
        return notices_.say_all(well, title, lines);
    }
    for (std::string& sentence : summary(*made.certificate)) lines.push_back(std::move(sentence));
    const std::vector<std::string> open = not_certified(*made.certificate);
    if (open.empty()) {
        if (!named)
            lines.emplace_back("save the scene next to the file, so that trivar verify finds it");
        return notices_.say_all(well, title, lines);
    }
    std::vector<ui::Notices::Action> more;
    if (open.size() > 1)
        more.push_back({fmt::format("Read all {}...", open.size()), [this, name, open] {
                            reading = OpenPoints{name, open};
                        }});
    lines.insert(lines.begin(), open.front());
    notices_.say_all(ui::NoticeKind::warning, title + ", not all of it certified", lines, {}, more);
}

} // namespace trivar
