#include "core/exchange/project/project_file.h"
#include "core/exchange/project/scene_file.h"
#include "tests/core/exchange/fields_set_in_none.h"
#include "tests/support/samples.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

/// The scene that the project sample of the same name stores.
Scene storedScene(const std::filesystem::path& sample) {
    const std::filesystem::path projects = sample.parent_path() / ".." / "projects";
    return loadProject(projects / (sample.stem().string() + ".esm")).scene;
}

TEST(SceneFileSamples, AreReadAndWrittenAsTheyWere) {
    for (const std::filesystem::path& file : samples("scenes")) {
        SCOPED_TRACE(file.filename());
        const Scene scene = readSceneFile(file);
        EXPECT_TRUE(scene == storedScene(file));
        const std::string text = toJson(scene).dump(2) + '\n';
        EXPECT_TRUE(readFile(file) == Bytes(text.begin(), text.end())) << text;
    }
}

TEST(SceneFileSamples, SetEveryField) {
    std::vector<Scene> scenes;
    std::vector<InstrumentMotion> instruments;
    for (const std::filesystem::path& file : samples("scenes")) {
        scenes.push_back(readSceneFile(file));
        const auto& own = scenes.back().instruments;
        instruments.insert(instruments.end(), own.begin(), own.end());
    }
    EXPECT_THAT(fieldsSetInNone(scenes), testing::IsEmpty());
    for (std::size_t shape = 0; shape < std::variant_size_v<Collider>; ++shape)
        EXPECT_TRUE(std::any_of(instruments.begin(), instruments.end(), [&](const auto& instrument) {
            return instrument.shape.index() == shape;
        })) << "a shape of instruments has no sample";
}

} // namespace
} // namespace esm
