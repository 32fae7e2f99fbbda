// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/relink.h"

#include "core/base/rejected.h"

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

// Hashes are read from the files, which may be large.
void run_prepared(Session& session, std::vector<EditImport> edits)
{
    if (edits.empty()) return;
    const std::string name = fs::path(edits.front().file.path).filename().string();
    session.jobs().start({"Reading " + name,
                          [&session, edits = std::move(edits),
                           store = session.assets()](const Progress& progress) -> Jobs::Finish {
                              std::vector<Command> commands;
                              for (const EditImport& edit : edits)
                                  commands.push_back(prepare(edit, *store, progress));
                              return [&session, commands = std::move(commands)] {
                                  session.cancel();
                                  for (const Command& command : commands)
                                      if (!session.run(command)) return;
                              };
                          },
                          [&session, name](const std::string& why) {
                              session.notices.say(ui::NoticeKind::error, name + " cannot be used",
                                                  why);
                          }});
}

} // namespace

std::vector<Id> missing_files(const Session& session)
{
    std::vector<Id> missing;
    std::error_code ignored;
    for (const auto& [id, object] : session.committed().objects)
        if (const auto* file = std::get_if<ImportedFile>(&object->source))
            if (!fs::exists(session.assets()->resolve(file->path), ignored)) missing.push_back(id);
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
