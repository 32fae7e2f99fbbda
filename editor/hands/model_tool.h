// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace trivar {

class Session;
struct TileFile;

// A TileFit says how a model is laid best as a tile.
struct TileFit {
    bool strand = false; // end to end
    double overlap = 0;  // in shares of its cell
};

// A ModelTool is a tool that works with models that need not be in the scene.
class ModelTool {
public:
    virtual ~ModelTool() = default;
    // Returns the files of the models that it works with; empty: none is chosen, or not of a file.
    virtual std::vector<std::string> chosen_models(const Session& session) const = 0;
    // `also`: besides those that are chosen already.
    virtual void choose_model(Session& session, const std::string& file, bool also) = 0;
    // Takes the best fit of the model that was chosen last.
    virtual void fit_model(const TileFit& fit) = 0;
    // The file of a model that a gesture waits for, once. Whoever reads it calls take_read().
    virtual std::optional<std::string> take_wanted() = 0;
    virtual void take_read(Session& session, const TileFile& model) = 0;
};

} // namespace trivar
