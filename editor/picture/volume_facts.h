// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"
#include "core/ffd/overlap.h"
#include "editor/picture/volume_surface.h"
#include "ui/palette.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace trivar {

// How many control points of an axis are left where they are made a quarter fewer.
int fewer_points(const Knots& axis);

// Of the volume of a placed object, with what may fold in it.
Lazy<CellVerdicts> verdicts_of(const EvaluatedObject& placed);

// The cells where a volume is proven to fold, where that is not known, and where it may. Nothing
// for what is proven good.
std::vector<gpu::Translucent> fold_veils(const EvaluatedObject& placed, const ui::Palette& color);

// What is known of the volume that is looked at. What takes longer than a frame is worked out on a
// thread of its own. Frame thread only.
class VolumeFacts {
public:
    VolumeFacts();
    ~VolumeFacts(); // stops the work
    VolumeFacts(const VolumeFacts&) = delete;
    VolumeFacts& operator=(const VolumeFacts&) = delete;

    // As fold_veils; those of the volume before as long as they are not known.
    const std::vector<gpu::Translucent>& folds(const EvaluatedObject& placed,
                                               const ui::Palette& color);
    // How far anything moves at most where an axis is left fewer_points(); none: it cannot be.
    using Deviations = std::array<std::optional<double>, 3>;
    // Null: not known yet. Overlap is looked for only once it was asked for.
    const CellVerdicts* verdicts(const EvaluatedObject& placed);
    const Deviations* deviations(const EvaluatedObject& placed);
    const Overlap* overlap(const EvaluatedObject& placed);
    // Where far parts meet, as far as that was asked for and is known: a slice at both places.
    std::vector<gpu::Translucent> meeting(const EvaluatedObject& placed,
                                          const ui::Palette& color) const;

    bool busy() const;
    int known() const; // counts up with what there is to show

private:
    struct Facts {
        Ref<Placement> placement;
        Lazy<CellVerdicts> verdicts;
        Lazy<FoldSurfaces> surfaces;
        Lazy<Deviations> deviations;
        Lazy<Overlap> overlap;
        bool overlap_wanted = false;
    };
    void look_at(const EvaluatedObject& placed);
    void hand_over(); // to the thread
    void work(const std::stop_token& stop);

    Facts facts_;
    std::shared_ptr<std::atomic<bool>> given_up_; // once another volume is looked at
    Ref<Placement> drawn_of_;                     // the veils
    std::array<ui::Color, 2> drawn_in_{};
    std::vector<gpu::Translucent> veils_;

    mutable std::mutex mutex_;
    std::condition_variable_any something_new_;
    std::optional<Facts> waiting_;
    bool working_ = false;
    std::jthread thread_; // last: it stops before the rest goes
};

} // namespace trivar
