// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/runs.h"

#include <memory>
#include <optional>
#include <unordered_map>

namespace trivar {

// A PerRun keeps a value for each run of a sequence, as long as what else they come from stays.
// Not thread-safe.
template <class From, class Value> class PerRun {
public:
    // The value of each run: those of the last call, and where it had none what make(r) gives for
    // run r, in parallel. O(#runs) besides.
    template <class T, class Make>
    const std::vector<Value>& operator()(const From& from, const std::vector<Ref<T>>& runs,
                                         Make&& make)
    {
        std::unordered_map<const void*, std::size_t> known;
        const bool same = from_ && *from_ == from;
        if (same)
            for (std::size_t r = 0; r < runs_.size(); ++r)
                if (r >= runs.size() || runs_[r] != runs[r]) known.emplace(runs_[r].get(), r);
        std::vector<Value> values(runs.size());
        std::vector<std::size_t> missing;
        for (std::size_t r = 0; r < runs.size(); ++r)
            if (same && r < runs_.size() && runs_[r] == runs[r])
                values[r] = values_[r];
            else if (const auto found = known.find(runs[r].get()); found != known.end())
                values[r] = values_[found->second];
            else
                missing.push_back(r);
        parallel_blocks(missing.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) values[missing[k]] = make(missing[k]);
        });
        from_ = from;
        runs_.assign(runs.begin(), runs.end());
        values_ = std::move(values);
        return values_;
    }

    // The values of the last call; null: it was for something else.
    const std::vector<Value>* values(const From& from) const
    {
        return from_ && *from_ == from ? &values_ : nullptr;
    }

private:
    std::optional<From> from_;
    std::vector<std::shared_ptr<const void>> runs_;
    std::vector<Value> values_;
};

} // namespace trivar
