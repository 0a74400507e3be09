#include "app/esmc/motion_frame.h"

#include "core/render/drawn_shape.h"
#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace esm {

namespace {

struct Row {
    double time;
    std::uint32_t node;
    Eigen::Vector3d position;
};

/// Takes a number and the comma behind it off the front; false where there is none.
template<typename Number> bool take(std::string_view& text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (!text.empty() && text.front() != ',') return false;
    if (!text.empty()) text.remove_prefix(1);
    return true;
}

std::optional<Row> rowOf(std::string_view line) {
    Row row{};
    const bool isWhole = take(line, row.time) && take(line, row.node) && take(line, row.position.x()) &&
                         take(line, row.position.y()) && take(line, row.position.z());
    if (!isWhole || !line.empty() || !std::isfinite(row.time) || !row.position.allFinite())
        return std::nullopt;
    return row;
}

std::string_view nextLine(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}

} // namespace

MotionFrame readMotionFrame(const std::filesystem::path& file, const std::vector<std::size_t>& nodeCounts,
                            std::optional<double> time) {
    const Bytes content = readFile(file);
    std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
    if (nextLine(text) != "time,node,x,y,z")
        throw FileError(file, "is no trajectory: its first line should be time,node,x,y,z");
    const std::size_t mostNodes = nodeCounts.back();
    std::vector<Eigen::Vector3d> positions(mostNodes, Eigen::Vector3d::Zero());
    std::vector<double> seen(mostNodes, std::nan(""));
    double frame = std::nan("");
    for (std::size_t number = 2; !text.empty(); ++number) {
        const std::optional<Row> row = rowOf(nextLine(text));
        if (!row || row->node >= mostNodes)
            throw FileError(file,
                            "line " + std::to_string(number) + " is no place of one of the model's " +
                                std::to_string(mostNodes) +
                                " nodes; where a scene splits the organ, store it in the project first");
        if (time && row->time > *time) break;
        frame = seen[row->node] = row->time;
        positions[row->node] = row->position;
    }
    if (std::isnan(frame)) throw FileError(file, "has no frame at that time or before it");
    const auto lastSeen = std::find(seen.rbegin(), seen.rend(), frame);
    const std::size_t nodeCount = *std::lower_bound(nodeCounts.begin(), nodeCounts.end(),
                                                    static_cast<std::size_t>(seen.rend() - lastSeen));
    positions.resize(nodeCount);
    for (std::size_t node = 0; node < nodeCount; ++node)
        if (seen[node] != frame)
            throw FileError(file, "says nothing of node " + std::to_string(node) + " at " +
                                      roundedText(frame) + " s; record all nodes");
        else if (!isDrawable(positions[node]))
            throw FileError(file, "has node " + std::to_string(node) + " at " + roundedText(frame) +
                                      " s too far away to be drawn; ask for an earlier frame with --at");
    return {frame, std::move(positions)};
}

std::vector<double> readSpeeds(const std::filesystem::path& file, const std::vector<std::size_t>& nodeCounts,
                               const MotionFrame& frame) {
    std::optional<MotionFrame> before;
    const double earlier = std::nextafter(frame.time, -HUGE_VAL);
    if (earlier >= 0) before = readMotionFrame(file, nodeCounts, earlier);
    if (!before || before->positions.size() != frame.positions.size())
        throw FileError(file, "has no frame before " + roundedText(frame.time) +
                                  " s to tell a speed from; ask for a later one with --at");
    std::vector<double> speeds;
    for (std::size_t node = 0; node < frame.positions.size(); ++node)
        speeds.push_back((frame.positions[node] - before->positions[node]).norm() /
                         (frame.time - before->time));
    return speeds;
}

} // namespace esm
