// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/log_use.h"

#include "core/base/finite.h"
#include "core/base/text.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "core/scene/log.h"
#include "core/scene/scene_file.h"
#include "tests/fuzz/cheap_scene.h"
#include "tests/fuzz/model_use.h"
#include "tests/fuzz/promises.h"

#include <algorithm>
#include <filesystem>

namespace trivar::testing {
namespace {

void check_same(const Document& a, const Document& b, const std::string& what)
{
    if (digest(a) != digest(b)) throw Broken(what + " gives another document");
}

void check_log_written(const History& history)
{
    promised("a log that was written is refused", [&] {
        const std::string text = log_text(history);
        const History again = replay(read_log(text, "again"));
        check_same(again.document(), history.committed(), "a log that was written");
        if (log_text(again) != text) throw Broken("a log is written otherwise the second time");
        const History compact = replay(read_log(compact_log_text(history), "compact"));
        check_same(compact.document(), history.committed(), "a compact log");
    });
}

void check_way_back(History history)
{
    const Document now = history.committed();
    const std::size_t steps = history.position();
    while (history.undo()) {
    }
    for (std::size_t i = 0; i < steps; ++i) history.redo();
    check_same(history.committed(), now, "undoing and redoing all");
}

void check_opened(const History& history, const std::string& path)
{
    promised("a log that was read cannot be opened", [&] {
        const SceneFile opened(path);
        check_same(opened.document(), history.document(), "opening it");
        check_sentences(opened.notices());
    });
}

void check_shown(const Document& document, const std::string& path)
{
    const std::string folder = std::filesystem::path(path).parent_path().string();
    Evaluator evaluator(std::make_shared<const AssetStore>(folder));
    for (const double frame : {1.0 * document.time.first_frame, 1.0 * document.time.last_frame}) {
        Evaluation shown = evaluator(document, frame);
        deform_parts(shown, true);
        for (const auto& [id, object] : shown.objects) {
            check_sentences(object->notices);
            for (const Part& part : object->parts)
                if (!std::ranges::all_of(part.mesh()->positions, finite<glm::vec3>))
                    throw Broken("what is shown has positions that are not finite");
        }
        const Model model = model_of(shown, document);
        if (!model.meshes.empty()) check_written(model, path);
    }
}

} // namespace

void check_history(const History& history)
{
    check_log_written(history);
    check_way_back(history);
}

void use_log(const std::string& path)
{
    const std::string name = std::filesystem::path(path).filename().string();
    const Log log = read_log(read_text_file(path), name);
    if (!log.notice.empty()) check_sentences({log.notice});
    const History history = replay(log);
    check_history(history);
    if (is_cheap(history.document())) check_shown(history.document(), path);
    check_opened(history, path);
}

} // namespace trivar::testing
