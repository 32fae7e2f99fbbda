// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/history.h"

#include <algorithm>
#include <iterator>

namespace trivar {

History::History(Document start) : start_(std::move(start)) {}

const Document& History::committed() const
{
    return position_ == 0 ? start_ : steps_[position_ - 1].result;
}

const Document& History::document() const
{
    return proposal_ ? proposal_->result : committed();
}

void History::propose(Command command, std::string note)
{
    Document result = after(committed(), command);
    proposal_ = Step{std::move(command), std::move(result), std::move(note)};
}

bool History::commit()
{
    if (!proposal_) return false;
    set_aside_undone();
    const auto taken_up = std::ranges::find_if(branches_, [&](const Branch& branch) {
        return branch.from == position_ && branch.steps.front().command == proposal_->command;
    });
    if (taken_up == branches_.end()) {
        steps_.push_back(std::move(*proposal_));
    } else {
        Branch branch = std::move(*taken_up);
        branches_.erase(taken_up);
        std::ranges::move(branch.steps, std::back_inserter(steps_));
        std::ranges::move(branch.others, std::back_inserter(branches_));
    }
    proposal_.reset();
    ++position_;
    return true;
}

void History::set_aside_undone()
{
    if (position_ == steps_.size()) return;
    constexpr std::size_t most = 100; // enough for trying one value after another
    const auto undone = steps_.begin() + static_cast<std::ptrdiff_t>(position_);
    Branch branch{position_, {undone, steps_.end()}, {}};
    const auto left_later =
        std::stable_partition(branches_.begin(), branches_.end(),
                              [this](const Branch& each) { return each.from <= position_; });
    branch.others.assign(left_later, branches_.end());
    branches_.erase(left_later, branches_.end());
    branches_.push_back(std::move(branch));
    if (branches_.size() > most) branches_.erase(branches_.begin());
    steps_.erase(undone, steps_.end());
}

namespace {

// Appends steps that follow `before` others, each after the undone branches that begin there.
void retell_steps(const std::vector<History::Step>& steps, std::size_t before,
                  const std::vector<History::Branch>& branches,
                  const std::function<void(const History::Step&)>& step,
                  const std::function<void()>& undo)
{
    for (std::size_t i = 0; i < steps.size(); ++i) {
        for (const History::Branch& branch : branches) {
            if (branch.from != before + i) continue;
            retell_steps(branch.steps, branch.from, branch.others, step, undo);
            for (std::size_t n = 0; n < branch.steps.size(); ++n) undo();
        }
        step(steps[i]);
    }
}

} // namespace

void History::retell(const std::function<void(const Step&)>& step,
                     const std::function<void()>& undo) const
{
    retell_steps(steps_, 0, branches_, step, undo);
    for (std::size_t i = position_; i < steps_.size(); ++i) undo();
}

void History::forget_undone()
{
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(position_), steps_.end());
    branches_.clear();
}

void History::run(Command command, std::string note)
{
    propose(std::move(command), std::move(note));
    commit();
}

bool History::undo()
{
    cancel();
    if (position_ == 0) return false;
    --position_;
    return true;
}

bool History::redo()
{
    cancel();
    if (position_ == steps_.size()) return false;
    ++position_;
    return true;
}

} // namespace trivar
