// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/layouter.h"

#include "core/tiles/stroke_work.h"

#include <algorithm>

namespace trivar {
namespace {

double cube_of(const TileBase& base, const std::vector<Ref<TileStroke>>& strokes)
{
    double least = base.diagonal();
    for (const Ref<TileStroke>& each : strokes) least = std::min(least, each->size);
    return std::max(least, 1e-4 * base.diagonal()) + 1e-300;
}

bool differ_by_samples(const TileStroke& a, const TileStroke& b)
{
    TileStroke other = a;
    other.samples = b.samples;
    return other == b;
}

} // namespace

class Layouter::Work {
public:
    Work(const TileBase& base, double cube) : cube_(cube), work_(base, cube) {}
    double cube() const { return cube_; }
    TileLayout operator()(const std::vector<Ref<TileStroke>>& strokes, const Progress& progress,
                          const Lazy<TileCurvature>* curvature)
    {
        work_.attend(progress, curvature);
        auto first =
            static_cast<std::size_t>(std::ranges::mismatch(done_, strokes).in1 - done_.begin());
        if (first < done_.size()) {
            if (goes_on(first, strokes)) {
                done_.back() = strokes[first];
                work_.go_on(before_.back().state, *strokes[first], static_cast<int>(first));
                ++first;
            } else
                first = go_back(first);
        }
        for (std::size_t i = first; i < strokes.size(); ++i) {
            if (before_.size() == most_before) before_.erase(before_.begin());
            before_.push_back({i, work_.state()});
            done_.push_back(strokes[i]);
            work_.work_off(*strokes[i], static_cast<int>(i));
        }
        return work_.result();
    }

private:
    // Whether only the last stroke changed, and may keep the tiles that it laid.
    bool goes_on(std::size_t first, const std::vector<Ref<TileStroke>>& strokes) const
    {
        return first + 1 == done_.size() && first < strokes.size() && work_.can_go_on() &&
               !before_.empty() && before_.back().stroke == first &&
               differ_by_samples(*strokes[first], *done_[first]);
    }
    // Goes back to before a stroke, or further; gives the number of strokes that stay.
    std::size_t go_back(std::size_t stroke)
    {
        while (!before_.empty() && before_.back().stroke > stroke) before_.pop_back();
        if (before_.empty()) {
            work_.go_back_to({});
            stroke = 0;
        } else {
            work_.go_back_to(before_.back().state);
            stroke = before_.back().stroke;
            before_.pop_back();
        }
        done_.resize(stroke);
        return stroke;
    }

    // Few, because the tracks and strands of all strokes are in each.
    static constexpr std::size_t most_before = 4;
    struct Before {
        std::size_t stroke;
        StrokeWork::State state;
    };
    double cube_;
    StrokeWork work_;
    std::vector<Ref<TileStroke>> done_;
    std::vector<Before> before_; // the last strokes of these
};

TileLayout layout_of(const TileBase& base, const std::vector<Ref<TileStroke>>& strokes,
                     const Progress& progress, const Lazy<TileCurvature>* curvature)
{
    StrokeWork work(base, cube_of(base, strokes));
    work.attend(progress, curvature);
    for (std::size_t i = 0; i < strokes.size(); ++i)
        work.work_off(*strokes[i], static_cast<int>(i));
    return work.result();
}

Layouter::Layouter() = default;
Layouter::~Layouter() = default;

TileLayout Layouter::operator()(const Ref<TileBase>& base,
                                const std::vector<Ref<TileStroke>>& strokes,
                                const Progress& progress, const Lazy<TileCurvature>* curvature)
{
    std::unique_ptr<Work> work = std::move(work_); // which is lost if it is cancelled
    const double cube = cube_of(*base, strokes);
    if (base_ != base || !work || work->cube() != cube) work = std::make_unique<Work>(*base, cube);
    base_ = base;
    TileLayout out = (*work)(strokes, progress, curvature);
    work_ = std::move(work);
    return out;
}

} // namespace trivar
