#include "core/geometry/repair_report.h"

namespace esm {

namespace {

std::string counted(std::size_t count, const std::string& singular, const std::string& plural) {
    return std::to_string(count) + " " + (count == 1 ? singular : plural);
}

std::string edgesText(std::size_t count) {
    return counted(count, "border edge", "border edges");
}

/// How many border edges there were, what became of them, and how many are left: the last number follows from
/// those before it. Empty where there never was one.
std::string borderAccount(const RepairReport& report) {
    const std::size_t before = report.boundaryEdgesBefore, found = report.boundaryEdgesFound();
    const bool isOpen = report.boundaryEdges > 0;
    if (before == found && found == report.boundaryEdges)
        return isOpen ? edgesText(found) + ": the surface is not closed" : std::string();
    std::string account = edgesText(before) + " in the file";
    const auto add = [&account](std::size_t count, const std::string& fate) {
        if (count > 0) account += ", " + std::to_string(count) + fate;
    };
    add(found > before ? found - before : 0, " more once faulty triangles are dropped");
    add(before > found ? before - found : 0, " fewer once faulty triangles are dropped");
    add(report.closedSlitEdges, " closed with slits");
    add(report.droppedPartEdges, " dropped with smaller parts");
    add(report.filledHoleEdges, " closed with holes");
    return account + (isOpen
                          ? ": " + std::to_string(report.boundaryEdges) + " left, the surface is not closed"
                          : std::string(": none left"));
}

class Warnings {
public:
    void add(std::size_t count, const std::string& singular, const std::string& plural,
             const std::string& fate) {
        if (count > 0) m_all.push_back(counted(count, singular, plural) + fate);
    }
    void add(const std::string& text) {
        if (!text.empty()) m_all.push_back(text);
    }
    std::vector<std::string> taken() { return std::move(m_all); }

private:
    std::vector<std::string> m_all;
};

} // namespace

std::vector<std::string> repairWarnings(const RepairReport& report, const LeftOpen& left) {
    Warnings warnings;
    warnings.add(report.degenerateTriangles, "triangle", "triangles", " without area dropped");
    warnings.add(report.duplicateTriangles, "duplicate triangle", "duplicate triangles", " dropped");
    warnings.add(report.unusedVertices, "vertex", "vertices", " of no triangle dropped");
    warnings.add(report.flippedTriangles, "triangle", "triangles",
                 " turned to face the same way as the rest");
    warnings.add(report.closedSlitEdges, "border edge", "border edges", " of slits closed");
    warnings.add(report.filledHoles, "hole", "holes",
                 " filled, with " + edgesText(report.filledHoleEdges) + " in all");
    warnings.add(report.refusedHoles, "hole", "holes",
                 " left open, with " + edgesText(left.refusedEdges) +
                     " in all: no filling would go on with the surface around without folding back onto it");
    warnings.add(report.droppedParts, "smaller part", "smaller parts", " dropped");
    if (report.components > 1)
        warnings.add("the surface has " + std::to_string(report.components) + " parts that do not touch");
    warnings.add(borderAccount(report));
    warnings.add(left.looseEdges, "border edge", "border edges",
                 " around no hole: the free edge of a wall or flap, which begins and ends where parts of the "
                 "surface meet, and cannot be filled");
    warnings.add(report.nonManifoldEdges, "edge", "edges", " shared by more than two triangles kept");
    warnings.add(report.inconsistentEdges, "edge", "edges",
                 " where the two sides of the surface cannot be told apart");
    return warnings.taken();
}

} // namespace esm
