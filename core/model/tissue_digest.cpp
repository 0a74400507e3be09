#include "core/model/tissue_digest.h"

#include <array>
#include <cstring>

namespace esm {

namespace {

/// The hash FNV-1a of Fowler, Noll and Vo (IETF draft), of 64 bits; start and factor are the numbers that
/// they give. It tells tissue that has changed, not somebody who wants to deceive. So a few lines do, with
/// the same digits on every machine and in every version of a library.
class Fnv1a {
public:
    void add(std::uint32_t word) {
        for (int byte = 0; byte < 4; ++byte) {
            m_state ^= word >> (8 * byte) & 0xFFU;
            m_state *= 0x100000001b3U;
        }
    }
    // In single precision, as a package holds it: what is read from a package has the digest that it had when
    // it was written.
    void add(double value) {
        const auto single = static_cast<float>(value);
        std::uint32_t bits = 0;
        std::memcpy(&bits, &single, sizeof bits);
        add(bits);
    }
    // With its length, so that a number cannot pass from the end of one list to the beginning of the next
    // unseen.
    void add(const std::vector<double>& values) {
        add(static_cast<std::uint32_t>(values.size()));
        for (const double value : values)
            add(value);
    }
    std::string digits() const {
        std::string text;
        for (int shift = 60; shift >= 0; shift -= 4)
            text += "0123456789abcdef"[m_state >> shift & 0xFU];
        return text;
    }

private:
    std::uint64_t m_state = 0xcbf29ce484222325U;
};

} // namespace

// What most tissue lacks is added only where it is there. Digests of tissue without it stay those that
// programs gave which knew nothing of it.
std::string tissueDigest(const TissueModel& model) {
    Fnv1a digest;
    digest.add(model.mass);
    digest.add(model.springConstant);
    digest.add(model.viscosity);
    for (const Spring& spring : model.network->springs) {
        digest.add(spring.first);
        digest.add(spring.second);
        digest.add(spring.restLength);
    }
    if (hasOwnValues(model))
        for (const auto& [springConstant, viscosity] : model.ownValues) {
            digest.add(springConstant);
            digest.add(viscosity);
        }
    if (model.stiffening) {
        digest.add(model.stiffening->strain);
        digest.add(model.stiffening->factor);
    }
    for (const auto& [nodes, stiffness, viscosity] : model.hinges) {
        for (const std::uint32_t node : nodes)
            digest.add(node);
        digest.add(stiffness);
        digest.add(viscosity);
    }
    for (const Cavity& cavity : model.cavities) {
        if (cavity.stiffness == 0 && cavity.largestPressure == 0) continue;
        digest.add(cavity.part);
        digest.add(cavity.stiffness);
        digest.add(cavity.largestPressure);
    }
    return digest.digits();
}

bool isFromOtherTissue(const MeasuredStepping& measured, const TissueModel& model) {
    return !measured.tissue.empty() && measured.tissue != tissueDigest(model);
}

} // namespace esm
