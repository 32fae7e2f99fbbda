// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/history.h"

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

void History::propose(Command command)
{
    Document result = after(committed(), command);
    proposal_ = Step{std::move(command), std::move(result)};
}

bool History::commit()
{
    if (!proposal_) return false;
    forget_undone();
    steps_.push_back(std::move(*proposal_));
    proposal_.reset();
    ++position_;
    return true;
}

void History::forget_undone()
{
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(position_), steps_.end());
}

void History::run(Command command, std::string note)
{
    propose(std::move(command));
    proposal_->note = std::move(note);
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
