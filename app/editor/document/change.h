#pragma once

#include "core/project/project.h"

namespace esm {

/// A fuzzy system that was edited, as against exchanged for another one, and what it became.
struct EditedSystem {
    std::shared_ptr<const FuzzySystem> before, after; ///< both, or neither
};

/// What differs between two projects; what a listener has to look at anew.
struct Change {
    bool name = false;
    bool mesh = false;   ///< the mesh, its network or its import report: another organ
    bool tissue = false; ///< the whole organ's base tissue
    bool regions = false;
    bool regionTissue = false; ///< of the regions more than names and colours
    bool spareSystems = false; ///< fuzzy systems that no region uses
    bool scene = false;
    bool stepping = false;  ///< how the motion is computed
    bool accuracy = false;  ///< what was measured of it
    bool layers = false;    ///< what lies on the organ
    bool landmarks = false; ///< of any photo
    bool texture = false;   ///< texture settings or the packed atlas
    EditedSystem system{};
    bool isOfHistory = false; ///< undone or redone, as against edited

    bool any() const {
        return name || mesh || tissue || regions || spareSystems || scene || stepping || accuracy || layers ||
               landmarks || texture;
    }
    /// What the simulation runs on.
    bool model() const { return mesh || tissue || regionTissue || scene; }
    /// What the composed texture is made of.
    bool picture() const { return mesh || layers || texture; }

    static Change everything() {
        return {true, true, true, true, true, true, true, true, true, true, true, true, {}};
    }
};

/// Whether both reach the same places: their ellipsoids and soft rims.
bool sameReach(const Region& a, const Region& b);
/// Landmarks only say where the photo was to be placed.
bool sameButForLandmarks(const TextureLayer& a, const TextureLayer& b);
Change difference(const Project& before, const Project& after);

} // namespace esm
