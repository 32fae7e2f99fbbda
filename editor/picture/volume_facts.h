// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"
#include "core/ffd/overlap.h"
#include "core/placement/placement.h"
#include "editor/jobs/worker.h"
#include "editor/picture/volume_surface.h"
#include "ui/palette.h"

namespace trivar {

// The number of control points that an axis keeps when a quarter of them is removed.
int fewer_points(const Knots& axis);

// Returns the verdicts on the volume of a placed object, with those parts that may fold.
Lazy<CellVerdicts> verdicts_of(const EvaluatedObject& placed);

// The cells where a volume is proven to fold, where that is unknown, and where it is allowed to.
// Empty where every cell is proven good.
std::vector<gpu::Translucent> fold_veils(const EvaluatedObject& placed, const ui::Palette& color);

// A FoldMark says what one colour of the veils over a volume means.
struct FoldMark {
    ui::Color color;
    std::string words;
};

// VolumeFacts is what is known of the volume that is looked at. What takes longer than a frame is
// computed on a thread of its own. Frame thread only.
class VolumeFacts {
public:
    VolumeFacts() = default;
    ~VolumeFacts(); // stops the work
    VolumeFacts(const VolumeFacts&) = delete;
    VolumeFacts& operator=(const VolumeFacts&) = delete;

    // Returns fold_veils(); those of the previous volume while the new ones are unknown.
    const std::vector<gpu::Translucent>& folds(const EvaluatedObject& placed,
                                               const ui::Palette& color);
    // Returns the meaning of the colours of those veils, one mark per colour that is seen.
    std::vector<FoldMark> fold_marks(const EvaluatedObject& placed, const ui::Palette& color);
    // The largest movement in a volume if an axis keeps only fewer_points(); empty: the axis
    // cannot.
    using Deviations = std::array<std::optional<double>, 3>;
    // Null: not known yet. Overlap is looked for only once it was asked for.
    const CellVerdicts* verdicts(const EvaluatedObject& placed);
    const Deviations* deviations(const EvaluatedObject& placed);
    const Overlap* overlap(const EvaluatedObject& placed);
    // The places where distant parts meet, if that was asked for and is known: a slice at each of
    // both places.
    std::vector<gpu::Translucent> meeting(const EvaluatedObject& placed,
                                          const ui::Palette& color) const;

    bool busy();       // throws what the work ended by, where that was a mistake of Trivar
    int known() const; // grows with each new fact

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

    Facts facts_;
    std::shared_ptr<std::atomic<bool>> given_up_; // once another volume is looked at
    Ref<Placement> drawn_of_;                     // the veils
    std::array<ui::Color, 2> drawn_in_{};
    std::vector<gpu::Translucent> veils_;
    Worker work_;
};

} // namespace trivar
