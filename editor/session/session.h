// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/on_failure.h"
#include "core/scene/life_sign.h"
#include "core/scene/scene_file.h"
#include "core/stages/evaluated.h"
#include "editor/jobs/job.h"
#include "editor/session/chosen_incision.h"
#include "editor/session/chosen_level.h"
#include "editor/session/level_scouts.h"
#include "editor/session/scene_view.h"
#include "editor/session/selection.h"
#include "ui/notices.h"

#include <functional>
#include <memory>
#include <string>

namespace trivar {

class BackgroundEvaluator;

// A Session is the open scene with its proposal, its latest evaluation, the selection and the point
// of view. Frame thread only.
class Session {
public:
    // Scenes without a name are kept in `unnamed_folder`; empty: in memory only.
    Session(std::function<void()> wake, std::string unnamed_folder, OnFailure on_failure = {});
    ~Session();

    const SceneFile& scene() const { return scene_; }
    // The proposal's or else the committed one, with its values at the present frame.
    const Document& document() const { return now_; }
    const Document& committed() const { return scene_.history().committed(); } // as it was said
    const Evaluation& evaluated() const { return evaluated_; } // may be a moment behind
    long evaluation() const { return evaluation_; }            // another number: other effects
    const Timings& timings() const { return timings_; } // of the last that had something to do
    // Counts up with every change of the document, proposed or committed.
    long change() const { return asked_ticket_; }
    bool up_to_date() const { return evaluated_ticket_ == asked_ticket_; }

    // The present frame, within the document's time. Not part of the document.
    int frame() const { return frame_; }
    void show_frame(int frame);

    // Gestures follow. A command that is Rejected becomes a notice, and the return value is false.
    bool propose(Command command);
    bool propose_quietly(Command command); // without the notice: more of the gesture is to come
    bool commit();
    // Commits if the evaluation of the proposal placed the object; else cancels it and says why.
    void commit_if_placed(Id object);
    void cancel();
    bool run(const Command& command); // propose and commit
    // Returns why the command was refused; empty: it ran. The note is stored beside it.
    std::string try_run(const Command& command, const std::string& note = {});
    void undo();
    void redo();
    void go_to_step(std::size_t position); // by undo and redo
    // Goes to `count` steps of that branch; the steps in force from where it begins on become one.
    void go_to_branch(std::size_t branch, std::size_t count);
    // Shows another document in the picture alone, until the next change; null: ends that.
    void preview(const Document* document);
    bool previewing() const { return previewed_.has_value(); }
    const Document& shown() const { return previewed_ ? *previewed_ : document(); }
    // Shows a step of an unchanged copy; the copy itself stays unchanged.
    void look_at_step(std::size_t position);
    bool proposing() const { return scene_.history().proposal().has_value(); }
    bool committing() const { return check_.has_value(); }
    struct RefusedCommand {    // in the present scene: shown in the log, not stored in the file
        std::size_t after = 0; // lines of the file
        std::string line, why;
    };
    const std::vector<RefusedCommand>& refused() const { return refused_; }

    // Replaces the scene; `offers` are actions for its notices. Selection and effects start anew.
    void replace_scene(SceneFile scene, std::vector<ui::Notices::Action> offers = {});
    long scenes() const { return scenes_; } // number of scenes so far
    const std::string& unnamed_folder() const { return unnamed_folder_; }
    std::function<void()> when_discarded; // a scene with work and without a name was replaced
    std::vector<ui::Notices::Action> missing_remedies; // of the notice that objects are not shown
    std::vector<Id> not_shown() const;                 // objects that show nothing, and say why
    void save_as(const std::string& path);             // may throw Rejected
    void save_compact(const std::string& path);        // may throw Rejected
    std::string make_shapes_folder() { return scene_.make_shapes_folder(); } // may throw Rejected
    Ref<AssetStore> assets() const { return assets_; }

    void poll(); // takes in what other threads finished, once a frame; throws their mistakes
    void try_to_write(double time_s); // again every few seconds while steps are not on disk
    void follow_file(double time_s);  // takes up lines that others add to it, once per second
    void be_at_work(bool in_frame);   // signs so; else only while the scene is evaluated
    Jobs& jobs() { return jobs_; }
    const Jobs& jobs() const { return jobs_; }
    Jobs& quiet_jobs() { return quiet_jobs_; } // work that nobody waits for, and without a card
    BackgroundEvaluator& evaluator() { return *evaluator_; }
    const BackgroundEvaluator& evaluator() const { return *evaluator_; }
    // The selection belongs to the person and is no part of the document and of no undo step.
    Selection selected;
    ChosenIncision incision; // of the active object
    ChosenLevel level;       // likewise
    LevelScouts level_scouts;
    std::vector<Id> hidden_here; // ascending: while the person works on others
    // selects all objects from that id up, without those in groups among them
    void select_new(Id first);
    SceneView view;
    bool deform_on_processor = true; // false: parts are left for the graphics card to deform
    bool warnings_beside = false;    // the window shows the selected object's beside the picture
    bool auto_key = false;           // every change of a number that can have keys sets a key
    ui::Notices notices;

private:
    void refresh();
    long submit(const Document& document);
    void look_at_frame();
    Command said(const Command& command) const; // as keys, where it changes what is animated
    bool is_proposed(const Command& command) const;
    void finish_check();
    void attach_proposal(const EvaluatedObject& laid);
    void tell_what_is_missing();
    void select_returned(const Document& before);
    void select_freed(const Document& before, const std::vector<Id>& were);
    void meet_document(); // the scene changed as a whole
    void take_back_deadly_steps();
    template <class Change> bool attempt(Change&& change);
    bool try_propose(const Command& command, bool quietly);
    void refuse(const Command& command, const std::string& why);

    std::function<void()> wake_;
    OnFailure on_failure_;
    std::string unnamed_folder_, told_trouble_;
    SceneFile scene_;
    std::optional<LifeSign> life_sign_;
    double next_try_s_ = 0, next_look_s_ = 0;
    std::vector<RefusedCommand> refused_;
    bool opened_ = false, drafted_ = false; // not evaluated yet; evaluated with fewer samples
    Ref<AssetStore> assets_;
    std::unique_ptr<BackgroundEvaluator> evaluator_;
    Jobs jobs_, quiet_jobs_;
    Evaluation evaluated_;
    Timings timings_;
    long scenes_ = 0, evaluation_ = 0, evaluated_ticket_ = 0, asked_ticket_ = 0;
    std::optional<long> check_; // the ticket of a proposal that is committed if it is placed
    Id checked_ = 0;            // the object that it places
    std::optional<Document> previewed_;
    int frame_ = Time{}.first_frame;
    Document now_;
    std::vector<Document> replaced_; // in this frame, whose objects panels may still look at
};

} // namespace trivar
