// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/relink.h"

#include "core/base/rejected.h"
#include "core/files/sample_models.h"

#include <filesystem>

namespace trivar {
namespace fs = std::filesystem;
namespace {

const ImportedFile* file_of(const Session& session, Id id)
{
    const auto found = session.committed().objects.find(id);
    if (found == session.committed().objects.end()) return nullptr;
    return std::get_if<ImportedFile>(&found->second->source);
}

std::string name_of_file(const EditImport& edit)
{
    return fs::path(edit.file.path).filename().string();
}

// Hashes are read from the files, which may be large. What cannot be read is left as it is.
void run_prepared(Session& session, std::vector<EditImport> edits)
{
    if (edits.empty()) return;
    const std::string first = name_of_file(edits.front());
    session.jobs().start(
        {"Reading " + first,
         [&session, edits = std::move(edits),
          store = session.assets()](const Progress& progress) -> Jobs::Finish {
             std::vector<Command> commands;
             std::vector<std::string> refused;
             for (const EditImport& edit : edits) try {
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
    std::error_code ignored;
    for (const auto& [id, object] : session.committed().objects)
        if (const auto* file = std::get_if<ImportedFile>(&object->source))
            if (const std::string path = session.assets()->resolve(file->path);
                !fs::exists(path, ignored) && !can_be_made(path))
                missing.push_back(id);
    return missing;
}

void relink(Session& session, Id object, const std::string& path)
{
    const ImportedFile* file = file_of(session, object);
    if (!file) return;
    const fs::path chosen = fs::absolute(path);
    std::vector<EditImport> edits{{object, *file}};
    edits.front().file.path = chosen.string();
    std::error_code ignored;
    for (const Id id : missing_files(session)) {
        const ImportedFile* other = file_of(session, id);
        if (id == object) continue;
        // The same file under another object, or a neighbour of the chosen one.
        const fs::path there = other->path == file->path
                                   ? chosen
                                   : chosen.parent_path() / fs::path(other->path).filename();
        if (!fs::exists(there, ignored)) continue;
        edits.push_back({id, *other});
        edits.back().file.path = there.string();
    }
    run_prepared(session, std::move(edits));
}

void read_anew(Session& session, const std::vector<Id>& objects)
{
    std::vector<EditImport> edits;
    for (const Id id : objects)
        if (const ImportedFile* file = file_of(session, id)) {
            session.assets()->forget(file->path);
            edits.push_back({id, *file});
        }
    run_prepared(session, std::move(edits));
}

} // namespace trivar
