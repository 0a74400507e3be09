#include "tests/core/exchange/simulators/sofa/sofa_reader.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace esm {

namespace {

std::string wholeText(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error(file.string() + " is missing");
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::map<std::string, std::string> attributesIn(const std::string& tag) {
    std::map<std::string, std::string> attributes;
    for (std::size_t place = 0;;) {
        const std::size_t equals = tag.find("=\"", place);
        if (equals == std::string::npos) return attributes;
        const std::size_t name = tag.find_last_of(" <", equals) + 1, end = tag.find('"', equals + 2);
        attributes[tag.substr(name, equals - name)] = tag.substr(equals + 2, end - equals - 2);
        place = end + 1;
    }
}

Eigen::Vector3d vectorAt(const std::vector<double>& numbers, std::size_t index) {
    return {numbers.at(3 * index), numbers.at(3 * index + 1), numbers.at(3 * index + 2)};
}

double ofEach(const std::vector<double>& numbers, std::size_t index) {
    return numbers.size() == 1 ? numbers.front() : numbers.at(index);
}

struct LinearSpring {
    std::size_t first, second;
    double stiffness, damping, length;
    bool onlyPulls;
};

std::vector<LinearSpring> linearSprings(const SofaElement& field) {
    std::vector<LinearSpring> springs;
    if (field.has("spring")) {
        const std::vector<double> numbers = field.numbers("spring");
        for (std::size_t i = 0; i + 4 < numbers.size(); i += 5)
            springs.push_back({static_cast<std::size_t>(numbers[i]), static_cast<std::size_t>(numbers[i + 1]),
                               numbers[i + 2], numbers[i + 3], numbers[i + 4], false});
        return springs;
    }
    const auto first = field.numbers("indices1"), second = field.numbers("indices2"),
               stiffness = field.numbers("stiffness"), damping = field.numbers("damping"),
               lengths = field.numbers("lengths"), onlyPulls = field.numbers("elongationOnly");
    for (std::size_t i = 0; i < first.size(); ++i)
        springs.push_back({static_cast<std::size_t>(first[i]), static_cast<std::size_t>(second.at(i)),
                           stiffness.at(i), damping.at(i), lengths.at(i), onlyPulls.at(i) != 0});
    return springs;
}

void addLinearSpring(const LinearSpring& spring, const SofaReader::Vectors& at,
                     const SofaReader::Vectors& velocities, SofaReader::Vectors& forces) {
    const Eigen::Vector3d between = at[spring.second] - at[spring.first];
    const double length = between.norm();
    if (!(length > 1e-9) || (spring.onlyPulls && length <= spring.length)) return;
    const Eigen::Vector3d along = between / length;
    const double speed = along.dot(velocities[spring.second] - velocities[spring.first]);
    const Eigen::Vector3d force =
        (spring.stiffness * (length - spring.length) + spring.damping * speed) * along;
    forces[spring.first] += force;
    forces[spring.second] -= force;
}

} // namespace

std::string SofaElement::text(const std::string& name) const {
    return attributes.at(name);
}

std::vector<double> SofaElement::numbers(const std::string& name) const {
    std::istringstream words(attributes.at(name));
    std::vector<double> numbers;
    for (std::string word; words >> word;)
        numbers.push_back(std::stod(word));
    return numbers;
}

SofaReader::SofaReader(const std::filesystem::path& folder) : m_folder(folder) {
    const std::string scene = wholeText(folder / "organ.scn");
    std::size_t depth = 0;
    for (std::size_t begin = scene.find('<'); begin != std::string::npos;
         begin = scene.find('<', begin + 1)) {
        const std::string tag = scene.substr(begin, scene.find('>', begin) - begin);
        if (tag[1] == '?' || tag[1] == '!') continue;
        if (tag[1] == '/') {
            --depth;
            continue;
        }
        m_elements.push_back({tag.substr(1, tag.find_first_of(" /", 1) - 1), attributesIn(tag), depth});
        if (tag.back() != '/') ++depth;
    }
    if (depth != 0) throw std::runtime_error("an element is not closed");
}

std::vector<const SofaElement*> SofaReader::all(const std::string& kind) const {
    std::vector<const SofaElement*> found;
    for (const SofaElement& element : m_elements)
        if (element.kind == kind) found.push_back(&element);
    return found;
}

const SofaElement& SofaReader::only(const std::string& kind) const {
    const auto found = all(kind);
    if (found.size() != 1) throw std::runtime_error(std::to_string(found.size()) + " elements are " + kind);
    return *found.front();
}

SofaReader::Vectors SofaReader::positions() const {
    for (const SofaElement& element : m_elements) {
        if (!element.has("name") || element.text("name") != "topology") continue;
        const std::vector<double> numbers = element.numbers("position");
        Vectors positions;
        for (std::size_t i = 0; 3 * i < numbers.size(); ++i)
            positions.push_back(vectorAt(numbers, i));
        return positions;
    }
    throw std::runtime_error("nothing has the nodes");
}

std::vector<SofaReader::VectorSpring> SofaReader::vectorSprings(const SofaElement& field) const {
    std::istringstream lines(wholeText(m_folder / field.text("filename")));
    std::string word;
    double version = 0;
    lines >> word >> version;
    if (word != "Xsp" || version != 4) throw std::runtime_error("no file of springs");
    std::vector<VectorSpring> springs;
    std::size_t masses = 0;
    while (lines >> word) {
        if (word == "numm" || word == "nums") {
            lines >> version;
        } else if (word == "mass") {
            ++masses;
            lines >> version >> word;
            for (int i = 0; i < 8; ++i)
                lines >> version;
        } else {
            VectorSpring spring{};
            lines >> version >> spring.first >> spring.second >> spring.stiffness >> spring.damping >>
                version >> spring.rest.x() >> spring.rest.y() >> spring.rest.z();
            if (version == -1 || spring.first-- > masses || spring.second-- > masses)
                throw std::runtime_error("SOFA would not take this spring");
            springs.push_back(spring);
        }
    }
    return springs;
}

bool SofaReader::addsDamping() const {
    return !all("StiffSpringForceField").empty();
}

void SofaReader::addSprings(const Vectors& at, const Vectors& velocities, Vectors& forces) const {
    for (const char* kind : {"SpringForceField", "StiffSpringForceField"})
        for (const SofaElement* field : all(kind))
            for (const LinearSpring& spring : linearSprings(*field))
                addLinearSpring(spring, at, velocities, forces);
    for (const SofaElement* field : all("VectorSpringForceField"))
        for (const auto& [first, second, stiffness, damping, rest] : vectorSprings(*field)) {
            const Eigen::Vector3d force = stiffness * (at[second] - at[first] - rest) +
                                          damping * (velocities[second] - velocities[first]);
            forces[first] += force;
            forces[second] -= force;
        }
}

void SofaReader::addRayleighDamping(const Vectors& velocities, Vectors& forces) const {
    for (const SofaElement* field : all("VectorSpringForceField")) {
        if (!field->has("rayleighStiffness")) continue;
        const double rayleigh = field->numbers("rayleighStiffness").front();
        for (const auto& [first, second, stiffness, damping, rest] : vectorSprings(*field)) {
            const Eigen::Vector3d force = rayleigh * stiffness * (velocities[second] - velocities[first]);
            forces[first] += force;
            forces[second] -= force;
        }
    }
    for (const SofaElement* field : all("RestShapeSpringsForceField")) {
        if (!field->has("rayleighStiffness")) continue;
        const double rayleigh = field->numbers("rayleighStiffness").front();
        const auto points = field->numbers("points"), stiffness = field->numbers("stiffness");
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto node = static_cast<std::size_t>(points[i]);
            forces[node] -= rayleigh * ofEach(stiffness, i) * velocities[node];
        }
    }
}

void SofaReader::addNodeDamping(const Vectors& velocities, Vectors& forces) const {
    for (const SofaElement* field : all("DiagonalVelocityDampingForceField")) {
        const std::vector<double> coefficients = field->numbers("dampingCoefficient");
        for (std::size_t node = 0; node < forces.size(); ++node)
            forces[node] -= vectorAt(coefficients, node).cwiseProduct(velocities[node]);
    }
}

SofaReader::Vectors SofaReader::forces(const Vectors& at, const Vectors& velocities) const {
    Vectors forces(at.size(), Eigen::Vector3d::Zero());
    const Vectors rest = positions();
    addSprings(at, velocities, forces);
    for (const SofaElement* field : all("RestShapeSpringsForceField")) {
        const auto points = field->numbers("points"), stiffness = field->numbers("stiffness");
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto node = static_cast<std::size_t>(points[i]);
            forces[node] -= ofEach(stiffness, i) * (at[node] - rest[node]);
        }
    }
    addNodeDamping(velocities, forces);
    if (addsDamping() && !all("EulerImplicitSolver").empty()) {
        addRayleighDamping(velocities, forces);
        addNodeDamping(velocities, forces);
    }
    return forces;
}

SofaReader::Vectors SofaReader::solvedDamping(const Vectors& velocities) const {
    Vectors forces(velocities.size(), Eigen::Vector3d::Zero());
    addRayleighDamping(velocities, forces);
    addNodeDamping(velocities, forces);
    return forces;
}

} // namespace esm
