#include "app/editor/workers/poke.h"

#include <algorithm>
#include <limits>

namespace esm {

namespace {

std::uint32_t nearestNode(const SpringNetwork& network, const Eigen::Vector3d& place) {
    double least = std::numeric_limits<double>::infinity();
    std::uint32_t nearest = 0;
    for (std::uint32_t node = 0; node < network.restPositions.size(); ++node) {
        const double distance = (network.restPositions[node] - place).squaredNorm();
        if (distance < least) {
            least = distance;
            nearest = node;
        }
    }
    return nearest;
}

} // namespace

PreviewLoads loadsAt(const Poke& poke, double time) {
    const auto next = std::upper_bound(poke.moments.begin(), poke.moments.end(), time,
                                       [](double at, const HandMoment& moment) { return at < moment.time; });
    return next == poke.moments.begin() ? PreviewLoads{} : std::prev(next)->loads;
}

Poke carriedOver(const Poke& poke, const std::shared_ptr<const SpringNetwork>& network) {
    if (network == poke.network) return poke;
    Poke carried = poke;
    carried.network = network;
    std::optional<std::uint32_t> grasped; // a pull keeps its node over many moments
    std::uint32_t nearest = 0;
    for (HandMoment& moment : carried.moments) {
        std::optional<Pull>& pull = moment.loads.pull;
        if (!pull) continue;
        const Eigen::Vector3d& rest = poke.network->restPositions[pull->node];
        if (grasped != pull->node) nearest = nearestNode(*network, rest);
        grasped = pull->node;
        pull = Pull{nearest, pull->target + network->restPositions[nearest] - rest};
    }
    return carried;
}

void PokeRecorder::note(double time, PreviewLoads loads) {
    std::vector<HandMoment>& moments = m_poke.moments;
    while (!moments.empty() && moments.back().time >= time)
        moments.pop_back();
    m_poke.duration = time;
    loads.gentleMotion = false;
    if (moments.empty() || !(moments.back().loads == loads)) moments.push_back({time, loads});
}

} // namespace esm
