#pragma once

#include "core/model/integrators.h"
#include "core/support/fields.h"

#include <array>
#include <string>
#include <vector>

namespace esm {

/// Of the numbers that explicit integrators compute with; the others take double.
enum class Precision { Double, Float };

template<>
inline constexpr auto wordsOf<Precision> =
    std::array{Word{Precision::Double, "double"}, Word{Precision::Float, "float"}};

/// One way to step the tissue.
struct Stepping {
    Integrator integrator = Integrator::Auto;
    double timeStep = 0; ///< s
    Precision precision = Precision::Double;

    bool operator==(const Stepping&) const = default;
};
template<>
inline constexpr auto fieldsOf<Stepping> = fieldTable(field("integrator", &Stepping::integrator),
                                                      field("timeStep", &Stepping::timeStep,
                                                            positiveLimits("the time step", "s")),
                                                      field("precision", &Stepping::precision));

inline constexpr Limits<double> errorLimits{"the error", 0, std::numeric_limits<double>::max()};
inline constexpr Limits<double> wallTimeLimits = positiveLimits("the wall time per simulated second", "s");

/// A way to step that was measured on a scene, with isotropic damping.
struct MeasuredStepping {
    Stepping stepping;
    double error = 0;                  ///< relative to the motion itself
    double wallPerSimulatedSecond = 0; ///< on the machine that measured
    std::string tissue = {};           ///< tissueDigest of what it was measured on; empty where nobody said

    bool operator==(const MeasuredStepping&) const = default;
};
template<>
inline constexpr auto fieldsOf<MeasuredStepping> = fieldTable(
    fieldsOfMember(&MeasuredStepping::stepping), field("error", &MeasuredStepping::error, errorLimits),
    field("wallPerSimulatedSecond", &MeasuredStepping::wallPerSimulatedSecond, wallTimeLimits),
    field("tissue", &MeasuredStepping::tissue).whenSet());

/// Every problem. Empty when tissue can be stepped so.
std::vector<std::string> validate(const Stepping& stepping);
std::vector<std::string> validate(const MeasuredStepping& measured);

/// Whether it may be tissueDigest()'s.
bool isTissueDigest(const std::string& digits);

} // namespace esm
