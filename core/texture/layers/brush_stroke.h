#pragma once

#include "core/support/fields.h"
#include "core/support/shared_values.h"
#include "core/texture/texture_limits.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace esm {

enum class BrushKind {
    Erase,   ///< takes the layer away
    Restore, ///< brings back what was erased
    Colour,  ///< lays a colour
    Clone,   ///< lays what lies beneath the layer at another place
    Heal,    ///< the same, but adapted to what lies around the stroke, see HealingRim
};

template<>
inline constexpr auto wordsOf<BrushKind> =
    std::array{Word{BrushKind::Erase, "erase"}, Word{BrushKind::Restore, "restore"},
               Word{BrushKind::Colour, "colour"}, Word{BrushKind::Clone, "clone"},
               Word{BrushKind::Heal, "heal"}};

/// Whether a brush lays what lies beneath its layer elsewhere.
constexpr bool copies(BrushKind kind) {
    return kind == BrushKind::Clone || kind == BrushKind::Heal;
}

/// Whether a brush lays colour instead of changing the layer's mask.
constexpr bool laysColour(BrushKind kind) {
    return kind == BrushKind::Colour || copies(kind);
}

/// A place on the surface over which a brush was led.
struct BrushPoint {
    Eigen::Vector3d place;  ///< m
    Eigen::Vector3d normal; ///< of the surface there, length > 0

    bool operator==(const BrushPoint&) const = default;
};

/// What is left of a brush at a point of its path, as where a pen presses lightly.
struct BrushShares {
    double radius = 1, strength = 1; ///< of the stroke's, 0 to 1

    bool operator==(const BrushShares&) const = default;
};

/// What one movement of a brush does to the surface around its path, in space and not in texels: it lies
/// where it lay however the texture is packed. Its weight is greatest over the path, so that nothing builds
/// up where it crosses itself.
struct BrushStroke {
    BrushKind kind = BrushKind::Erase;
    double radius = 0.005;                ///< m
    double softness = 0.5;                ///< share of the radius over which the weight falls to 0, 0 to 1
    double strength = 1;                  ///< weight in the middle, 0 to 1
    std::array<std::uint8_t, 3> colour{}; ///< sRGB, of a colour brush
    Eigen::Vector3d shift{
        Eigen::Vector3d::Zero()}; ///< m, of one that copies, from where it paints to its source
    std::vector<BrushPoint> path; ///< at least one point; joined by straight lines
    /// Of each point, passing evenly from one to the next; empty where all is left of the brush everywhere.
    std::vector<BrushShares> shares;

    bool operator==(const BrushStroke&) const = default;
};
template<>
inline constexpr auto fieldsOf<BrushStroke> =
    fieldTable(field("brush", &BrushStroke::kind),
               field("radius", &BrushStroke::radius,
                     Limits<double>{"the brush's radius", texture_limits::shortestPhoto,
                                    texture_limits::longestPhoto, "m"}),
               field("softness", &BrushStroke::softness, Limits<double>{"the brush's softness", 0, 1}),
               field("strength", &BrushStroke::strength, Limits<double>{"the brush's strength", 0, 1}),
               field("points", &BrushStroke::path), field("shares", &BrushStroke::shares).whenSet(),
               field("colour", &BrushStroke::colour).onlyWhere([](const BrushStroke& stroke) {
                   return stroke.kind == BrushKind::Colour;
               }),
               field("shift", &BrushStroke::shift, finiteLimits("the way to the place that is copied"))
                   .onlyWhere([](const BrushStroke& stroke) { return copies(stroke.kind); }));

/// Never null; shared, so that a copy of a layer costs little.
using BrushStrokes = std::vector<ByValue<BrushStroke>>;

/// Every problem of a stroke. Empty when all is well.
std::vector<std::string> validate(const BrushStroke& stroke);

/// A place of the surface that a stroke is asked about.
struct SurfacePoint {
    Eigen::Vector3d place;  ///< m
    Eigen::Vector3d normal; ///< of length 1, smooth over the triangles
};

/// A triangle's corners and their normals, as columns.
struct TriangleCorners {
    Eigen::Matrix3d places, normals;
};

/// What is left of a brush at a share of the way from a point of its path to the next.
BrushShares sharesBetween(const BrushStroke& stroke, std::size_t point, double t);

/// All that a stroke may reach.
Eigen::AlignedBox3d reachOf(const BrushStroke& stroke);

/// The weight at a distance (m) from the path: `strength` up to the soft part of the radius, from there down
/// to 0 as 3t² − 2t³.
double strokeProfile(const BrushStroke& stroke, double distance, const BrushShares& shares = {});

/// A stroke as one triangle meets it.
class StrokeOnTriangle {
public:
    /// Nothing where the stroke stays away from the triangle or looks at its other side: a brush does not
    /// paint through a thin wall.
    /// @param margin m around the triangle in which weights are asked for
    static std::optional<StrokeOnTriangle> make(const BrushStroke& stroke, const TriangleCorners& corners,
                                                double margin);

    const BrushStroke& stroke() const { return *m_stroke; }

    /// 0 to `strength`, at a point of the triangle's plane: less where the surface turns away from the brush
    /// by more than 60°, nothing from 90° on.
    double weightAt(const SurfacePoint& point) const;

private:
    struct Segment {
        Eigen::Vector3d start, along;
        double squaredLength;
        Eigen::Vector3d startNormal, endNormal; ///< of the surface under the brush, of length 1
        BrushShares startShares, endShares;
    };

    const BrushStroke* m_stroke = nullptr;
    std::vector<Segment> m_segments;
};

} // namespace esm
