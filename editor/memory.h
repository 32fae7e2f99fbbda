// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <typeindex>

namespace trivar {

// A Memory holds what single parts of the window remember between two frames: one value per type,
// made when it is first asked for. The type stands with its part, so that nobody else depends on
// it.
class Memory {
public:
    template <class State> State& of()
    {
        std::shared_ptr<void>& state = states_[typeid(State)];
        if (!state) state = std::make_shared<State>();
        return *static_cast<State*>(state.get());
    }
    template <class State> const State& of() const
    {
        static const State unchanged{};
        const auto found = states_.find(typeid(State));
        return found == states_.end() ? unchanged : *static_cast<const State*>(found->second.get());
    }

private:
    std::map<std::type_index, std::shared_ptr<void>> states_;
};

} // namespace trivar
