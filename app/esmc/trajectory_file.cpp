#include "app/esmc/trajectory_file.h"

#include <charconv>
#include <string>

namespace esm {

namespace {

/// The shortest text that reads back as the same number.
template<typename Number> void append(std::string& text, Number value) {
    char digits[32];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

} // namespace

TrajectoryFile::TrajectoryFile(const std::filesystem::path& file, const std::string& points,
                               std::optional<std::vector<std::uint32_t>> numbers)
    : m_file(file), m_numbers(std::move(numbers)) {
    m_file.write("time," + points + ",x,y,z\n");
}

void TrajectoryFile::add(double time, const std::vector<Eigen::Vector3d>& positions) {
    std::string row;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        row.clear();
        append(row, time);
        row += ',';
        append(row, m_numbers ? std::size_t{(*m_numbers)[i]} : i);
        for (const double coordinate : positions[i]) {
            row += ',';
            append(row, coordinate);
        }
        row += '\n';
        m_file.write(row);
    }
}

} // namespace esm
