#pragma once

#include "core/fuzzy/inference.h"
#include "core/geometry/ellipsoid.h"
#include "core/support/fields.h"
#include "core/support/id.h"
#include "core/support/shared_values.h"

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace esm {

/// Parameters of tissue. What is not set stays as it was beneath.
struct TissueValues {
    std::optional<double> springConstant; ///< N/m
    std::optional<double> viscosity;      ///< N·s/m
    std::optional<double> mass;           ///< kg, total of the region, spread evenly over its nodes

    bool operator==(const TissueValues&) const = default;
};
template<>
inline constexpr auto fieldsOf<TissueValues> = fieldTable(
    field("springConstant", &TissueValues::springConstant, amountLimits("the spring constant")).whenSet(),
    field("viscosity", &TissueValues::viscosity, amountLimits("the viscosity")).whenSet(),
    field("mass", &TissueValues::mass, massLimits("the mass")).whenSet());

/// One of them.
enum class Parameter { SpringConstant, Viscosity, Mass };
inline constexpr std::array<Parameter, 3> everyParameter{Parameter::SpringConstant, Parameter::Viscosity,
                                                         Parameter::Mass};
std::optional<double>& valueOf(TissueValues& values, Parameter parameter);
std::optional<double> valueOf(const TissueValues& values, Parameter parameter);

/// The output of a fuzzy system that sets a parameter, by its name: `spring_const`, `spring_constant` or
/// `youngs_modulus`, `viscosity` or `relaxation_time`, `mass`. The first where there are several; none
/// without.
std::optional<std::size_t> outputFor(const FuzzySystem& system, Parameter parameter);

/// Whether an output says the spring constant as Young's modulus of a wall, Pa.
inline bool isYoungsModulus(const FuzzyVariable& output) {
    return output.name == "youngs_modulus";
}
/// Whether an output says the viscosity as the time, s, that it takes times the spring constant.
inline bool isRelaxationTime(const FuzzyVariable& output) {
    return output.name == "relaxation_time";
}

/// Whether an output sets a parameter in one of these ways.
bool isInClinicalUnits(const FuzzySystem& system, std::size_t output);

/// The parameter that an output sets: the other way round.
std::optional<Parameter> parameterOf(const FuzzySystem& system, std::size_t output);

/// The value of a name, if it has one.
std::optional<double> valueOf(const NamedValues& values, const std::string& name);

/// A part of the organ and how its tissue behaves. Kept as it was put in, and re-evaluated, so it stays
/// editable.
struct Region : Identified<Region> {
    std::string name;
    std::array<std::uint8_t, 3> colour{63, 182, 168}; ///< red, green, blue; the same in list and view
    std::optional<Ellipsoid> ellipsoid;               ///< the whole organ without
    double rim = 0; ///< m around the ellipsoid, over which its tissue fades into what lies beneath; 0: sharp
    ByValue<FuzzySystem> system; ///< may be null: then only `held` counts
    NamedValues inputs;          ///< of the fuzzy system
    TissueValues held;           ///< set by hand, in place of what the system infers

    bool operator==(const Region&) const = default;
};
using RegionId = Id<Region>;
template<>
inline constexpr auto
    fieldsOf<Region> = fieldTable(field("name", &Region::name), field("colour", &Region::colour),
                                  field("ellipsoid", &Region::ellipsoid).whenSet(),
                                  field("rim", &Region::rim, amountLimits("the soft rim")).whenSet(),
                                  field("fuzzySystem", &Region::system).whenSet(),
                                  field("inputs", &Region::inputs), field("held", &Region::held));

/// Sets or adds one input value.
void setInput(Region& region, const std::string& variable, double value);

/// How much of a place's tissue is the region's: 1 inside, and in the soft rim around the ellipsoid smoothly
/// down to 0, 1 − 3t² + 2t³ at the share t of the rim's width. The rim lies outside, so that what the
/// ellipsoid holds keeps the region's values in full, however wide the rim is.
double weightAt(const Region& region, const Eigen::Vector3d& point);

/// What a region's fuzzy system and held values give together.
struct RegionTissue {
    TissueValues values;
    /// s: the viscosity over whatever spring constant lies beneath, where the region sets this time but no
    /// spring constant; its values have no viscosity then.
    std::optional<double> relaxationTime{};
    InferenceResult inference;          ///< empty lists without a system
    std::vector<std::size_t> unreached; ///< outputs that no rule reaches and nothing holds, as indices
    std::vector<std::string> warnings;  ///< inputs out of range, outputs that set nothing
};

/// What tissue has of a parameter in the terms of an output that sets it: a spring constant as Young's
/// modulus where the output says it so, a viscosity as relaxation time. None where the tissue has no such
/// value.
std::optional<double> inTermsOf(const FuzzyVariable& output, Parameter parameter, const TissueValues& tissue,
                                double wallThickness);

/// Pa, of a wall; none where no spring constant is set.
std::optional<double> youngsModulusOf(const TissueValues& values, double wallThickness);
/// s, viscosity over spring constant; none where one of both is not set, or the constant is 0.
std::optional<double> relaxationTimeOf(const TissueValues& values);
/// The same, or the time that the region sets where it leaves its spring constant to what lies beneath.
std::optional<double> relaxationTimeOf(const RegionTissue& tissue);

/// @param wallThickness m, of which a Young's modulus means a spring constant
/// @throws InvalidModel when an input is unknown to the fuzzy system or not finite
RegionTissue evaluate(const Region& region, double wallThickness);

} // namespace esm
