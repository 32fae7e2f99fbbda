// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace trivar {

// A History is the way from a first document to the present one. `propose` replaces the pending
// proposal and always works on the last committed document, so a drag is many proposals and one
// commit. There is no inverse code: undo returns to a document that is still held, at no cost.
class History {
public:
    struct Step {
        Command command;
        Document result;
        std::string note = {}; // from the author to the reader of the scene; may be empty
    };
    // A Branch is the steps that were undone when another step was made instead, after `from` steps
    // in force.
    struct Branch {
        std::size_t from = 0;
        std::vector<Step> steps;
        std::vector<Branch> others; // branches that had left these steps before
    };
    explicit History(Document start = {});

    const Document& document() const;  // the proposal's if there is one, else committed()
    const Document& committed() const; // after position() steps
    const std::optional<Step>& proposal() const { return proposal_; }

    // Proposes a command. If it is Rejected, the pending proposal stays as it was.
    void propose(Command command, std::string note = {});
    // Commits the proposal; false: there was none. The undone steps become a branch. A command that
    // begins a branch brings back the steps of that branch, all but the first of them undone.
    bool commit();
    void cancel() { proposal_.reset(); }
    void run(Command command, std::string note = {}); // propose and commit
    bool undo(); // false: there is nothing to undo. undo and redo both cancel a pending proposal
    bool redo();
    void forget_undone(); // afterwards there is nothing to redo, and there are no branches

    const Document& start() const { return start_; }
    const std::vector<Step>& steps() const { return steps_; } // undone ones at the end
    std::size_t position() const { return position_; }        // number of steps in force
    // branches that leave these steps
    const std::vector<Branch>& branches() const { return branches_; }

    // Calls step(Step) and undo() in an order that, done to a new history, gives it the same steps,
    // position and branches. Of branches from one place the oldest comes first.
    void retell(const std::function<void(const Step&)>& step,
                const std::function<void()>& undo) const;

private:
    void set_aside_undone();
    Document start_;
    std::vector<Step> steps_;
    std::size_t position_ = 0;
    std::vector<Branch> branches_; // the oldest first
    std::optional<Step> proposal_;
};

} // namespace trivar
