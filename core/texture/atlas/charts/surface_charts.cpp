#include "core/texture/atlas/charts/surface_charts.h"

#include "core/support/parallel_steps.h"
#include "core/texture/atlas/charts/chart_border.h"
#include "core/texture/atlas/stretch.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace esm {

namespace {

/// Of a page, what a chart may take with the box around it. Few large ones leave more of a page empty than
/// cuts cost.
constexpr double mostOfPage = 0.15;

bool isWithin(const DistortionSpread& spread, const DistortionSpread& most) {
    return spread.mean <= most.mean && spread.percentile95 <= most.percentile95 && spread.worst <= most.worst;
}

std::vector<Stretch> stretchesOf(const ChartMesh& chart, const PlanePoints& places) {
    std::vector<Stretch> stretches;
    stretches.reserve(chart.corners.size());
    for (const Triangle& at : chart.corners)
        stretches.push_back(stretchOf({chart.vertices[at[0]], chart.vertices[at[1]], chart.vertices[at[2]]},
                                      {places[at[0]], places[at[1]], places[at[2]]}));
    return stretches;
}

PlanePoints placesOfBorder(const ChartMesh& chart, const PlanePoints& places) {
    PlanePoints border;
    border.reserve(chart.borders[0].size());
    for (const std::uint32_t vertex : chart.borders[0])
        border.push_back(places[vertex]);
    return border;
}

/// Where no triangle is turned over and the border does not cross itself, no two triangles overlap: each
/// place is covered as often as the border goes around it, which is once.
bool isSoundlyFlat(const ChartMesh& chart, const PlanePoints& places, const std::vector<Stretch>& stretches) {
    const bool isUpright = std::all_of(stretches.begin(), stretches.end(), [](const Stretch& stretch) {
        return stretch.larger > 0 && !stretch.isClockwise;
    });
    return isUpright && isWithin(angleSpread(stretches), chartAngleLimit) &&
           isWithin(areaSpread(stretches), chartAreaLimit) && keepsClear(placesOfBorder(chart, places), 0);
}

/// So that the chart has the surface's area in the plane too.
void scaleToSurface(PlanePoints& places, const std::vector<Stretch>& stretches) {
    double surface = 0, plane = 0;
    for (const Stretch& stretch : stretches) {
        surface += stretch.area;
        plane += stretch.area * stretch.larger * stretch.smaller;
    }
    for (Eigen::Vector2d& place : places)
        place *= std::sqrt(surface / plane);
}

} // namespace

SurfaceCharts::Chart SurfaceCharts::alone(std::uint32_t triangle) const {
    const PatchShape& shape = m_shapes[triangle];
    const PatchCorners ofShape{{{0, 0}, {shape.base, 0}, {shape.foot, shape.height}}};
    UnfoldedGroup group{{triangle}, {ofShape}, shape.base * shape.height / 2};
    for (std::size_t i = 0; i < 3; ++i)
        group.corners[0][(shape.firstCorner + i) % 3] = ofShape[i];
    return {{triangle}, turned(group), {}, {}};
}

/// Nothing where the piece cannot be one chart.
std::optional<SurfaceCharts::Chart> SurfaceCharts::chartOf(const TriangleSet& triangles) const {
    if (triangles.size() == 1) return alone(triangles[0]);
    const ChartMesh chart = chartMesh(m_mesh, partOf(m_graph, triangles).across, triangles);
    if (!chart.isDisc) return std::nullopt;
    std::optional<PlanePoints> places = flattened(chart);
    if (!places) return std::nullopt;
    const std::vector<Stretch> stretches = stretchesOf(chart, *places);
    if (!isSoundlyFlat(chart, *places, stretches)) return std::nullopt;
    scaleToSurface(*places, stretches);
    UnfoldedGroup group;
    group.triangles = triangles;
    group.corners.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& at = chart.corners[i];
        group.corners.push_back({(*places)[at[0]], (*places)[at[1]], (*places)[at[2]]});
        group.area += m_graph.areas[triangles[i]];
    }
    return Chart{triangles, turned(group), placesOfBorder(chart, *places), {}};
}

/// Both, by the surface's numbers.
std::array<TriangleSet, 2> SurfaceCharts::halvesOf(const TriangleSet& piece) const {
    std::array<TriangleSet, 2> both = halves(partOf(m_graph, piece));
    for (TriangleSet& half : both)
        for (std::uint32_t& triangle : half)
            triangle = piece[triangle];
    return both;
}

/// Pieces that cannot be one chart are halved until what is left can, a triangle at the latest. What comes
/// when does not depend on which thread was first: results have their places.
std::vector<std::size_t> SurfaceCharts::make(std::vector<TriangleSet> pieces, const Progress& progress) {
    ProgressParts rounds(progress);
    std::vector<std::size_t> made;
    while (!pieces.empty()) {
        std::vector<std::optional<Chart>> charts(pieces.size());
        std::vector<std::array<TriangleSet, 2>> cut(pieces.size());
        forEachInParallel(pieces.size(), rounds.nextOfRest(0.4), [&](std::size_t i) {
            charts[i] = chartOf(pieces[i]);
            if (!charts[i]) cut[i] = halvesOf(pieces[i]);
        });
        std::vector<TriangleSet> smaller;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (charts[i]) {
                made.push_back(m_charts.size());
                m_charts.push_back(std::move(*charts[i]));
            } else {
                std::move(cut[i].begin(), cut[i].end(), std::back_inserter(smaller));
            }
        }
        pieces = std::move(smaller);
    }
    reportProgress(rounds.rest(), 1);
    return made;
}

std::vector<std::size_t> SurfaceCharts::makeAll(const Progress& progress) {
    ProgressParts parts(progress);
    std::vector<bool> hasArea;
    hasArea.reserve(m_shapes.size());
    for (const PatchShape& shape : m_shapes)
        hasArea.push_back(shape.height > 0);
    m_graph = dualGraph(m_mesh, hasArea);
    std::vector<TriangleSet> pieces = segments(m_graph, parts.next(0.3));
    std::vector<std::size_t> whole = make(std::move(pieces), parts.rest());
    for (std::uint32_t triangle = 0; triangle < m_shapes.size(); ++triangle) {
        if (hasArea[triangle]) continue;
        whole.push_back(m_charts.size());
        m_charts.push_back(alone(triangle));
    }
    return whole;
}

/// The largest charts that fit the page and keep the gap at a scale. Which they are follows from the scale
/// alone, whatever was laid out before.
std::vector<std::size_t> SurfaceCharts::chosenFor(double texelsPerMetre, const PageRoom& page,
                                                  const Progress& progress) {
    constexpr std::size_t block = 16;
    const double clearance = page.gap / texelsPerMetre, room = (page.size - page.gap) / texelsPerMetre;
    ProgressParts rounds(progress);
    std::vector<std::size_t> chosen, asked = m_whole;
    while (!asked.empty()) {
        std::vector<char> fits(asked.size());
        forEachInBlocks(asked.size(), block, rounds.nextOfRest(0.3), [&](std::size_t i) {
            const Chart& chart = m_charts[asked[i]];
            const double length = chart.laid.length, height = chart.laid.height;
            const bool hasRoom = length <= room && length * height <= mostOfPage * room * room;
            fits[i] = chart.border.empty() || (hasRoom && keepsClear(chart.border, clearance));
        });
        std::vector<std::size_t> smaller;
        for (std::size_t i = 0; i < asked.size(); ++i) {
            if (fits[i]) {
                chosen.push_back(asked[i]);
                continue;
            }
            const std::vector<std::size_t>& parts = partsOf(asked[i], rounds.nextOfRest(0.02));
            smaller.insert(smaller.end(), parts.begin(), parts.end());
        }
        asked = std::move(smaller);
    }
    reportProgress(rounds.rest(), 1);
    return chosen;
}

/// Made when they are asked for first.
const std::vector<std::size_t>& SurfaceCharts::partsOf(std::size_t chart, const Progress& progress) {
    if (m_charts[chart].parts.empty()) {
        std::array<TriangleSet, 2> both = halvesOf(m_charts[chart].triangles);
        std::vector<std::size_t> parts = make({std::move(both[0]), std::move(both[1])}, progress);
        m_charts[chart].parts = std::move(parts);
    }
    return m_charts[chart].parts;
}

PatchLayout SurfaceCharts::layoutAt(double texelsPerMetre, const PageRoom& page, int mostPages,
                                    const Progress& progress) {
    ProgressParts parts(progress);
    if (m_charts.empty()) m_whole = makeAll(parts.next(0.8));
    if (!(page.size > page.gap)) return {}; // no room, however small the charts
    std::vector<std::size_t> chosen = chosenFor(texelsPerMetre, page, parts.nextOfRest(0.4));
    std::stable_sort(chosen.begin(), chosen.end(), [&](std::size_t a, std::size_t b) {
        return m_charts[a].laid.height > m_charts[b].laid.height;
    });
    std::vector<TurnedGroup> groups;
    groups.reserve(chosen.size());
    m_order.clear();
    m_order.reserve(m_shapes.size());
    for (const std::size_t chart : chosen) {
        groups.push_back(m_charts[chart].laid);
        for (const std::uint32_t triangle : m_charts[chart].triangles) {
            m_order.push_back(m_shapes[triangle]);
            m_order.back().firstCorner = 0;
        }
    }
    return layoutGroups(groups, texelsPerMetre, page, mostPages, parts.rest());
}

} // namespace esm
