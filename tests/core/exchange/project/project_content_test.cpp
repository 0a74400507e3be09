#include "core/exchange/project/project_content.h"
#include "core/support/errors.h"
#include "tests/support/exchange_projects.h"
#include "tests/support/same_project.h"

#include <gmock/gmock.h>

using namespace esm;

namespace {

/// Entries in memory, as any other place that keeps them.
struct Kept {
    nlohmann::ordered_json manifest;
    std::map<std::string, Bytes> entries;

    explicit Kept(const Project& project) {
        const ProjectContent content = contentOf(project);
        manifest = content.manifest;
        for (const ContentPiece& piece : content.pieces) {
            const Bytes bytes = piece.bytes();
            Bytes& entry = entries[piece.entry];
            entry.insert(entry.end(), bytes.begin(), bytes.end());
        }
    }

    ContentSource source() const {
        return {[this](const std::string& entry, std::uint64_t largest, const Progress&) {
                    const auto found = entries.find(entry);
                    if (found == entries.end() || found->second.size() > largest)
                        throw InvalidModel(entry + " cannot be had");
                    return found->second;
                },
                [this](const std::string& entry) {
                    const auto found = entries.find(entry);
                    return found == entries.end() ? std::string()
                                                  : std::string(found->second.begin(), found->second.end());
                }};
    }
};

} // namespace

TEST(ProjectContent, BringsBackEveryKindOfProject) {
    for (const Project& project : {richProject(), paintedProject(), softProject(), biphasicProject(),
                                   boundProject({Detail::Kind::Nodes, 20}), bareProject()}) {
        const Kept kept(project);
        SharedParts shared;
        const ReadContent read = projectFrom(kept.manifest, kept.source(), shared);
        EXPECT_THAT(read.problems, testing::IsEmpty());
        expectSameProject(project, read.project);
    }
}

TEST(ProjectContent, SharesWhatProjectsHaveInCommon) {
    Project project = paintedProject();
    const Kept before(project);
    project.base.mass *= 2;
    const Kept after(project);
    SharedParts shared;
    const Project first = projectFrom(before.manifest, before.source(), shared).project;
    const Project second = projectFrom(after.manifest, after.source(), shared).project;
    EXPECT_EQ(first.mesh, second.mesh);
    EXPECT_EQ(first.network, second.network);
    EXPECT_EQ(first.atlas, second.atlas);
    EXPECT_EQ(first.importReport, second.importReport);
    for (std::size_t i = 0; i < first.layers.size(); ++i) {
        EXPECT_EQ(first.layers[i].photo, second.layers[i].photo);
        EXPECT_EQ(first.layers[i].prepared.get(), second.layers[i].prepared.get());
    }
    EXPECT_NE(first.base.mass, second.base.mass);
}

TEST(ProjectContent, DoesNotShareWhatDiffers) {
    Project project = richProject();
    const Kept before(project);
    auto mesh = std::make_shared<TriangleMesh>(*project.mesh);
    mesh->vertices[0].x() += 1e-9;
    project.mesh = mesh;
    const Kept after(project);
    SharedParts shared;
    const Project first = projectFrom(before.manifest, before.source(), shared).project;
    const Project second = projectFrom(after.manifest, after.source(), shared).project;
    EXPECT_EQ(second.mesh->vertices[0].x(), mesh->vertices[0].x());
    EXPECT_EQ(first.network, second.network);
}

TEST(ProjectContent, TellsAnEntryThatCannotBeHad) {
    Kept kept(richProject());
    kept.entries.erase("mesh/vertices.f64");
    SharedParts shared;
    EXPECT_THAT(projectFrom(kept.manifest, kept.source(), shared).problems,
                testing::Contains("mesh/vertices.f64 cannot be had"));
}

TEST(ProjectContent, MakesNoPieceOfANumberThatIsNotFinite) {
    Project project = richProject();
    auto mesh = std::make_shared<TriangleMesh>(*project.mesh);
    mesh->vertices[0].x() = std::numeric_limits<double>::infinity();
    project.mesh = mesh;
    EXPECT_THROW(contentOf(project).pieces.front().bytes(), InvalidModel);
}
