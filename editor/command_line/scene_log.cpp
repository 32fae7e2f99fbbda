// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/command_line/scene_log.h"

#include "core/base/ordinary_file.h"
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/document/named_files.h"
#include "editor/command_line/drawing.h"

#include <filesystem>
#include <fmt/format.h>
#include <set>

namespace trivar {

std::map<std::string, std::string> relinked_files(const std::vector<std::string>& settings)
{
    std::map<std::string, std::string> files;
    for (const std::string& setting : settings) {
        const std::size_t equals = setting.find('=');
        if (equals == 0 || equals == std::string::npos || equals + 1 == setting.size())
            throw WrongUsage("--set " + setting + ": must be NAME=FILE");
        files[setting.substr(0, equals)] = setting.substr(equals + 1);
    }
    return files;
}

Ref<AssetStore> asset_store(const SceneLog& scene)
{
    return std::make_shared<const AssetStore>(
        std::filesystem::absolute(scene.path).lexically_normal().parent_path().string(),
        relinked_files(scene.relinked));
}

void check_relinked(const SceneLog& scene, const Document& document)
{
    std::set<std::string> named;
    for (const auto& [id, object] : document.objects)
        for (const FileUse& file : files_named(*object))
            for (std::string& name : AssetStore::names_of(file.path)) named.insert(std::move(name));
    std::error_code ignored;
    for (const auto& [name, file] : relinked_files(scene.relinked)) {
        if (!named.contains(name))
            throw Rejected(
                fmt::format("--set {}={}: the scene names no file {}", name, file, name));
        if (!std::filesystem::exists(file, ignored))
            throw Rejected(fmt::format("--set {}={}: there is no file {}", name, file, file));
        const OrdinaryFile can_be_read(file);
    }
}

SourceFiles kept_sources(const SceneLog& scene, const Document& document, const AssetStore& assets)
{
    if (scene.overwrite) return {};
    return source_files(document, assets, scene.path, "or use --overwrite");
}

void check_whole(const SceneLog& scene, const Evaluation& evaluated, const Document& document)
{
    if (!scene.keep_going) check_whole(lacks(evaluated, document));
}

void say_not_whole(const SceneLog& scene, const Streams& streams)
{
    streams.talk << fmt::format("trivar: {}: it is not whole, for the reasons above, so nothing is "
                                "written; --keep-going writes what there is\n",
                                scene.path);
}

void check_written(const std::vector<std::string>& paths)
{
    for (const std::string& path : paths)
        if (!path.empty()) check_replaceable(path);
}

std::string log_text(const SceneLog& scene)
{
    return read_text_file(scene.path);
}

Log scene_log(const std::string& text, const std::string& path, const Streams& streams)
{
    Log log = read_log(text, path);
    if (!log.notice.empty()) streams.talk << "trivar: " << log.notice << "\n";
    return log;
}

Progress shown_progress(const Streams& streams)
{
    if (!streams.terminal) return {};
    return [&talk = streams.talk](double fraction, std::string_view stage) {
        talk << fmt::format("\r\x1b[K{:3.0f} % {}", 100 * fraction, stage) << std::flush;
    };
}

Progress stoppable(const Streams& streams, const Interrupts& interrupts)
{
    return [shown = shown_progress(streams), &interrupts](double fraction, std::string_view stage) {
        if (interrupts.came()) throw Cancelled();
        report(shown, fraction, stage);
    };
}

void clear_progress(const Streams& streams)
{
    if (streams.terminal) streams.talk << "\r\x1b[K";
}

} // namespace trivar
