#include "tests/core/exchange/project/stored_fields.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/project/simulated_network.h"
#include "core/support/numbers.h"
#include "tests/core/exchange/project/stored_field_settings.h"
#include "tests/support/exchange_projects.h"

#include <cmath>

namespace esm::stored {

namespace {

/// Masses are spread over nodes, of which each must keep one: this is enough for all.
constexpr double leastMass = 1e3 / largestNumber;

Region* regionOf(Project& project) {
    return project.regions.size() > 1 ? &project.regions[1] : nullptr;
}

template<class T> T* first(std::vector<T>& list) {
    return list.empty() ? nullptr : &list.front();
}

/// Changes a copy of what many share.
template<class T> Setting replaced(std::shared_ptr<const T> Project::*member, void (*change)(T&)) {
    return [member, change](Project& project) {
        if (!(project.*member)) return;
        auto copy = std::make_shared<T>(*(project.*member));
        change(*copy);
        project.*member = copy;
    };
}

template<class Change> Setting systemWith(const Change& change) {
    return [change](Project& project) {
        Region* region = regionOf(project);
        if (!region || !region->system) return;
        FuzzySystem system = *region->system;
        change(system);
        region->system = std::make_shared<const FuzzySystem>(system);
    };
}

void addTissue(Fields& fields) {
    fields.push_back(
        field<double>("base.mass", {leastMass, largestNumber}, [](Project& p) { return &p.base.mass; }));
    fields.push_back(
        field<std::optional<double>>("held.mass", {std::nullopt, leastMass, largestNumber},
                                     partOf(regionOf, [](Region& region) { return &region.held.mass; })));
}

void addRegions(Fields& fields) {
    fields.push_back(field<std::vector<Region>>("regions", {{}}, [](Project& p) { return &p.regions; }));
    fields.push_back(field<NamedValues>("region.inputs",
                                        {{}, {{"zeal", -largest}}, {{"zeal", largest}, {"age", smallest}}},
                                        partOf(regionOf, [](Region& r) { return &r.inputs; })));
}

/// As many and as long as they may be; of all terms but two no rule speaks.
void fillVariable(FuzzyVariable& variable) {
    for (std::size_t i = variable.terms.size(); i < mostFuzzyWords; ++i)
        variable.terms.push_back({"t" + std::to_string(i), variable.terms.front().set});
}

void addSystems(Fields& fields) {
    fields.push_back({"system.description",
                      {systemWith([](FuzzySystem& s) { s.description.clear(); }),
                       systemWith([](FuzzySystem& s) { s.description = std::string(10000, 'd'); })}});
    fields.push_back({"system.note", {systemWith([](FuzzySystem& s) { s.note.clear(); })}});
    fields.push_back({"system.rules", {systemWith([](FuzzySystem& s) { s.rules.clear(); })}});
    fields.push_back({"rule.weight",
                      {systemWith([](FuzzySystem& s) {
                           if (!s.rules.empty()) s.rules[0].weight = 0;
                       }),
                       systemWith([](FuzzySystem& s) {
                           if (!s.rules.empty()) s.rules[0].weight = smallest;
                       })}});
    fields.push_back({"system.norms", {systemWith([](FuzzySystem& s) {
                          s.norms = {TNorm::Product, TConorm::BoundedSum, TNorm::BoundedDifference,
                                     TConorm::ProbabilisticSum};
                      })}});
    fields.push_back(
        {"variable.unit",
         {systemWith([](FuzzySystem& s) { s.outputs[0].unit = ""; }),
          systemWith([](FuzzySystem& s) { s.outputs[0].unit = std::string(longestUnit, 'N'); })}});
    fields.push_back({"variable.range",
                      {systemWith([](FuzzySystem& s) {
                           s.inputs[0].minimum = -largestNumber;
                           s.inputs[0].maximum = largestNumber;
                       }),
                       systemWith([](FuzzySystem& s) {
                           s.inputs[0].minimum = 0;
                           s.inputs[0].maximum = smallest;
                       })}});
    fields.push_back(
        {"term.set", {systemWith([](FuzzySystem& s) {
             s.inputs[0].terms[0].set = {-largestNumber, -largestNumber, largestNumber, largestNumber};
             s.inputs[0].terms[1].set = {};
         })}});
    fields.push_back({"variable.terms", {systemWith([](FuzzySystem& s) { fillVariable(s.inputs[1]); })}});
    fields.push_back({"a preset's description", {[](Project& p) {
                          if (Region* region = regionOf(p)) {
                              FuzzySystem preset = fuzzyPreset("susilap-g");
                              preset.description.clear();
                              region->system = std::make_shared<const FuzzySystem>(preset);
                              region->inputs.clear();
                          }
                      }}});
}

void addScene(Fields& fields) {
    const std::vector<Eigen::Vector3d> vectors{Eigen::Vector3d::Constant(-largest),
                                               Eigen::Vector3d::Constant(largest)};
    const auto force = [](Project& p) { return first(p.scene.forces); };
    fields.push_back(field<Scene>("scene", {{}}, [](Project& p) { return &p.scene; }));
    fields.push_back(field<std::vector<NodeSelection>>("fixed", {{}, {{}}, {{{7}, Ellipsoid{}}}},
                                                       [](Project& p) { return &p.scene.fixed; }));
    fields.push_back(field<NodeForce>(
        "forces", {{0, vectors[0], -largest, -largest}, {7, vectors[1], smallest, largest}}, force));
    fields.push_back(field<std::vector<NodeMove>>(
        "moves", {{}, {{7, {{-largest, vectors[0]}, {0, {smallest, 0, -0.0}}, {largest, vectors[1]}}}}},
        [](Project& p) { return &p.scene.moves; }));
    const Eigen::Quaterniond half(0, 1, 0, 0), quarter(std::sqrt(0.5), 0, -std::sqrt(0.5), -0.0);
    const InstrumentMotion small{Sphere{smallest}, {{-largest, vectors[0]}}, {}, {}};
    fields.push_back(field<std::vector<InstrumentMotion>>(
        "instruments",
        {{},
         {small},
         {{Sphere{largest}, {{largest, vectors[1]}}, {}, {}}},
         {{Capsule{smallest, 0}, {{0, vectors[0]}, {1, vectors[1]}}, {half, quarter}, "blade"}, small},
         {{Capsule{largest, largestNumber}, {{0, vectors[0]}}, {}, std::string(100, 'n')}}},
        [](Project& p) { return &p.scene.instruments; }));
    fields.push_back(field<Recording>(
        "record", {{smallest, std::nullopt}, {largest, std::vector<std::uint32_t>{}}, {1, {{7, 0, 7}}}},
        [](Project& p) { return &p.scene.record; }));
}

void addStepping(Fields& fields) {
    StoredField stepping{"stepping", {[](Project& p) { p.stepping.reset(); }}};
    for (const Integrator integrator : allIntegrators)
        stepping.settings.push_back([integrator](Project& p) {
            p.stepping = MeasuredStepping{{integrator, smallest, Precision::Double}, largest, smallest, ""};
        });
    stepping.settings.push_back([](Project& p) {
        p.stepping = MeasuredStepping{
            {Integrator::Split2, largest, Precision::Double}, 0, largest, "fedcba9876543210"};
    });
    fields.push_back(stepping);
}

void addTexture(Fields& fields) {
    const std::vector<AtlasOptions> options{{1, 1, 0, AtlasLayout::Rows, 0},
                                            {16384, 4, 16384, AtlasLayout::MatchedRows, 1e9},
                                            {4096, 64, 0, AtlasLayout::UnfoldedGroups, smallest},
                                            {4096, 64, 0, AtlasLayout::Charts, 0},
                                            {4096, 1, 0, AtlasLayout::Own, 0}};
    fields.push_back(field("texture", options, [](Project& p) { return &p.texture.atlas; }));
    fields.push_back(
        field<std::shared_ptr<const Atlas>>("atlas", {nullptr}, [](Project& p) { return &p.atlas; }));
    fields.push_back({"atlas.options",
                      {replaced<Atlas>(&Project::atlas,
                                       [](Atlas& a) {
                                           a.options = {16384, 4, 16384, AtlasLayout::Rows, smallest};
                                       }),
                       replaced<Atlas>(&Project::atlas, [](Atlas& a) {
                           a.options = {4096, 64, 0, AtlasLayout::UnfoldedGroups, 1e9};
                       })}});
    fields.push_back({"atlas.texelsPerMetre",
                      {replaced<Atlas>(&Project::atlas, [](Atlas& a) { a.texelsPerMetre = smallest; }),
                       replaced<Atlas>(&Project::atlas, [](Atlas& a) { a.texelsPerMetre = largest; })}});
    fields.push_back({"atlas.utilisation",
                      {replaced<Atlas>(&Project::atlas, [](Atlas& a) { a.utilisation = 0; }),
                       replaced<Atlas>(&Project::atlas, [](Atlas& a) { a.utilisation = 1; })}});
}

/// The organ at another size, its texture packed anew.
Setting scaledBy(double factor) {
    return [factor](Project& project) {
        auto mesh = std::make_shared<TriangleMesh>(*project.mesh);
        for (Eigen::Vector3d& vertex : mesh->vertices)
            vertex *= factor;
        project.mesh = mesh;
        project.network = std::make_shared<SpringNetwork>(networkFromMesh(*mesh));
        if (project.atlas)
            project.atlas = std::make_shared<Atlas>(packAtlas(*mesh, {128, 1, 1, AtlasLayout::Rows, 0}));
    };
}

Setting simulatedBy(const Detail& detail) {
    return [detail](Project& project) {
        project.network = std::make_shared<SpringNetwork>(networkOf(*project.mesh, detail));
    };
}

void fillReport(RepairReport& report) {
    for (std::size_t* count :
         {&report.mergedVertices, &report.splitPolygons, &report.degenerateTriangles,
          &report.duplicateTriangles, &report.unusedVertices, &report.flippedTriangles, &report.droppedParts,
          &report.components, &report.boundaryEdgesBefore, &report.nonManifoldEdgesBefore,
          &report.boundaryEdges, &report.nonManifoldEdges, &report.inconsistentEdges, &report.closedSlitEdges,
          &report.filledHoles, &report.filledHoleEdges, &report.refusedHoles, &report.droppedPartEdges})
        *count = std::numeric_limits<std::size_t>::max();
    report.warnings.assign(1000, std::string(100, 'w'));
}

void addOrgan(Fields& fields) {
    fields.push_back(field<std::string>("name", {"", std::string(100000, 'n'), "\x01\n\"\\\t\xc3\xa4"},
                                        [](Project& p) { return &p.name; }));
    fields.push_back({"mesh", {scaledBy(4e-6), scaledBy(1e-10), scaledBy(1e20)}});
    fields.push_back({"network",
                      {simulatedBy({Detail::Kind::Nodes, 20}), simulatedBy({Detail::Kind::Rigid, 0}),
                       replaced<SpringNetwork>(&Project::network, [](SpringNetwork& network) {
                           for (Spring& spring : network.springs)
                               spring.restLength = 0;
                       })}});
    fields.push_back({"importReport",
                      {replaced<RepairReport>(&Project::importReport, [](RepairReport& r) { r = {}; }),
                       replaced<RepairReport>(&Project::importReport, fillReport)}});
}

} // namespace

} // namespace esm::stored

namespace esm {

std::vector<StoredField> storedFields() {
    std::vector<StoredField> fields;
    stored::addTables(fields);
    stored::addTissue(fields);
    stored::addRegions(fields);
    stored::addSystems(fields);
    stored::addScene(fields);
    stored::addStepping(fields);
    stored::addPhotoFields(fields);
    stored::addTexture(fields);
    stored::addOrgan(fields);
    return fields;
}

Project fullProject() {
    Project project = paintedProject();
    for (std::size_t i = 1; i < 3; ++i) {
        project.layers[i].projector = {};
        project.layers[i].projector.kind = ProjectorKind::Perspective;
    }
    project.layers[2].projector.intrinsics = Intrinsics{900, 900, 20, 20};
    return project;
}

} // namespace esm
