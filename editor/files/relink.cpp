// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/relink.h"

#include "core/base/rejected.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/voxels.h"
#include "core/commands/tiles/heights.h"
#include "core/commands/tiles/mask_tiles.h"
#include "core/files/sample_models.h"

#include <algorithm>
#include <filesystem>
#include <optional>

namespace trivar {
namespace fs = std::filesystem;
namespace {

// A ReadFile is a file that an object reads: its model, its volume data, or a picture.
struct ReadFile : FileUse {
    Id object = 0;
    bool operator==(const ReadFile& other) const
    {
        return object == other.object && kind == other.kind && mask == other.mask;
    }
};

std::vector<ReadFile> uses_of(const Session& session, Id id)
{
    std::vector<ReadFile> out;
    const auto found = session.committed().objects.find(id);
    if (found == session.committed().objects.end()) return out;
    for (FileUse& each : files_named(*found->second))
        if (each.kind != FileKind::font) out.push_back({std::move(each), id});
    return out;
}

bool is_missing(const Session& session, const ReadFile& use)
{
    const std::string path = session.assets()->resolve(use.path);
    std::error_code ignored;
    return !fs::exists(path, ignored) && !can_be_made(path);
}

std::vector<ReadFile> missing_uses(const Session& session)
{
    std::vector<ReadFile> out;
    for (const auto& [id, object] : session.committed().objects)
        for (ReadFile& use : uses_of(session, id))
            if (is_missing(session, use)) out.push_back(std::move(use));
    return out;
}

// Returns the file of an object that another one replaces; nothing: it has none.
std::optional<ReadFile> replaced_use(const Session& session, Id object)
{
    const std::vector<ReadFile> uses = uses_of(session, object);
    if (uses.empty()) return {};
    const auto missing =
        std::ranges::find_if(uses, [&](const ReadFile& use) { return is_missing(session, use); });
    return missing != uses.end() ? *missing : uses.front();
}

Command with_file(const Session& session, const ReadFile& use, const std::string& path)
{
    const Object& object = trivar::object(session.committed(), use.object);
    if (use.kind == FileKind::volume) {
        SetVoxels set{use.object, std::get<VoxelShape>(object.source)};
        set.shape.path = path;
        return set;
    }
    if (use.kind == FileKind::model) {
        EditImport edit{use.object, std::get<ImportedFile>(object.source)};
        edit.file.path = path;
        return edit;
    }
    if (use.mask == 0) {
        SetHeights set{use.object, std::get<HeightShape>(object.source)};
        set.shape.image = path;
        return set;
    }
    MaskTiles mask{use.object, use.mask,
                   object.tiles->masks[static_cast<std::size_t>(use.mask) - 1]};
    mask.mask.image = path;
    return mask;
}

// Hashes are read from the files, which may be large. What cannot be read is left as it is.
void run_prepared(Session& session, std::vector<Command> edits, const std::string& first_path)
{
    if (edits.empty()) return;
    const std::string first = fs::path(first_path).filename().string();
    session.jobs().start(
        {"Reading " + first,
         [&session, edits = std::move(edits),
          store = session.assets()](const Progress& progress) -> Jobs::Finish {
             std::vector<Command> commands;
             std::vector<std::string> refused;
             for (const Command& edit : edits) try {
                     commands.push_back(prepare(edit, *store, progress));
                 } catch (const Rejected& why) {
                     refused.emplace_back(why.what());
                 }
             return
                 [&session, store, commands = std::move(commands), refused = std::move(refused)] {
                     if (session.assets() != store) return; // another scene, or another folder
                     for (const std::string& why : refused)
                         session.notices.say(ui::NoticeKind::error, "A file cannot be used", why);
                     session.cancel();
                     for (const Command& command : commands)
                         if (!session.run(command)) return;
                 };
         },
         [&session, first](const std::string& why) {
             session.notices.say(ui::NoticeKind::error, first + " cannot be used", why);
         }});
}

} // namespace

std::vector<Id> missing_files(const Session& session)
{
    std::vector<Id> missing;
    for (const ReadFile& use : missing_uses(session))
        if (missing.empty() || missing.back() != use.object) missing.push_back(use.object);
    return missing;
}

std::string file_to_relink(const Session& session, Id object)
{
    const std::optional<ReadFile> use = replaced_use(session, object);
    return use ? session.assets()->resolve(use->path) : std::string();
}

FileKind kind_to_relink(const Session& session, Id object)
{
    const std::optional<ReadFile> use = replaced_use(session, object);
    return use ? use->kind : FileKind::model;
}

void relink(Session& session, Id object, const std::string& path)
{
    const std::optional<ReadFile> use = replaced_use(session, object);
    if (!use) return;
    const fs::path chosen = fs::absolute(path);
    std::vector<Command> edits{with_file(session, *use, chosen.string())};
    std::error_code ignored;
    for (const ReadFile& other : missing_uses(session)) {
        if (other == *use) continue;
        // The same file under another object, or a neighbour of the chosen one.
        const fs::path there = other.path == use->path
                                   ? chosen
                                   : chosen.parent_path() / fs::path(other.path).filename();
        if (fs::exists(there, ignored)) edits.push_back(with_file(session, other, there.string()));
    }
    run_prepared(session, std::move(edits), path);
}

bool reads_files(const Session& session, const std::vector<Id>& objects)
{
    return std::ranges::any_of(objects, [&](Id id) { return !uses_of(session, id).empty(); });
}

void read_anew(Session& session, const std::vector<Id>& objects)
{
    std::vector<Command> edits;
    std::string first;
    for (const Id id : objects)
        for (const ReadFile& use : uses_of(session, id)) {
            session.assets()->forget(use.path);
            if (edits.empty()) first = use.path;
            edits.push_back(with_file(session, use, use.path));
        }
    run_prepared(session, std::move(edits), first);
}

} // namespace trivar
