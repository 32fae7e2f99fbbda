// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/tetrahedra.h"
#include "editor/tools/tool.h"

#include <optional>

namespace trivar {

// Works on a volume of tetrahedra through what stands in it: a ball pulls control points, a brush
// lowers the continuity across faces or cuts them, a stroke refines.
class TetrahedraTool : public Tool {
public:
    std::string name() const override { return "Tetrahedra"; }
    const char* icon() const override;
    std::string help() const override
    {
        return "Pull, crease, cut and refine what stands in tetrahedra.";
    }
    std::string page() const override { return "tetrahedra"; }
    std::vector<ui::Chord> keys() const override { return {{'Y'}}; }
    void begin(Session& session) override;
    void use(Session& session, const ViewportInput& input) override;
    bool busy() const override { return gesture_.has_value(); }
    bool takes_wheel() const override { return busy(); }
    bool resize(Session& session, double factor) override;
    void cancel(Session& session) override;
    int mode() const override { return static_cast<int>(by_); }
    std::vector<gpu::Line> lines(const Session& session, const ui::Theme& theme) const override;
    std::vector<gpu::Translucent> veils(const Session& session,
                                        const ui::Theme& theme) const override;
    void overlay(const Session& session, const ui::Theme& theme,
                 const ViewportInput& input) const override;
    void options(Session& session, const ui::Theme& theme, float width) override;
    std::vector<Hint> hints(const Session& session) const override;

private:
    enum class By { pull, crease, refine };
    struct Place {                    // on what stands in the volume
        glm::dvec3 world{0}, rest{0}; // and where that rests in the volume
    };
    struct Gesture {
        Id object = 0;
        TetrahedraEdit edit;
        glm::dvec3 grabbed{0}; // world
        glm::dmat3 to_volume{1};
        glm::dvec2 from_px{0};
        bool moved = false, proposed = false;
    };
    static Id volume_of(const Session& session, Id id);
    std::optional<Place> place_under(const Session& session, const ViewportInput& input) const;
    double radius(const Session& session) const; // metres in the volume
    void start(Session& session, const ViewportInput& input);
    void go_on(Session& session, const ViewportInput& input);
    void finish(Session& session);
    TetrahedraEdit edit_at(const TetrahedraShape& shape, const Place& place,
                           const Session& session) const;

    By by_ = By::pull;
    Decay decay_ = Decay::smooth;
    bool guard_ = true;
    double radius_ = 0; // 0: a share of the volume
    int depth_ = 3;     // of creases; the degree and more: a cut
    std::optional<Place> at_;
    std::optional<Gesture> gesture_;
};

} // namespace trivar
