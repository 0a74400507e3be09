#include "core/exchange/project/project_file.h"
#include "core/exchange/project/projector_file.h"
#include "tests/core/exchange/fields_set_in_none.h"
#include "tests/support/samples.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

/// The projector of the layer that a sample's name ends in, in the project whose name stands before.
Projector storedProjector(const std::filesystem::path& sample) {
    const std::string name = sample.stem().string();
    const std::size_t dash = name.rfind('-');
    const std::filesystem::path projects = sample.parent_path() / ".." / "projects";
    const Project project = loadProject(projects / (name.substr(0, dash) + ".esm"));
    return project.layers.at(std::stoul(name.substr(dash + 1))).projector;
}

TEST(ProjectorFileSamples, AreReadAndWrittenAsTheyWere) {
    for (const std::filesystem::path& file : samples("projectors")) {
        SCOPED_TRACE(file.filename());
        const Projector projector = readProjectorFile(file);
        EXPECT_TRUE(projector == storedProjector(file));
        const std::string text = toJson(projector).dump(2) + '\n';
        EXPECT_TRUE(readFile(file) == Bytes(text.begin(), text.end())) << text;
    }
}

TEST(ProjectorFileSamples, SetEveryField) {
    std::vector<Projector> projectors;
    for (const std::filesystem::path& file : samples("projectors"))
        projectors.push_back(readProjectorFile(file));
    EXPECT_THAT(fieldsSetInNone(projectors), testing::IsEmpty());
}

} // namespace
} // namespace esm
