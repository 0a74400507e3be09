#include "tests/core/exchange/simulators/mujoco/mjcf_reader.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace esm {

namespace {

std::string unescaped(std::string text) {
    for (const auto& [name, letter] :
         {std::pair("&lt;", "<"), std::pair("&quot;", "\""), std::pair("&gt;", ">"), std::pair("&amp;", "&")})
        for (std::size_t place = 0; (place = text.find(name, place)) != std::string::npos; ++place)
            text.replace(place, std::string(name).size(), letter);
    return text;
}

MjcfElement elementOf(const std::string& tag) {
    MjcfElement element{tag.substr(1, tag.find_first_of(" />", 1) - 1), {}, {}};
    for (std::size_t place = 0, equals; (equals = tag.find("=\"", place)) != std::string::npos;) {
        const std::size_t name = tag.rfind(' ', equals) + 1, end = tag.find('"', equals + 2);
        element.attributes[tag.substr(name, equals - name)] =
            unescaped(tag.substr(equals + 2, end - equals - 2));
        place = end + 1;
    }
    return element;
}

/// Where a tag ends; within quotes the mark is a letter.
std::size_t tagEnd(const std::string& text, std::size_t begin) {
    bool isQuoted = false;
    for (std::size_t place = begin; place < text.size(); ++place) {
        if (text[place] == '"') isQuoted = !isQuoted;
        if (text[place] == '>' && !isQuoted) return place;
    }
    throw std::runtime_error("a tag does not end");
}

/// @param tag of the element @param place behind it, moved behind all that it holds
MjcfElement withChildren(const std::string& text, const std::string& tag, std::size_t& place) {
    MjcfElement element = elementOf(tag);
    if (tag[tag.size() - 2] == '/') return element;
    for (;;) {
        const std::size_t begin = text.find('<', place), end = tagEnd(text, begin);
        const std::string next = text.substr(begin, end + 1 - begin);
        place = end + 1;
        if (next == "</" + element.kind + ">") return element;
        element.children.push_back(withChildren(text, next, place));
    }
}

} // namespace

std::vector<double> MjcfElement::numbers(const std::string& name) const {
    std::istringstream words(attributes.at(name));
    std::vector<double> numbers;
    for (std::string word; words >> word;)
        numbers.push_back(std::stod(word));
    return numbers;
}

double MjcfElement::number(const std::string& name, double without) const {
    return has(name) ? numbers(name).at(0) : without;
}

std::vector<const MjcfElement*> MjcfElement::all(const std::string& childKind) const {
    std::vector<const MjcfElement*> found;
    for (const MjcfElement& child : children)
        if (child.kind == childKind) found.push_back(&child);
    return found;
}

const MjcfElement& MjcfElement::only(const std::string& childKind) const {
    const auto found = all(childKind);
    if (found.size() != 1)
        throw std::runtime_error(std::to_string(found.size()) + " elements are " + childKind);
    return *found.front();
}

struct MjcfReader::Motion {
    Vectors displacements, places, velocities;
};

MjcfReader::MjcfReader(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error(file.string() + " is missing");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const std::size_t begin = text.find("<mujoco");
    std::size_t place = tagEnd(text, begin) + 1;
    m_model = withChildren(text, text.substr(begin, place - begin), place);
    std::map<std::string, Eigen::Vector3d> axes;
    for (const MjcfElement* group : m_model.only("default").all("default")) {
        const std::vector<double> axis = group->only("joint").numbers("axis");
        axes[group->text("class")] = {axis.at(0), axis.at(1), axis.at(2)};
    }
    m_bodies = m_model.only("worldbody").all("body");
    for (std::size_t node = 0; node < m_bodies.size(); ++node) {
        m_sites[m_bodies[node]->only("site").text("name")] = node;
        for (const MjcfElement* joint : m_bodies[node]->all("joint"))
            m_joints[joint->text("name")] = {node, axes.at(joint->text("class"))};
    }
}

MjcfReader::Vectors MjcfReader::positions() const {
    Vectors places;
    for (const MjcfElement* body : m_bodies) {
        const std::vector<double> place = body->numbers("pos");
        places.emplace_back(place.at(0), place.at(1), place.at(2));
    }
    return places;
}

void MjcfReader::addJoints(const Motion& motion, Vectors& forces) const {
    for (const MjcfElement* body : m_bodies)
        for (const MjcfElement* joint : body->all("joint")) {
            const auto& [node, axis] = m_joints.at(joint->text("name"));
            forces[node] -= axis * (joint->number("stiffness") * axis.dot(motion.displacements[node]) +
                                    joint->number("damping") * axis.dot(motion.velocities[node]));
        }
}

void MjcfReader::addSpatial(const MjcfElement& tendon, const Motion& motion, Vectors& forces) const {
    const auto sites = tendon.all("site");
    const std::size_t first = m_sites.at(sites.at(0)->text("site")),
                      second = m_sites.at(sites.at(1)->text("site"));
    const Eigen::Vector3d between = motion.places[second] - motion.places[first];
    const double length = between.norm();
    if (!(length > 0)) return;
    const Eigen::Vector3d along = between / length;
    const std::vector<double> lengths = tendon.numbers("springlength");
    const double stretch = length > lengths.back()    ? length - lengths.back()
                           : length < lengths.front() ? length - lengths.front()
                                                      : 0;
    const double speed = along.dot(motion.velocities[second] - motion.velocities[first]);
    const Eigen::Vector3d force =
        (tendon.number("stiffness") * stretch + tendon.number("damping") * speed) * along;
    forces[first] += force;
    forces[second] -= force;
}

void MjcfReader::addFixed(const MjcfElement& tendon, const Motion& motion, Vectors& forces) const {
    double length = 0, speed = 0;
    for (const MjcfElement* term : tendon.all("joint")) {
        const auto& [node, axis] = m_joints.at(term->text("joint"));
        length += term->number("coef") * axis.dot(motion.displacements[node]);
        speed += term->number("coef") * axis.dot(motion.velocities[node]);
    }
    const double force = -tendon.number("stiffness") * (length - tendon.number("springlength")) -
                         tendon.number("damping") * speed;
    for (const MjcfElement* term : tendon.all("joint")) {
        const auto& [node, axis] = m_joints.at(term->text("joint"));
        forces[node] += term->number("coef") * force * axis;
    }
}

MjcfReader::Vectors MjcfReader::forces(const Vectors& at, const Vectors& velocities) const {
    Motion motion{at, at, velocities};
    const Vectors rest = positions();
    for (std::size_t node = 0; node < rest.size(); ++node)
        motion.displacements[node] -= rest[node];
    Vectors forces(rest.size(), Eigen::Vector3d::Zero());
    addJoints(motion, forces);
    for (const MjcfElement* tendon : m_model.only("tendon").all("spatial"))
        addSpatial(*tendon, motion, forces);
    for (const MjcfElement* tendon : m_model.only("tendon").all("fixed"))
        addFixed(*tendon, motion, forces);
    for (std::size_t node = 0; node < rest.size(); ++node)
        if (!isMovable(node)) forces[node].setZero();
    return forces;
}

} // namespace esm
