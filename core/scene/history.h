// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

// The way from a first document to the present one. `propose` replaces the pending proposal and
// always works on the last committed document, so a drag is many proposals and one commit. There
// is no inverse code: undo returns to a document that is still held, at no cost.
class History {
public:
    struct Step {
        Command command;
        Document result;
        std::string note = {}; // of the author, to whom reads the scene; may be empty
    };
    // Steps that were undone when another was made instead, after `from` steps in force.
    struct Branch {
        std::size_t from = 0;
        std::vector<Step> steps;
        std::vector<Branch> others; // that had left these steps before
    };
    explicit History(Document start = {});

    const Document& document() const;  // the proposal's if there is one, else committed()
    const Document& committed() const; // after position() steps
    const std::optional<Step>& proposal() const { return proposal_; }

    // Rejected: the pending proposal stays as it was.
    void propose(Command command, std::string note = {});
    // False: nothing was proposed. The undone steps become a branch; a command that begins a branch
    // brings back its steps, the others of them undone.
    bool commit();
    void cancel() { proposal_.reset(); }
    void run(Command command, std::string note = {}); // propose and commit
    bool undo(); // false: nothing to undo. Both cancel a pending proposal
    bool redo();
    void forget_undone(); // nothing to redo any more, and no branches

    const Document& start() const { return start_; }
    const std::vector<Step>& steps() const { return steps_; } // undone ones at the end
    std::size_t position() const { return position_; }        // how many of them are in force
    const std::vector<Branch>& branches() const { return branches_; } // that leave these steps

private:
    void set_aside_undone();
    Document start_;
    std::vector<Step> steps_;
    std::size_t position_ = 0;
    std::vector<Branch> branches_; // the oldest first
    std::optional<Step> proposal_;
};

} // namespace trivar
